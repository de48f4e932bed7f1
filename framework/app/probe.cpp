#include "framework/app/probe.hpp"

#include "framework/app/picture.hpp"
#include "framework/raster/assemble.hpp"
#include "framework/raster/interpolate.hpp"
#include "framework/raster/setup.hpp"

#include <iomanip>
#include <optional>
#include <sstream>

namespace glint {
namespace {

// The triangle that wins a sample, found as the rasterizers' contract says it.
struct Hit {
    ScreenTriangle triangle;
    Edges edges;
    float depth;
};

std::optional<Hit> winner(const Mesh& mesh, const View& view, Cull cull, std::int64_t x,
                          std::int64_t y) {
    std::optional<Hit> best;
    const float to_pixel = 1.0F / static_cast<float>(subpixel_one);
    for (const ScreenTriangle& t : assemble(mesh, view).triangles) {
        const Edges e = edges_of(t.v);
        if (culled(e, cull) || e.edge[0].at(x, y) < 0 || e.edge[1].at(x, y) < 0 ||
            e.edge[2].at(x, y) < 0) {
            continue;
        }
        const float depth =
            depth_plane(t.v, e.double_area)
                .at(static_cast<float>(x) * to_pixel, static_cast<float>(y) * to_pixel);
        if (depth > (best ? best->depth : 0.0F)) {
            best = Hit{t, e, depth};
        }
    }
    return best;
}

std::vector<Reading> barycentric_readings(const std::string& name, const auto& f, const auto& d) {
    std::vector<Reading> all;
    for (std::size_t i = 0; i < 3; ++i) {
        all.push_back({name + std::to_string(i), double{f[i]}, d[i]});
    }
    return all;
}

void add_geometry(PixelReport& report, const Hit& hit, std::int64_t x, std::int64_t y,
                  const Barycentrics<float>& f, const Barycentrics<double>& d) {
    report.words.push_back("triangle " + std::to_string(hit.triangle.source) +
                           (hit.triangle.clipped ? " (a piece of it, clipped)" : ""));
    report.doubled_area =
        static_cast<double>(hit.edges.double_area) / (subpixel_one * subpixel_one);
    for (const Edge& e : hit.edges.edge) {
        report.edges.push_back({e.at(x, y) + (e.inclusive ? 0 : 1), e.inclusive});
    }
    report.screen = barycentric_readings("screen barycentric ", f.screen, d.screen);
    report.readings = barycentric_readings("barycentric ", f.space, d.space);
    double depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        depth += d.screen[i] * double{hit.triangle.v[i].z};
    }
    report.readings.push_back({"depth", double{hit.depth}, depth});
}

void add_notes(PixelReport& report, const std::vector<Note>& f, const std::vector<Note>& d) {
    for (std::size_t i = 0; i < d.size() && i < f.size(); ++i) {
        for (int c = 0; c < d[i].components; ++c) {
            const auto at = static_cast<std::size_t>(c);
            const std::string suffix = d[i].components == 1 ? "" : std::string(".") + "xyz"[c];
            report.readings.push_back(
                {std::string(d[i].name) + suffix, f[i].value[at], d[i].value[at]});
        }
    }
}

void add_shading(PixelReport& report, const Shader& shader, const float* in_float,
                 const double* in_double) {
    if (shader.explain_float != nullptr) {
        std::vector<Note> notes_float;
        std::vector<Note> notes_double;
        shader.explain_float(shader.shader, in_float, notes_float);
        shader.explain_double(shader.shader, in_double, notes_double);
        add_notes(report, notes_float, notes_double);
    }
    float rgb_float[3];
    double rgb_double[3];
    shader.shade_1(shader.shader, in_float, 1, 1, rgb_float);
    shader.reference(shader.shader, in_double, 1, 1, rgb_double);
    for (int c = 0; c < 3; ++c) {
        report.readings.push_back(
            {std::string("radiance.") + "rgb" [c], double { rgb_float[c] }, rgb_double[c]});
    }
}

class Table {
  public:
    Table() { out_ << std::setprecision(9); }

    template <class... Values>
    void line(const std::string& name, const Values&... values) {
        out_ << std::left << std::setw(24) << name << std::right;
        ((out_ << std::setw(18) << values), ...);
        out_ << '\n';
    }
    void text(const std::string& words) { out_ << words << '\n'; }
    std::string str() const { return out_.str(); }

  private:
    std::ostringstream out_;
};

}  // namespace

PixelReport probe_pixel(const Lesson& lesson, const Options& o, const Scene& scene) {
    const View view = view_of(scene, o.width, o.height);
    const auto [px, py] = *o.probe;
    const std::int64_t x = px * subpixel_one + subpixel_one / 2;
    const std::int64_t y = py * subpixel_one + subpixel_one / 2;
    PixelReport report;
    const std::optional<Hit> hit = winner(scene.mesh, view, o.settings.cull, x, y);
    if (!hit) {
        report.words.emplace_back("nothing is drawn here");
        return report;
    }
    const ShaderSet set = lesson.shaders(scene, o.parameters);
    const std::uint16_t material = scene.mesh.materials.empty()
                                       ? std::uint16_t{0}
                                       : scene.mesh.materials[hit->triangle.source];
    const Shader& shader = set.shaders[material];
    const auto f = barycentrics<float>(hit->triangle, hit->edges, x, y);
    const auto d = barycentrics<double>(hit->triangle, hit->edges, x, y);
    report.words.push_back("material " + scene.materials[material].name);
    add_geometry(report, *hit, x, y, f, d);
    const CornerVaryings corners = corner_varyings(shader, scene.mesh, hit->triangle);
    const EyeRays rays = eye_rays(view);
    add_shading(report, shader, interpolate(shader, corners, f.space, rays, x, y).data(),
                interpolate(shader, corners, d.space, rays, x, y).data());
    return report;
}

std::string explain_pixel(const Lesson& lesson, const Options& options, const Scene& scene) {
    const PixelReport report = probe_pixel(lesson, options, scene);
    Table table;
    for (const std::string& words : report.words) {
        table.text(words);
    }
    if (report.edges.empty()) {
        return table.str();
    }
    table.line("doubled area, px^2", report.doubled_area);
    table.line("", "E, 1/65536 px^2", "top or left");
    for (std::size_t i = 0; i < report.edges.size(); ++i) {
        table.line("edge " + std::to_string(i), report.edges[i].value,
                   report.edges[i].inclusive ? "yes" : "no");
    }
    table.line("", "float", "double", "difference");
    for (const auto* readings : {&report.screen, &report.readings}) {
        for (const Reading& r : *readings) {
            table.line(r.name, r.in_float, r.in_double, r.in_float - r.in_double);
        }
    }
    return table.str();
}

}  // namespace glint
