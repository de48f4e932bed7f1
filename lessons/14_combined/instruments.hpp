// What the gonioreflectometer says of a BRDF, as colours on a surface that one light falls on: the
// total albedo for light from there, or how far swapping light and viewer changes the BRDF.
#pragma once

#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "framework/scene/false_colour.hpp"

#include <array>

namespace glint {

// The total albedo by the cosine of the light's angle: measured at equal steps, straight between.
class AlbedoCurve {
  public:
    template <class Brdf>
    explicit AlbedoCurve(const Brdf& brdf) {
        for (std::size_t i = 0; i < at_.size(); ++i) {
            const double cosine = std::max(static_cast<double>(i) / steps, 1e-6);
            at_[i] = static_cast<float>(directional_albedo(brdf, cosine).g);
        }
    }
    template <Real T>
    T operator()(const T& cosine) const {
        T sum(0.0F);
        for (std::size_t i = 0; i < at_.size(); ++i) {
            const T steps_off = abs(cosine * T(float{steps}) - T(static_cast<float>(i)));
            sum += at_[i] * max(T(1.0F) - steps_off, T(0.0F));
        }
        return sum;
    }

  private:
    static constexpr int steps = 64;
    std::array<float, steps + 1> at_{};
};

// |f(L,V) - f(V,L)| as a share of the larger one; green stands for all.
template <class Brdf, Real T>
T relative_reciprocity_error(const Brdf& brdf, const Incidence<T>& g) {
    const T f = brdf(g).g;
    const T difference = reciprocity_error(brdf, g).g;
    return abs(difference) / max(max(f, f - difference), T(1e-30F));
}

// A share as a false colour; its change to the warning colour above 1 is a pixel or so wide.
template <Real T>
Rgb<T> colour_of_share(const T& share) {
    const T above = clamp((share - T(1.0001F)) * 1000.0F, T(0.0F), T(1.0F));
    return mix(false_colour(min(share, T(1.0F))), false_colour(T(2.0F)), Rgb<T>(above));
}

template <class Brdf>
struct Instruments {
    Brdf brdf;
    AlbedoCurve albedo;
    bool reciprocity;  // else the total albedo
    glm::vec3 to_light, eye;

    template <class T>
    using Varyings = typename Lit<Brdf>::template Varyings<T>;
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Incidence<T> g = incidence(N, Vec3<T>(to_light), normalize(eye - in.position));
        const T share = reciprocity ? relative_reciprocity_error(brdf, g) : albedo(g.NL);
        note("N.L", g.NL);
        note("N.V", g.NV);
        note(reciprocity ? "reciprocity error" : "total albedo", share);
        const Rgb<T> unlit(T(0.03F));
        return mix(unlit, colour_of_share(share), Rgb<T>(clamp(g.NL * 100.0F, T(0.0F), T(1.0F))));
    }
};

}  // namespace glint
