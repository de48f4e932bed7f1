#include "framework/geometry/obj.hpp"

#include "framework/geometry/shapes.hpp"
#include "framework/math/error.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

namespace glint {
namespace {

const std::string data = "tests/data/obj/";
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Obj parse(const std::string& text) {
    Obj obj = parse_obj(text, "a.obj");
    CHECK(is_valid(obj.mesh));
    return obj;
}

std::string message(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

std::string error(const std::string& text) {
    return message([&] { parse_obj(text, "a.obj"); });
}

using Triangles = LineVector<glm::uvec3>;

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) {
        all += line + '\n';
    }
    return all;
}

TEST_CASE("polygons are fans round their first vertex, in the order of the file") {
    const Mesh mesh = parse(
                          "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\n"
                          "f 2 3 4\nf 1 2 3 4 5\nf 5 1 2\n")
                          .mesh;
    // vertices are numbered as they are first used: 2 3 4 1 5
    CHECK(mesh.triangles == Triangles{{0, 1, 2}, {3, 0, 1}, {3, 1, 2}, {3, 2, 4}, {4, 3, 0}});
    CHECK(mesh.positions[3] == glm::vec3(0, 0, 0));
    CHECK(mesh.uvs.empty());
}

TEST_CASE("a polygon may have more corners than a byte counts") {
    std::ostringstream text;
    for (int i = 0; i < 1000; ++i) {
        text << "v " << std::cos(i * 0.00628) << ' ' << std::sin(i * 0.00628) << " 0\n";
    }
    text << "f";
    for (int i = 1; i <= 1000; ++i) {
        text << ' ' << i;
    }
    CHECK(parse(text.str()).mesh.triangles.size() == 998);
}

TEST_CASE("corners that differ in texture or normal are different vertices") {
    const Mesh mesh = parse(square +
                            "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 0 -1\n"
                            "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n"
                            "f 1/2/1 2/1/2 3/1/1\n")
                          .mesh;
    CHECK(mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 2}});
    CHECK(mesh.uvs[4] == glm::vec2(1, 0));
    CHECK(mesh.normals[5] == glm::vec3(0, 0, -1));
}

TEST_CASE("a thousand textures at one position stay a thousand vertices") {
    std::ostringstream text;
    text << square;
    for (int i = 0; i < 1000; ++i) {
        text << "vt " << i << " 0\n";
    }
    for (int round = 0; round < 2; ++round) {
        for (int i = 1; i <= 1000; ++i) {
            text << "f 1/" << i << " 2/" << i << " 3/" << i << '\n';
        }
    }
    const Mesh mesh = parse(text.str()).mesh;
    CHECK(mesh.positions.size() == 3000);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        REQUIRE(mesh.positions[t.y] == glm::vec3(1, 0, 0));
        REQUIRE(mesh.uvs[t.y].x == static_cast<float>(i % 1000));
    }
}

TEST_CASE("all ways to write a corner") {
    const std::string lists = square + "vt 0.25 0.5\nvn 0 1 0\n";
    CHECK(parse(lists + "f 1 2 3\n").mesh.normals[0] == glm::vec3(0, 0, 1));
    CHECK(parse(lists + "f 1/1 2/1 3/1\n").mesh.uvs[2] == glm::vec2(0.25F, 0.5F));
    CHECK(parse(lists + "f 1//1 2//1 3//1\n").mesh.normals[1] == glm::vec3(0, 1, 0));
    const Mesh full = parse(lists + "f 1/1/1 2/1/1 3/1/1\n").mesh;
    CHECK(full.uvs[0] == glm::vec2(0.25F, 0.5F));
    CHECK(full.normals[0] == glm::vec3(0, 1, 0));
    CHECK(parse(lists + "f 1// 2// 3/\n").mesh.uvs.empty());
    const Mesh mixed = parse(lists + "f 1/1 2 3//1\n").mesh;
    CHECK(mixed.uvs[1] == glm::vec2(0, 0));
    CHECK(mixed.normals[0] == glm::vec3(0, 0, 1));
    CHECK(mixed.normals[2] == glm::vec3(0, 1, 0));
}

TEST_CASE("negative indices count back from where they stand") {
    const Obj obj = read_obj(data + "relative.obj");
    CHECK(obj.mesh.triangles == Triangles{{0, 1, 2}, {3, 4, 5}, {0, 1, 2}, {0, 2, 5}, {0, 5, 4}});
    CHECK(obj.mesh.positions[4] == glm::vec3(1, 0, 1));
    CHECK(parse(square + "vt 0 0\nvt 1 1\nvn 0 0 1\nf -4/-1/-1 -3/-2/-1 -2/-1/-1").mesh.uvs[1] ==
          glm::vec2(0, 0));
}

TEST_CASE("line ends, continued lines, tabs, comments and a byte order mark") {
    const Triangles one{{0, 1, 2}};
    CHECK(read_obj(data + "crlf.obj").mesh.triangles == one);
    CHECK(parse("v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r").mesh.triangles == one);
    CHECK(parse("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3").mesh.triangles == one);
    const Mesh mesh = parse(
                          "# C:\\models\\\n\n  v\t0 \\\n0\\\n 0 # origin\nv 1 0 0\\\n\n"
                          "v 1 1 0\n# f 1 2 2\nf 1 2 3 # one\n\\\n")
                          .mesh;
    CHECK(mesh.triangles == one);
    CHECK(mesh.positions[2] == glm::vec3(1, 1, 0));
}

TEST_CASE("numbers are read in all their spellings") {
    const Mesh mesh = parse(
                          "v +1.5 -.25 2.\nv 1e-3 1E+2 12345678\nv 0.1 16777217 3.4e38\n"
                          "f 1 2 3")
                          .mesh;
    CHECK(mesh.positions[0] == glm::vec3(1.5F, -0.25F, 2.0F));
    CHECK(mesh.positions[1] == glm::vec3(1e-3F, 100.0F, 12345678.0F));
    CHECK(mesh.positions[2] == glm::vec3(0.1F, 16777216.0F, 3.4e38F));
}

TEST_CASE("what is not a triangle is passed over, what is unknown too but with a word") {
    const Obj obj = read_obj(data + "freeform.obj");
    CHECK(obj.mesh.triangles.size() == 3);
    CHECK(joined(obj.warnings) ==
          joined({data + "freeform.obj:17: `wibble` is not an OBJ statement: passed over",
                  data + "freeform.obj:8: the normal is zero or not finite: made from the faces "
                         "(and 1 more)"}));
    for (const glm::vec3& n : obj.mesh.normals) {
        CHECK(n == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("the file's normals are made unit length, however long they are") {
    const Mesh mesh = parse(square + "vn 0 3 4\nvn 1e-38 0 0\nvn 0 0 -3e38\nf 1//1 2//2 3//3").mesh;
    CHECK(mesh.normals[0] == glm::vec3(0, 0.6F, 0.8F));
    CHECK(mesh.normals[1] == glm::vec3(1, 0, 0));
    CHECK(mesh.normals[2] == glm::vec3(0, 0, -1));
}

TEST_CASE("missing normals are weighted by area and shared across texture seams") {
    // a triangle of area 2 facing +z and one of area 1/2 facing -y share the edge 1 2
    const std::string text =
        "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 0.5\nvt 0 0\nvt 1 1\n"
        "f 1/1 2/1 3/1\nf 1/2 2/2 4/2\n";
    const Mesh mesh = parse(text).mesh;
    REQUIRE(mesh.normals.size() == 6);
    const glm::vec3 shared = glm::normalize(glm::vec3(0, -1, 4));
    for (const std::size_t i : {0U, 1U, 3U, 4U}) {
        CHECK(length(mesh.normals[i] - shared) < 1e-7F);
    }
    CHECK(mesh.normals[2] == glm::vec3(0, 0, 1));
    CHECK(mesh.normals[5] == glm::vec3(0, -1, 0));
}

TEST_CASE("smooth normals of a sphere of tiny coordinates come near the exact ones") {
    const Mesh ball = sphere(1.0F, 64, 32);
    std::ostringstream text;
    for (const glm::vec3& p : ball.positions) {
        text << "v " << p.x << "e-25 " << std::fixed << p.y << "e-25 " << p.z << "e-25\n";
    }
    for (const glm::uvec3& t : ball.triangles) {
        text << "f " << t.x + 1 << ' ' << t.y + 1 << ' ' << t.z + 1 << '\n';
    }
    const Mesh mesh = parse(text.str()).mesh;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (std::abs(mesh.normals[i].y) < 0.9F && mesh.normals[i].x > 0.1F) {
            CHECK(dot(mesh.normals[i], glm::normalize(mesh.positions[i] * 1e25F)) > 0.999F);
        }
    }
}

TEST_CASE("degenerate faces are counted: dropped without 3 vertices, kept without area") {
    const Obj obj = read_obj(data + "degenerate.obj");
    CHECK(obj.dropped_faces == 2);
    // 1 2 3 lies on a line, 1 2 2 4 makes the triangles 1 2 2 and 1 2 4
    CHECK(obj.zero_area_triangles == 2);
    CHECK(obj.mesh.triangles.size() == 5);
    CHECK(
        joined(obj.warnings) ==
        joined({data + "degenerate.obj:5: the face has fewer than 3 distinct vertices: dropped "
                       "(and 1 more)",
                data + "degenerate.obj: 2 triangles have no area: they stay, but cover nothing",
                data + "degenerate.obj: 1 vertices have faces without a common side: their normal "
                       "is (0, 0, 1)"}));
}

TEST_CASE("materials of an MTL whose name has spaces, with a picture") {
    const Obj obj = read_obj(data + "cube.obj");
    REQUIRE(obj.materials.size() == 2);
    const Material& brick = obj.materials[0];
    CHECK(brick.name == "red brick");
    CHECK(brick.diffuse == glm::vec3(0.6F, 0.2F, 0.1F));
    CHECK(brick.specular == glm::vec3(0.05F));
    CHECK(brick.exponent == 12.5F);
    CHECK(brick.ior == 1.45F);
    CHECK(brick.diffuse_map.empty());
    const Material& lid = obj.materials[1];
    CHECK(lid.diffuse == glm::vec3(1.0F, 0.5F, 0.5F));
    CHECK(lid.specular == Material{}.specular);
    CHECK(lid.exponent == Material{}.exponent);
    CHECK(lid.ior == Material{}.ior);
    CHECK(lid.diffuse_map == data + "pictures/two by two.ppm");
    CHECK(obj.mesh.materials == std::vector<std::uint16_t>{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1});
    CHECK(topology(obj.mesh).closed());
    CHECK(volume(obj.mesh) == 8.0);
    CHECK(least_agreement(obj.mesh) == 1.0);
    CHECK(texture_is_unmirrored(obj.mesh));
    CHECK(joined(obj.warnings) ==
          joined({data + "two words.mtl:13: the options of map_Kd are ignored"}));
}

TEST_CASE("a bad MTL spoils nothing and says so") {
    const Obj obj = read_obj(data + "relative.obj");
    const std::string mtl = data + "spoiled.mtl:";
    CHECK(joined(obj.warnings) ==
          joined({mtl + "1: stands before the first newmtl: ignored",
                  mtl + "3: Kd needs three numbers: ignored", mtl + "4: Ks is limited to 0..1",
                  mtl + "5: Ns needs a number >= 0: ignored",
                  mtl + "6: Ni needs a number > 0: ignored",
                  mtl + "7: picture `nowhere.png` cannot be read: left out",
                  mtl + "11: Kd needs three numbers: ignored",
                  mtl + "12: Ns needs a number >= 0: ignored",
                  data + "relative.obj:1: " + data + "nowhere.mtl: no such file",
                  data + "relative.obj:11: no MTL file defines material `unheard-of`"}));
    REQUIRE(obj.materials.size() == 4);
    CHECK(obj.materials[0].diffuse == Material{}.diffuse);
    CHECK(obj.materials[0].specular == glm::vec3(1.0F, 0.5F, 0.0F));
    CHECK(obj.materials[0].exponent == Material{}.exponent);
    CHECK(obj.materials[0].ior == Material{}.ior);
    CHECK(obj.materials[1].diffuse == glm::vec3(0.3F));
    CHECK(obj.materials[3].name == "unheard-of");
    // of two with one name the first is meant
    CHECK(obj.mesh.materials == std::vector<std::uint16_t>{0, 0, 3, 3, 3});
}

TEST_CASE("faces before any usemtl have Material's own values") {
    const Obj obj = parse(square + "f 1 2 3\nusemtl x\nf 1 3 4\n");
    REQUIRE(obj.materials.size() == 2);
    CHECK(obj.materials[0].name.empty());
    CHECK(obj.materials[0].diffuse == Material{}.diffuse);
    CHECK(obj.mesh.materials == std::vector<std::uint16_t>{0, 1});
}

TEST_CASE("more materials than 16 bits count are refused") {
    std::ostringstream text;
    text << square << "f 1 2 3\n";
    for (int i = 0; i < 65536; ++i) {
        text << "usemtl " << i << '\n';
    }
    CHECK(error(text.str()) == "a.obj:65541: more than 65536 materials");
}

TEST_CASE("warnings stay few") {
    std::ostringstream text;
    text << square << "f 1 2 3\n";
    for (int i = 0; i < 1000; ++i) {
        text << "usemtl " << i << '\n';
    }
    const Obj obj = parse(text.str());
    CHECK(obj.warnings.size() == 51);
    CHECK(obj.warnings.back() == "and 950 more warnings");
}

TEST_CASE("an error names the file, the line and what is wrong") {
    CHECK(message([] { read_obj(data + "bad_index.obj"); }) ==
          data +
              "bad_index.obj:5: vertex index 99 is out of range (the file has 3 vertices up to "
              "here)");
    CHECK(message([] { read_obj(data + "not_finite.obj"); }) ==
          data + "not_finite.obj:2: `nan` is not a finite number");
    CHECK(message([] { read_obj(data + "cut_short.obj"); }) ==
          data + "cut_short.obj:4: a face needs at least 3 corners, this has 2");
    CHECK(error(square + "f 1 2 -5") ==
          "a.obj:5: vertex index -5 is out of range (the file has 4 vertices up to here)");
    CHECK(
        error(square + "vt 0 0\nf 1/1 2/1 3/2") ==
        "a.obj:6: texture coordinate index 2 is out of range (the file has 1 of them up to here)");
    CHECK(error(square + "f 1//1 2//1 3//1") ==
          "a.obj:5: normal index 1 is out of range (the file has 0 of them up to here)");
    CHECK(error("f 1 2 3\n" + square) ==
          "a.obj:1: vertex index 1 is out of range (the file has 0 vertices up to here)");
    CHECK(error("v 1 2\n") == "a.obj:1: v needs at least 3 numbers, this has 2");
    CHECK(error("v 0 \\\n0 0\nvt\n") == "a.obj:3: vt needs at least 1 number, this has 0");
    CHECK(error("v 1 2 3x\n") == "a.obj:1: `3x` is not a finite number");
    CHECK(error("v 1 2 1e39\n") == "a.obj:1: a coordinate is too large");
    CHECK(error("v 1 2 0e999\n") == "a.obj:1: a coordinate is too large");
    CHECK(error("vt inf 0\n") == "a.obj:1: `inf` is not a finite number");
    CHECK(error("vt 1e99 0\n") == "a.obj:1: a texture coordinate is too large");
    CHECK(error("vn 1 2\n") == "a.obj:1: vn needs at least 3 numbers, this has 2");
    CHECK(error("<html>\n") == "a.obj:1: `<html>` does not begin an OBJ statement");
}

TEST_CASE("spellings of corners and numbers that are refused") {
    for (const char* word : {"0", "1/0", "1//0", "a", "1a", "/1", "//", "1///1", "1/1/1/1", "1.5",
                             "+1", "--1", "9999999999", "-", "1/-", "1\\"}) {
        CAPTURE(word);
        CHECK(error(square + "vt 0 0\nvn 0 0 1\nf 1 2 " + word + " 3").find("a.obj:7: `") == 0);
    }
    for (const char* word :
         {"1.2.3", "1e", "e5", ".", "+", "1e99999", "0x10", "1,5", "1 - 2", "1.#IND", "--1"}) {
        CAPTURE(word);
        CHECK(error("v 0 0 " + std::string(word)).find(" is not a finite number") !=
              std::string::npos);
    }
}

TEST_CASE("a text without triangles is an error") {
    CHECK(error("") == "a.obj: is empty");
    CHECK(error("\n# nothing\n") == "a.obj: has no faces");
    CHECK(error(square) == "a.obj: has no faces");
    CHECK(error(square + "f 1 1 2\n") == "a.obj: has no faces with 3 distinct vertices");
    CHECK(error(std::string("\x89PNG\r\n\0\0", 8)) == "a.obj: is a binary file, not text");
    CHECK(error("\x7f"
                "ELF\x02\x01\x1b[2J") == "a.obj:1: `?ELF???[2J` does not begin an OBJ statement");
    CHECK(error("v 0 0 " + std::string(100000, '7') + "x").size() < 100);
}

TEST_CASE("files that cannot be read are errors") {
    CHECK(message([] { read_obj(data + "nowhere.obj"); }) == data + "nowhere.obj: no such file");
    CHECK(message([] { read_obj(data); }) == data + ": is a folder, not a file");
    CHECK(message([] { read_obj("/dev/null"); }) == "/dev/null: is not a file");
    CHECK(message([] { read_obj("no\nwhere.obj"); }) == "no?where.obj: no such file");
}

TEST_CASE("a file of more than 2 GiB is refused before it is read") {
    const auto path = std::filesystem::temp_directory_path() /
                      ("glint_large_" + std::to_string(std::rand()) + ".obj");
    std::ofstream(path) << square;
    std::error_code no_sparse_files;
    std::filesystem::resize_file(path, (std::uintmax_t{1} << 31) + 1, no_sparse_files);
    if (!no_sparse_files) {
        CHECK(message([&] { read_obj(path); }) == path.string() + ": is larger than 2 GiB");
    }
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace glint
