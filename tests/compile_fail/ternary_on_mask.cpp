#include "framework/math/lanes.hpp"
#include "framework/math/vec.hpp"

namespace glint {

template <Real T>
T lit(T cosine) {
    return cosine > T(0.0F) ? cosine : T(0.0F);  // wrong
}

Float<4> use(Float<4> cosine) {
    return lit(cosine);
}

}  // namespace glint
