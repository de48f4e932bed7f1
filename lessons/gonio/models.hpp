// The lessons' models by name: columns of numbers in, columns of numbers out, for any number type.
#pragma once

#include "lessons/10_fresnel_dielectric/fresnel_dielectric.hpp"
#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/12_schlick/schlick.hpp"
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "framework/measure/gonioreflectometer.hpp"

#include <string>
#include <vector>

namespace glint::models {

using Columns = std::vector<std::string>;

template <Real T>
using Row = std::vector<T>;

template <Real T>
Vec3<T> vector_at(const Row<T>& in, std::size_t at) {
    return normalize_or(Vec3<T>(in[at], in[at + 1], in[at + 2]), Vec3<T>(T(0.0F)));
}

template <Real T>
Rgb<T> colour_at(const Row<T>& in, std::size_t at) {
    return {in[at], in[at + 1], in[at + 2]};
}

template <Real T>
Row<T> columns_of(const Reflectances<T>& r) {
    return {r.parallel, r.perpendicular, r.unpolarised};
}

struct FresnelDielectric {
    static Columns in() { return {"n1", "n2", "cos_i"}; }
    static Columns out() { return {"R_par", "R_perp", "R"}; }
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        return columns_of(fresnel_dielectric(x[0], x[1], x[2]));
    }
};

struct FresnelConductor {
    static Columns in() { return {"ior", "k", "cos_i"}; }
    static Columns out() { return {"R_par", "R_perp", "R"}; }
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        return columns_of(fresnel_conductor(x[0], x[1], x[2]));
    }
};

struct FresnelConductorApprox : FresnelConductor {
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        return columns_of(fresnel_conductor_approximate(x[0], x[1], x[2]));
    }
};

struct SchlickModel {
    static Columns in() { return {"F0", "cos_i"}; }
    static Columns out() { return {"F"}; }
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        return {schlick(x[0], x[1])};
    }
};

struct Lambert {
    static Columns in() { return {"Nx", "Ny", "Nz", "Lx", "Ly", "Lz", "Cd", "E"}; }
    static Columns out() { return {"Lo"}; }
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        const T NL = dot(vector_at(x, 0), vector_at(x, 3));
        return {reflect_light(Rgb<T>(x[6] * inverse_pi<T>), Rgb<T>(x[7]), NL).r};
    }
};

template <bool normalised>
struct Phong {
    static Columns in() {
        return {"Nx", "Ny", "Nz", "Lx", "Ly", "Lz", "Vx", "Vy", "Vz", "n", "Cd", "E"};
    }
    static Columns out() { return {"spec_brdf", "Lo"}; }
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        const Incidence<T> g = incidence(vector_at(x, 0), vector_at(x, 3), vector_at(x, 6));
        const T lobe = normalised ? normalised_phong(g, x[9]) : phong_lobe(g, x[9]);
        const T diffuse = normalised ? x[10] * inverse_pi<T> : x[10];
        return {lobe, reflect_light(Rgb<T>(diffuse + lobe), Rgb<T>(x[11]), g.NL).r};
    }
};

struct Final {
    static Columns in() {
        return {"Nx",  "Ny",  "Nz",   "Lx",   "Ly",   "Lz",   "Vx",   "Vy",
                "Vz",  "n",   "Cd_r", "Cd_g", "Cd_b", "F0_r", "F0_g", "F0_b",
                "E_r", "E_g", "E_b",  "La_r", "La_g", "La_b"};
    }
    static Columns out() { return {"Lo_r", "Lo_g", "Lo_b"}; }
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        const Incidence<T> g = incidence(vector_at(x, 0), vector_at(x, 3), vector_at(x, 6));
        const Rgb<T> Cd = colour_at(x, 10);
        const Rgb<T> F0 = colour_at(x, 13);
        const Rgb<T> f = diffuse_by_f0(Cd, F0) + specular_by_angle(F0, x[9], g);
        const Rgb<T> Lo = reflect_light(f, colour_at(x, 16), g.NL) +
                          colour_at(x, 19) * Cd * (Rgb<T>(T(1.0F)) - F0);
        return {Lo.r, Lo.g, Lo.b};
    }
};

// The lobe's albedo by quadrature, the lobe in the number type, the sum in double.
struct Albedo {
    static Columns in() { return {"n", "cos_theta"}; }
    static Columns out() { return {"A"}; }
    template <Real T>
    static Row<T> eval(const Row<T>& x) {
        const auto lobe = [n = x[0]](const Incidence<double>& g) {
            const Incidence<T> narrow{T(g.NL), T(g.NV), T(g.LV)};
            return Rgb<double>(first_lane(normalised_phong(narrow, n)));
        };
        return {T(directional_albedo(lobe, first_lane(x[1])).r)};
    }

  private:
    template <Real T>
    static double first_lane(const T& value) {
        if constexpr (is_lanes<T>) {
            float lanes[lanes_of<T>];
            store(lanes, value);
            return double{lanes[0]};
        } else {
            return static_cast<double>(value);
        }
    }
};

}  // namespace glint::models
