// The peer: Mesa's llvmpipe, through OpenGL ES 3 without a window.
#pragma once

#include "framework/image/image.hpp"
#include "tests/bench/scenes.hpp"

#include <memory>
#include <string>

namespace glint {

// One at a time: Mesa reads how many threads it may have when the context is made.
class Llvmpipe {
  public:
    // Makes the context with the peer's best settings: registers of 256 bits, no shader cache;
    // threads = 1 draws in the calling thread, as LP_NUM_THREADS=0 says. Error where there is no
    // llvmpipe, or the bench was built without EGL.
    explicit Llvmpipe(int threads);
    ~Llvmpipe();
    Llvmpipe(const Llvmpipe&) = delete;
    Llvmpipe& operator=(const Llvmpipe&) = delete;

    std::string version() const;  // of Mesa, and what it draws with

    // What the frames show from now on; its buffers are uploaded.
    void set_scene(const BenchScene& scene);

    // Clears and draws into an sRGB 8-bit picture with 32-bit float depth, and waits for the end.
    void frame();

    // The picture of the last frame. Alpha is 255 where a triangle covers the pixel, else 0.
    SrgbImage picture() const;

    // A frame in linear float.
    LinearImage linear_picture();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace glint
