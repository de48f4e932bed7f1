#include "framework/app/probe.hpp"

#include "framework/app/picture.hpp"
#include "framework/raster/assemble.hpp"
#include "framework/raster/interpolate.hpp"
#include "framework/raster/setup.hpp"

#include <array>
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

template <class T>
std::array<T, max_varyings> varyings_at(const Shader& shader, const Mesh& mesh, const Hit& hit,
                                        const Barycentrics<T>& b) {
    std::array<T, max_varyings> values{};
    interpolate(corner_varyings(shader, mesh, hit.triangle), shader.varyings, b.space,
                values.data(), 1);
    return values;
}

void print_geometry(Table& table, const Hit& hit, std::int64_t x, std::int64_t y,
                    const Barycentrics<float>& f, const Barycentrics<double>& d) {
    table.text("triangle " + std::to_string(hit.triangle.source) +
               (hit.triangle.clipped ? " (a piece of it, clipped)" : ""));
    table.line("doubled area, px^2",
               static_cast<double>(hit.edges.double_area) / (subpixel_one * subpixel_one));
    table.line("", "E, 1/65536 px^2", "top or left");
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge& e = hit.edges.edge[i];
        table.line("edge " + std::to_string(i), e.at(x, y) + (e.inclusive ? 0 : 1),
                   e.inclusive ? "yes" : "no");
    }
    table.line("", "float", "double", "difference");
    for (std::size_t i = 0; i < 3; ++i) {
        table.line("screen barycentric " + std::to_string(i), f.screen[i], d.screen[i],
                   f.screen[i] - d.screen[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        table.line("barycentric " + std::to_string(i), f.space[i], d.space[i],
                   f.space[i] - d.space[i]);
    }
    double depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        depth += d.screen[i] * double{hit.triangle.v[i].z};
    }
    table.line("depth", hit.depth, depth, hit.depth - depth);
}

void print_notes(Table& table, const std::vector<Note>& f, const std::vector<Note>& d) {
    for (std::size_t i = 0; i < d.size() && i < f.size(); ++i) {
        for (int c = 0; c < d[i].components; ++c) {
            const auto at = static_cast<std::size_t>(c);
            const std::string suffix = d[i].components == 1 ? "" : std::string(".") + "xyz"[c];
            table.line(std::string(d[i].name) + suffix, f[i].value[at], d[i].value[at],
                       f[i].value[at] - d[i].value[at]);
        }
    }
}

}  // namespace

std::string explain_pixel(const Lesson& lesson, const Options& o, const Scene& scene) {
    const View view = view_of(scene, o.width, o.height);
    const auto [px, py] = *o.probe;
    const std::int64_t x = px * subpixel_one + subpixel_one / 2;
    const std::int64_t y = py * subpixel_one + subpixel_one / 2;
    Table table;
    table.text("pixel " + std::to_string(px) + "," + std::to_string(py) + ", at its centre");
    const std::optional<Hit> hit = winner(scene.mesh, view, o.settings.cull, x, y);
    if (!hit) {
        table.text("nothing is drawn here");
        return table.str();
    }
    const ShaderSet set = lesson.shaders(scene, o.parameters);
    const std::uint16_t material = scene.mesh.materials.empty()
                                       ? std::uint16_t{0}
                                       : scene.mesh.materials[hit->triangle.source];
    const Shader& shader = set.shaders[material];
    const auto f = barycentrics<float>(hit->triangle, hit->edges, x, y);
    const auto d = barycentrics<double>(hit->triangle, hit->edges, x, y);
    table.text("material " + scene.materials[material].name);
    print_geometry(table, *hit, x, y, f, d);

    const auto in_float = varyings_at<float>(shader, scene.mesh, *hit, f);
    const auto in_double = varyings_at<double>(shader, scene.mesh, *hit, d);
    if (shader.explain_float != nullptr) {
        std::vector<Note> notes_float;
        std::vector<Note> notes_double;
        shader.explain_float(shader.shader, in_float.data(), notes_float);
        shader.explain_double(shader.shader, in_double.data(), notes_double);
        print_notes(table, notes_float, notes_double);
    }
    float rgb_float[3];
    double rgb_double[3];
    shader.shade_1(shader.shader, in_float.data(), 1, 1, rgb_float);
    shader.reference(shader.shader, in_double.data(), 1, 1, rgb_double);
    for (int c = 0; c < 3; ++c) {
        table.line(std::string("radiance.") + "rgb"[c], rgb_float[c], rgb_double[c],
                   rgb_float[c] - rgb_double[c]);
    }
    return table.str();
}

}  // namespace glint
