// counted_frames NAME: draws a small frame twice, the second time in a function of its own, whose
// instructions tests/instruction_counts/count counts.
#include "lessons/15_engine_integration/lit_from_afar.hpp"
#include "lessons/15_engine_integration/where_it_shows.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/renderer.hpp"
#include "framework/math/error.hpp"

#include <cmath>
#include <iostream>
#include <span>
#include <string_view>
#include <vector>

namespace {

using namespace glint;

constexpr int lanes = 8;

// A sheet with hills that fills the picture, of 2 side^2 triangles.
Mesh sheet(int side) {
    Mesh mesh;
    for (int row = 0; row <= side; ++row) {
        for (int column = 0; column <= side; ++column) {
            const float x = 2 * static_cast<float>(column) / static_cast<float>(side) - 1;
            const float y = 2 * static_cast<float>(row) / static_cast<float>(side) - 1;
            mesh.positions.emplace_back(x, y, 0.5F + 0.1F * std::sin(5 * x) * std::sin(4 * y));
            mesh.normals.push_back(
                glm::normalize(glm::vec3(-std::cos(5 * x) * std::sin(4 * y), -std::sin(5 * x), 2)));
            if (row < side && column < side) {
                const auto a = static_cast<std::uint32_t>(row * (side + 1) + column);
                const auto above = a + static_cast<std::uint32_t>(side) + 1;
                mesh.triangles.emplace_back(a, a + 1, above + 1);
                mesh.triangles.emplace_back(a, above + 1, above);
            }
        }
    }
    return mesh;
}

Lighting lights(int count) {
    Lighting lighting;
    for (int i = 0; i < count; ++i) {
        const auto angle = static_cast<float>(i);
        lighting.directional.push_back(
            {glm::normalize(glm::vec3(std::cos(angle), std::sin(angle), 1)),
             Rgb<float>(3.0F / static_cast<float>(count))});
    }
    return lighting;
}

// Three materials, in stripes.
Mesh striped(Mesh mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        mesh.materials.push_back(static_cast<std::uint16_t>(t / 10 % 3));
    }
    return mesh;
}

struct Frame {
    Mesh mesh;
    Lighting lighting;
    View view;
    int samples = 1;
};

Frame frame(std::string_view name) {
    const glm::mat4 as_it_is(1.0F);
    if (name == "many_triangles") {
        return {sheet(192), lights(2), {as_it_is, 320, 240}};
    }
    if (name == "large_triangles") {
        return {sheet(4), lights(2), {as_it_is, 640, 480}};
    }
    if (name == "many_lights") {
        return {sheet(16), lights(64), {as_it_is, 320, 240}};
    }
    if (name == "many_samples") {
        return {striped(sheet(64)), lights(2), {as_it_is, 320, 240}, 4};
    }
    throw Error("there is no frame " + std::string(name));
}

}  // namespace

// Valgrind finds it by its name.
extern "C" [[gnu::noinline]] void counted_frame(Renderer& renderer, const Frame& f,
                                                std::span<const Shader> shaders,
                                                SrgbImage& picture) {
    renderer.render(f.mesh, f.view, shaders, {.srgb = &picture});
}

int main(int argc, char** argv) {
    try {
        const Frame f = frame(argc == 2 ? argv[1] : "");
        const EnginePhong phong{Rgb<float>(0.5F, 0.3F, 0.2F), Rgb<float>(0.04F), 50};
        const float from = highlight_from(phong, f.lighting, radiance_of_codes(1e-3F));
        const LitFromAfar lit{{phong, from}, f.lighting};
        const std::vector<Shader> shaders(f.mesh.materials.empty() ? 1 : 3, plug(lit));
        Renderer renderer({.lanes = lanes, .samples = f.samples});
        SrgbImage picture;
        const Statistics s = renderer.render(f.mesh, f.view, shaders, {.srgb = &picture});
        std::cerr << s.triangles_visible << " triangles seen, " << s.fragments_shaded
                  << " fragments shaded\n";
        counted_frame(renderer, f, shaders, picture);
        return 0;
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << "\n";
        return 2;
    }
}
