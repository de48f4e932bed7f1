#include "tests/grading/instructor/fragments.hpp"

#include "framework/scene/stages.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/renderer.hpp"
#include "framework/math/error.hpp"

#include <nlohmann/json.hpp>

namespace glint::grading {
namespace {

constexpr int width = 48;
constexpr int height = 48;
constexpr int teapot = 2;  // the still life's material

// Its colour is a place, or a normal.
struct Attribute {
    bool is_normal;
    template <class T>
    struct Varyings {
        Vec3<T> vector;
    };
    Varyings<float> vertex(const Vertex& v) const { return {is_normal ? v.normal : v.position}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return in.vector;
    }
};

LinearImage drawn(const Scene& scene, bool normals, Image<std::int32_t>& triangle) {
    const Attribute attribute{normals};
    const std::vector<Shader> shaders(scene.materials.size(), plug(attribute));
    LinearImage image;
    const View view{clip_from_world(scene.camera, 1.0F * width / height), width, height};
    Renderer(Settings{})
        .render(scene.mesh, view, shaders, {.linear = &image, .triangle = &triangle});
    return image;
}

Fragments draw() {
    const Scene scene = stages::still_life_upright();
    Image<std::int32_t> triangle;
    const LinearImage places = drawn(scene, false, triangle);
    const LinearImage normals = drawn(scene, true, triangle);
    const glm::vec3 light = scene.lighting.directional.front().direction;
    Fragments f{width, height, {}};
    for (std::size_t i = 0; i < triangle.pixels().size(); ++i) {
        const std::int32_t t = triangle.pixels()[i];
        if (t != no_triangle) {
            const auto material = scene.mesh.materials[static_cast<std::size_t>(t)];
            f.all.push_back({static_cast<int>(i), normalize(normals.pixels()[i]), light,
                             normalize(scene.camera.eye - places.pixels()[i]),
                             scene.materials[material], material == teapot});
        }
    }
    return f;
}

}  // namespace

const Fragments& still_life_fragments() {
    static const Fragments all = draw();
    return all;
}

void put_part(const Fragment& f, const nlohmann::json& part, std::vector<double>& row) {
    const auto put = [&](const glm::vec3& v) { row.insert(row.end(), {v.x, v.y, v.z}); };
    const std::string name = part.is_string() ? part.get<std::string>() : "";
    if (part.is_number()) {
        row.push_back(part);
    } else if (name == "normal") {
        put(f.normal);
    } else if (name == "light") {
        put(f.light);
    } else if (name == "viewer") {
        put(f.viewer);
    } else if (name == "incidence") {
        put({f.NL(), f.NV(), dot(f.light, f.viewer)});
    } else if (name == "diffuse") {
        put(f.material.diffuse);
    } else if (name == "specular") {
        put(f.material.specular);
    } else if (name == "exponent") {
        row.push_back(f.material.exponent);
    } else if (name == "metal") {
        row.push_back(f.is_metal ? 1 : 0);
    } else if (name == "codes") {
        put(0.5F + 0.5F * f.normal);
    } else {
        throw Error("a fragment has no " + part.dump());
    }
}

}  // namespace glint::grading
