#include "lessons/18_scanline_to_tiles/big_pixels.hpp"
#include "lessons/18_scanline_to_tiles/cover.hpp"
#include "lessons/18_scanline_to_tiles/grids.hpp"
#include "framework/app/lesson.hpp"
#include "framework/raster/coverage.hpp"
#include "framework/image/colour.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace {

using namespace glint;
using by_hand::Corners;

// Which triangles cover a pixel.
using Owners = Image<std::vector<int>>;

enum : int { yours, tiles, scanline };

std::vector<Corners> snapped(const grids::Grid& grid, int bits) {
    std::vector<Corners> all;
    for (const auto& triangle : grid.triangles) {
        Corners& corners = all.emplace_back();
        std::ranges::transform(triangle, corners.begin(), [&](const glm::vec2& p) {
            return glm::ivec2(by_hand::snapped(p.x, bits), by_hand::snapped(p.y, bits));
        });
    }
    return all;
}

Owners owners(const std::vector<Corners>& triangles, int by) {
    Owners all(grids::width, grids::height);
    if (by == yours) {
        int index = 0;
        for (const Corners& corners : triangles) {
            by_hand::cover<Lanes<max_lanes>::Int>(
                corners, grids::width, grids::height,
                [&](int x, int y) { all(x, y).push_back(index); });
            ++index;
        }
    } else {
        const Settings settings{.rasterizer =
                                    by == tiles ? Rasterizer::tiles : Rasterizer::scanline};
        find_coverage(triangles, grids::width, grids::height, settings,
                      [&](int, int triangle, int y, int begin, int end) {
                          for (int x = begin; x < end; ++x) {
                              all(x, y).push_back(triangle);
                          }
                      });
    }
    return all;
}

// ---- the picture
// ---------------------------------------------------------------------------------

constexpr std::size_t colours = 12;  // six hues, light and dark
enum : std::size_t { empty = colours, wrong, outline, mark };

std::vector<Material> palette() {
    std::vector<Material> all;
    for (std::size_t i = 0; i < colours; ++i) {
        const std::size_t hue = i / 2;
        const float turn = static_cast<float>(hue) * glm::pi<float>() / 3;
        const float lightness = i % 2 == 0 ? 0.72F : 0.5F;
        all.push_back({.diffuse = rgb_from_oklab(
                           glm::vec3(lightness, 0.1F * std::cos(turn), 0.1F * std::sin(turn)))});
    }
    all.push_back({.diffuse = Rgb<float>(0.020F, 0.022F, 0.027F)});
    all.push_back({.diffuse = Rgb<float>(1, 0, 0.5F)});
    all.push_back({.diffuse = Rgb<float>(0.75F)});
    all.push_back({.diffuse = Rgb<float>(1)});
    return all;
}

// From pixels to the picture's world: y runs upwards there.
glm::vec2 in_picture(const glm::vec2& pixels) {
    return {pixels.x, grids::height - pixels.y};
}

glm::vec2 centre(int x, int y) {
    return in_picture(glm::vec2(x, y) + 0.5F);
}

void add_pixels(Mesh& mesh, const Owners& all, const Owners& right, const Owners& finest) {
    for (int y = 0; y < grids::height; ++y) {
        for (int x = 0; x < grids::width; ++x) {
            const glm::vec2 middle = centre(x, y);
            const std::size_t i =
                all(x, y).empty() ? empty : static_cast<std::size_t>(all(x, y)[0]) % colours;
            const bool is_right = all(x, y) == right(x, y);
            if (i != empty || !is_right) {
                big_pixels::add_square(mesh, middle, 0.94F, 0, is_right ? i : wrong);
            }
            if (right(x, y) != finest(x, y)) {
                big_pixels::add_square(mesh, middle, 0.3F, 2, mark);
            }
        }
    }
}

Scene stage(const Parameters& p) {
    Scene s;
    s.materials = palette();
    for (int y = 0; y < grids::height; ++y) {
        for (int x = 0; x < grids::width; ++x) {
            big_pixels::add_square(s.mesh, centre(x, y), 0.94F, -1, empty);
        }
    }
    for (const grids::Grid& grid : grids::all()) {
        const auto triangles = snapped(grid, static_cast<int>(p["bits"]));
        add_pixels(s.mesh, owners(triangles, static_cast<int>(p["by"])), owners(triangles, tiles),
                   owners(snapped(grid, subpixel_bits), tiles));
        for (const auto& [a, b, c] : grid.triangles) {
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                big_pixels::add_line(s.mesh, in_picture(from), in_picture(to), 0.06F, 1, outline);
            }
        }
    }
    const glm::vec3 middle(0.5F * grids::width, 0.5F * grids::height, 0);
    const float distance = 2000;
    s.camera = {.eye = middle + glm::vec3(0, 0, distance),
                .target = middle,
                .fov_degrees = glm::degrees(2 * std::atan(20.3F / distance)),
                .near = 1900,
                .far = 2100};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "18_scanline_to_tiles",
         .title = "Lesson 18: which pixels a triangle covers, with 0, 4 and 8 sub-pixel bits",
         .parameters = {{"bits", 8, 0, 8, "vertices are snapped to 1/2^bits pixel", true},
                        {"by", 0, 0, 2, "0: your header, 1: Glint's tiles, 2: its scanlines",
                         true}},
         .panels = {{{"bits", 0}}, {{"bits", 4}}, {{"bits", 8}}},
         .stage = stage,
         .shaders = shade_each_material([](const Scene&, const Material& m, const Parameters&) {
             return big_pixels::Flat{m.diffuse};
         })});
}
