#include "framework/app/picture.hpp"

#include "framework/app/debug_views.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/renderer.hpp"
#include "framework/image/pfm.hpp"
#include "framework/image/png.hpp"

#include <algorithm>

namespace glint {
namespace {

bool shows_surfaces(ViewMode mode) {
    return mode == ViewMode::shaded || mode == ViewMode::normal;
}

const NormalView normal_view;

std::vector<Shader> shaders_of(ViewMode mode, std::span<const Shader> shaders) {
    return mode == ViewMode::normal ? std::vector<Shader>(shaders.size(), plug(normal_view))
                                    : std::vector<Shader>(shaders.begin(), shaders.end());
}

}  // namespace

Settings settings_for(const Options& o) {
    Settings settings = o.settings;
    if (!shows_surfaces(o.view)) {
        settings.samples = 1;
    }
    return settings;
}

View view_of(const Scene& scene, int width, int height) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    return {clip_from_world(scene.camera, aspect), width, height};
}

Drawing draw_view(ViewMode mode, Renderer& renderer, const Scene& scene, const View& view,
                  std::span<const Shader> shaders, bool linear) {
    Drawing d;
    Image<float> depth;
    Image<std::int32_t> triangle;
    Target target{.srgb = &d.srgb, .background = scene.background};
    if (shows_surfaces(mode)) {
        target.linear = linear ? &d.linear : nullptr;
    } else {
        target.depth = &depth;
        target.triangle = &triangle;
    }
    d.frames.push_back(renderer.render(scene.mesh, view, shaders_of(mode, shaders), target));
    switch (mode) {
        case ViewMode::shaded:
        case ViewMode::normal:
            break;
        case ViewMode::depth:
            d.srgb = depth_picture(depth);
            d.values = std::move(depth);
            break;
        case ViewMode::triangle:
            d.srgb = triangle_picture(triangle);
            d.values = as_floats(triangle);
            break;
        case ViewMode::overdraw:
            d.values = overdraw(scene.mesh, view, renderer.settings().cull);
            d.srgb = count_picture(d.values);
            break;
        case ViewMode::tiles:
            d.values = triangles_by_tile(scene.mesh, view, renderer.settings());
            d.srgb = tile_picture(d.values);
            break;
    }
    return d;
}

// By the parameters as they are, whatever the tolerance.
static Drawing draw_by_parameters(const Lesson& lesson, const Options& o, const Scene& scene) {
    Renderer renderer(settings_for(o));
    const ShaderSet shading = lesson.shaders(scene, o.parameters);
    const View view = view_of(scene, o.width, o.height);
    const bool linear = std::any_of(o.outs.begin(), o.outs.end(),
                                    [](const std::string& out) { return out.ends_with(".pfm"); });
    Drawing drawing = draw_view(o.view, renderer, scene, view, shading.shaders, linear);
    if (o.frames > 1) {
        drawing.frames.clear();
        SrgbImage again;
        const std::vector<Shader> shaders = shaders_of(o.view, shading.shaders);
        const Target target{.srgb = &again, .background = scene.background};
        for (int i = 0; i < o.frames; ++i) {
            drawing.frames.push_back(renderer.render(scene.mesh, view, shaders, target));
        }
    }
    return drawing;
}

Drawing draw(const Lesson& lesson, const Options& o, const Scene& scene) {
    if (o.tolerance > 0 && o.view == ViewMode::shaded) {
        const Plan plan = make_plan(lesson, o, scene);
        Drawing drawing = draw_by_parameters(lesson, planned(plan, o), scene);
        drawing.plans.push_back(plan);
        return drawing;
    }
    return draw_by_parameters(lesson, o, scene);
}

void write_picture(const std::string& path, const Drawing& drawing) {
    if (path.ends_with(".png")) {
        write_png(path, drawing.srgb);
    } else if (drawing.values.empty()) {
        write_pfm(path, drawing.linear);
    } else {
        write_pfm(path, drawing.values);
    }
}

}  // namespace glint
