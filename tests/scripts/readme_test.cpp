#include "framework/raster/plug.hpp"

#include <doctest/doctest.h>

namespace glint {

#include "readme_shader.hpp"

TEST_CASE("the README's shader is one, and paints two tones") {
    const TwoTones shader;
    CHECK(plug(shader).varyings == 3);
    using Varyings = TwoTones::Varyings<float>;
    CHECK(shader(Varyings{glm::vec3(0, 2, 0)}) == Rgb<float>(0.8F));
    CHECK(shader(Varyings{glm::vec3(0, 0, 1)}) == Rgb<float>(0.2F));
}

}  // namespace glint
