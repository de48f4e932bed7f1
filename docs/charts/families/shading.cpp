// How often the model is evaluated - once a corner of flat faces, once a corner, once a pixel - and
// how finely a surface is cut into triangles; against the sphere itself, and against the teapot's
// patches cut so finely that no pixel tells the difference.
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "framework/geometry/shapes.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/picture.hpp"

#include <glm/trigonometric.hpp>

#include <optional>

namespace glint::charts {
namespace {

constexpr int side = 320;  // of the picture, pixels
const Camera camera{.eye = {0, 0, 4}, .fov_degrees = 30, .near = 2, .far = 6};

using Model = Lit<EnginePhong>;

// The model at the corners of the triangles, and its colours in between (Gouraud 1971).
struct AtCorners {
    Model model;

    template <class T>
    struct Varyings {
        Rgb<T> colour;
    };
    Varyings<float> vertex(const Vertex& v) const { return {model(Model::vertex(v))}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return in.colour;
    }
};

Model model_of(const Scene& s, const Material& m) {
    return {{m.diffuse, m.specular, m.exponent}, s.lighting, s.camera.eye};
}

AtCorners corner_model_of(const Scene& s, const Material& m) {
    return {model_of(s, m)};
}

// Each triangle for itself, with the normal of its plane.
Mesh faceted(const Mesh& mesh) {
    Mesh flat;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 corner[] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
        const glm::vec3 normal =
            normalize_or(cross(corner[1] - corner[0], corner[2] - corner[0]), glm::vec3(0, 1, 0));
        const auto first = static_cast<std::uint32_t>(flat.positions.size());
        flat.positions.insert(flat.positions.end(), std::begin(corner), std::end(corner));
        flat.normals.insert(flat.normals.end(), 3, normal);
        flat.triangles.emplace_back(first, first + 1, first + 2);
    }
    return flat;
}

Scene scene_of(const Mesh& mesh) {
    Scene s;
    s.mesh = mesh;
    s.materials = {{.diffuse = Rgb<float>(0.3F, 0.15F, 0.1F), .exponent = 50}};
    s.lighting.directional = {{normalize(glm::vec3(-0.5F, 0.6F, 0.8F)), Rgb<float>(3.0F)}};
    s.lighting.ambient = Rgb<float>(0.05F);
    s.camera = camera;
    return s;
}

struct Picture {
    Codes codes;
    Image<std::int32_t> triangle;
};

// Shaded by Glint; the reference has as many triangles as it takes.
Picture draw(const Stage& stage) {
    Renderer renderer(Settings{});
    Picture p{draw_codes(stage, {}), {}};
    renderer.render(stage.scene.mesh, stage.view, stage.shading.shaders, {.triangle = &p.triangle});
    return p;
}

// The unit sphere where the ray through a pixel's centre meets it.
std::optional<glm::dvec3> hit_sphere(int x, int y) {
    const double distance = side / (2 * std::tan(glm::radians(double{camera.fov_degrees}) / 2));
    const glm::dvec3 from(camera.eye);
    const glm::dvec3 along(x + 0.5 - side / 2.0, side / 2.0 - y - 0.5, -distance);
    const double a = dot(along, along);
    const double b = dot(from, along);
    const double inside = b * b - a * (dot(from, from) - 1);
    if (inside < 0) {
        return std::nullopt;
    }
    return from - (b + std::sqrt(inside)) / a * along;
}

Picture true_sphere() {
    const Scene scene = scene_of(sphere(1, 8, 4));
    const Model model = model_of(scene, scene.materials[0]);
    Picture p{Codes(side, side, glm::dvec3(0)), Image<std::int32_t>(side, side, no_triangle)};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (const auto hit = hit_sphere(x, y)) {
                const Rgb<double> c = model(Model::Varyings<double>{*hit, *hit});
                p.codes(x, y) = {code_of(c.r), code_of(c.g), code_of(c.b)};
                p.triangle(x, y) = 0;
            }
        }
    }
    return p;
}

// The shading where both pictures have the object, and the share of its pixels that only one has.
std::vector<Judgement> judge(const Picture& found, const Picture& exact, const std::string& name) {
    ErrorSum shading;
    int covered = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < exact.triangle.pixels().size(); ++i) {
        const bool right = exact.triangle.pixels()[i] != no_triangle;
        const bool here = found.triangle.pixels()[i] != no_triangle;
        covered += right ? 1 : 0;
        wrong += right != here ? 1 : 0;
        for (int k = 0; k < 3 && right && here; ++k) {
            shading.add(found.codes.pixels()[i][k] - exact.codes.pixels()[i][k]);
        }
    }
    const double share = static_cast<double>(wrong) / covered;
    return {{name, "codes", shading.errors()},
            {"silhouette of the " + name, "share of its pixels", {share, share}}};
}

void add_mesh(std::vector<Contender>& all, const Mesh& mesh, const std::string& level,
              const Picture& exact, const std::string& name) {
    const auto add = [&](const std::string& method, Stage made) {
        const auto stage = std::make_shared<const Stage>(std::move(made));
        all.push_back(frame_contender(method + level, stage, {}, judge(draw(*stage), exact, name)));
    };
    add("flat ", stage_of(scene_of(faceted(mesh)), side, side, corner_model_of));
    add("Gouraud ", stage_of(scene_of(mesh), side, side, corner_model_of));
    add("per pixel ", stage_of(scene_of(mesh), side, side, model_of));
}

Mesh small_teapot(int steps) {
    Mesh m = teapot(steps);
    for (glm::vec3& p : m.positions) {
        p = (p - glm::vec3(0.25F, 1.5F, 0)) * 0.3F;
    }
    return m;
}

}  // namespace

std::vector<Contender> shading_contenders() {
    std::vector<Contender> all;
    const Picture exact_sphere = true_sphere();
    const Picture exact_teapot = draw(stage_of(scene_of(small_teapot(96)), side, side, model_of));
    const char* const levels[] = {"coarse", "medium", "fine", "finest"};
    int size = 8;
    for (const char* level : levels) {  // about as many triangles of each
        add_mesh(all, sphere(1, 2 * size, size), level, exact_sphere, "sphere");
        add_mesh(all, small_teapot(size / 4), level, exact_teapot, "teapot");
        size *= 2;
    }
    return all;
}

}  // namespace glint::charts
