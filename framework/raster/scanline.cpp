// The scanline rasterizer's frame: the samples won, row by row and triangle by triangle, then the
// colours, pixel by pixel. Scalar throughout, and no faster than it must be.
#include "framework/raster/scanline.hpp"

#include "framework/raster/assemble.hpp"
#include "framework/raster/fragment.hpp"
#include "framework/raster/interpolate.hpp"
#include "framework/raster/scanline_rasterizer.hpp"
#include "framework/image/srgb.hpp"

#include <chrono>

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

ScanlineRasterizer::ScanlineRasterizer(const Settings& settings)
    : settings_(settings), offsets_(sample_offsets(settings.samples)) {}

Statistics ScanlineRasterizer::render(const Mesh& mesh, const View& view,
                                      std::span<const Shader> shaders, const Target& target) {
    Statistics statistics;
    const auto start = Clock::now();
    Assembly assembly = assemble(mesh, view);
    triangles_ = std::move(assembly.triangles);
    corners_of_ = no_triangle;
    rays_ = eye_rays(view);
    won_a_sample_.assign(mesh.triangles.size(), 0);
    statistics.triangles_in = static_cast<std::int64_t>(mesh.triangles.size());
    statistics.triangles_not_finite = assembly.not_finite;
    const auto assembled = Clock::now();
    find_visible(view);
    const auto found = Clock::now();
    statistics.geometry_ms = std::chrono::duration<double, std::milli>(assembled - start).count();
    statistics.visibility_ms = std::chrono::duration<double, std::milli>(found - assembled).count();
    for (int y = 0; y < view.height; ++y) {
        const auto row = Clock::now();
        shade_row(mesh, shaders, target, y, statistics);
        statistics.shading_ms += milliseconds_since(row);
        const auto shaded = Clock::now();
        write_row(target, y);
        statistics.output_ms += milliseconds_since(shaded);
    }
    for (const std::uint8_t won : won_a_sample_) {
        statistics.triangles_visible += won;
    }
    statistics.frame_ms = milliseconds_since(start);
    return statistics;
}

void ScanlineRasterizer::find_visible(const View& view) {
    depth_.assign(offsets_.size(), Image<float>(view.width, view.height, 0.0F));
    owner_.assign(offsets_.size(), Image<std::int32_t>(view.width, view.height, no_triangle));
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        for (std::size_t s = 0; s < offsets_.size(); ++s) {
            draw(static_cast<std::int32_t>(t), s, view);
        }
    }
}

void ScanlineRasterizer::draw(std::int32_t index, std::size_t sample, const View& view) {
    const ScreenTriangle& triangle = triangles_[static_cast<std::size_t>(index)];
    const Edges edges = edges_of(triangle.v);
    if (culled(edges, settings_.cull)) {
        return;
    }
    const DepthPlane<float> plane = depth_plane(triangle.v, edges.double_area);
    const SampleOffset offset = offsets_[sample];
    const float sample_x = 0.5F + static_cast<float>(offset.x) / static_cast<float>(subpixel_one);
    const float sample_y = 0.5F + static_cast<float>(offset.y) / static_cast<float>(subpixel_one);
    walk_triangle(triangle.v, offset, view.width, view.height, [&](int y, int first, int last) {
        for (int x = first; x < last; ++x) {
            const float z =
                plane.at(static_cast<float>(x) + sample_x, static_cast<float>(y) + sample_y);
            if (z > depth_[sample](x, y)) {
                depth_[sample](x, y) = z;
                owner_[sample](x, y) = index;
            }
        }
    });
}

void ScanlineRasterizer::shade_row(const Mesh& mesh, std::span<const Shader> shaders,
                                   const Target& target, int y, Statistics& statistics) {
    row_.assign(static_cast<std::size_t>(owner_[0].width()), target.background);
    std::array<std::int32_t, max_samples> won{};
    const std::span<const std::int32_t> of_pixel(won.data(), offsets_.size());
    for (int x = 0; x < owner_[0].width(); ++x) {
        for (std::size_t s = 0; s < offsets_.size(); ++s) {
            won[s] = owner_[s](x, y);
        }
        const glm::ivec2 centre = glm::ivec2(x, y) * subpixel_one + subpixel_one / 2;
        resolve_pixels(of_pixel, settings_.sample_shading,
                       [&](bool, std::int32_t triangle, std::size_t sample, std::int32_t count) {
                           const SampleOffset o =
                               count == settings_.samples ? SampleOffset{0, 0} : offsets_[sample];
                           const Rgb<float> colour =
                               shade(mesh, shaders, triangle, centre + glm::ivec2(o.x, o.y));
                           const float share =
                               static_cast<float>(count) / static_cast<float>(settings_.samples);
                           row_[static_cast<std::size_t>(x)] +=
                               (colour - target.background) * share;
                           ++statistics.fragments_shaded;
                       });
    }
}

Rgb<float> ScanlineRasterizer::shade(const Mesh& mesh, std::span<const Shader> shaders,
                                     std::int32_t index, glm::ivec2 at) {
    const ScreenTriangle& triangle = triangles_[static_cast<std::size_t>(index)];
    const Shader& shader = shaders[mesh.materials.empty() ? 0 : mesh.materials[triangle.source]];
    won_a_sample_[triangle.source] = 1;
    if (index != corners_of_) {  // neighbours are mostly of one triangle
        corners_ = corner_varyings(shader, mesh, triangle);
        edges_ = edges_of(triangle.v);
        corners_of_ = index;
    }
    return settings_.rasterizer == Rasterizer::reference ? shade_as<double>(shader, triangle, at)
                                                         : shade_as<float>(shader, triangle, at);
}

template <class T>
Rgb<float> ScanlineRasterizer::shade_as(const Shader& shader, const ScreenTriangle& triangle,
                                        glm::ivec2 at) const {
    const auto weights = barycentrics<T>(triangle, edges_, at.x, at.y).space;
    const auto in = interpolate(shader, corners_, weights, rays_, at.x, at.y);
    T rgb[3];
    if constexpr (std::same_as<T, double>) {
        shader.reference(shader.shader, in.data(), 1, 1, rgb);
    } else {
        shader.shade_1(shader.shader, in.data(), 1, 1, rgb);
    }
    return Rgb<float>(rgb[0], rgb[1], rgb[2]);
}

void ScanlineRasterizer::write_row(const Target& target, int y) const {
    for (int x = 0; x < owner_[0].width(); ++x) {
        const Rgb<float>& c = row_[static_cast<std::size_t>(x)];
        if (target.srgb != nullptr) {
            (*target.srgb)(x, y) = {linear_to_srgb(c.r), linear_to_srgb(c.g), linear_to_srgb(c.b),
                                    255};
        }
        if (target.linear != nullptr) {
            (*target.linear)(x, y) = c;
        }
        if (target.depth != nullptr) {
            (*target.depth)(x, y) = depth_[0](x, y);
        }
        if (target.triangle != nullptr) {
            const std::int32_t t = owner_[0](x, y);
            (*target.triangle)(x, y) =
                t == no_triangle
                    ? no_triangle
                    : static_cast<std::int32_t>(triangles_[static_cast<std::size_t>(t)].source);
        }
    }
}

}  // namespace glint
