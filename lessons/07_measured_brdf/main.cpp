#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/07_measured_brdf/capture.hpp"
#include "framework/app/lesson.hpp"
#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace glint;

// What is put under the gonioreflectometer: a formula, or what a file has of something real. And
// the table that it was written to, if one is to be drawn by.
struct Sample {
    LambertPhong formula;
    MeasuredBrdf file, table;
    Rgb<float> ambient;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return table.table ? table(g) : file.table ? file(g) : formula(g);
    }
    Rgb<float> ambient_albedo() const { return ambient; }
};

// A knot, shaded, and the error that the table makes on it. One lamp is low behind it.
Scene two_knots(const Parameters&) {
    Scene s;
    s.materials.clear();
    for (const char* name : {"shaded", "error"}) {
        s.materials.push_back({.name = name,
                               .diffuse = Rgb<float>(0.36F, 0.12F, 0.06F),
                               .specular = Rgb<float>(0.6F),
                               .exponent = 120});
    }
    const Mesh knot = torus_knot({.tube = 0.3F}, 256, 32);
    for (const float y : {1.45F, -1.45F}) {
        const glm::mat4 there = glm::translate(glm::mat4(1.0F), glm::vec3(0, y, 0));
        append(s.mesh,
               transform(knot, glm::rotate(glm::scale(there, glm::vec3(0.76F)), 1.45F,
                                           glm::vec3(1, 0.25F, 0))),
               y > 0 ? 0 : 1);
    }
    s.lighting.directional = {{normalize(glm::vec3(-0.5F, 0.6F, 0.8F)), Rgb<float>(1.0F)},
                              {normalize(glm::vec3(0.6F, 0.5F, -0.5F)), Rgb<float>(1.0F)}};
    s.lighting.ambient = Rgb<float>(0.06F, 0.07F, 0.09F);
    s.camera = {.eye = {0, 0, 19}, .fov_degrees = 17.6F, .near = 15, .far = 24};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

struct TableAndTruth {
    Lit<Sample> table, truth;
    bool shows_error;

    template <class T>
    using Varyings = Lit<Sample>::Varyings<T>;
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Rgb<T> radiance = table(in, note);
        if (!shows_error) {
            return radiance;
        }
        const Rgb<T> difference = radiance - truth(in);
        const Rgb<T> off{abs(difference.r), abs(difference.g), abs(difference.b)};
        note("error of the radiance", off);
        return off;
    }
};

class Bench {
  public:
    void read(const std::string& path, const Parameters&) {
        file_.table = table_of(read_merl(path));
    }
    void write(const std::string& path, const Parameters& p) const {
        const Material m = two_knots(p).materials.front();
        write_merl(path, measure(sample_of(m), p));
    }
    auto shader(const Scene& s, const Material& m, const Parameters& p) const {
        const Sample truth = sample_of(m);
        Sample table = truth;
        if (p["size"] > 0) {
            table.table.table = table_of(measure(truth, p));
        }
        return TableAndTruth{{table, s.lighting, s.camera.eye},
                             {truth, s.lighting, s.camera.eye},
                             m.name == "error" && p["error"] > 0};
    }

  private:
    Sample sample_of(const Material& m) const {
        Sample sample{{m.diffuse, m.specular, m.exponent}, file_, {}, Rgb<float>(0.0F)};
        sample.ambient = Rgb<float>(mean_albedo(sample));
        return sample;
    }
    static MerlBrdf measure(const Sample& sample, const Parameters& p) {
        const int size = p["size"] > 0 ? static_cast<int>(p["size"]) : 90;
        return capture(sample, size, size, 2 * size);
    }
    MeasuredBrdf file_{};
};

}  // namespace

int main(int argc, char** argv) {
    Bench bench;
    return run_lesson(
        argc, argv,
        {.name = "07_measured_brdf",
         .title = "Lesson 7: a BRDF that was measured, by tables of four sizes",
         .parameters = {{"size", 90, 0, 128, "of the table, size x size x 2 size; 0: none", true},
                        {"error", 1, 0, 1, "1: the lower knot shows the error", true}},
         .panels = {{{"size", 4}}, {{"size", 10}}, {{"size", 25}}, {{"size", 90}}},
         .stage = two_knots,
         .shaders = shade_each_material([&](const Scene& s, const Material& m,
                                            const Parameters& p) { return bench.shader(s, m, p); }),
         .files = {
             {"--read", "FILE.binary", "measure this BRDF of the MERL database, not a formula",
              [&](const std::string& path, const Parameters& p) { bench.read(path, p); }},
             {"--write", "FILE.binary", "write the table, of the parameter size",
              [&](const std::string& path, const Parameters& p) { bench.write(path, p); }, true}}});
}
