#include "framework/app/lesson.hpp"

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

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>

namespace glint {
namespace {

void load_mesh(const Options& o, Scene& scene) {
    Obj obj = read_obj(o.scene_file);
    for (const std::string& warning : obj.warnings) {
        std::cerr << "warning: " << warning << '\n';
    }
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

struct Comparison {
    Metrics metrics;
    std::string heat_map;
};

Comparison compare(const Options& o, const SrgbImage& picture) {
    const SrgbImage reference = read_png(o.compare);
    Comparison c{measure_difference(reference, picture), o.outs.front() + ".diff.png"};
    write_png(c.heat_map, side_by_side(reference, picture, heat_map(flip_map(reference, picture))));
    return c;
}

void print(std::ostream& out, const Comparison& c, const std::string& reference) {
    out << "against " << reference << ": largest difference " << c.metrics.max << " codes at "
        << c.metrics.worst_x << ',' << c.metrics.worst_y << ", RMSE " << c.metrics.rmse << ", PSNR "
        << c.metrics.psnr << " dB, SSIM " << c.metrics.ssim << ", FLIP " << c.metrics.flip_mean
        << ", over one code " << 100 * c.metrics.over_one << " %; " << c.heat_map << '\n';
}

int run(int argc, const char* const* argv, const Lesson& lesson) {
    Options o = parse_options(argc, argv, lesson.name, lesson.title, lesson.parameters);
    if (o.outs.empty()) {
        o.outs.push_back("out/" + lesson.name + ".png");
    }
    const Scene scene = make_scene(lesson, o);
    if (o.window) {
        return run_window(lesson, o, scene);
    }
    if (o.probe) {
        std::cout << explain_pixel(lesson, o, scene);
        return 0;
    }
    const Drawing drawing = draw(lesson, o, scene);
    for (const std::string& out : o.outs) {
        const auto folder = std::filesystem::path(out).parent_path();
        if (!folder.empty() && o.outs.size() == 1 && out.starts_with("out/")) {
            std::filesystem::create_directories(folder);
        }
        write_picture(out, drawing);
    }
    std::ostream& words = o.stats == "-" ? std::cerr : std::cout;
    words << summary(lesson, o, drawing) << '\n';
    if (!o.compare.empty()) {
        print(words, compare(o, drawing.srgb), o.compare);
    }
    if (!o.stats.empty()) {
        write_statistics(o, drawing);
    }
    return 0;
}

}  // namespace

Scene make_scene(const Lesson& lesson, const Options& o) {
    Scene scene = lesson.stage(o.parameters);
    if (!o.scene_file.empty()) {
        load_mesh(o, scene);
    }
    override_materials(o, scene.materials);
    override_lights(o, scene.lighting);
    override_camera(o, scene.mesh, scene.camera);
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
