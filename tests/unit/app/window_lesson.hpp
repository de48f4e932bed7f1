// A lesson for the tests of the live window: a ball that shows its normals, with a parameter that
// its shader takes and one that its stage does.
#pragma once

#include "framework/app/lesson.hpp"
#include "framework/geometry/shapes.hpp"

namespace glint {

struct NormalsAt {
    float level;
    template <class T>
    struct Varyings {
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Rgb<T> colour = level * (0.5F * (in.normal + Vec3<T>(T(1.0F))));
        note("colour", colour);
        return colour;
    }
};

inline Lesson window_lesson() {
    return {.name = "00_window",
            .title = "A ball",
            .parameters = {{"level", 0.5F, 0, 1, "brightness"}, {"day", 0, 0, 1, "0 or 1", true}},
            .stage =
                [](const Parameters& p) {
                    Scene s;
                    s.mesh = sphere(1, 24, 12);
                    s.camera = {.eye = {0, 0, 4}, .near = 1, .far = 10};
                    s.background = Rgb<float>(p["day"]);
                    return s;
                },
            .shaders = shade_each_material([](const Scene&, const Material&, const Parameters& p) {
                return NormalsAt{p["level"]};
            })};
}

inline Lesson window_lesson_in_panels() {
    Lesson lesson = window_lesson();
    lesson.panels = {{{"level", 0.25F}}, {{"level", 0.75F}}, {{"level", 1.0F}, {"day", 1.0F}}};
    return lesson;
}

inline Options window_options() {
    Options o;
    o.width = 121;
    o.height = 80;
    o.settings = {.lanes = 4, .threads = 2, .samples = 2};
    o.parameters = window_lesson().parameters;
    o.outs = {"ball.png"};
    return o;
}

}  // namespace glint
