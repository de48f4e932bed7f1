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
// for SIMD lanes; plug(), of plug.hpp, makes of it what the rasterizer takes. A shader may accept a
// second argument, a commentator: note("N.L", cosine). It is silent when drawing, and lists the
// terms of one pixel when probing.
#pragma once

#include "framework/geometry/mesh.hpp"
#include "framework/math/vec.hpp"

#include <array>
#include <cstdint>
#include <string_view>
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

}  // namespace glint
