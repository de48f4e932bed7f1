// x^n by everything that shaders have taken for it. In a picture that frames a highlight, equal
// shares of the area have equal shares of log(x^n); so have the numbers that are tried here.
#include "framework/math/pow.hpp"

#include "docs/charts/families.hpp"
#include "docs/charts/fit.hpp"
#include "docs/charts/kernel.hpp"

namespace glint::charts {
namespace {

constexpr double root_half = 0.70710678118654752;

// 2^(n log2 x) with so many terms each; x > 0 a normal number.
template <std::size_t LogTerms, std::size_t ExpTerms>
struct ShortPow {
    std::array<float, LogTerms> log = fit<LogTerms>([](double f) { return std::log2(1 + f) / f; },
                                                    root_half - 1, 2 * root_half - 1);
    std::array<float, ExpTerms> exp =
        fit<ExpTerms>([](double f) { return std::exp2(f); }, -0.5, 0.5);
    float n;

    template <class T>
    std::array<T, 1> operator()(const std::array<T, 1>& x) const {
        using I = IntOf<T>;
        const I bits = bits_of(x[0]);
        const I e = (bits - I(bits_of(static_cast<float>(root_half)))) >> 23;
        const T f = float_from_bits(bits - (e << 23)) - T(1.0F);
        const T y = max(T(n) * fma(f, polynomial_of(f, log), to_float(e)), T(-126.0F));
        const I k = round_to_int(y);
        return {scale(polynomial_of(y - to_float(k), exp), to_float(k))};
    }
};

// Values at equal steps of x, and straight lines between them.
struct Table {
    std::vector<float> value;

    Table(int steps, double n) {
        for (int i = 0; i <= steps + 1; ++i) {
            value.push_back(static_cast<float>(std::pow(std::min(double(i) / steps, 1.0), n)));
        }
    }
    template <class T>
    std::array<T, 1> operator()(const std::array<T, 1>& x) const {
        using I = IntOf<T>;
        const T place = x[0] * T(static_cast<float>(value.size() - 2));
        const I i = truncate_to_int(place);
        const T low = gather(value.data(), i);
        return {low + (place - to_float(i)) * (gather(value.data(), i + I(1)) - low)};
    }
};

// Errors in units of the last place and in codes of a picture whose white is 1.
std::vector<Judgement> judge(const Columns& in, const Columns& out, float n, const char* name) {
    ErrorSum ulp;
    ErrorSum codes;
    for (int i = 0; i < Columns::rows; ++i) {
        const double exact = std::pow(double{in.column(0)[i]}, double{n});
        const double found = double{out.column(0)[i]};
        const double unit = std::exp2(std::floor(std::log2(exact)) - 23);
        ulp.add((found - exact) / unit);
        codes.add(code_of(found) - code_of(exact));
    }
    return {{name, "ulp", ulp.errors()}, {name, "codes", codes.errors()}};
}

class Exponent {
  public:
    Exponent(std::vector<Contender>& all, float n, const char* name)
        : all_(all), n_(n), name_(name), in_(make_columns<1>([n](int i) {
              return std::array{static_cast<float>(std::exp2(-14 * share_of(i) / double{n}))};
          })) {}

    template <class T, class F>
    void add(const std::string& method, const F& f) {
        const Trial t = try_out_quick<T, 1, 1>(in_, f);
        all_.push_back({method, t.work, t.amount, judge(*in_, *t.out, n_, name_)});
    }

  private:
    std::vector<Contender>& all_;
    float n_;
    const char* name_;
    std::shared_ptr<const Columns> in_;
};

void add_all(std::vector<Contender>& all, float n, const char* name) {
    Exponent e(all, n, name);
    e.add<float>("libm", [n](const auto& x) { return std::array{std::pow(x[0], n)}; });
    e.add<Wide>("Glint's pow", [n](const auto& x) { return std::array{pow(x[0], Wide(n))}; });
    e.add<Wide>("9 + 7 terms", [n](const auto& x) {
        using namespace pow_detail;
        return std::array{exp2_of_number(n * log2_of_normal(x[0]))};
    });
    e.add<Wide>("6 + 5 terms", ShortPow<6, 5>{.n = n});
    e.add<Wide>("4 + 4 terms", ShortPow<4, 4>{.n = n});
    e.add<Wide>("3 + 3 terms", ShortPow<3, 3>{.n = n});
    e.add<Wide>("2 + 2 terms", ShortPow<2, 2>{.n = n});
    if (n == std::floor(n)) {
        e.add<Wide>("squaring", [n](const auto& x) {
            return std::array{pow_detail::pow_whole(x[0], static_cast<std::uint32_t>(n))};
        });
    }
    e.add<Wide>("table of 256", Table(256, double{n}));
    e.add<Wide>("table of 4096", Table(4096, double{n}));
    e.add<Wide>("Schlick's quotient", [n](const auto& x) {  // Schlick 1994, for Phong's highlight
        return std::array{x[0] / (Wide(n) - n * x[0] + x[0])};
    });
}

}  // namespace

std::vector<Contender> pow_contenders() {
    std::vector<Contender> all;
    add_all(all, 1, "n = 1");
    add_all(all, 10, "n = 10");
    add_all(all, 51.2F, "n = 51.2");
    add_all(all, 1000, "n = 1000");
    add_all(all, 1e6F, "n = 1e6");
    return all;
}

}  // namespace glint::charts
