// make_variants HEADER MUTANTS QUESTIONS OUT: writes the source of a lesson's variants. Its header
// stands there once for the solution, once for the skeleton, once for each task's skeleton and once
// for each mutant, each in a namespace of its own inside glint.
#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/instructor/marks.hpp"
#include "tests/grading/instructor/mutants.hpp"

#include <filesystem>
#include <iostream>
#include <regex>
#include <sstream>

namespace {

using namespace glint::grading;
using glint::read_text;
using glint::write_text;

struct Source {
    std::string kind, task, words, text;
};

std::vector<Source> sources(const std::vector<Region>& regions, const std::vector<Mutant>& all) {
    std::vector<Source> out{{"solution", "", "", with_answer(regions, "", {})},
                            {"skeleton", "", "the skeleton", handed_out(regions)}};
    for (const Region& r : regions) {
        if (!r.task.empty()) {
            out.push_back(
                {"skeleton", r.task, "the skeleton", with_answer(regions, r.task, r.skeleton)});
        }
    }
    for (const Mutant& m : all) {
        out.push_back({m.right ? "alternative" : "mutant", m.task, m.words,
                       with_answer(regions, m.task, m.code)});
    }
    return out;
}

bool is_include(const std::string& line) {
    return line.starts_with("#include");
}

void write_includes(std::ostream& out, const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (is_include(line)) {
            out << line << '\n';
        }
    }
}

// The text's namespaces glint become glint::NAME.
void write_renamed(std::ostream& out, const std::string& text, const std::string& name) {
    static const std::regex glint("^namespace glint\\b");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("#")) {
            out << std::regex_replace(line, glint, "namespace glint::" + name) << '\n';
        }
    }
}

// One for each variant of each lesson: they are all linked together.
std::string name_of(const std::string& lesson, std::size_t variant) {
    return "as_" + lesson.substr(0, 2) + '_' + std::to_string(variant);
}

void write_table(std::ostream& out, const std::vector<Source>& all, const std::string& lesson) {
    out << "namespace glint::grading {\nstd::span<const Variant> variants_" << lesson
        << "() {\n    static const Variant all[] = {\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = "glint::" + name_of(lesson, i);
        out << "        {VariantKind::" << all[i].kind << ", \"" << all[i].task << "\", R\"("
            << all[i].words << ")\", " << name << "::plain<float>, " << name
            << "::plain<double>},\n";
    }
    out << "    };\n    return all;\n}\n}\n";
}

void write(std::ostream& out, const std::vector<Source>& all, const std::string& questions,
           const std::string& lesson) {
    write_includes(out, all.front().text);
    out << "#include \"tests/grading/runner/question.hpp\"\n"
           "#include \"tests/grading/instructor/variants.hpp\"\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = name_of(lesson, i);
        write_renamed(out, all[i].text, name);
        out << "namespace glint::" << name << " {\n" << questions;
        out << "template <class T>\nvoid plain(int task, const double* in, double* out) {\n"
               "    answer<T>(task, In<T>(in), Out<T>(out));\n}\n}\n";
    }
    write_table(out, all, lesson);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 5) {
            throw glint::Error("usage: make_variants HEADER MUTANTS QUESTIONS OUT");
        }
        const auto regions = read_marks(argv[1], read_text(argv[1]));
        const auto mutants = read_mutants(argv[2], read_text(argv[2]));
        const std::string lesson = std::filesystem::path(argv[3]).stem();
        std::ostringstream out;
        write(out, sources(regions, mutants), read_text(argv[3]), lesson);
        write_text(argv[4], out.str());
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
