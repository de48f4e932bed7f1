// Stands in for window.cpp in a build without SDL2.
#include "framework/app/window.hpp"
#include "framework/math/error.hpp"

namespace glint {

int run_window(const Lesson&, const Options&) {
    throw Error("--window: this build has no SDL2; install libsdl2-dev and build again");
}

}  // namespace glint
