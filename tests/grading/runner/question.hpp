// How the grader's numbers reach a student's functions and come back. A question is a row of
// numbers for one task; its answer is a row too. Numbers travel as double and are rounded to T.
//
// questions/NN_lesson.hpp holds, for the lesson's header before it,
//
//     template <Real T>
//     void answer(int task, In<T> in, Out<T> out);     // task 2 is NN.2
//
// It is read where the header's names are known, the students' or the instructor's: so it has
// neither includes nor a namespace of its own. Where lanes are asked for, lanes.hpp comes first.
#pragma once

#include "framework/math/incidence.hpp"

#include <array>
#include <cstddef>
#include <type_traits>

namespace glint {

template <class T>
using ScalarOf = std::conditional_t<lanes_of<T> == 1, T, float>;
template <class T>
inline constexpr std::size_t width_of = static_cast<std::size_t>(lanes_of<T>);

// The row that is asked; lanes beside it hold other rows, which must not matter.
template <Real T>
class In {
  public:
    explicit In(const double* at) requires(lanes_of<T> == 1) : at_{at} {}
    In(const double* questions, std::size_t rows, std::size_t columns, std::size_t row)
        : own_(row % width_of<T>) {
        for (std::size_t lane = 0; lane < width_of<T>; ++lane) {
            at_[lane] = questions + (row - own_ + lane) % rows * columns;
        }
    }
    T number() {
        std::array<ScalarOf<T>, width_of<T>> values;
        for (std::size_t lane = 0; lane < width_of<T>; ++lane) {
            values[lane] = static_cast<ScalarOf<T>>(*at_[lane]++);
        }
        return load<T>(values.data());
    }
    Vec3<T> vector() {
        const T x = number();
        const T y = number();
        return {x, y, number()};
    }
    // The same in all lanes.
    float uniform_number() {
        const double own = *at_[own_];
        number();
        return static_cast<float>(own);
    }
    Rgb<float> uniform() {
        const float x = uniform_number();
        const float y = uniform_number();
        return {x, y, uniform_number()};
    }
    Incidence<T> incidence() {
        const Vec3<T> v = vector();
        return {v.x, v.y, v.z};
    }

  private:
    std::array<const double*, width_of<T>> at_{};
    std::size_t own_ = 0;
};

template <Real T>
class Out {
  public:
    explicit Out(double* at, std::size_t row = 0) : at_(at), own_(row % width_of<T>) {}
    void operator()(T number) { put(number); }
    template <class V>
    void operator()(const glm::vec<3, V>& v) {
        for (int i = 0; i < 3; ++i) {
            put(v[i]);
        }
    }

  private:
    template <class V>
    void put(V number) {
        std::array<ScalarOf<V>, width_of<V>> values;
        store(values.data(), number);
        *at_++ = static_cast<double>(values[width_of<V> == 1 ? 0 : own_]);
    }

    double* at_;
    std::size_t own_;
};

}  // namespace glint
