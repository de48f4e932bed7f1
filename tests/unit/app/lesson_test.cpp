// A lesson program as its users meet it: exit codes, standard output, files.
#include "framework/image/pfm.hpp"
#include "framework/image/png.hpp"
#include "tests/unit/app/program.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace glint {
namespace {

using nlohmann::json;

Run run(const TemporaryFolder& folder, const std::string& arguments) {
    return run(LESSON_PROGRAM, folder, arguments);
}

TEST_CASE("without words it draws its picture") {
    const TemporaryFolder folder;
    const Run r = run(folder, "");
    CHECK(r.status == 0);
    CHECK(r.err.empty());
    CHECK(lines(r.out) == 1);
    CHECK(r.out.starts_with("01_ad_hoc_phong: "));
    const SrgbImage picture = read_png(folder / "out/01_ad_hoc_phong.png");
    CHECK(picture.width() == 960);
    CHECK(picture.height() == 540);
}

TEST_CASE("bad input: exit code 2, one line on standard error, no file") {
    for (const std::string arguments : {"--no-such-option",
                                        "word",
                                        "--size 0x0",
                                        "--size",
                                        "--samples 3",
                                        "--threads 0",
                                        "--lanes 5",
                                        "--kd 2,0,0",
                                        "--ns -1",
                                        "--fov 180",
                                        "--near 5 --far 2",
                                        "--near 1000",
                                        "--light 0,0,0:1,1,1",
                                        "--set gain=1",
                                        "--out picture.jpg",
                                        "--out no/such/folder.png",
                                        "--out a.png --stats .",
                                        "--probe 960,0",
                                        "--probe x",
                                        "--frames 0",
                                        "--view none",
                                        "--cull front",
                                        "--raster none",
                                        "--scene no_such.obj",
                                        "--scene .",
                                        "--compare no_such.png",
                                        "--up 0,0,0",
                                        "--eye 1,1,1 --target 1,1,1",
                                        "--eye 1e30,0,0",
                                        "--eye 0,5,0 --target 0,0,0 --up 0,1,0"}) {
        CAPTURE(arguments);
        const TemporaryFolder folder;
        const Run r = run(folder, arguments);
        CHECK(r.status == 2);
        CHECK(r.out.empty());
        CHECK(r.err.starts_with("error: "));
        CHECK(lines(r.err) == 1);
        CHECK(folder.count() == 0);
    }
}

TEST_CASE("a file that cannot be written, or compared with, leaves none of the others") {
    const TemporaryFolder sources;
    write_png(sources / "small.png", SrgbImage(3, 3));
    const std::string small = (sources / "small.png").string();
    for (const std::string& arguments :
         {std::string("--out a.png --out no/such/b.pfm"), "--out a.png --compare " + small,
          std::string("--out a.png --compare no/such.png"),
          std::string("--out a.png --stats no/such/s.json")}) {
        CAPTURE(arguments);
        const TemporaryFolder folder;
        const Run r = run(folder, "--size 32x18 " + arguments);
        CHECK(r.status == 2);
        CHECK(r.err.starts_with("error: "));
        CHECK(lines(r.err) == 1);
        CHECK(folder.count() == 0);
    }
}

TEST_CASE("--stats - prints one JSON object and nothing else") {
    const TemporaryFolder folder;
    const Run r =
        run(folder, "--size 64x36 --threads 2 --lanes 4 --samples 2 --frames 3 --stats -");
    CHECK(r.status == 0);
    CHECK(lines(r.err) == 1);
    const json s = json::parse(r.out);
    CHECK(s.is_object());
    CHECK(s["frames"] == 3);
    CHECK(s["threads"] == 2);
    CHECK(s["lanes"] == 4);
    CHECK(s["samples"] == 2);
    CHECK(s["triangles_in"] > 1000);
    CHECK(s["triangles_visible"] <= s["triangles_in"]);
    CHECK(s["frame_ms_min"] <= s["frame_ms_median"]);
    const Run file = run(folder, "--size 8x8 --stats s.json --out a.png");
    CHECK(file.status == 0);
    CHECK(lines(file.out) == 1);
    CHECK(json::parse(text_of(folder / "s.json"))["frames"] == 1);
}

TEST_CASE("PFM files of the views hold raw values") {
    const TemporaryFolder folder;
    const std::string size = "--size 64x36 ";
    for (const std::string view : {"depth", "triangle", "overdraw", "tiles"}) {
        CHECK(run(folder, size + "--view " + view + " --out " + view + ".pfm").status == 0);
    }
    const Image<float> depth = read_pfm_grey(folder / "depth.pfm");
    const Image<float> triangle = read_pfm_grey(folder / "triangle.pfm");
    const Image<float> layers = read_pfm_grey(folder / "overdraw.pfm");
    int nothing = 0;
    int wrong = 0;
    for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 64; ++x) {
            const float t = triangle(x, y);
            nothing += t == -1.0F ? 1 : 0;
            wrong += (t == -1.0F) != (depth(x, y) == 0.0F) ? 1 : 0;
            wrong += (t == -1.0F) != (layers(x, y) == 0.0F) ? 1 : 0;
            wrong += t != std::floor(t) || t < -1.0F ? 1 : 0;
            wrong += !(depth(x, y) >= 0.0F && depth(x, y) <= 1.0F) ? 1 : 0;
        }
    }
    CHECK(wrong == 0);
    CHECK(nothing > 0);
    CHECK(nothing < 36 * 64 / 2);
}

// What the probe's text says of red, green and blue, in float and in double; empty where nothing
// is.
std::vector<double> radiance_of(const std::string& text) {
    std::vector<double> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        double in_float = 0;
        double in_double = 0;
        words >> name >> in_float >> in_double;
        if (name.starts_with("radiance.")) {
            all.insert(all.end(), {in_float, in_double});
        }
    }
    return all;
}

void check_probes(const std::string& panels) {
    const TemporaryFolder folder;
    const std::string size = "--size 160x90 --samples 1 " + panels;
    CHECK(run(folder, size + "--out a.pfm --out a.png").status == 0);
    CHECK(run(folder, size + "--view triangle --out t.pfm").status == 0);
    const LinearImage picture = read_pfm(folder / "a.pfm");
    const Image<float> triangle = read_pfm_grey(folder / "t.pfm");
    const auto files = folder.count();
    int drawn = 0;
    for (const auto& [x, y] :
         {std::pair(70, 45), {40, 50}, {120, 40}, {90, 70}, {0, 0}, {90, 30}}) {
        const std::string pixel = std::to_string(x) + "," + std::to_string(y);
        CAPTURE(pixel);
        const Run r = run(folder, size + "--probe " + pixel);
        CHECK(r.status == 0);
        CHECK(r.err.empty());
        CHECK(r.out.starts_with("pixel " + pixel + ", at its centre\n"));
        const std::vector<double> radiance = radiance_of(r.out);
        if (triangle(x, y) < 0) {
            CHECK(radiance.empty());
            continue;
        }
        ++drawn;
        REQUIRE(radiance.size() == 6);
        for (std::size_t i = 0; i < 6; ++i) {
            const float expected = picture(x, y)[static_cast<int>(i / 2)];
            CHECK(std::abs(radiance[i] - double{expected}) < 2e-5);
        }
    }
    CHECK(drawn >= 3);
    CHECK(folder.count() == files);
}

TEST_CASE("--probe tells the radiance of the picture's pixel") {
    check_probes("--set lights=1 ");  // one panel
    check_probes("");
}

TEST_CASE("several files are written at once, and compared") {
    const TemporaryFolder folder;
    const std::string size = "--size 40x30 --threads 2 ";
    CHECK(run(folder, size + "--out a.png --out a.pfm --out b.png").status == 0);
    CHECK(folder.count() == 3);
    CHECK(read_png(folder / "a.png") == read_png(folder / "b.png"));
    const Run same = run(folder, size + "--out c.png --compare a.png");
    CHECK(same.status == 0);
    CHECK(same.out.find("largest difference 0") != std::string::npos);
    const Run other = run(folder, size + "--kd 0,1,0 --out d.png --compare a.png");
    CHECK(other.status == 0);
    CHECK(other.out.find("largest difference 0") == std::string::npos);
}

TEST_CASE("the same picture on any number of threads, nearly the same on any rasterizer") {
    const TemporaryFolder folder;
    const std::string size = "--size 130x70 --out ";
    CHECK(run(folder, size + "a.png --threads 1").status == 0);
    CHECK(run(folder, size + "b.png --threads 7").status == 0);
    CHECK(text_of(folder / "a.png") == text_of(folder / "b.png"));
    const Run scanline = run(folder, size + "c.png --raster scanline --compare a.png");
    const bool close = scanline.out.find("difference 0 codes") != std::string::npos ||
                       scanline.out.find("difference 1 codes") != std::string::npos;
    CHECK(close);
}

TEST_CASE("a mesh of one's own is framed, drawn and warned about") {
    const TemporaryFolder folder;
    const std::string cube = SOURCE_FOLDER "/tests/data/obj/cube.obj";
    const Run r = run(
        folder, "--size 40x30 --set lights=1 --scene '" + cube + "' --view triangle --out t.pfm");
    CHECK(r.status == 0);
    const Image<float> triangle = read_pfm_grey(folder / "t.pfm");
    CHECK(triangle(20, 15) >= 0.0F);
    CHECK(triangle(0, 0) == -1.0F);
}

// One triangle; its material is nowhere to be found.
void write_triangle(const std::filesystem::path& file, const std::string& size) {
    std::ofstream(file) << "v 0 0 0\nv " << size << " 0 0\nv 0 " << size
                        << " 0\nusemtl none\nf 1 2 3\n";
}

TEST_CASE("a mesh of any size is framed, or refused by its name") {
    for (const std::string size : {"0", "1e-30", "1e-17", "1", "1e17", "1e30"}) {
        CAPTURE(size);
        const TemporaryFolder folder;
        write_triangle(folder / "a.obj", size);
        const Run r = run(folder, "--size 40x30 --set lights=1 --scene a.obj --view triangle");
        const bool drawn = size == "1e-17" || size == "1" || size == "1e17";
        CHECK(r.status == (drawn ? 0 : 2));
        CHECK((r.err.find("error: a.obj: ") == std::string::npos) == drawn);
    }
}

TEST_CASE("a system that starts no more threads is an error, not an end without one") {
    const TemporaryFolder folder;
    const auto limited = [&](const std::string& arguments) {
        const std::string command = "cd '" + folder.path().string() +
                                    "' && ulimit -v 700000 && exec timeout 60 '" LESSON_PROGRAM
                                    "' " +
                                    arguments + " >/dev/null 2>err";
        const int result = std::system(command.c_str());
        return WIFEXITED(result) ? WEXITSTATUS(result) : -1;
    };
    if (std::string(EMULATOR).empty() && limited("--help") == 0) {  // sanitizers take more to begin
        CHECK(limited("--size 40x30 --threads 256") == 2);
        CHECK(
            text_of(folder / "err").starts_with("error: threads: the system starts no more than"));
        CHECK(folder.count() == 1);
    }
}

TEST_CASE("a mesh is read once for all panels: warnings come once") {
    const TemporaryFolder folder;
    write_triangle(folder / "a.obj", "1");
    const Run r = run(folder, "--size 40x30 --scene a.obj");
    CHECK(r.status == 0);
    CHECK(lines(r.err) == 1);
    CHECK(r.err.find("warning: a.obj:4: ") != std::string::npos);
}

TEST_CASE("--help explains itself and is no failure") {
    const TemporaryFolder folder;
    const Run r = run(folder, "--help");
    CHECK(r.status == 0);
    CHECK(r.err.empty());
    CHECK(folder.count() == 0);
    for (const std::string option :
         {"--scene",          "--kd",      "--ks",     "--ns",          "--set",
          "--size",           "--eye",     "--target", "--up",          "--fov",
          "--near",           "--far",     "--light",  "--point-light", "--ambient",
          "--cull",           "--raster",  "--lanes",  "--threads",     "--samples",
          "--sample-shading", "--out",     "--view",   "--frames",      "--stats",
          "--probe",          "--compare", "--window", "Examples:"}) {
        CAPTURE(option);
        CHECK(r.out.find(option) != std::string::npos);
    }
}

}  // namespace
}  // namespace glint
