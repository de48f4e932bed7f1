// What the bench says where it was built without EGL.
#include "framework/math/error.hpp"
#include "tests/bench/llvmpipe.hpp"

namespace glint {

struct Llvmpipe::Impl {};

Llvmpipe::Llvmpipe(int) {
    throw Error(
        "llvmpipe: this bench was built without EGL; on Debian, as root, run\n"
        "  apt-get install libegl-dev libgles-dev libgl1-mesa-dri\n"
        "and build again");
}
Llvmpipe::~Llvmpipe() = default;
std::string Llvmpipe::version() const {
    return {};
}
void Llvmpipe::set_scene(const BenchScene&) {}
void Llvmpipe::frame() {}
SrgbImage Llvmpipe::picture() const {
    return {};
}
LinearImage Llvmpipe::linear_picture() {
    return {};
}

}  // namespace glint
