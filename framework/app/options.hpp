// The command line of every lesson program.
#pragma once

#include "framework/scene/scene.hpp"
#include "framework/raster/pipeline.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glint {

// A number that a lesson lets its user move.
struct Parameter {
    std::string name;
    float value;
    float low, high;
    std::string meaning;
    bool whole = false;  // takes whole numbers only
    // Names of the values 0, 1, ..., where these are the same thing computed ever more cheaply and
    // less accurately: --tolerance chooses among them.
    std::vector<std::string> forms{};
};

class Parameters {
  public:
    Parameters() = default;
    Parameters(std::initializer_list<Parameter> all) : all_(all) {}
    // The value of a parameter that the lesson declared; Error for other names.
    float operator[](std::string_view name) const;
    // Error for unknown names and values that the parameter does not take.
    void set(std::string_view name, float value);
    std::vector<Parameter>& all() { return all_; }
    const std::vector<Parameter>& all() const { return all_; }

  private:
    std::vector<Parameter> all_;
};

// A file that one lesson's program takes besides meshes and pictures.
struct FileOption {
    std::string flag, type, meaning;  // "--read", "FILE.binary", what for
    std::function<void(const std::string& path, const Parameters&)> use;
    bool writes = false;  // used last, when all else is done, and ends as type does; else first
};

enum class ViewMode { shaded, normal, depth, triangle, overdraw, tiles };

struct Options {
    std::string scene_file;  // empty: the lesson's stage
    std::optional<glm::vec3> kd, ks;
    std::optional<float> ns;
    int width = 960, height = 540;
    std::optional<glm::vec3> eye, target, up;
    std::optional<float> fov, near, far;
    std::vector<DirectionalLight> lights;
    std::vector<PointLight> point_lights;
    std::optional<glm::vec3> ambient;
    Settings settings;
    ViewMode view = ViewMode::shaded;
    std::vector<std::string> outs;
    int frames = 0;       // 0: one picture, or a window until it is closed
    float tolerance = 0;  // sRGB codes that colours may be off by, see plan.hpp; 0: the full model
    std::string stats;    // file, "-" for standard output, empty for none
    std::optional<std::pair<int, int>> probe;
    std::string compare;
    bool window = false;
    Parameters parameters;
    std::vector<std::string> set;              // the parameters that --set named
    std::map<std::string, std::string> files;  // path by flag of a FileOption
};

// What is asked for, with Error for what cannot be. --help prints and ends the program with 0.
Options parse_options(int argc, const char* const* argv, const std::string& name,
                      const std::string& title, const Parameters& parameters,
                      const std::vector<FileOption>& files = {});

}  // namespace glint
