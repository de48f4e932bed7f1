#include "lessons/17_speed_and_accuracy/forms.hpp"

int main(int argc, char** argv) {
    using namespace glint;
    return run_lesson(
        argc, argv,
        {.name = "17_speed_and_accuracy",
         .title = "Lesson 17: the cheapest forms within 4, 1 and 1/4 code",
         .parameters = thrift::forms,
         .panels = {{{"metals", 3}, {"dielectrics", 2}, {"power", 1}, {"highlights", 3}},
                    {{"metals", 1}, {"dielectrics", 0}, {"power", 1}, {"highlights", 3}},
                    {{"metals", 0}, {"dielectrics", 0}, {"power", 1}, {"highlights", 3}}},
         .stage = thrift::still_life,
         .shaders = shade_each_material(thrift::thrifty)});
}
