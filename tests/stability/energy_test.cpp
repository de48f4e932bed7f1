// Energy and reciprocity: what models reflect, and how it is measured.
#include "lessons/06_energy/energy.hpp"

#include "lessons/09_normalised_phong/phong_albedo.hpp"
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "lessons/16_where_it_fails/consistent_phong.hpp"
#include "tests/stability/row.hpp"

#include <algorithm>

namespace glint::stability {
namespace {

// A BRDF that is asked in T, for instruments that measure in double.
template <Real T, class Brdf>
auto asked_in(const Brdf& brdf) {
    return [brdf](const Incidence<double>& g) {
        const Rgb<T> f = brdf(Incidence<T>{T(g.NL), T(g.NV), T(g.LV)});
        return Rgb<double>(value(f.r), value(f.g), value(f.b));
    };
}

// Of light or, in a furnace, of sight: the most above 1 over these cosines.
template <Real T, class Brdf>
double most_above_1(const Brdf& brdf, std::initializer_list<double> cosines) {
    double most = 0;
    for (const double c : cosines) {
        most = std::max(most, directional_albedo(asked_in<T>(brdf), c).g - 1);
    }
    return most;
}

const Rgb<float> white(1.0F);

TEST_CASE("the lobe's albedo by equal steps: n = 1e6") {
    const double cosine = 0.6;
    const auto lobe = [](const Incidence<double>& g) {
        return Rgb<double>(normalised_phong(g, 1e6));
    };
    const double exact = phong_albedo(1e6, cosine);
    row({std::abs(albedo(lobe, std::acos(cosine), 45) - exact) / exact,
         std::abs(directional_albedo(lobe, cosine).g - exact) / exact},
        0.5, 1e-7);
}

TEST_CASE("the combined model Cd (1 - F0) + F(N.L) near grazing") {
    row(in_all_numbers([]<Real T>() {
            const std::initializer_list<double> cosines{0.02, 0.1, 1.0 / 6, 0.3, 0.6, 1};
            return Errors{
                most_above_1<T>(EnginePhong{white, Rgb<float>(0), 100}, cosines),
                most_above_1<T>(Combined{white, Rgb<float>(0), 100, Remains::by_angle}, cosines)};
        }),
        0.06, 1e-5);
}

// Albedo from along the normal to grazing; magenta where it is above 1.
template <class Brdf>
Shade albedo_ramp(const Brdf& brdf) {
    return [brdf](int x, int) {
        const double albedo = directional_albedo(brdf, std::cos((x + 0.5) * pi / 130)).g;
        return albedo > 1.001 ? Rgb<float>(1, 0, 0.5F) : Rgb<float>(static_cast<float>(albedo));
    };
}

TEST_CASE("a white furnace with n towards 0") {
    picture("furnace", 65, 16, 3, albedo_ramp(EnginePhong{white, Rgb<float>(0), 1e-3F}),
            albedo_ramp(ConsistentPhong{white, Rgb<float>(0), 1e-3F}));
    row(in_all_numbers([]<Real T>() {
            const std::initializer_list<double> cosines{1e-3, 0.1, 0.5, 0.77, 1};
            return Errors{most_above_1<T>(EnginePhong{white, Rgb<float>(0), 1e-3F}, cosines),
                          most_above_1<T>(ConsistentPhong{white, Rgb<float>(0), 1e-3F}, cosines)};
        }),
        0.4, 8e-4);
}

TEST_CASE("diffuse and specular side by side: Cd + F0 up to 2") {
    row(in_all_numbers([]<Real T>() {
            const std::initializer_list<double> cosines{0.5, 1};
            return Errors{most_above_1<T>(NormalisedPhong{white, white, 32}, cosines),
                          most_above_1<T>(Combined{white, white, 32, Remains::by_angle}, cosines)};
        }),
        0.9, 1e-5);
}

TEST_CASE("reciprocity of F(N.L)") {
    // Light and viewer at 78.5 and 71.7 degrees, n = 100: f(L, V) / f(V, L).
    const auto ratio = []<Real T>(const auto& brdf) {
        const auto g = incidence_of_angles(78.5 * pi / 180, 71.7 * pi / 180, pi);
        const Incidence<T> there{T(g.NL), T(g.NV), T(g.LV)};
        const Incidence<T> back{T(g.NV), T(g.NL), T(g.LV)};
        return value(brdf(there).g) / value(brdf(back).g) - 1;
    };
    row(in_all_numbers([&]<Real T>() {
            const Rgb<float> F0(0.04F);
            return Errors{ratio.template operator()<T>(EnginePhong{Rgb<float>(0), F0, 100}),
                          ratio.template operator()<T>(ConsistentPhong{Rgb<float>(0), F0, 100})};
        }),
        0.8, 0);
}

}  // namespace
}  // namespace glint::stability
