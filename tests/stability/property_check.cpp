#include "tests/stability/property_check.hpp"

#include "framework/raster/assemble.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/setup.hpp"
#include "framework/raster/tile.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace glint::stability {
namespace {

struct ShowNormal {
    template <class T>
    struct Varyings {
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return in.normal;
    }
};
constexpr ShowNormal show_normal;

// What is allowed at a pixel, as far as that can be said.
struct Allowed {
    Rgb<double> most{std::numeric_limits<double>::infinity()};
    Rgb<double> base{std::numeric_limits<double>::infinity()};  // difference of colours, and ...
    Rgb<double> share{0};                                       // ... as a share of the colour
};

class Judge {
  public:
    Judge(const World& world, std::span<const Shader> shaders)
        : world_(world),
          shaders_(shaders),
          view_{clip_from_world(world.camera,
                                static_cast<float>(world.width) / static_cast<float>(world.height)),
                world.width, world.height} {}

    std::string verdict() {
        Settings settings = world_.settings;
        settings.rasterizer = Rasterizer::scanline;
        const Drawn scanline = drawn(shaders_, settings);
        find_allowed(scanline, settings);
        std::string fault = fault_alone(scanline);
        if (!fault.empty()) {
            return fault + " (scanline)";
        }
        settings.rasterizer = Rasterizer::tiles;
        for (const int lanes : all_lanes()) {
            settings.lanes = lanes;
            settings.threads = 1;
            const Drawn tiles = drawn(shaders_, settings);
            fault = fault_alone(tiles) + fault_beside(tiles, scanline);
            if (fault.empty() && lanes == lanes_for_threads()) {
                settings.threads = 2 + static_cast<int>(world_.seed % 6);
                fault = fault_of_threads(drawn(shaders_, settings), tiles);
            }
            if (!fault.empty()) {
                return fault + " (" + glint::words(settings) + ")";
            }
        }
        return {};
    }

  private:
    Drawn drawn(std::span<const Shader> shaders, const Settings& settings) const {
        return draw(world_.mesh, view_, shaders, settings);
    }

    int lanes_for_threads() const {
        const std::vector<int> lanes = all_lanes();
        return lanes[world_.seed % lanes.size()];
    }

    // How uncertain a triangle's interpolants are, in units of float's precision: the more the
    // thinner it is and the more its depth varies.
    std::vector<double> uncertainties() const {
        std::vector<double> all(world_.mesh.triangles.size(), 1);
        for (const ScreenTriangle& t : assemble(world_.mesh, view_).triangles) {
            const Edges edges = edges_of(t.v);
            double longest = 1;
            for (const Edge& e : edges.edge) {
                longest = std::max(longest,
                                   std::hypot(static_cast<double>(e.a), static_cast<double>(e.b)));
            }
            const auto [far, near] =
                std::minmax({t.v[0].inverse_w, t.v[1].inverse_w, t.v[2].inverse_w});
            const double height =
                std::abs(static_cast<double>(edges.double_area)) / longest / subpixel_one;
            all[t.source] = std::max(all[t.source], (1 + tile_size / height) * double{near / far});
        }
        return all;
    }

    void find_allowed(const Drawn& scanline, const Settings& settings) {
        allowed_ = Image<Allowed>(world_.width, world_.height);
        if (settings.samples > 1) {
            return;  // pixels are mixtures
        }
        const std::vector<Shader> positions(shaders_.size(), plug(show_position));
        const std::vector<Shader> normals(shaders_.size(), plug(show_normal));
        const LinearImage position = drawn(positions, settings).linear;
        const LinearImage normal = drawn(normals, settings).linear;
        const std::vector<double> uncertain = uncertainties();
        for (std::size_t i = 0; i < allowed_.pixels().size(); ++i) {
            const std::int32_t t = scanline.triangle.pixels()[i];
            allowed_.pixels()[i] =
                t == no_triangle
                    ? Allowed{Rgb<double>(0), Rgb<double>(0)}
                    : allowed(glm::dvec3(position.pixels()[i]), glm::dvec3(normal.pixels()[i]),
                              static_cast<std::size_t>(t), uncertain[static_cast<std::size_t>(t)]);
        }
    }

    // What arrives at a point, and how well it is known there.
    struct Lit {
        Rgb<double> arrives{0};
        double angle = 0;       // how far directions are off, in radians
        bool grazing = false;   // some N.L is near 0: what it multiplies is all of the error
        bool opposite = false;  // some L is near -V, where L.H is steep
    };

    Allowed allowed(const glm::dvec3& p, const glm::dvec3& normal, std::size_t triangle,
                    double uncertain) const {
        const glm::uvec3 v = world_.mesh.triangles[triangle];
        double extent = 0;
        double bend = 0;
        for (int i = 0; i < 3; ++i) {
            extent = std::max(extent, length(glm::dvec3(world_.mesh.positions[v[i]]) - p));
            bend = std::max(bend, length(glm::dvec3(world_.mesh.normals[v[i]]) - normal));
        }
        const double unit = 0x1p-21 * uncertain;
        const double place = unit * extent + 0x1p-22 * (1 + length(p));
        const glm::dvec3 to_eye = glm::dvec3(world_.camera.eye) - p;
        Lit lit;
        lit.angle =
            0x1p-21 + unit * bend / std::max(length(normal), 1e-30) + place / length(to_eye);
        const auto add = [&](const glm::dvec3& L, const Rgb<double>& irradiance) {
            lit.arrives += irradiance;
            lit.grazing |= !(std::abs(dot(normal, L)) > 0.02 * length(normal) * length(L));
            lit.opposite |= dot(to_eye, L) < -0.9 * length(to_eye) * length(L);
        };
        for (const DirectionalLight& light : world_.lighting.directional) {
            add(light.direction, light.irradiance);
        }
        for (const PointLight& light : world_.lighting.point) {
            const glm::dvec3 way = glm::dvec3(light.position) - p;
            lit.angle += 2 * place / std::max(length(way), 1e-30);
            const double nearest =
                std::max(length(way) - place, 0.999 * double{nearest_point_light});
            add(way, Rgb<double>(light.intensity) / (nearest * nearest));
        }
        return limits(world_.surfaces[world_.mesh.materials[triangle]], lit);
    }

    Allowed limits(const Surface& surface, const Lit& lit) const {
        const double n = double{surface.n};
        const double peak = 0.5 * n + 1;
        double of_peak = 3e-5 * lit.angle;  // of Schlick's slope along the normal
        if (n < 20 || lit.grazing) {
            of_peak += (8 + 4 * std::min(n, 20.0)) * lit.angle;
        }
        if (n < 1) {
            of_peak += std::pow(8 * lit.angle, n);  // its lobe begins with an infinite slope
        }
        if (world_.model == Model::consistent && lit.opposite) {
            of_peak += 8 * std::sqrt(lit.angle);
        }
        Allowed a;
        for (int band = 0; band < 3; ++band) {
            const double ambient = double{world_.lighting.ambient[band] * surface.Cd[band]};
            const double arrives = lit.arrives[band];
            a.most[band] = 1.0001 * (ambient + stated_brightest(surface, band) * arrives) + 1e-30;
            if (lit.angle * (n + 1) < 0.05) {
                a.base[band] =
                    (2 * lit.angle + of_peak * peak) * arrives + 0x1p-20 * ambient + 1e-30;
            }
            // Schlick's F changes most, relatively, where it is 5 F0.
            const double slope = 3.1 * std::pow(std::max(double{surface.F0[band]}, 1e-7), -0.2);
            a.share[band] = lit.angle * (8 + slope + 4 * n) + 0x1p-20;
        }
        return a;
    }

    std::string at(std::size_t pixel) const {
        const auto width = static_cast<std::size_t>(world_.width);
        return " at pixel " + std::to_string(pixel % width) + ", " + std::to_string(pixel / width);
    }

    std::string fault_alone(const Drawn& d) const {
        for (std::size_t i = 0; i < d.linear.pixels().size(); ++i) {
            for (int band = 0; band < 3; ++band) {
                const double radiance = double{d.linear.pixels()[i][band]};
                if (!std::isfinite(radiance) || radiance < 0) {
                    return "radiance " + std::to_string(radiance) + at(i);
                }
                const double most = allowed_.pixels()[i].most[band];
                if (radiance > most) {
                    return "radiance " + std::to_string(radiance) + " above " +
                           std::to_string(most) + at(i);
                }
            }
        }
        return {};
    }

    std::string fault_beside(const Drawn& d, const Drawn& scanline) const {
        for (std::size_t i = 0; i < d.linear.pixels().size(); ++i) {
            if (d.triangle.pixels()[i] != scanline.triangle.pixels()[i] ||
                d.depth.pixels()[i] != scanline.depth.pixels()[i]) {
                return "another triangle or depth than by scanlines" + at(i);
            }
            const Allowed& a = allowed_.pixels()[i];
            for (int band = 0; band < 3; ++band) {
                const double x = double{d.linear.pixels()[i][band]};
                const double y = double{scanline.linear.pixels()[i][band]};
                if (!(std::abs(x - y) <= a.base[band] + a.share[band] * std::max(x, y))) {
                    return "radiance " + std::to_string(x) + ", by scanlines " + std::to_string(y) +
                           at(i);
                }
            }
        }
        return {};
    }

    static std::string fault_of_threads(const Drawn& many, const Drawn& one) {
        return many.linear == one.linear && many.srgb == one.srgb && many.depth == one.depth &&
                       many.triangle == one.triangle
                   ? ""
                   : "another picture than with one thread";
    }

    const World& world_;
    std::span<const Shader> shaders_;
    View view_;
    Image<Allowed> allowed_;
};

}  // namespace

std::string picture_fault(const World& world, std::span<const Shader> shaders) {
    return Judge(world, shaders).verdict();
}

double stated_brightest(const Surface& surface, int band) {
    return (1.05 * double{surface.Cd[band]} + 0.5 * double{surface.n} + 1) / std::numbers::pi;
}

}  // namespace glint::stability
