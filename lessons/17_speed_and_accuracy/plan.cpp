// plan [SCENE.obj] [OPTION...]: the cheapest ways to draw a scene with lesson 17's model.
#include "framework/app/plan.hpp"

#include "lessons/17_speed_and_accuracy/forms.hpp"
#include "framework/math/error.hpp"

#include <iostream>

namespace {

using namespace glint;

void print_plans(std::vector<const char*> words) {
    if (words.size() > 1 && words[1][0] != '-') {
        words.insert(words.begin() + 1, "--scene");
    }
    const Lesson lesson{
        .name = "plan",
        .title =
            "Plans for a scene, plan [SCENE.obj] [OPTION...]: the cheapest forms within "
            "--tolerance codes, or within 4, 1, 0.5 and 0.25",
        .parameters = thrift::forms,
        .stage = thrift::still_life,
        .shaders = shade_each_material(thrift::thrifty)};
    Options o = parse_options(static_cast<int>(words.size()), words.data(), lesson.name,
                              lesson.title, lesson.parameters);
    const Scene scene = make_scene(lesson, o);
    std::vector<float> tolerances{4, 1, 0.5F, 0.25F};
    if (o.tolerance > 0) {
        tolerances = {o.tolerance};
    }
    for (const float tolerance : tolerances) {
        o.tolerance = tolerance;
        std::cout << plan_table(make_plan(lesson, o, scene)) << std::flush;
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        print_plans({argv, argv + argc});
        return 0;
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
