// Lesson 15's shader compiled as programs compile it, a*b+c rounded once, for tests that are not.
#pragma once

#include "lessons/15_engine_integration/engine_phong.hpp"
#include "framework/raster/shader.hpp"

namespace glint::stability {

struct Contracted : EnginePhong {};  // a type of its own, that the linker may not take for another

[[gnu::visibility("default")]] Shader plug_contracted(const Lit<Contracted>& shader);

}  // namespace glint::stability
