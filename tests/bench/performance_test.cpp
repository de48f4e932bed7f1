// The page about performance is told a made-up bench, and shows its numbers.
#include "docs/performance/report.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace glint::performance {
namespace {

using nlohmann::json;

json scene(const std::string& name, int threads, double ms) {
    json s{{"scene", name},
           {"threads", threads},
           {"glint_ms_min", ms},
           {"operations", 4e6},
           {"bytes", 8e6},
           {"ns_per_fragment", 5},
           {"kernel_ns_per_fragment", 3},
           {"whole_model_ns_per_fragment", 4},
           {"floor_ms", 3.2},
           {"million_triangles_per_second", 20},
           {"share_of_fma_peak", 0.5},
           {"share_of_write_peak", 0.125},
           {"stages",
            {{"geometry_ms", 0.5},
             {"visibility_ms", 1},
             {"shading_ms", 2},
             {"output_ms", 0.25},
             {"frame_ms", 4}}}};
    if (threads == 1) {
        s["scalar_ms_min"] = 8 * ms;
        s["scanline_ms_min"] = 25 * ms;
    }
    return s;
}

json bench() {
    return {{"fma_gflops", 200},
            {"write_gbs", 40},
            {"scenes",
             {scene("one", 1, 4), scene("two", 1, 10), scene("one", 2, 2), scene("two", 2, 8)}}};
}

// ms = 3 size^2, but for one point that is 4 times above.
json scaling() {
    json points;
    for (const double size : {1.0, 2.0, 4.0}) {
        points.push_back({{"size", size}, {"ms", 3 * size * size * (size == 2 ? 4 : 1)}});
    }
    return {{"scales", {{{"name", "things"}, {"points", points}, {"slope", 2.0}}}}};
}

bool has(const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
}

TEST_CASE("ways are beside their aims, which are bold where they are reached") {
    const std::string table = ways_table(bench());
    CHECK(has(table, "(aim 8)"));
    CHECK(has(table, "(aim 1.85)"));
    CHECK(has(table, "| one | 4.00 | **8.0** | **2.00** | 25.0 |\n"));
    CHECK(has(table, "| two | 10.0 | **8.0** | 1.25 | 25.0 |\n"));
}

TEST_CASE("a scene's work is beside what it cannot do without") {
    CHECK(has(work_table(bench()),
              "| one | 1 | 5.00 | 3.00 | 4.00 | 1.25 | 20.0 | 50.0 % | 12.5 % |\n"));
}

TEST_CASE("slopes from point to point") {
    CHECK(has(scaling_table(scaling()), "| things | 1 | 3.00 | 4 | 48.0 | 2.00 | 4.00, 0.00 |\n"));
}

TEST_CASE("the fitted line goes through the middle of the points") {
    // The geometric mean of 3, 48 and 48 at that of 1, 2 and 4, which is 2.
    CHECK(has(scaling_csv(scaling()), "things,2.0,48.0,19.0488,2.00\n"));
}

TEST_CASE("a scene's place in the roofline, and its stages") {
    CHECK(has(scenes_csv(bench()), "one,1,0.5,1,200,40,0.5,1,2,0.25,4\n"));
    CHECK(has(stages_table(bench()), "| one | 1 | 0.500 | 1.00 | 2.00 | 0.250 | 4.00 |\n"));
}

TEST_CASE("a bench without what is asked for is told") {
    CHECK_THROWS(llvmpipe_table(bench()));
}

}  // namespace
}  // namespace glint::performance
