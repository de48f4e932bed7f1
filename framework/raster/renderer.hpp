// Draws a mesh: the one door into the rasterizers.
#pragma once

#include "framework/raster/pipeline.hpp"
#include "framework/raster/shader.hpp"

#include <memory>
#include <span>

namespace glint {

// Keeps its threads and memory from frame to frame: by tiles, a steady frame allocates nothing.
class Renderer {
  public:
    // Error where a setting is out of its range, the build lacks the lanes or the system the
    // threads.
    explicit Renderer(const Settings& settings);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    const Settings& settings() const;

    // One frame: triangle t is shaded by shaders[mesh.materials[t]]. Of equal depths the triangle
    // submitted first wins. The pictures do not depend on the number of threads, nor ids and depths
    // on lanes and rasterizer; colours do so by rounding, which tests/pictures bounds.
    // Error where the view is out of its range, a shader is missing, or the mesh's arrays do not
    // fit together; then nothing is drawn. That triangles name existing vertices is not checked.
    Statistics render(const Mesh& mesh, const View& view, std::span<const Shader> shaders,
                      const Target& target);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace glint
