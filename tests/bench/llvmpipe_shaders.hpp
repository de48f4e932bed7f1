// Lesson 15's model and Glint's clip space, as GLSL.
#pragma once

namespace glint {

// Glint's depth runs from 1 (near) to 0 (far), OpenGL's window depth from 0 to 1.
inline constexpr const char* vertex_glsl = R"(#version 300 es
uniform mat4 clip_from_world;
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
out highp vec3 position;
out highp vec3 normal;
void main() {
    position = vertex_position;
    normal = vertex_normal;
    vec4 clip = clip_from_world * vec4(vertex_position, 1.0);
    gl_Position = vec4(clip.xy, clip.w - 2.0 * clip.z, clip.w);
}
)";

// The way to the eye by an interpolated position: by gl_FragCoord, as Glint has it from the pixel,
// llvmpipe takes longer. LIGHTS is defined in front of it, as a literal, so that the loop is
// unrolled.
inline constexpr const char* fragment_glsl = R"(
precision highp float;
uniform vec3 eye;
uniform vec3 light_direction[LIGHTS];
uniform vec3 light_irradiance[LIGHTS];
uniform vec3 ambient;
uniform vec3 Cd;
uniform vec3 F0;
uniform float n;
in vec3 position;
in vec3 normal;
out vec4 colour;
const float inverse_pi = 0.31830988618;
void main() {
    vec3 N = normalize(normal);
    vec3 V = normalize(eye - position);
    vec3 diffuse = Cd * (1.0 - F0);
    float factor = (n + 2.0) * (0.5 * inverse_pi);
    vec3 radiance = ambient * diffuse;
    vec3 irradiance = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 L = light_direction[i];
        float NL = dot(N, L);
        float VR = clamp(2.0 * NL * dot(N, V) - dot(L, V), 0.0, 1.0);
        float lobe = VR > 0.0 ? factor * pow(VR, n) : 0.0;
        float m = 1.0 - clamp(NL, 0.0, 1.0);
        float m2 = m * m;
        vec3 F = F0 + (1.0 - F0) * (m2 * m2 * m);
        vec3 E = light_irradiance[i] * max(NL, 0.0);
        irradiance += E;
        radiance += F * lobe * E;
    }
    radiance += diffuse * inverse_pi * irradiance;
    colour = vec4(radiance, 1.0);
}
)";

}  // namespace glint
