// What is asked of a student's functions, and what their answers are held against. Holds numbers
// only: this is all that students get of the instructor's side.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace glint::grading {

// A weighted sum of answers that lies between two bounds: every check has this form.
struct Check {
    struct Term {
        std::size_t answer;  // its place among all answers
        double weight;
    };
    std::vector<Term> terms;
    double low, high;
};

// What a known mistake would answer.
struct Mistake {
    std::string task;   // where it is made, "09.1"
    std::string words;  // "a lobe without its 1/pi"
    bool skeleton;      // nothing was done yet
    std::vector<double> answers;
};

// Where the answers of a batch stand in a picture; none where width is 0.
struct Frame {
    int width = 0, height = 0;
    std::vector<int> pixels;    // of the rows' first answers, counted row by row from the top
    std::vector<double> light;  // what a row's answer is multiplied by to be seen
};

// Questions of one number type. Answers stand row by row.
struct Batch {
    std::string number;  // "float", "double" or "lanes"
    std::size_t columns, answers_a_row;
    std::vector<double> questions;
    std::vector<Check> checks;
    std::vector<Mistake> mistakes;  // those that answer otherwise than is right
    double floor;                   // the share of checks that trivial answers pass
    Frame frame;

    std::size_t rows() const { return questions.size() / columns; }
};

// A case is passed as far as the worst of its batches is.
struct Case {
    std::string name, kind;
    double points;
    bool hidden;
    std::vector<Batch> batches;

    bool is_property() const { return kind == "reciprocity" || kind == "albedo"; }
};

struct Task {
    std::string id, title;
    std::string of;  // what the numbers of a question are, vectors by their length: "N[3] L[3] n"
    std::vector<Case> cases;
};

struct Lesson {
    std::string name;    // "09_normalised_phong"
    std::string header;  // "normalised_phong.hpp"
    std::vector<Task> tasks;
};

void to_json(nlohmann::json& j, const Lesson& lesson);
void from_json(const nlohmann::json& j, Lesson& lesson);

}  // namespace glint::grading
