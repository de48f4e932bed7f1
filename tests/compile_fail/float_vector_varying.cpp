#include "framework/raster/plug.hpp"

namespace glint {

struct Lit {
    template <class T>
    struct Varyings {
        Vec3<T> position;
        glm::vec3 normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return in.position;
    }
};

Shader use() {
    static const Lit shader;
    return plug(shader);  // wrong
}

}  // namespace glint
