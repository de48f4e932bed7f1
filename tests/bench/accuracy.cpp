#include "tests/bench/accuracy.hpp"

#include "framework/raster/assemble.hpp"
#include "framework/raster/interpolate.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/setup.hpp"
#include "framework/image/srgb.hpp"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

int nearest_code(double linear) {
    return static_cast<int>(std::lround(255 * std::clamp(srgb_encode(linear), 0.0, 1.0)));
}

// The triangle that each of the mesh's became; no scene of the bench is clipped.
std::vector<ScreenTriangle> by_source(const Mesh& mesh, const View& view) {
    std::vector<ScreenTriangle> all(mesh.triangles.size());
    for (const ScreenTriangle& t : assemble(mesh, view).triangles) {
        all[t.source] = t;
    }
    return all;
}

}  // namespace

ReferencePicture reference_picture(const BenchScene& bench) {
    const Mesh& mesh = bench.scene.mesh;
    Image<std::int32_t> ids;
    GlintFrames(bench, {.cull = Cull::back}).frame(nullptr, &ids);
    const BenchShader shader = bench_shader(bench.scene);
    const Shader plugged = plug(shader);
    const std::vector<ScreenTriangle> triangles = by_source(mesh, bench_view(bench));
    const EyeRays rays = eye_rays(bench_view(bench));
    ReferencePicture reference;
    for (int y = 0; y < bench.height; ++y) {
        for (int x = 0; x < bench.width; ++x) {
            const std::int32_t id = ids(x, y);
            reference.covered.push_back(id != no_triangle);
            if (id == no_triangle) {
                reference.radiance.emplace_back(bench.scene.background);
                continue;
            }
            const ScreenTriangle& t = triangles[static_cast<std::size_t>(id)];
            const std::int64_t at_x = x * subpixel_one + subpixel_one / 2;
            const std::int64_t at_y = y * subpixel_one + subpixel_one / 2;
            const auto weights = barycentrics<double>(t, edges_of(t.v), at_x, at_y).space;
            const auto in =
                interpolate(plugged, corner_varyings(plugged, mesh, t), weights, rays, at_x, at_y);
            double rgb[3];
            plugged.reference(plugged.shader, in.data(), 1, 1, rgb);
            reference.radiance.emplace_back(rgb[0], rgb[1], rgb[2]);
        }
    }
    return reference;
}

Accuracy accuracy(const ReferencePicture& reference, const LinearImage& radiance,
                  const SrgbImage& codes, const std::vector<bool>& covered) {
    Accuracy a;
    std::vector<double> errors;
    std::int64_t off = 0;
    for (std::size_t i = 0; i < reference.radiance.size(); ++i) {
        if (covered[i] != reference.covered[i]) {
            ++a.coverage_differs;
            continue;
        }
        if (!covered[i]) {
            continue;
        }
        const Rgba8 pixel = codes.pixels()[i];
        const int code[] = {pixel.r, pixel.g, pixel.b};
        for (int c = 0; c < 3; ++c) {
            const double exact = reference.radiance[i][c];
            errors.push_back(std::abs(double{radiance.pixels()[i][c]} - exact) / exact);
            const int apart = std::abs(code[c] - nearest_code(exact));
            off += apart > 0 ? 1 : 0;
            a.largest_codes = std::max(a.largest_codes, apart);
        }
    }
    if (!errors.empty()) {
        const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
        std::nth_element(errors.begin(), middle, errors.end());
        a.median_error = *middle;
        a.largest_error = *std::max_element(errors.begin(), errors.end());
        a.share_off_by_one = static_cast<double>(off) / static_cast<double>(errors.size());
    }
    return a;
}

Difference difference(const SrgbImage& a, const SrgbImage& b) {
    Difference d;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgba8 p = a.pixels()[i];
        const Rgba8 q = b.pixels()[i];
        for (const int apart : {std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) {
            d.largest = std::max(d.largest, apart);
            sum += apart;
        }
    }
    d.mean = static_cast<double>(sum) / (3.0 * static_cast<double>(a.pixels().size()));
    return d;
}

}  // namespace glint
