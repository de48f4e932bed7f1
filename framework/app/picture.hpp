// A lesson's picture, in any of its views, and what it took to draw it.
#pragma once

#include "framework/app/lesson.hpp"
#include "framework/app/plan.hpp"
#include "framework/image/image.hpp"

#include <string>
#include <vector>

namespace glint {

struct Drawing {
    SrgbImage srgb;
    LinearImage linear;              // shaded and normal views, where asked for
    Image<float> values;             // raw values of the other views
    std::vector<Statistics> frames;  // one a frame
    std::vector<Plan> plans;         // one a panel, where there is a tolerance
};

// Draws options.frames times, by a plan if there is a tolerance, before that once more if there are
// several, so that none pays for the first touch of memory. The views depth, triangle, overdraw and
// tiles take one sample a pixel.
Drawing draw(const Lesson& lesson, const Options& options, const Scene& scene);

// The settings that options.view is drawn with.
Settings settings_for(const Options& options);

View view_of(const Scene& scene, int width, int height);

// The window of a view as a picture: for the live window, which keeps its renderer.
class Renderer;
Drawing draw_view(ViewMode mode, Renderer& renderer, const Scene& scene, const View& view,
                  std::span<const Shader> shaders, bool linear);

// PNG: what is seen. PFM: linear radiance, or the raw values of the view.
void write_picture(const std::string& path, const Drawing& drawing);

}  // namespace glint
