#include "framework/raster/renderer.hpp"

#include "framework/raster/samples.hpp"
#include "framework/raster/scanline_rasterizer.hpp"
#include "framework/raster/tiles.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace glint {
namespace {

constexpr int most_threads = 256;
constexpr int largest_side = 16384;

void check(const Settings& s) {
    with_lanes(s.lanes, []<int N>() {});
    sample_offsets(s.samples);
    if (s.threads < 1 || s.threads > most_threads) {
        throw Error("threads: " + std::to_string(s.threads) + " is not within 1..256");
    }
}

void check(const Mesh& mesh, const View& view, std::span<const Shader> shaders) {
    if (view.width < 1 || view.height < 1 || view.width > largest_side ||
        view.height > largest_side) {
        throw Error("picture size: " + std::to_string(view.width) + "x" +
                    std::to_string(view.height) + " is not within 1x1..16384x16384");
    }
    if (mesh.triangles.size() >= piece_bit || mesh.positions.size() > piece_bit / 3) {
        throw Error("mesh: more triangles or vertices than 32 bits can number");
    }
    const auto fits = [](std::size_t size, std::size_t whole) {
        return size == 0 || size == whole;
    };
    if (!fits(mesh.normals.size(), mesh.positions.size()) ||
        !fits(mesh.uvs.size(), mesh.positions.size()) ||
        !fits(mesh.materials.size(), mesh.triangles.size())) {
        throw Error(
            "mesh: normals and uvs are as many as positions, materials as triangles, or none");
    }
    const auto most = std::max_element(mesh.materials.begin(), mesh.materials.end());
    const std::size_t needed = most == mesh.materials.end() ? 1 : *most + std::size_t{1};
    if (shaders.size() < needed) {
        throw Error("shaders: " + std::to_string(shaders.size()) + " for " +
                    std::to_string(needed) + " materials");
    }
}

template <class Pixel>
void resize(Image<Pixel>* image, const View& view) {
    if (image != nullptr && (image->width() != view.width || image->height() != view.height)) {
        *image = Image<Pixel>(view.width, view.height);
    }
}

}  // namespace

struct Renderer::Impl {
    Settings settings;
    std::optional<TileRasterizer> tiles;
    std::optional<ScanlineRasterizer> scanline;

    explicit Impl(const Settings& s) : settings(s) {
        if (s.rasterizer == Rasterizer::tiles) {
            tiles.emplace(s);
        } else {
            scanline.emplace(s);
        }
    }
};

Renderer::Renderer(const Settings& settings) {
    check(settings);
    impl_ = std::make_unique<Impl>(settings);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Settings& Renderer::settings() const {
    return impl_->settings;
}

Statistics Renderer::render(const Mesh& mesh, const View& view, std::span<const Shader> shaders,
                            const Target& target) {
    check(mesh, view, shaders);
    resize(target.srgb, view);
    resize(target.linear, view);
    resize(target.depth, view);
    resize(target.triangle, view);
    return impl_->tiles ? impl_->tiles->render(mesh, view, shaders, target)
                        : impl_->scanline->render(mesh, view, shaders, target);
}

}  // namespace glint
