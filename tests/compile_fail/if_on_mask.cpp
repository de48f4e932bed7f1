#include "framework/math/lanes.hpp"
#include "framework/math/vec.hpp"

namespace glint {

template <Real T>
T lit(T cosine) {
    if (cosine > T(0.0F)) {  // wrong
        return cosine;
    }
    return T(0.0F);
}

Float<4> use(Float<4> cosine) {
    return lit(cosine);
}

}  // namespace glint
