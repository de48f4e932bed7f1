#include "framework/raster/plug.hpp"

namespace glint {

struct Striped {
    template <class T>
    struct Varyings {
        Vec2<T> uv;
        int stripe;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.uv, 3}; }

    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return Rgb<T>(in.uv.x);
    }
};

Shader use() {
    static const Striped shader;
    return plug(shader);  // wrong
}

}  // namespace glint
