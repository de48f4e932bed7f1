// From a fragment shader to what the rasterizer takes of it.
#pragma once

#include "framework/raster/shader.hpp"
#include "framework/math/lanes.hpp"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace glint {
namespace shader_detail {

template <class S, class T>
using Varyings = typename S::template Varyings<T>;

// A number of twelve bytes: a member that is not made of T does not grow with it.
struct TwelveBytes {
    float bytes[3];
};

template <class S>
inline constexpr int count = static_cast<int>(sizeof(Varyings<S, float>) / sizeof(float));

template <class S>
inline constexpr bool takes_to_eye = requires(Varyings<S, float> v) {
    v.to_eye;
};

template <class S>
inline constexpr int interpolated = count<S> - (takes_to_eye<S> ? 3 : 0);

template <class S>
inline constexpr bool directions_only = requires {
    requires S::directions_only;
};

template <class S>
constexpr bool to_eye_is_last() {
    if constexpr (takes_to_eye<S>) {
        using V = Varyings<S, float>;
        return std::is_same_v<decltype(V::to_eye), Vec3<float>> &&
               offsetof(V, to_eye) == sizeof(V) - sizeof(Vec3<float>);
    }
    return true;
}

template <class S, class T>
Varyings<S, T> gather_varyings(const auto* in, int stride) {
    std::array<T, count<S>> values;
    for (int k = 0; k < count<S>; ++k) {
        values[static_cast<std::size_t>(k)] = load<T>(in + k * stride);
    }
    return std::bit_cast<Varyings<S, T>>(values);
}

template <class S>
void vertex(const void* shader, const Mesh& mesh, const std::uint32_t* vertices, int n, int stride,
            float* out) {
    for (int i = 0; i < n; ++i) {
        const auto at = vertices[i];
        const Vertex v{mesh.positions[at], mesh.normals.empty() ? glm::vec3(0) : mesh.normals[at],
                       mesh.uvs.empty() ? glm::vec2(0) : mesh.uvs[at]};
        const Varyings<S, float> varyings = static_cast<const S*>(shader)->vertex(v);
        const auto* bytes = reinterpret_cast<const std::byte*>(&varyings);
        for (int k = 0; k < interpolated<S>; ++k) {
            float value = 0;
            std::memcpy(&value, bytes + k * int{sizeof value}, sizeof value);
            out[k * stride + i] = value;
        }
    }
}

// Flattened: what the shader calls is part of this loop, or its registers would go through memory.
template <class S, class T, class Scalar>
[[gnu::flatten]] void shade(const void* shader, const Scalar* __restrict in, int stride, int n,
                            Scalar* __restrict out) {
    const S& s = *static_cast<const S*>(shader);
    for (int i = 0; i < n; i += lanes_of<T>) {
        const Rgb<T> colour = s(gather_varyings<S, T>(in + i, stride));
        store(out + i, colour.r);
        store(out + stride + i, colour.g);
        store(out + 2 * stride + i, colour.b);
    }
}

template <class S, class T>
void explain(const void* shader, const T* in, std::vector<Note>& notes) {
    (*static_cast<const S*>(shader))(gather_varyings<S, T>(in, 1), NoteTaker(notes));
}

}  // namespace shader_detail

// A concept sees the declaration only; plug() compiles the body, so mistakes show at its call.
template <class S>
concept FragmentShader = requires(const S s, const Vertex& v,
                                  const shader_detail::Varyings<S, float>& in) {
    { s.vertex(v) } -> std::same_as<shader_detail::Varyings<S, float>>;
    { s(in) } -> std::same_as<Rgb<float>>;
};

template <FragmentShader S>
Shader plug(const S& shader) {
    using namespace shader_detail;
    static_assert(std::is_trivially_copyable_v<Varyings<S, float>> &&
                      sizeof(Varyings<S, TwelveBytes>) == 3 * sizeof(Varyings<S, float>),
                  "Varyings<T> may hold only T and vectors of T");
    static_assert(to_eye_is_last<S>(), "to_eye must be a Vec3<T> and the last of Varyings<T>");
    static_assert(count<S> <= max_varyings, "a shader has at most 16 scalar varyings");
    Shader p{.shader = &shader,
             .varyings = interpolated<S>,
             .to_eye = takes_to_eye<S>,
             .directions_only = directions_only<S>,
             .vertex = vertex<S>,
             .shade_1 = shade<S, float, float>,
             .shade_4 = shade<S, Float<4>, float>,
             .reference = shade<S, double, double>};
    if constexpr (max_lanes >= 8) {
        p.shade_8 = shade<S, Float<8>, float>;
    }
    if constexpr (max_lanes >= 16) {
        p.shade_16 = shade<S, Float<16>, float>;
    }
    if constexpr (requires(const Varyings<S, float>& in, std::vector<Note>& notes) {
                      shader(in, NoteTaker(notes));
                  }) {
        p.explain_float = explain<S, float>;
        p.explain_double = explain<S, double>;
    }
    return p;
}

}  // namespace glint
