// How the grader's numbers reach a student's functions and come back. A question is a row of
// numbers for one task; its answer is a row too. Numbers travel as double and are rounded to T.
//
// questions/NN_lesson.hpp holds, for the lesson's header before it,
//
//     template <Real T>
//     void answer(int task, In<T> in, Out<T> out);     // task 2 is NN.2
//
// It is read where the header's names are known, the students' or the instructor's: so it has
// neither includes nor a namespace of its own.
#pragma once

#include "framework/math/incidence.hpp"

namespace glint {

template <Real T>
class In {
  public:
    explicit In(const double* at) : at_(at) {}
    T number() { return static_cast<T>(*at_++); }
    Vec3<T> vector() {
        const T x = number();
        const T y = number();
        return {x, y, number()};
    }
    Rgb<float> uniform() { return Rgb<float>(vector()); }
    Incidence<T> incidence() {
        const Vec3<T> v = vector();
        return {v.x, v.y, v.z};
    }

  private:
    const double* at_;
};

template <Real T>
class Out {
  public:
    explicit Out(double* at) : at_(at) {}
    void operator()(T number) { *at_++ = static_cast<double>(number); }
    template <class V>
    void operator()(const glm::vec<3, V>& v) {
        for (int i = 0; i < 3; ++i) {
            *at_++ = static_cast<double>(v[i]);
        }
    }

  private:
    double* at_;
};

}  // namespace glint
