// Lesson 7's measured BRDFs: tables of so many cells an axis against the formula that they were
// captured from, on a sphere under one light.
#include "lessons/03_brdf/brdf.hpp"
#include "lessons/07_measured_brdf/capture.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/kernel.hpp"

namespace glint::charts {
namespace {

// Copper paint, as in lesson 7, with a broad highlight and with a sharp one.
LambertPhong formula(float n) {
    return {Rgb<float>(0.36F, 0.12F, 0.06F), Rgb<float>(0.6F), n};
}

// N.L, N.V and L.V all over the lit half of a sphere that is seen from its front.
std::shared_ptr<const Columns> incidences() {
    const glm::dvec3 L = normalize(glm::dvec3(-0.5, 0.6, 0.8));
    return make_columns<3>([&](int i) {
        const double radius = std::sqrt(share_of(i));  // a spiral: equal shares of the area
        const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
        const glm::dvec3 N(radius * std::cos(angle), radius * std::sin(angle),
                           std::sqrt(1 - radius * radius));
        return std::array{static_cast<float>(std::max(dot(N, L), 1e-3)), static_cast<float>(N.z),
                          static_cast<float>(L.z)};
    });
}

template <class T, class Brdf>
Rgb<T> radiance(const Brdf& brdf, const Incidence<T>& g) {
    return reflect_light(brdf(g), Rgb<T>(T(1.0F)), g.NL);
}

Errors errors_of(const LambertPhong& exact, const Columns& in, const Columns& out) {
    ErrorSum sum;
    for (int i = 0; i < Columns::rows; ++i) {
        const Incidence<double> g{in.column(0)[i], in.column(1)[i], in.column(2)[i]};
        const Rgb<double> right = radiance(exact, g);
        for (int k = 0; k < 3; ++k) {
            sum.add(code_of(double{out.column(k)[i]}) - code_of(right[k]));
        }
    }
    return sum.errors();
}

// The nearest cell, without anything between: an eighth of the memory that is read.
struct Nearest {
    std::shared_ptr<const BrdfTable> table;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const Vec3<T> place = place_in_table(g);
        const auto cell = [](const T& share, int cells) {
            return truncate_to_int(clamp(share * static_cast<float>(cells), T(0.0F),
                                         T(static_cast<float>(cells - 1))));
        };
        return table->at<T>(cell(place.x, table->half), cell(place.y, table->difference),
                            cell(place.z, table->azimuth));
    }
};

void add_all(std::vector<Contender>& all, float n, const std::string& name) {
    const auto in = incidences();
    const LambertPhong exact = formula(n);
    const auto add = [&](const std::string& method, const std::string& task, const auto& brdf) {
        const Trial t = try_out<Wide, 3, 3>(in, [brdf](const std::array<Wide, 3>& g) {
            const Rgb<Wide> colour = radiance(brdf, Incidence<Wide>{g[0], g[1], g[2]});
            return std::array{colour.r, colour.g, colour.b};
        });
        all.push_back({method, t.work, t.amount, {{task, "codes", errors_of(exact, *in, *t.out)}}});
    };
    add("formula " + name, "no table", exact);
    for (const int size : {4, 10, 25, 45, 90}) {
        const auto table = table_of(capture(exact, size, size, 2 * size));
        add("table of " + std::to_string(size), name, MeasuredBrdf{table});
        add("nearest of " + std::to_string(size), name, Nearest{table});
    }
}

}  // namespace

std::vector<Contender> captured_contenders() {
    std::vector<Contender> all;
    add_all(all, 20, "n = 20");
    add_all(all, 120, "n = 120");
    add_all(all, 1000, "n = 1000");
    return all;
}

}  // namespace glint::charts
