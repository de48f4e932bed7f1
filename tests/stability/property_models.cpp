// The property run's four models, and what holds of them without a picture.
#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "lessons/16_where_it_fails/consistent_phong.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/oracle/random.hpp"
#include "tests/stability/property_check.hpp"

#include <algorithm>
#include <cmath>

namespace glint::stability {
namespace {

// Calls f(make), where make(surface) is the world's BRDF.
template <class F>
std::string with_model(const World& world, F f) {
    switch (world.model) {
        case Model::side_by_side:
            return f([](const Surface& s) { return NormalisedPhong{s.Cd, s.F0, s.n}; });
        case Model::engine:
            return f([](const Surface& s) { return EnginePhong{s.Cd, s.F0, s.n}; });
        case Model::by_angle:
            return f([](const Surface& s) { return Combined{s.Cd, s.F0, s.n, Remains::by_angle}; });
        default:
            return f([](const Surface& s) { return ConsistentPhong{s.Cd, s.F0, s.n}; });
    }
}

double most_albedo(Model model, double F0) {
    constexpr double measured = 1e-6;
    switch (model) {
        case Model::side_by_side:
            return 2 + measured;
        case Model::engine:
            return std::max(1.5 - F0, 1.0) + measured;
        case Model::by_angle:
            return 1 + measured;
        default:
            return 1.0008;
    }
}

}  // namespace

std::string picture_fault(const World& world) {
    return with_model(world, [&](auto make) { return picture_fault_with(world, make); });
}

std::string material_fault(const World& world, const AnyBrdf& brdf) {
    oracle::Random random(world.seed);
    const double cosine = std::pow(random.real(0, 1), 3) * 0.999999 + 1e-6;
    const double other = random.real(0, 1);
    const double turn = random.real(0, std::numbers::pi);
    const Rgb<double> albedo = directional_albedo(brdf, cosine);
    for (int band = 0; band < 3; ++band) {
        const double most = most_albedo(world.model, double{world.surfaces[0].F0[band]});
        if (!(albedo[band] >= 0 && albedo[band] <= most)) {
            return "albedo " + std::to_string(albedo[band]) + " beyond 0.." + std::to_string(most) +
                   " at cosine " + std::to_string(cosine);
        }
    }
    const auto g = incidence_of_angles(std::acos(cosine), std::acos(other), turn);
    if (world.model == Model::consistent && reciprocity_error(brdf, g) != Rgb<double>(0)) {
        return "not reciprocal at cosines " + std::to_string(cosine) + ", " + std::to_string(other);
    }
    return {};
}

std::string material_fault(const World& world) {
    return with_model(
        world, [&](auto make) { return material_fault(world, AnyBrdf(make(world.surfaces[0]))); });
}

std::string fresnel_fault(std::uint64_t seed) {
    oracle::Random random(seed);
    const auto index = [&] { return static_cast<float>(std::pow(10.0, random.real(-6, 6))); };
    for (int i = 0; i < 1000; ++i) {
        const float n1 = index();
        const float n2 = random.one_in(3) ? n1 * (1 + 1e-6F * index()) : index();
        const float k = random.one_in(4) ? 0.0F : index();
        const float c = random.one_in(4) ? static_cast<float>(random.between(0, 1))
                                         : static_cast<float>(std::pow(random.real(0, 1), 8));
        for (const auto& r : {fresnel_dielectric(n1, n2, c), fresnel_conductor(n2, k, c)}) {
            if (!(std::min(r.parallel, r.perpendicular) >= 0 &&
                  std::max(r.parallel, r.perpendicular) <= 1)) {
                return "reflectances " + std::to_string(r.parallel) + ", " +
                       std::to_string(r.perpendicular) + " of indices " + std::to_string(n1) +
                       ", " + std::to_string(n2) + " + " + std::to_string(k) + " i at cosine " +
                       std::to_string(c);
            }
        }
    }
    return {};
}

}  // namespace glint::stability
