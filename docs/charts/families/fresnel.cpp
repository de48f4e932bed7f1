// The reflectance of a colour by the light's angle, for the metals of lesson 11 and three
// dielectrics.
#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/11_fresnel_conductor/metals.hpp"
#include "lessons/12_schlick/schlick.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/kernel.hpp"

namespace glint::charts {
namespace {

// Calls reflectance(band) of T for the three bands.
template <class T, class F>
std::array<T, 3> by_band(const F& reflectance) {
    return {reflectance(0), reflectance(1), reflectance(2)};
}

template <class T>
T exact(const Metal& m, int band, const T& cosine) {
    return m.k[band] > 0 ? fresnel_conductor(T(m.ior[band]), T(m.k[band]), cosine).unpolarised
                         : fresnel_dielectric(T(1.0F), T(m.ior[band]), cosine).unpolarised;
}

Errors errors_of(const Metal& m, const Columns& in, const Columns& out) {
    ErrorSum sum;
    for (int i = 0; i < Columns::rows; ++i) {
        for (int band = 0; band < 3; ++band) {
            sum.add(double{out.column(band)[i]} - exact(m, band, double{in.column(0)[i]}));
        }
    }
    return sum.errors();
}

class Material {
  public:
    Material(std::vector<Contender>& all, const Metal& m)
        : all_(all),
          m_(m),
          in_(make_columns<1>([](int i) { return std::array{static_cast<float>(share_of(i))}; })) {}

    // of(band, cosine)
    template <class F>
    void add(const char* method, const F& of) {
        const Trial t = try_out_quick<Wide, 1, 3>(in_, [of](const auto& x) {
            return by_band<Wide>([&](int band) { return of(band, x[0]); });
        });
        all_.push_back({method,
                        t.work,
                        t.amount,
                        {{std::string(m_.name), "reflectance", errors_of(m_, *in_, *t.out)}}});
    }

  private:
    std::vector<Contender>& all_;
    const Metal& m_;
    std::shared_ptr<const Columns> in_;
};

void add_exact(Material& material, const Metal& m) {
    if (m.k.r == 0) {
        material.add("exact dielectric", [m](int band, const Wide& c) {
            return fresnel_dielectric(Wide(1.0F), Wide(m.ior[band]), c).unpolarised;
        });
    }
    material.add("exact conductor", [m](int band, const Wide& c) {
        return fresnel_conductor(Wide(m.ior[band]), Wide(m.k[band]), c).unpolarised;
    });
    material.add("approximate conductor", [m](int band, const Wide& c) {
        return fresnel_conductor_approximate(Wide(m.ior[band]), Wide(m.k[band]), c).unpolarised;
    });
}

void add_by_f0(Material& material, const Metal& m) {
    Rgb<float> F0(0.0F);
    Rgb<float> without_k(0.0F);
    Rgb<float> dip(0.0F);
    for (int band = 0; band < 3; ++band) {
        F0[band] = f0_conductor(m.ior[band], m.k[band]);
        without_k[band] = f0_dielectric(m.ior[band]);
        dip[band] = lazanyi_dip(F0[band], exact(m, band, 1.0F / 7.0F));
    }
    material.add("Schlick", [F0](int band, const Wide& c) { return schlick(Wide(F0[band]), c); });
    material.add("Schlick by a Gaussian",
                 [F0](int band, const Wide& c) { return schlick_gaussian(Wide(F0[band]), c); });
    material.add("Lazanyi", [F0, dip](int band, const Wide& c) {
        return lazanyi(Wide(F0[band]), Wide(dip[band]), c);
    });
    material.add("F0 at every angle", [F0](int band, const Wide&) { return Wide(F0[band]); });
    if (m.k.r > 0) {
        material.add("Schlick without k", [without_k](int band, const Wide& c) {
            return schlick(Wide(without_k[band]), c);
        });
    }
}

constexpr std::array<Metal, 3> dielectrics{{
    {"water", Rgb<float>(1.33F), Rgb<float>(0.0F)},
    {"glass", Rgb<float>(1.5F), Rgb<float>(0.0F)},
    {"diamond", Rgb<float>(2.417F), Rgb<float>(0.0F)},
}};

}  // namespace

std::vector<Contender> fresnel_contenders() {
    std::vector<Contender> all;
    const auto add = [&](const Metal& m) {
        Material material(all, m);
        add_exact(material, m);
        add_by_f0(material, m);
    };
    for (const Metal& m : metals) {
        add(m);
    }
    for (const Metal& m : dielectrics) {
        add(m);
    }
    return all;
}

}  // namespace glint::charts
