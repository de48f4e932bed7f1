#include "framework/image/filter.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

template <class T>
std::vector<T> values(const Image<T>& image) {
    return {image.pixels().begin(), image.pixels().end()};
}

Image<double> row_of(std::vector<double> numbers) {
    Image<double> image(static_cast<int>(numbers.size()), 1);
    std::ranges::copy(numbers, image.pixels().begin());
    return image;
}

TEST_CASE("beyond the edge the last value repeats, or the row turns back") {
    std::vector<int> repeated;
    std::vector<int> mirrored;
    for (int i = -7; i <= 9; ++i) {
        repeated.push_back(inside(i, 3, Border::repeat));
        mirrored.push_back(inside(i, 3, Border::mirror));
    }
    CHECK(repeated == std::vector{0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2, 2, 2});
    CHECK(mirrored == std::vector{0, 0, 1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1, 2, 2});
    CHECK(inside(-5, 1, Border::mirror) == 0);
    CHECK(inside(5, 1, Border::repeat) == 0);
}

TEST_CASE_TEMPLATE("the first weight is that of the left and of the upper neighbour", T, float,
                   double) {
    Image<T> image(3, 3);
    image(1, 1) = T{1};
    const std::vector<T> weights{T{2}, T{3}, T{5}};
    CHECK(values(filter_rows(image, weights, Border::repeat)) ==
          std::vector<T>{0, 0, 0, 5, 3, 2, 0, 0, 0});
    CHECK(values(filter_columns(image, weights, Border::repeat)) ==
          std::vector<T>{0, 5, 0, 0, 3, 0, 0, 2, 0});
}

TEST_CASE("edges are what the border says, wider than the picture too") {
    const Image<double> row = row_of({1, 10, 100});
    CHECK(values(filter_rows(row, {1, 0, 0}, Border::repeat)) == std::vector<double>{1, 1, 10});
    CHECK(values(filter_rows(row, {1, 0, 0, 0, 0}, Border::mirror)) ==
          std::vector<double>{10, 1, 1});
    CHECK(values(filter_rows(row, {0, 0, 0, 0, 0, 0, 0, 0, 1}, Border::mirror)) ==
          std::vector<double>{10, 1, 1});
    CHECK(values(filter_columns(row, {1, 2, 4, 8, 16}, Border::mirror)) ==
          std::vector<double>{31, 310, 3100});
}

}  // namespace
}  // namespace glint
