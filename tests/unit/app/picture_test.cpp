#include "framework/app/picture.hpp"

#include "framework/raster/renderer.hpp"
#include "framework/image/convert.hpp"
#include "framework/image/pfm.hpp"
#include "framework/image/png.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/app/small_lesson.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace glint {
namespace {

struct Raw {
    Image<float> depth;
    Image<std::int32_t> triangle;
};

Raw raw_picture(const Lesson& lesson, const Options& o, const Scene& scene) {
    Raw raw;
    Renderer renderer({});
    const ShaderSet set = lesson.shaders(scene, o.parameters);
    renderer.render(scene.mesh, view_of(scene, o.width, o.height), set.shaders,
                    {.depth = &raw.depth, .triangle = &raw.triangle});
    return raw;
}

TEST_CASE("the PFM of the depth view holds depths, 0 where nothing is") {
    const TemporaryFolder folder;
    const Lesson lesson = small_lesson();
    Options o = small_options();
    o.view = ViewMode::depth;
    o.settings.samples = 4;  // of no effect: depths are not mixed
    const Scene scene = ball_before_wall();
    const Drawing drawing = draw(lesson, o, scene);
    write_picture(folder / "d.pfm", drawing);
    const Image<float> depth = read_pfm_grey(folder / "d.pfm");
    CHECK(depth == raw_picture(lesson, o, scene).depth);
    CHECK(depth(0, 0) == 0.0F);
    CHECK(depth(45, 35) > depth(45, 60));
    CHECK(settings_for(o).samples == 1);
}

TEST_CASE("the PFM of the triangle view holds numbers, -1 where nothing is") {
    const TemporaryFolder folder;
    const Lesson lesson = small_lesson();
    Options o = small_options();
    o.view = ViewMode::triangle;
    o.settings.samples = 16;
    const Scene scene = ball_before_wall();
    write_picture(folder / "t.pfm", draw(lesson, o, scene));
    const Image<float> numbers = read_pfm_grey(folder / "t.pfm");
    const Image<std::int32_t> triangle = raw_picture(lesson, o, scene).triangle;
    CHECK(std::ranges::equal(numbers.pixels(), triangle.pixels(),
                             [](float a, std::int32_t b) { return a == static_cast<float>(b); }));
    CHECK(numbers(0, 0) == -1.0F);
    CHECK(numbers(45, 35) >= 8.0F);  // the ball comes after the wall's eight
}

TEST_CASE("the PFMs of overdraw and tiles hold counts") {
    const TemporaryFolder folder;
    const Lesson lesson = small_lesson();
    Options o = small_options();
    const Scene scene = ball_before_wall();
    o.view = ViewMode::overdraw;
    write_picture(folder / "o.pfm", draw(lesson, o, scene));
    const Image<float> layers = read_pfm_grey(folder / "o.pfm");
    CHECK(layers(0, 0) == 0.0F);
    CHECK(layers(45, 35) == 3.0F);  // the ball's front and back, and the wall
    o.settings.cull = Cull::back;
    CHECK(draw(lesson, o, scene).values(45, 35) == 2.0F);
    o.view = ViewMode::tiles;
    const Image<float> by_tile = draw(lesson, o, scene).values;
    CHECK(by_tile(0, 0) == by_tile(63, 63));
    CHECK(by_tile(0, 0) > by_tile(89, 69));
    CHECK(by_tile(63, 63) <= static_cast<float>(scene.mesh.triangles.size()));
}

TEST_CASE("PNG is what is seen, PFM its radiance") {
    const TemporaryFolder folder;
    const Lesson lesson = small_lesson();
    Options o = small_options();
    o.settings.samples = 4;
    const Scene scene = ball_before_wall();
    for (const ViewMode view : {ViewMode::shaded, ViewMode::normal}) {
        o.view = view;
        const Drawing drawing = draw(lesson, o, scene);
        write_picture(folder / "a.png", drawing);
        write_picture(folder / "a.pfm", drawing);
        CHECK(read_png(folder / "a.png") == drawing.srgb);
        CHECK(read_pfm(folder / "a.pfm") == drawing.linear);
        CHECK(to_srgb(drawing.linear) == drawing.srgb);
        CHECK(drawing.linear(0, 0) == scene.background);
    }
    // The ball's foremost point faces the eye.
    CHECK(distance(draw(lesson, o, scene).linear(45, 35), glm::vec3(0.5F, 0.5F, 1)) < 0.05F);
}

TEST_CASE("no PFM, no linear picture") {
    Options o = small_options();
    o.outs = {"a.png"};
    CHECK(draw(small_lesson(), o, ball_before_wall()).linear.empty());
}

TEST_CASE("every view has a picture, of every rasterizer the same") {
    const Lesson lesson = small_lesson();
    const Scene scene = ball_before_wall();
    for (const ViewMode view : {ViewMode::normal, ViewMode::depth, ViewMode::triangle,
                                ViewMode::overdraw, ViewMode::tiles}) {
        Options o = small_options();
        o.view = view;
        const Drawing tiles = draw(lesson, o, scene);
        o.settings.rasterizer = Rasterizer::scanline;
        const Drawing scanline = draw(lesson, o, scene);
        CHECK(tiles.srgb.width() == 90);
        CHECK(tiles.srgb.height() == 70);
        CHECK(tiles.values == scanline.values);
        if (view != ViewMode::normal) {
            CHECK(tiles.srgb == scanline.srgb);
            CHECK(tiles.values.width() == 90);
        }
        CHECK(tiles.srgb(0, 0) != tiles.srgb(45, 35));
    }
}

TEST_CASE("as many frames are timed as were asked for") {
    const Lesson lesson = small_lesson();
    const Scene scene = ball_before_wall();
    Options o = small_options();
    CHECK(draw(lesson, o, scene).frames.size() == 1);
    o.frames = 1;
    CHECK(draw(lesson, o, scene).frames.size() == 1);
    o.frames = 5;
    const Drawing five = draw(lesson, o, scene);
    CHECK(five.frames.size() == 5);
    CHECK(five.frames[4].fragments_shaded == five.frames[0].fragments_shaded);
    CHECK(!five.linear.empty());
}

TEST_CASE("a view has the camera's matrix and the picture's size") {
    const Scene scene = ball_before_wall();
    const View view = view_of(scene, 30, 60);
    CHECK(view.width == 30);
    CHECK(view.height == 60);
    CHECK(view.clip_from_world == clip_from_world(scene.camera, 0.5F));
}

}  // namespace
}  // namespace glint
