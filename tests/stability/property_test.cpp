// The property run finds what is planted: each kind of fault, by what it says.
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "tests/stability/property_check.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <limits>
#include <utility>

namespace glint::stability {
namespace {

// Lesson 15's model, spoilt by Spoil<T>::of(brdf value, geometry).
template <class Spoil>
struct Spoilt {
    EnginePhong right;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return Spoil::of(right(g), g);
    }
    Rgb<float> ambient_albedo() const { return right.ambient_albedo(); }
};
struct Nothing {
    template <Real T>
    static Rgb<T> of(const Rgb<T>& f, const Incidence<T>&) {
        return f;
    }
};
struct NotANumber {  // in the mirror direction's neighbourhood, as a root without a limit
    template <Real T>
    static Rgb<T> of(const Rgb<T>& f, const Incidence<T>& g) {
        return f + Rgb<T>(T(0.0F) * sqrt(T(0.99F) - v_dot_r(g)));
    }
};
struct Negative {
    template <Real T>
    static Rgb<T> of(const Rgb<T>& f, const Incidence<T>& g) {
        return f - Rgb<T>(T(0.1F) * max(T(0.1F) - g.NV, T(0.0F)));
    }
};
struct TooBright {  // twice and more what is stated, of lobes that are not tight
    template <Real T>
    static Rgb<T> of(const Rgb<T>& f, const Incidence<T>&) {
        return f * T(2.5F) + Rgb<T>(T(10.0F));
    }
};
struct OtherInFourLanes {  // by a thousandth
    template <Real T>
    static Rgb<T> of(const Rgb<T>& f, const Incidence<T>&) {
        return f * T(lanes_of<T> == 4 ? 1.001F : 1.0F);
    }
};
std::atomic<int> calls{0};
struct OtherEachTime {  // by what was shaded before, as threads that share a variable
    template <Real T>
    static Rgb<T> of(const Rgb<T>& f, const Incidence<T>&) {
        return f * T(1.0F + 1e-7F * static_cast<float>(calls++ % 7));
    }
};

// What is said of the first faulty world, and how many there were among the first 60.
template <class Spoil>
std::pair<std::string, int> found() {
    std::pair<std::string, int> said{"", 0};
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        World world = random_world(seed);
        world.model = Model::engine;
        const std::string fault = picture_fault_with(world, [](const Surface& s) {
            return Spoilt<Spoil>{{s.Cd, s.F0, s.n}};
        });
        said.first = said.second == 0 ? fault : said.first;
        said.second += fault.empty() ? 0 : 1;
    }
    return said;
}

bool says(const std::pair<std::string, int>& found, const std::string& words) {
    MESSAGE(found.second, " of 60: ", found.first);
    return found.second > 0 && found.first.find(words) != std::string::npos;
}

TEST_CASE("worlds of right models are without fault") {
    CHECK(found<Nothing>().second == 0);
}

TEST_CASE("planted faults of pictures are found") {
    CHECK(says(found<NotANumber>(), "nan"));
    CHECK(says(found<Negative>(), "radiance -"));
    CHECK(says(found<TooBright>(), "above"));
    CHECK(says(found<OtherInFourLanes>(), "by scanlines"));
    CHECK(says(found<OtherEachTime>(), "one thread"));
}

TEST_CASE("planted faults of materials are found") {
    World world = random_world(1);
    world.surfaces = {{Rgb<float>(1.0F), Rgb<float>(0.04F), 10}};
    const EnginePhong engine{Rgb<float>(1.0F), Rgb<float>(0.04F), 10};
    world.model = Model::engine;
    CHECK(material_fault(world, engine).empty());
    world.model = Model::consistent;  // which lesson 15's is not: neither energy nor reciprocity
    CHECK(!material_fault(world, engine).empty());
    const AnyBrdf not_a_number = [](const Incidence<double>&) {
        return Rgb<double>(std::numeric_limits<double>::quiet_NaN());
    };
    CHECK(!material_fault(world, not_a_number).empty());
}

TEST_CASE("a seed makes the same world, another seed another") {
    CHECK(words(random_world(5)) == words(random_world(5)));
    CHECK(words(random_world(5)) != words(random_world(6)));
    CHECK(size_of(random_world(5)) > 1);
}

}  // namespace
}  // namespace glint::stability
