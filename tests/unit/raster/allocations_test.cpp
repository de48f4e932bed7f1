// A steady frame allocates nothing: this program counts every call of operator new.
#include "framework/raster/plug.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/pictures/random_scene.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
    if (counting) {
        ++allocations;
    }
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, whole > 0 ? whole : alignment);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

}  // namespace

// The other forms of new and delete call these.
void* operator new(std::size_t size) {
    return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace glint {
namespace {

struct Counted {
    long first = 0;
    long steady = 0;  // in frames 3, 4 and 5
};

Counted count_allocations(const Settings& settings, const Mesh& mesh, const View& view,
                          std::span<const Shader> shaders) {
    Drawn d;
    const Target target{
        .srgb = &d.srgb, .linear = &d.linear, .depth = &d.depth, .triangle = &d.triangle};
    Renderer renderer(settings);
    Counted c;
    for (int frame = 1; frame <= 5; ++frame) {
        allocations = 0;
        counting = true;
        renderer.render(mesh, view, shaders, target);
        counting = false;
        (frame == 1 ? c.first : c.steady) += frame == 2 ? 0 : allocations.load();
    }
    return c;
}

void check_scene(Mesh mesh, const Camera& camera, int materials) {
    CAPTURE(materials);
    mesh.materials.clear();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::size_t material = i * 7 % static_cast<std::size_t>(materials);
        mesh.materials.push_back(static_cast<std::uint16_t>(material));
    }
    std::vector<Shader> shaders(static_cast<std::size_t>(materials), plug(show_uv));
    for (std::size_t i = 0; i < shaders.size(); i += 2) {
        shaders[i] = plug(show_position);
    }
    const View view{clip_from_world(camera, 1.5F), 300, 200};
    for (const int samples : {1, 4}) {
        for (const int threads : {1, 2}) {
            for (const bool sample_shading : {false, true}) {
                const Settings settings{
                    .threads = threads, .samples = samples, .sample_shading = sample_shading};
                CAPTURE(words(settings));
                const Counted c = count_allocations(settings, mesh, view, shaders);
                CHECK(c.first > 0);  // or nothing was counted
                CHECK(c.steady == 0);
            }
        }
    }
}

TEST_CASE("a steady frame of a mesh allocates nothing") {
    const Camera camera{.eye = {0.5F, 3, 6}, .target = {0, 1, 0}, .near = 1, .far = 20};
    const Mesh mesh = teapot(12);
    check_scene(mesh, camera, 1);
    check_scene(mesh, camera, 3);
}

TEST_CASE("nor does a steady frame of clipped triangles and of tiles unlike each other") {
    for (const std::uint64_t seed : {5U, 6U, 7U}) {
        CAPTURE(seed);
        const RandomScene scene = random_scene(seed);
        check_scene(scene.mesh, scene.camera, 1);
        check_scene(scene.mesh, scene.camera, 4);
    }
}

TEST_CASE("the second round of a turning camera allocates nothing") {
    Drawn d;
    Renderer renderer({.threads = 2, .samples = 4});
    const Mesh mesh = teapot(12);
    const Shader shader = plug(show_position);
    const auto round = [&] {
        for (int step = 0; step < 24; ++step) {
            const float angle = 0.2618F * static_cast<float>(step);
            const Camera camera{.eye = {6 * std::sin(angle), 3, 6 * std::cos(angle)},
                                .target = {0, 1, 0}};
            renderer.render(mesh, {clip_from_world(camera, 1.5F), 300, 200}, std::span(&shader, 1),
                            {.srgb = &d.srgb});
        }
    };
    round();
    allocations = 0;
    counting = true;
    round();
    counting = false;
    CHECK(allocations == 0);
}

}  // namespace
}  // namespace glint
