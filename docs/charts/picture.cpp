#include "docs/charts/picture.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace glint::charts {
namespace {

LinearImage draw(const Stage& stage, const View& view, Renderer& renderer) {
    LinearImage linear;
    renderer.render(stage.scene.mesh, view, stage.shading.shaders,
                    {.linear = &linear, .background = stage.scene.background});
    return linear;
}

// The view with the picture moved by so many pixels to the right and down.
View moved(const View& view, float right, float down) {
    const glm::vec3 shift(2 * right / static_cast<float>(view.width),
                          -2 * down / static_cast<float>(view.height), 0);
    View v = view;
    v.clip_from_world = glm::translate(glm::mat4(1.0F), shift) * view.clip_from_world;
    return v;
}

glm::dvec3 codes_of(const glm::dvec3& linear) {
    return {code_of(linear.r), code_of(linear.g), code_of(linear.b)};
}

}  // namespace

Codes draw_codes(const Stage& stage, const Settings& settings) {
    Renderer renderer(settings);
    const LinearImage linear = draw(stage, stage.view, renderer);
    Codes codes(linear.width(), linear.height());
    for (std::size_t i = 0; i < linear.pixels().size(); ++i) {
        codes.pixels()[i] = codes_of(glm::dvec3(linear.pixels()[i]));
    }
    return codes;
}

Codes draw_256_samples(const Stage& stage) {
    constexpr int side = 16;
    Renderer renderer(Settings{});
    Codes mean(stage.view.width, stage.view.height, glm::dvec3(0));
    for (int i = 0; i < side * side; ++i) {
        const auto offset = [](int step) {
            return (static_cast<float>(step) + 0.5F) / side - 0.5F;
        };
        const View view = moved(stage.view, offset(i % side), offset(i / side));
        const LinearImage once = draw(stage, view, renderer);
        for (std::size_t p = 0; p < once.pixels().size(); ++p) {
            mean.pixels()[p] += glm::dvec3(once.pixels()[p]) / double{side * side};
        }
    }
    for (glm::dvec3& pixel : mean.pixels()) {
        pixel = codes_of(pixel);
    }
    return mean;
}

Errors difference(const Codes& picture, const Codes& reference) {
    ErrorSum sum;
    for (std::size_t i = 0; i < reference.pixels().size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            sum.add(picture.pixels()[i][k] - reference.pixels()[i][k]);
        }
    }
    return sum.errors();
}

Contender frame_contender(const std::string& method, const std::shared_ptr<const Stage>& stage,
                          const Settings& settings, std::vector<Judgement> judgements) {
    const auto renderer = std::make_shared<Renderer>(settings);
    const auto picture = std::make_shared<SrgbImage>();
    const auto work = [=] {
        renderer->render(stage->scene.mesh, stage->view, stage->shading.shaders,
                         {.srgb = picture.get(), .background = stage->scene.background});
    };
    return {method, work, double(stage->view.width) * stage->view.height, std::move(judgements)};
}

}  // namespace glint::charts
