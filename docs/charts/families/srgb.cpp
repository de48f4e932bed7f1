// 8-bit sRGB codes of linear light. The reference is the code nearest to the exact curve.
#include "framework/image/srgb.hpp"

#include "framework/math/pow.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/kernel.hpp"

#include <cmath>
#include <limits>

namespace glint::charts {
namespace {

// Codes travel as the bits of floats, so that storing them costs nothing more.
template <class T>
T code_bits(const IntOf<T>& code) {
    return float_from_bits(code);
}

template <class T>
T clamped(const T& x) {
    return min(max(x, T(0.0F)), T(1.0F));
}

template <class T>
T rounded_code(const T& encoded) {
    return code_bits<T>(truncate_to_int(encoded * T(255.0F) + T(0.5F)));
}

float by_libm(float x) {
    x = clamped(x);
    return rounded_code(x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1.0F / 2.4F) - 0.055F);
}

// Codes at equal steps of the linear value.
struct CodeTable {
    std::vector<std::int32_t> code;

    explicit CodeTable(int size) {
        for (int i = 0; i < size; ++i) {
            code.push_back(static_cast<int>(
                std::lround(255 * srgb_encode(static_cast<double>(i) / (size - 1)))));
        }
    }
    template <class T>
    T operator()(const T& x) const {
        const T place = clamped(x) * T(static_cast<float>(code.size() - 1)) + T(0.5F);
        return code_bits<T>(gather(code.data(), truncate_to_int(place)));
    }
};

// Straight lines over the eighths of each octave from 2^-13 on: the place in the table is a few
// bits of the float (an idea of Giesen's, 2012).
struct OctaveTable {
    static constexpr int octaves = 13;
    static constexpr int shift = 20;  // leaves the exponent and three bits
    std::vector<float> start, slope;

    OctaveTable() {
        for (int i = 0; i <= octaves * 8; ++i) {
            const double low = std::ldexp(1 + (i % 8) / 8.0, i / 8 - octaves);
            const double high = low + std::ldexp(0.125, i / 8 - octaves);
            const double rise = 255 * (srgb_encode(high) - srgb_encode(low)) / (high - low);
            start.push_back(static_cast<float>(255 * srgb_encode(low) - rise * low + 0.5));
            slope.push_back(static_cast<float>(rise));
        }
    }
    template <class T>
    T operator()(const T& linear) const {
        using I = IntOf<T>;
        const T x = min(max(linear, T(std::ldexp(1.0F, -octaves))), T(1.0F));
        const I i = (bits_of(x) - I(bits_of(std::ldexp(1.0F, -octaves)))) >> shift;
        return code_bits<T>(
            truncate_to_int(fma(gather(slope.data(), i), x, gather(start.data(), i))));
    }
};

// A closer fit, mended where the fraction says that the code may be a neighbour's: the nearest code
// of every float.
struct Mended {
    std::vector<float> end;  // of each code: the first float of the next

    // mantissa^(1/2.4): a minimax fit of degree 6, relative error 1.9e-7.
    struct Power {
        template <class T>
        T operator()(const T& mantissa) const {
            return polynomial(mantissa, 0.350306869F, 1.06413138F, -0.687737048F, 0.390423328F,
                              -0.145197615F, 0.0309279542F, -0.00285470439F);
        }
    };

    Mended() {
        for (int code = 0; code < 255; ++code) {
            const double half_way = srgb_decode((code + 0.5) / 255);
            const auto near = static_cast<float>(half_way);
            end.push_back(near < half_way ? std::nextafter(near, 2.0F) : near);
        }
        end.push_back(std::numeric_limits<float>::infinity());
    }
    template <class T>
    T operator()(const T& linear) const {
        using I = IntOf<T>;
        const T x = clamped(linear);
        const I code = srgb::code_and_fraction(x, Power());
        if (any(((code + I(1)) & I(0xffe)) == I(0))) [[unlikely]] {
            const I low = ((code - I(1)) >> 12) & I(255);
            return code_bits<T>(low + select(x >= gather(end.data(), low), I(1), I(0)));
        }
        return code_bits<T>((code >> 12) & I(255));
    }
};

Errors errors_of(const Columns& in, const Columns& out) {
    ErrorSum sum;
    for (int i = 0; i < Columns::rows; ++i) {
        const double exact = std::round(255 * srgb_encode(double{in.column(0)[i]}));
        sum.add(bits_of(out.column(0)[i]) - exact);
    }
    return sum.errors();
}

class Values {
  public:
    Values(std::vector<Contender>& all, const char* name, std::shared_ptr<const Columns> in)
        : all_(all), name_(name), in_(std::move(in)) {}

    template <class T, class F>
    void add(const char* method, const F& f) {
        const Trial t =
            try_out<T, 1, 1>(in_, [f](const std::array<T, 1>& x) { return std::array{f(x[0])}; });
        all_.push_back({method, t.work, t.amount, {{name_, "codes", errors_of(*in_, *t.out)}}});
    }

  private:
    std::vector<Contender>& all_;
    const char* name_;
    std::shared_ptr<const Columns> in_;
};

void add_all(Values values) {
    values.add<float>("libm's pow", by_libm);
    values.add<Wide>("Glint's", [](const Wide& x) { return code_bits<Wide>(srgb_code(x)); });
    values.add<Wide>("mended", Mended());
    values.add<Wide>("table of 256", CodeTable(256));
    values.add<Wide>("table of 4096", CodeTable(4096));
    values.add<Wide>("table by octaves", OctaveTable());
    values.add<Wide>("square root", [](const Wide& x) { return rounded_code(sqrt(clamped(x))); });
    values.add<Wide>("gamma 2.2", [](const Wide& x) {
        return rounded_code(pow(clamped(x), Wide(1.0F / 2.2F)));
    });
}

// The last float of a code and the first of the next, and their neighbours.
float at_an_edge(int i) {
    const auto end = static_cast<float>(srgb_decode((i / 8 % 255 + 0.5) / 255));
    return float_from_bits(bits_of(end) + i % 8 - 4);
}

}  // namespace

std::vector<Contender> srgb_contenders() {
    std::vector<Contender> all;
    add_all({all, "even in light",
             make_columns<1>([](int i) { return std::array{static_cast<float>(share_of(i))}; })});
    add_all({all, "even in codes", make_columns<1>([](int i) {
                 return std::array{static_cast<float>(srgb_decode(share_of(i)))};
             })});
    add_all({all, "at the edges of codes",
             make_columns<1>([](int i) { return std::array{at_an_edge(i)}; })});
    return all;
}

}  // namespace glint::charts
