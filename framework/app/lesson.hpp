// What a lesson's main() hands over, and the program that it becomes.
#pragma once

#include "framework/app/options.hpp"
#include "framework/scene/scene.hpp"
#include "framework/raster/plug.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace glint {

// One shader a material, and the memory that they live in.
struct ShaderSet {
    std::shared_ptr<const void> owner;
    std::vector<Shader> shaders;
};

// Values of parameters that a part of the picture is drawn with.
using Panel = std::vector<std::pair<std::string, float>>;

struct Lesson {
    std::string name;   // of its folder, NN_name
    std::string title;  // a line
    Parameters parameters{};
    // Left to right; empty: one picture, of the parameters as they stand. Panels that differ in a
    // parameter are not drawn when the command line sets it.
    std::vector<Panel> panels{};
    std::function<Scene(const Parameters&)> stage;
    std::function<ShaderSet(const Scene&, const Parameters&)> shaders;
    std::vector<FileOption> files{};
};

// Lesson::shaders from a function make(scene, material, parameters) that returns a fragment shader.
template <class Make>
auto shade_each_material(Make make) {
    return [make](const Scene& scene, const Parameters& parameters) {
        using S = decltype(make(scene, scene.materials.front(), parameters));
        auto all = std::make_shared<std::vector<S>>();
        for (const Material& material : scene.materials) {
            all->push_back(make(scene, material, parameters));
        }
        ShaderSet set{.owner = all, .shaders = {}};
        for (const S& shader : *all) {
            set.shaders.push_back(plug(shader));
        }
        return set;
    };
}

// The scene that the options ask for: the lesson's stage or a file, and what overrides it; lights
// that are black are left out. Warnings about a file go to standard error. Error where it cannot be
// had.
Scene make_scene(const Lesson& lesson, const Options& options);

// The same where `before` was made for the same file, which is not read again.
Scene make_scene(const Lesson& lesson, const Options& options, const Scene& before);

// Does what the command line says; returns main()'s exit code: 0, or 2 with one line on standard
// error where the command line or a file is at fault, and then nothing is written.
int run_lesson(int argc, const char* const* argv, const Lesson& lesson);

}  // namespace glint
