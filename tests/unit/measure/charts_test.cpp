// The charts' harness is fed methods with planted errors and planted delays, and finds both.
#include "framework/math/error.hpp"
#include "docs/charts/harness.hpp"
#include "docs/charts/report.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace glint::charts {
namespace {

Judgement judged(const std::string& variant, double planted) {
    ErrorSum sum;
    for (int i = 0; i < 1000; ++i) {
        sum.add(i == 500 ? -planted : planted / 2);
    }
    return {variant, "codes", sum.errors()};
}

// A machine whose clock goes on by what a method is said to cost.
struct Machine {
    double now = 0;

    Contender contender(const std::string& method, double ms, double amount, double error) {
        return {method, [this, ms] { now += ms; }, amount, {judged("easy", error)}};
    }
};

TEST_CASE("a planted error is found at its true size") {
    const Errors e = judged("any", 0.25).errors;
    CHECK(e.largest == 0.25);
    CHECK(e.rms == doctest::Approx(0.25 * std::sqrt((1 + 999 * 0.25) / 1000)));
    CHECK(ErrorSum().errors().rms == 0);
}

TEST_CASE("an error that is not a number is as bad as can be") {
    ErrorSum sum;
    sum.add(1);
    sum.add(std::numeric_limits<double>::quiet_NaN());
    CHECK(sum.errors().largest == std::numeric_limits<double>::infinity());
    CHECK(sum.errors().rms == std::numeric_limits<double>::infinity());
}

TEST_CASE("a planted delay is found at its true size, by task") {
    Machine m;
    const auto rows =
        measure({m.contender("plain", 2, 1000, 0.5), m.contender("delayed", 3, 500, 0.25)},
                JudgedBy::largest, 9, [&] { return m.now; });
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].ns == doctest::Approx(2000));
    CHECK(rows[1].ns == doctest::Approx(6000));
    CHECK(rows[1].ns_low == doctest::Approx(6000));
    CHECK(rows[1].ns_high == doctest::Approx(6000));
    CHECK(rows[0].error == 0.5);
    CHECK(rows[1].error == 0.25);
}

TEST_CASE("a slow spell shows in the spread, not in the cost") {
    Machine m;
    int call = 0;
    const std::vector<Contender> uneasy{
        {"uneasy", [&] { m.now += ++call > 6 ? 5 : 1; }, 1000, {judged("easy", 1)}}};
    const auto rows = measure(uneasy, JudgedBy::largest, 8, [&] { return m.now; });
    CHECK(rows[0].ns_low == doctest::Approx(1000));
    CHECK(rows[0].ns == doctest::Approx(1000));
    CHECK(rows[0].ns_high == doctest::Approx(5000));
}

TEST_CASE("rivals are those of the same variant and unit") {
    Machine m;
    Contender slow = m.contender("slow", 9, 1, 2);
    slow.judgements.push_back(judged("hard", 7));
    slow.judgements.push_back({"easy", "ulp", {7, 7}});
    const auto rows =
        measure({m.contender("quick", 1, 1, 1), slow}, JudgedBy::rms, 3, [&] { return m.now; });
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].on_front);
    CHECK_FALSE(rows[1].on_front);
    CHECK(rows[2].on_front);
    CHECK(rows[3].on_front);
    CHECK(rows[1].error == rows[1].judgement.errors.rms);
}

TEST_CASE("an error that is better by rounding only keeps nobody on the front") {
    Machine m;
    const auto rows =
        measure({m.contender("quick", 1, 1, 0.2504), m.contender("slow", 2, 1, 0.2496),
                 m.contender("slower", 3, 1, 0.244), m.contender("exact", 4, 1, 0)},
                JudgedBy::largest, 3, [&] { return m.now; });
    CHECK(rows[0].on_front);
    CHECK_FALSE(rows[1].on_front);
    CHECK(rows[2].on_front);
    CHECK(rows[3].on_front);
}

TEST_CASE("a file and a table of what was found") {
    const Family family{"toys", "evaluation", JudgedBy::largest, 1, nullptr};
    const std::vector<Row> rows{{"a", {"easy", "codes", {0.5, 0.25}}, 2, 1.5, 2.5, 0.5, true},
                                {"b", {"easy", "codes", {0.75, 0.25}}, 4, 4, 4, 0.75, false},
                                {"b", {"hard", "codes", {0.0625, 0.01}}, 4, 4, 4, 0.0625, true}};
    CHECK(csv(family, rows) ==
          "method,variant,per,ns,ns_low,ns_high,max_error,rms_error,unit,judged_by,on_front\n"
          "a,easy,evaluation,2,1.5,2.5,0.5,0.25,codes,max,1\n"
          "b,easy,evaluation,4,4,4,0.75,0.25,codes,max,0\n"
          "b,hard,evaluation,4,4,4,0.0625,0.01,codes,max,1\n");
    const std::string text = table(family, rows);
    CHECK(
        text.starts_with("| method | easy, codes | hard, codes |\n|---|---|---|\n"
                         "| a | **2 / 0.5** |  |\n| b | 4 / 0.75 | **4 / 0.062** |\n\n"
                         "ns an evaluation / largest error"));
}

TEST_CASE("a table goes between its marks and nowhere else") {
    const std::string text =
        "A\n<!-- begin table x -->\nold\n<!-- end table x -->\n"
        "B\n<!-- begin table y -->\n<!-- end table y -->\n";
    CHECK(with_table(text, "x", "new\n") ==
          "A\n<!-- begin table x -->\nnew\n<!-- end table x -->\n"
          "B\n<!-- begin table y -->\n<!-- end table y -->\n");
    CHECK(with_table(with_table(text, "y", "1\n"), "y", "1\n") == with_table(text, "y", "1\n"));
    CHECK_THROWS_WITH_AS(with_table(text, "z", ""), "the document has no marks for the table z",
                         Error);
}

}  // namespace
}  // namespace glint::charts
