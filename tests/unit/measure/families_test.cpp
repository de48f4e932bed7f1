// The charts against what is known of the methods, and their files against each other. Errors only:
// times are the machine's.
#include "docs/charts/families.hpp"

#include "framework/image/file.hpp"
#include "docs/charts/report.hpp"

#include <doctest/doctest.h>

#include <filesystem>

namespace glint::charts {
namespace {

Errors errors_of(const std::vector<Contender>& all, const std::string& method,
                 const std::string& variant) {
    for (const Contender& c : all) {
        for (const Judgement& j : c.judgements) {
            if (c.method == method && j.variant == variant) {
                return j.errors;
            }
        }
    }
    FAIL("no ", method, " for ", variant);
    return {};
}

TEST_CASE("the errors of Fresnel's approximations are those of the literature") {
    const auto all = fresnel_contenders();
    const auto largest = [&](const char* method, const char* material) {
        return errors_of(all, method, material).largest;
    };
    CHECK(largest("exact conductor", "gold") < 1e-6);
    CHECK(largest("exact dielectric", "glass") < 1e-6);
    CHECK(largest("Schlick", "aluminium") == doctest::Approx(0.130).epsilon(0.01));
    CHECK(largest("Schlick", "iron") == doctest::Approx(0.178).epsilon(0.01));
    CHECK(largest("Schlick", "water") == doctest::Approx(0.0599).epsilon(0.02));
    CHECK(largest("Schlick", "glass") == doctest::Approx(0.0357).epsilon(0.01));
    CHECK(largest("approximate conductor", "silver") == doctest::Approx(0.0009).epsilon(0.05));
    CHECK(largest("approximate conductor", "iron") == doctest::Approx(0.0058).epsilon(0.02));
    CHECK(largest("approximate conductor", "glass") == doctest::Approx(0.0987).epsilon(0.01));
}

TEST_CASE("mended codes are right, Glint's but for edges, and what is known to be bad is bad") {
    const auto all = srgb_contenders();
    for (const char* inputs : {"even in light", "even in codes", "at the edges of codes"}) {
        CAPTURE(inputs);
        CHECK(errors_of(all, "mended", inputs).largest == 0);
        CHECK(errors_of(all, "Glint's", inputs).largest <= 1);
        CHECK(errors_of(all, "square root", inputs).largest > 8);
        CHECK(errors_of(all, "gamma 2.2", inputs).largest > 8);
    }
    CHECK(errors_of(all, "Glint's", "at the edges of codes").largest == 1);
}

TEST_CASE("every family has its numbers, its charts and its place in the document") {
    const std::filesystem::path charts = "docs/charts";
    const std::string document = read_text("docs/speed-and-accuracy.md");
    int families = 0;
    for (const auto& file : std::filesystem::directory_iterator(charts / "families")) {
        const std::string name = file.path().stem().string();
        CAPTURE(name);
        ++families;
        CHECK_NOTHROW(with_table(document, name, ""));
        CHECK(document.find("charts/results/" + name + ".svg") != std::string::npos);
        const std::string numbers = read_text(charts / "results" / (name + ".csv"));
        const std::string names = csv({}, {});
        CHECK(numbers.starts_with(names));
        CHECK(std::filesystem::exists(charts / "results" / (name + ".svg")));
        CHECK(std::filesystem::exists(charts / "results" / (name + ".png")));
    }
    CHECK(families == 10);
}

}  // namespace
}  // namespace glint::charts
