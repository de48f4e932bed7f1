#include "tests/stability/contracted.hpp"

namespace glint::stability {

Shader plug_contracted(const Lit<Contracted>& shader) {
    return plug(shader);
}

}  // namespace glint::stability
