// Lesson 0: the smallest shader - a surface's normal as its colour.
//
// A shader is a struct with two functions. vertex() says what each corner of a triangle hands on;
// the rasterizer finds the pixels that the triangle covers and interpolates what the corners gave;
// the call operator makes a colour of it, once a pixel. T is one number or many: float, or as many
// floats as the processor computes on at once, or double to check them by.
#pragma once

#include "framework/raster/shader.hpp"

namespace glint {

struct HelloShader {
    float brightness = 1.0F;  // a uniform: a plain member, the same for every pixel

    // What is interpolated: numbers of T and vectors of them, nothing else.
    template <class T>
    struct Varyings {
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }

    // Linear RGB; the file's 8-bit codes are made of it by the curve of sRGB.
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        note("interpolated", in.normal);
        note("its length", length(in.normal));
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        note("normal", N);
        return brightness * 0.5F * (N + 1.0F);
    }
};

}  // namespace glint
