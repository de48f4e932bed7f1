#include "framework/app/lesson.hpp"

#include "framework/app/panels.hpp"
#include "framework/app/picture.hpp"
#include "framework/app/probe.hpp"
#include "framework/app/statistics.hpp"
#include "framework/app/window.hpp"
#include "framework/geometry/obj.hpp"
#include "framework/image/flip.hpp"
#include "framework/image/heat_map.hpp"
#include "framework/image/metrics.hpp"
#include "framework/image/png.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>

namespace glint {
namespace {

// Beyond, and below its inverse, the squares of distances leave the range of float.
constexpr float largest_extent = 1e18F;

void require_extent(const std::string& file, const Mesh& mesh) {
    const Bounds box = bounds(mesh);
    const glm::vec3 extent = box.high - box.low;
    const float largest = std::max({extent.x, extent.y, extent.z});
    if (!(largest <= largest_extent)) {
        throw Error(file + ": reaches over more than 1e18, too far to be drawn; scale it down");
    }
    if (!(largest >= 1 / largest_extent)) {
        throw Error(file + ": all its triangles lie in one point; there is nothing to draw");
    }
}

void load_mesh(const Options& o, Scene& scene) {
    Obj obj = read_obj(o.scene_file);
    for (const std::string& warning : obj.warnings) {
        std::cerr << "warning: " << warning << '\n';
    }
    require_extent(o.scene_file, obj.mesh);
    scene.mesh = std::move(obj.mesh);
    scene.materials = std::move(obj.materials);
}

void override_materials(const Options& o, std::vector<Material>& materials) {
    for (Material& m : materials) {
        m.diffuse = o.kd.value_or(m.diffuse);
        m.specular = o.ks.value_or(m.specular);
        m.exponent = o.ns.value_or(m.exponent);
    }
}

void override_lights(const Options& o, Lighting& lighting) {
    if (!o.lights.empty() || !o.point_lights.empty()) {
        lighting.directional = o.lights;
        lighting.point = o.point_lights;
    }
    lighting.ambient = o.ambient.value_or(lighting.ambient);
    // What brings no light is not computed.
    const Rgb<float> black(0.0F);
    std::erase_if(lighting.directional,
                  [&](const DirectionalLight& l) { return l.irradiance == black; });
    std::erase_if(lighting.point, [&](const PointLight& l) { return l.intensity == black; });
}

void override_camera(const Options& o, const Mesh& mesh, Camera& camera) {
    camera.fov_degrees = o.fov.value_or(camera.fov_degrees);
    camera.up = o.up.value_or(camera.up);
    const float aspect = static_cast<float>(o.width) / static_cast<float>(o.height);
    if (!o.scene_file.empty()) {
        camera = frame(mesh, camera, aspect);
    }
    const bool moved = o.eye || o.target;
    camera.eye = o.eye.value_or(camera.eye);
    camera.target = o.target.value_or(camera.target);
    if (moved) {
        camera = around(mesh, camera);
    }
    camera.near = o.near.value_or(camera.near);
    camera.far = o.far.value_or(camera.far);
}

void override_by(const Options& o, Scene& scene) {
    override_materials(o, scene.materials);
    override_lights(o, scene.lighting);
    override_camera(o, scene.mesh, scene.camera);
}

// Where the heat map of --compare goes.
std::string heat_map_name(const Options& o) {
    return o.outs.front() + ".diff.png";
}

void print(std::ostream& out, const Metrics& m, const Options& o) {
    out << "against " << o.compare << ": largest difference " << m.max << " codes at " << m.worst_x
        << ',' << m.worst_y << ", RMSE " << m.rmse << ", PSNR " << m.psnr << " dB, SSIM " << m.ssim
        << ", FLIP " << m.flip_mean << ", over one code " << 100 * m.over_one << " %; "
        << heat_map_name(o) << '\n';
}

void probe(const Lesson& lesson, const Options& o) {
    PanelOptions at = panels_of(lesson, o).front();
    for (const PanelOptions& panel : panels_of(lesson, o)) {
        if (panel.left <= o.probe->first) {
            at = panel;
        }
    }
    at.options.probe->first -= at.left;
    std::cout << "pixel " << o.probe->first << ',' << o.probe->second << ", at its centre\n"
              << explain_pixel(lesson, at.options, make_scene(lesson, at.options));
}

void require_place_for(const std::string& file) {
    const auto folder = std::filesystem::path(file).parent_path();
    if (std::filesystem::is_directory(file)) {
        throw Error(file + ": is a folder; name a file");
    }
    if (!folder.empty() && !std::filesystem::is_directory(folder)) {
        throw Error(file + ": there is no folder " + folder.string());
    }
}

void prepare_folders(const Options& o) {
    if (o.outs.front().starts_with("out/")) {
        std::filesystem::create_directories("out");
    }
    for (const std::string& out : o.outs) {
        require_place_for(out);
    }
    require_place_for(o.stats);
    if (!o.compare.empty()) {
        require_place_for(heat_map_name(o));
    }
}

// Everything that can fail for bad input comes before the first file is written.
void draw_picture(const Lesson& lesson, const Options& o) {
    const SrgbImage reference = o.compare.empty() ? SrgbImage() : read_png(o.compare);
    const Drawing drawing = draw_panels(lesson, o);
    const Metrics metrics =
        o.compare.empty() ? Metrics() : measure_difference(reference, drawing.srgb);
    prepare_folders(o);
    for (const std::string& out : o.outs) {
        write_picture(out, drawing);
    }
    std::ostream& words = o.stats == "-" ? std::cerr : std::cout;
    words << summary(lesson, o, drawing) << '\n';
    for (const Plan& plan : drawing.plans) {
        words << plan_table(plan);
    }
    if (!o.compare.empty()) {
        const SrgbImage heat = heat_map(flip_map(reference, drawing.srgb));
        write_png(heat_map_name(o), side_by_side(reference, drawing.srgb, heat));
        print(words, metrics, o);
    }
    if (!o.stats.empty()) {
        write_statistics(lesson, o, drawing);
    }
}

// Those that are read, or those that are written, where given.
void use_files(const Lesson& lesson, const Options& o, bool writing) {
    for (const FileOption& f : lesson.files) {
        const auto given = o.files.find(f.flag);
        if (given != o.files.end() && f.writes == writing) {
            f.use(given->second, o.parameters);
        } else if (given != o.files.end() && f.writes) {
            require_place_for(given->second);
        }
    }
}

int show(const Lesson& lesson, const Options& o) {
    if (o.window) {
        return run_window(lesson, o);
    }
    if (o.probe) {
        probe(lesson, o);
    } else {
        draw_picture(lesson, o);
    }
    return 0;
}

int run(int argc, const char* const* argv, const Lesson& lesson) {
    Options o =
        parse_options(argc, argv, lesson.name, lesson.title, lesson.parameters, lesson.files);
    if (o.outs.empty()) {
        o.outs.push_back("out/" + lesson.name + ".png");
    }
    use_files(lesson, o, false);
    const int code = show(lesson, o);
    use_files(lesson, o, true);
    return code;
}

}  // namespace

Scene make_scene(const Lesson& lesson, const Options& o) {
    Scene scene = lesson.stage(o.parameters);
    if (!o.scene_file.empty()) {
        load_mesh(o, scene);
    }
    override_by(o, scene);
    return scene;
}

Scene make_scene(const Lesson& lesson, const Options& o, const Scene& before) {
    Scene scene = lesson.stage(o.parameters);
    if (!o.scene_file.empty()) {
        scene.mesh = before.mesh;
        scene.materials = before.materials;
    }
    override_by(o, scene);
    return scene;
}

int run_lesson(int argc, const char* const* argv, const Lesson& lesson) {
    try {
        return run(argc, argv, lesson);
    } catch (const Error& e) {
        std::cerr << "error: " << e.what() << '\n';
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
    }
    return 2;
}

}  // namespace glint
