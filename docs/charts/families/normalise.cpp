// Vectors made of length 1, and 1/x.
#include "framework/math/vec.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/kernel.hpp"

#include <random>

namespace glint::charts {
namespace {

template <class T>
Vec3<T> vector_of(const std::array<T, 3>& x) {
    return {x[0], x[1], x[2]};
}

template <class T>
std::array<T, 3> scaled(const std::array<T, 3>& v, const T& scale) {
    return {v[0] * scale, v[1] * scale, v[2] * scale};
}

template <class T>
T square_of(const std::array<T, 3>& v) {
    return dot(vector_of(v), vector_of(v));
}

// One step of Newton's iteration towards 1/sqrt(a), and towards 1/a.
template <class T>
T better_root(const T& a, const T& y) {
    return y * (T(1.5F) - T(0.5F) * a * y * y);
}
template <class T>
T better_quotient(const T& a, const T& y) {
    return y * (T(2.0F) - a * y);
}

// Half the exponent by a shift of the bits, as games did it in the nineties.
template <class T>
T shifted_root(const T& a) {
    using I = IntOf<T>;
    return float_from_bits(I(0x5f375a86) - (bits_of(a) >> 1));
}
template <class T>
T shifted_quotient(const T& a) {
    using I = IntOf<T>;
    return float_from_bits(I(0x7ef311c3) - bits_of(a));
}

std::shared_ptr<const Columns> vectors() {
    std::mt19937 random(1);
    const auto coordinate = [&] { return 2 * (static_cast<double>(random()) / 0x1p32) - 1; };
    return make_columns<3>([&](int i) {
        glm::dvec3 v(1, 0, 0);
        do {
            v = {coordinate(), coordinate(), coordinate()};
        } while (dot(v, v) > 1 || dot(v, v) < 0.01);
        v *= std::pow(10.0, 6 * share_of(i) - 3);
        return std::array{static_cast<float>(v.x), static_cast<float>(v.y),
                          static_cast<float>(v.z)};
    });
}

Errors errors_of_vectors(const Columns& in, const Columns& out) {
    ErrorSum sum;
    for (int i = 0; i < Columns::rows; ++i) {
        const glm::dvec3 v(in.column(0)[i], in.column(1)[i], in.column(2)[i]);
        const glm::dvec3 exact = normalize(v);
        for (int k = 0; k < 3; ++k) {
            sum.add((double{out.column(k)[i]} - exact[k]) * 0x1p24);
        }
    }
    return sum.errors();
}

Errors errors_of_quotients(const Columns& in, const Columns& out) {
    ErrorSum sum;
    for (int i = 0; i < Columns::rows; ++i) {
        const double exact = 1 / double{in.column(0)[i]};
        sum.add((double{out.column(0)[i]} - exact) / std::exp2(std::floor(std::log2(exact)) - 23));
    }
    return sum.errors();
}

void add_vectors(std::vector<Contender>& all) {
    const auto in = vectors();
    const auto add = [&](const char* method, const auto& normalised) {
        const Trial t = try_out_quick<Wide, 3, 3>(in, normalised);
        all.push_back({method,
                       t.work,
                       t.amount,
                       {{"a vector of length 1", "2^-24", errors_of_vectors(*in, *t.out)}}});
    };
    const auto by = [](const auto& inverse_root) {
        return [=](const auto& v) { return scaled(v, inverse_root(square_of(v))); };
    };
    add("exact operations", by([](const Wide& a) { return Wide(1.0F) / sqrt(a); }));
    add("Glint's", [](const auto& v) {
        const Vec3<Wide> n = normalize(vector_of(v));
        return std::array{n.x, n.y, n.z};
    });
#if defined(__AVX512VL__)
    const auto estimate = [](const Wide& a) { return Wide(simd::root_estimate(a.v.data)); };
    add("estimate", by(estimate));
    add("estimate and Newton", by([=](const Wide& a) { return better_root(a, estimate(a)); }));
#endif
    add("shifted bits and Newton",
        by([](const Wide& a) { return better_root(a, shifted_root(a)); }));
    add("shifted bits", by([](const Wide& a) { return shifted_root(a); }));
}

void add_quotients(std::vector<Contender>& all) {
    const auto in = make_columns<1>(
        [](int i) { return std::array{static_cast<float>(std::pow(10.0, 6 * share_of(i) - 3))}; });
    const auto add = [&](const char* method, const auto& inverse) {
        const Trial t =
            try_out_quick<Wide, 1, 1>(in, [=](const auto& x) { return std::array{inverse(x[0])}; });
        all.push_back(
            {method, t.work, t.amount, {{"1/x", "ulp", errors_of_quotients(*in, *t.out)}}});
    };
    add("exact operations", [](const Wide& a) { return Wide(1.0F) / a; });
    add("Glint's", [](const Wide& a) { return reciprocal(a); });
#if defined(__AVX512VL__)
    const auto estimate = [](const Wide& a) { return Wide(simd::quotient_estimate(a.v.data)); };
    add("estimate", estimate);
    add("estimate and Newton", [=](const Wide& a) { return better_quotient(a, estimate(a)); });
#endif
    add("shifted bits and Newton",
        [](const Wide& a) { return better_quotient(a, shifted_quotient(a)); });
    add("shifted bits", [](const Wide& a) { return shifted_quotient(a); });
}

}  // namespace

std::vector<Contender> normalise_contenders() {
    std::vector<Contender> all;
    add_vectors(all);
    add_quotients(all);
    return all;
}

}  // namespace glint::charts
