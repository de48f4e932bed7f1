#include "framework/raster/plug.hpp"

namespace glint {

struct Lit {
    template <class T>
    struct Varyings {
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }

    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        if (in.normal.z > T(0.0F)) {  // wrong
            return Rgb<T>(in.normal.z);
        }
        return Rgb<T>(T(0.0F));
    }
};

Shader use() {
    static const Lit shader;
    return plug(shader);
}

}  // namespace glint
