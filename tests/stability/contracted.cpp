#include "tests/stability/contracted.hpp"

#include "framework/raster/plug.hpp"

namespace glint::stability {

Shader plug_contracted(const Lit<Contracted>& shader) {
    return plug(shader);
}

}  // namespace glint::stability
