// The contract between the rasterizer and whoever shades. A fragment shader is one struct:
//
//     struct NormalColour {
//         float gain = 0.5F;                                       // uniforms: plain members
//         template <class T>
//         struct Varyings {                                        // what is interpolated
//             Vec3<T> normal;
//         };
//         static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }
//         template <Real T>
//         Rgb<T> operator()(const Varyings<T>& in) const {         // radiance towards the eye
//             return gain * (normalize(in.normal) + Vec3<T>(T(1.0F)));
//         }
//     };
//
// Varyings holds Ts and vectors of T, nothing else, and only what the shader needs: every member
// costs time in every fragment. A last member Vec3<T> to_eye is not interpolated but known of each
// pixel, and cheaper: the direction towards the eye, of any length; vertex() leaves it 0. A shader
// that asks for the directions of its varyings alone, and so for no length, may say
//
//     static constexpr bool directions_only = true;
//
// Perspective-correct interpolation ends with a quotient by the interpolated 1/w, which lengthens a
// fragment's varyings, all by the same, and turns none: it is then left out.
//
// The call is compiled for float, for double (the reference that accuracy is measured against) and
// for SIMD lanes; plug() makes of it what the rasterizer takes. A shader may accept a second
// argument, a commentator: note("N.L", cosine). It is silent when drawing, and lists the terms of
// one pixel when probing.
#pragma once

#include "framework/geometry/mesh.hpp"
#include "framework/math/vec.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace glint {

// What the mesh says at a corner of a triangle, in world space.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;  // unit length; zero where the mesh has none
    glm::vec2 uv;      // zero where the mesh has none
};

inline constexpr int max_varyings = 16;  // scalars

struct Silent {
    template <class Value>
    void operator()(std::string_view, const Value&) const {}
};

// One named term of a pixel's shading: one or three components, as both readings have it.
struct Note {
    std::string_view name;
    int components = 0;
    std::array<double, 3> value{};
};

class NoteTaker {
  public:
    explicit NoteTaker(std::vector<Note>& notes) : notes_(&notes) {}
    template <Real T>
    void operator()(std::string_view name, const T& value) const {
        notes_->push_back({name, 1, {static_cast<double>(value)}});
    }
    template <Real T>
    void operator()(std::string_view name, const Vec3<T>& v) const {
        notes_->push_back({name, 3, {double(v.x), double(v.y), double(v.z)}});
    }

  private:
    std::vector<Note>* notes_;
};

// What the rasterizer holds of a shader: addresses. The shader itself must outlive it.
struct Shader {
    // Varyings of the named vertices, less to_eye: varying k of vertices[i] goes to
    // out[k * stride + i].
    using VertexCall = void (*)(const void* shader, const Mesh&, const std::uint32_t* vertices,
                                int count, int stride, float* out);
    // Colours of a block of fragments: varying k of fragment i is at in[k * stride + i], its red,
    // green and blue go to out[i], out[stride + i], out[2 * stride + i]. The three of to_eye come
    // last. The lanes version reads and writes up to the next multiple of its width. in and out do
    // not overlap.
    template <class Scalar>
    using ShadeCall = void (*)(const void* shader, const Scalar* in, int stride, int count,
                               Scalar* out);
    template <class Scalar>
    using ExplainCall = void (*)(const void* shader, const Scalar* in, std::vector<Note>& notes);

    const void* shader = nullptr;
    int varyings = 0;  // to be interpolated
    bool to_eye = false;
    bool directions_only = false;  // what is interpolated may be of any length
    VertexCall vertex = nullptr;
    ShadeCall<float> shade_1 = nullptr;
    ShadeCall<float> shade_4 = nullptr;
    ShadeCall<float> shade_8 = nullptr;   // null where the build has no such lanes
    ShadeCall<float> shade_16 = nullptr;  // likewise
    ShadeCall<double> reference = nullptr;
    ExplainCall<float> explain_float = nullptr;    // null where the shader takes no commentator
    ExplainCall<double> explain_double = nullptr;  // likewise
};

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
