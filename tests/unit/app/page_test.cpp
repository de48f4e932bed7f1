#include "framework/app/programs/page.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/temporary.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

TEST_CASE("a section is cut out, and its name stays") {
    std::string text = "a\n<!-- begin part -->\n  {{x}}\n<!-- end part -->\nz\n";
    CHECK(take_section(text, "part") == "  {{x}}\n");
    CHECK(text == "a\n{{part}}z\n");
    CHECK_THROWS_WITH_AS(take_section(text, "part"), "the template has no section part", Error);
    std::string turned = "<!-- end part -->\n<!-- begin part -->\n";
    CHECK_THROWS_AS(take_section(turned, "part"), Error);
}

TEST_CASE("names are filled in, once") {
    const Values values{{"a", "1"}, {"b c", "{{a}}"}, {"empty", ""}};
    CHECK(fill("{{a}}-{{b c}}-{{a}}{{empty}}.", values) == "1-{{a}}-1.");
    CHECK(fill("no { names } }}", values) == "no { names } }}");
    CHECK(fill("", values).empty());
    CHECK_THROWS_WITH_AS(fill("{{d}}", values), "the template asks for {{d}}, which there is not",
                         Error);
    CHECK_THROWS_AS(fill("{{a}} {{a", values), Error);
}

TEST_CASE("text cannot become a tag or end an attribute") {
    CHECK(escape("<b title=\"x\">A & B</b>") == "&lt;b title=&quot;x&quot;&gt;A &amp; B&lt;/b&gt;");
    CHECK(escape("N\u00b7L") == "N\u00b7L");
}

// The test vectors of RFC 4648, section 10.
TEST_CASE("a file becomes an address") {
    const TemporaryFolder folder;
    const auto file = folder / "f";
    for (const auto& [text, coded] : std::map<std::string, std::string>{{"", ""},
                                                                        {"f", "Zg=="},
                                                                        {"fo", "Zm8="},
                                                                        {"foo", "Zm9v"},
                                                                        {"foob", "Zm9vYg=="},
                                                                        {"fooba", "Zm9vYmE="},
                                                                        {"foobar", "Zm9vYmFy"},
                                                                        {"\xff\xfe\xfd", "//79"}}) {
        write_text(file, text);
        CHECK(data_uri(file, "a/b") == "data:a/b;base64," + coded);
        CHECK(read_text(file) == text);
    }
    CHECK_THROWS_AS(data_uri(folder / "none", "a/b"), Error);
}

}  // namespace
}  // namespace glint
