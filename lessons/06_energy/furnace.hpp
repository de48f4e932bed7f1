// The white furnace of lesson 6: light of radiance 1 from everywhere. What conserves energy is
// never brighter than its walls.
#pragma once

#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "framework/scene/false_colour.hpp"

#include <array>

namespace glint {

// The albedo by the cosine of the fixed direction's angle: measured at equal steps, straight
// between; green stands for all.
class AlbedoCurve {
  public:
    template <class Brdf>
    explicit AlbedoCurve(const Brdf& brdf, Fixed fixed = Fixed::light) {
        for (std::size_t i = 0; i < at_.size(); ++i) {
            const double cosine = std::max(static_cast<double>(i) / steps, 1e-6);
            at_[i] = static_cast<float>(directional_albedo(brdf, cosine, fixed).g);
        }
    }
    template <Real T>
    T operator()(const T& cosine) const {
        T sum(0.0F);
        for (std::size_t i = 0; i < at_.size(); ++i) {
            const T steps_off = abs(cosine * T(float{steps}) - T(static_cast<float>(i)));
            // fma: left to the compiler, it rounds another way in lanes than alone
            sum = fma(max(T(1.0F) - steps_off, T(0.0F)), T(at_[i]), sum);
        }
        return sum;
    }

  private:
    static constexpr int steps = 64;
    std::array<float, steps + 1> at_{};
};

// A share as a false colour; above 1 it changes to the warning colour within 1/steepness. A steep
// edge shows roundings.
template <Real T>
Rgb<T> colour_of_share(const T& share, float steepness) {
    const T above = clamp((share - T(1.0001F)) * steepness, T(0.0F), T(1.0F));
    return mix(false_colour(min(share, T(1.0F))), false_colour(T(2.0F)), Rgb<T>(above));
}

// What a viewer sees of a surface in the furnace, as a colour.
struct Furnace {
    AlbedoCurve seen;  // with the view fixed
    glm::vec3 eye;

    template <class T>
    using Varyings = Lit<UnnormalisedLambert>::Varyings<T>;
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const T cosine = clamp(dot(N, normalize(eye - in.position)), T(0.0F), T(1.0F));
        const T radiance = seen(cosine);
        note("N.V", cosine);
        note("radiance, the furnace's being 1", radiance);
        return colour_of_share(radiance, 40);
    }
};

}  // namespace glint
