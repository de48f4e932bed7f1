#include "tests/grading/instructor/make_batch.hpp"

#include "framework/measure/quadrature.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/instructor/domains.hpp"
#include "tests/grading/instructor/fragments.hpp"
#include "tests/grading/judge.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace glint::grading {
namespace {

using nlohmann::json;
using Numbers = std::vector<double>;

class Maker {
  public:
    Maker(const Wanted& wanted, const std::string& number)
        : w_(wanted),
          single_(number != "double"),
          task_(task_number(wanted.task.at("id"))),
          random_(wanted.seed) {
        batch_.number = number;
        batch_.answers_a_row = wanted.task.at("answers");
    }

    Batch make() {
        ask();
        Numbers truth = answers_of(w_.variants.front().as_double, batch_.questions);
        Numbers tolerance = tolerances(truth);
        if (kind() == "values" || kind() == "picture") {
            drop_ill_conditioned(truth, tolerance);
        } else if (kind() == "rows") {
            limit(tolerance, truth);
        }
        check(truth, tolerance);
        find_mistakes(truth, tolerance);
        batch_.floor = floor(truth);
        return std::move(batch_);
    }

  private:
    std::string kind() const { return w_.asked.at("kind"); }
    static double largest(const Numbers& numbers) {
        double most = 0;
        for (const double x : numbers) {
            most = std::max(most, std::abs(x));
        }
        return most;
    }
    // The middle one of those that are not 0: answers may differ by orders of magnitude.
    static double typical(const Numbers& numbers) {
        Numbers sizes;
        for (const double x : numbers) {
            if (x != 0) {
                sizes.push_back(std::abs(x));
            }
        }
        std::sort(sizes.begin(), sizes.end());
        return sizes.empty() ? 0 : sizes[sizes.size() / 2];
    }
    static int task_number(const std::string& id) { return id.at(3) - '0'; }

    // ---- questions; what floats cannot hold is asked of neither type
    void add_row(const Numbers& row) {
        batch_.columns = row.size();
        for (const double x : row) {
            batch_.questions.push_back(static_cast<double>(static_cast<float>(x)));
        }
    }
    Numbers drawn_row() {
        Numbers row;
        for (const json& domain : w_.task.at("asks")) {
            draw(domain, random_, row);
        }
        return row;
    }
    void ask() {
        if (kind() == "rows") {
            for (const json& row : w_.asked.at("rows")) {
                add_row(row.get<Numbers>());
            }
        } else if (kind() == "values" || kind() == "reciprocity") {
            for (int i = 0; i < w_.asked.at("count"); ++i) {
                Numbers row = drawn_row();
                add_row(row);
                if (kind() == "reciprocity") {
                    std::swap(row.at(w_.asked.at("swap")[0]), row.at(w_.asked.at("swap")[1]));
                    add_row(row);
                }
            }
        } else if (kind() == "picture") {
            ask_fragments();
        } else if (kind() == "coverage") {
            ask_raster();
        } else if (kind() == "albedo") {
            for (const double cosine : w_.asked.at("cosines")) {
                ask_hemisphere(cosine);
            }
        } else {
            throw Error("there is no kind of case " + kind());
        }
    }
    // What the still life shows in each pixel, of those that are lit where the answer is a BRDF.
    void ask_fragments() {
        const bool lit = w_.asked.value("lit", false);
        const Fragments& picture = still_life_fragments();
        batch_.frame = {picture.width, picture.height, {}, {}};
        for (const Fragment& f : picture.all) {
            if (!lit || (f.NL() > 0.02F && f.NV() > 0.02F)) {
                Numbers row;
                for (const json& part : w_.asked.at("row")) {
                    put_part(f, part, row);
                }
                add_row(row);
                batch_.frame.pixels.push_back(f.pixel);
                batch_.frame.light.push_back(lit ? std::numbers::pi * f.NL() : 1);
            }
        }
    }
    // The manifest's triangle, asked about every pixel; a row answers for some that follow.
    void ask_raster() {
        const int width = w_.asked.at("width");
        const int height = w_.asked.at("height");
        batch_.frame = {width, height, {}, {}};
        for (int pixel = 0; pixel < width * height; pixel += w_.task.at("answers").get<int>()) {
            auto row = w_.asked.at("triangle").get<Numbers>();
            const int x = pixel % width;
            const int y = pixel / width;
            row.push_back(x);
            row.push_back(y);
            add_row(row);
            batch_.frame.pixels.push_back(pixel);
            batch_.frame.light.push_back(1);
        }
    }
    // The integral over the hemisphere of BRDF cos(theta) d omega: by Gauss over cos(theta), by
    // equal steps over the azimuth, of which the other half is the same.
    void ask_hemisphere(double NL) {
        constexpr int azimuths = 8;
        static const Quadrature rule = gauss_legendre(16);
        for (std::size_t i = 0; i < rule.node.size(); ++i) {
            const double NV = 0.5 * (rule.node[i] + 1);
            for (int j = 0; j < azimuths; ++j) {
                const double azimuth = std::numbers::pi * (j + 0.5) / azimuths;
                const double side = std::sqrt((1 - NL * NL) * (1 - NV * NV));
                add_row(filled({NL, NV, NL * NV + side * std::cos(azimuth)}));
                weights_.push_back(std::numbers::pi / azimuths * rule.weight[i] * NV);
            }
        }
    }
    // The manifest's row, in which nulls stand for the incidence.
    Numbers filled(const Numbers& incidence) const {
        Numbers row;
        std::size_t next = 0;
        for (const json& x : w_.asked.at("row")) {
            row.push_back(x.is_null() ? incidence.at(next++) : x.get<double>());
        }
        return row;
    }

    // ---- answers
    Numbers answers_of(Answer answer, const Numbers& questions) const {
        const std::size_t rows = questions.size() / batch_.columns;
        Numbers all(rows * batch_.answers_a_row);
        for (std::size_t i = 0; i < rows; ++i) {
            answer(task_, &questions[i * batch_.columns], &all[i * batch_.answers_a_row]);
        }
        return all;
    }
    // How far rounding may take an honest answer: a few units of the answer, and as many as the
    // answer changes by when a question does by a unit; constants may be floats among doubles.
    Numbers tolerances(const Numbers& truth) const {
        if (w_.task.value("exact", false)) {
            return Numbers(truth.size());
        }
        const double unit = (single_ ? 100 : 1) * 0x1p-23;
        const Answer answer = w_.variants.front().as_double;
        const double scale = typical(truth);
        Numbers change(truth.size(), 0.0);
        for (std::size_t column = 0; column < batch_.columns; ++column) {
            constexpr double step = 1e-6;
            Numbers moved = batch_.questions;
            for (std::size_t i = column; i < moved.size(); i += batch_.columns) {
                moved[i] += step * std::max(std::abs(moved[i]), 1e-3);
            }
            const Numbers there = answers_of(answer, moved);
            for (std::size_t i = 0; i < truth.size(); ++i) {
                const double slope = std::abs(there[i] - truth[i]) / step;
                change[i] += std::isfinite(slope) ? slope : 0;
            }
        }
        Numbers tolerance(truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double size = std::abs(truth[i]) + 0.01 * scale;
            tolerance[i] = 2 * unit * size + 0.2 * unit * change[i];
        }
        return tolerance;
    }

    // A thousandth of the largest answer: who is off by more is wrong.
    static double most(const Numbers& truth) { return 1e-3 * largest(truth); }

    // Rows that the manifest names are exact, at a jump of the truth too.
    static void limit(Numbers& tolerance, const Numbers& truth) {
        for (double& t : tolerance) {
            t = std::min(t, most(truth));
        }
    }
    // Drawn rows at which an honest answer may be far off are not asked.
    void drop_ill_conditioned(Numbers& truth, Numbers& tolerance) {
        const double limit = most(truth);
        const std::size_t width = batch_.answers_a_row;
        Numbers questions;
        Numbers kept_truth;
        Numbers kept;
        Frame frame{batch_.frame.width, batch_.frame.height, {}, {}};
        for (std::size_t i = 0; i < batch_.rows(); ++i) {
            const auto at = [&](Numbers& n, std::size_t row) {
                return n.begin() + static_cast<std::ptrdiff_t>(row);
            };
            const auto begin = at(tolerance, i * width);
            const auto end = at(tolerance, (i + 1) * width);
            if (std::all_of(begin, end, [&](double t) { return t <= limit; })) {
                if (kind() == "picture") {
                    frame.pixels.push_back(batch_.frame.pixels[i]);
                    frame.light.push_back(batch_.frame.light[i]);
                }
                questions.insert(questions.end(), at(batch_.questions, i * batch_.columns),
                                 at(batch_.questions, (i + 1) * batch_.columns));
                kept_truth.insert(kept_truth.end(), at(truth, i * width),
                                  at(truth, (i + 1) * width));
                kept.insert(kept.end(), begin, end);
            }
        }
        batch_.questions = questions;
        batch_.frame = frame;
        truth = kept_truth;
        tolerance = kept;
    }

    // ---- checks
    void check(const Numbers& truth, const Numbers& tolerance) {
        const std::size_t width = batch_.answers_a_row;
        if (kind() == "reciprocity") {
            for (std::size_t i = 0; i < truth.size(); i += 2 * width) {
                for (std::size_t j = i; j < i + width; ++j) {
                    const double off = tolerance[j] + tolerance[j + width];
                    batch_.checks.push_back({{{j, 1.0}, {j + width, -1.0}}, -off, off});
                }
            }
        } else if (kind() == "albedo") {
            const std::size_t rows = weights_.size() / w_.asked.at("cosines").size();
            for (std::size_t first = 0; first < weights_.size(); first += rows) {
                for (std::size_t i = 0; i < width; ++i) {
                    check_sum(truth, tolerance, first, first + rows, i);
                }
            }
        } else {
            for (std::size_t i = 0; i < truth.size(); ++i) {
                batch_.checks.push_back(
                    {{{i, 1.0}}, truth[i] - tolerance[i], truth[i] + tolerance[i]});
            }
        }
    }
    void check_sum(const Numbers& truth, const Numbers& tolerance, std::size_t first,
                   std::size_t end, std::size_t component) {
        Check c{{}, 0, 0};
        double sum = 0;
        double off = 0;
        for (std::size_t row = first; row < end; ++row) {
            const std::size_t i = row * batch_.answers_a_row + component;
            c.terms.push_back({i, weights_[row]});
            sum += weights_[row] * truth[i];
            off += weights_[row] * tolerance[i];
        }
        c.low = sum - off;
        c.high = sum + off;
        batch_.checks.push_back(c);
    }

    // ---- what is known beforehand
    void find_mistakes(const Numbers& truth, const Numbers& tolerance) {
        for (const Variant& v : w_.variants.subspan(1)) {
            if (v.kind == VariantKind::alternative) {
                continue;
            }
            const Numbers answers =
                answers_of(single_ ? v.as_float : v.as_double, batch_.questions);
            bool differs = false;
            for (std::size_t i = 0; i < truth.size(); ++i) {
                differs = differs || !(std::abs(answers[i] - truth[i]) <= tolerance[i]);
            }
            if (differs) {
                batch_.mistakes.push_back(
                    {v.task, v.words, v.kind == VariantKind::skeleton, answers});
            }
        }
    }
    // Trivial answers: 0, 1, the middle one of the right answers, the skeleton's.
    double floor(const Numbers& truth) const {
        Numbers sorted = truth;
        std::sort(sorted.begin(), sorted.end());
        double best = 0;
        for (const double constant : {0.0, 1.0, sorted[sorted.size() / 2]}) {
            best = std::max(best, passed_share(batch_, Numbers(truth.size(), constant)));
        }
        for (const Mistake& m : batch_.mistakes) {
            if (m.skeleton && (m.task.empty() || m.task == w_.task.at("id"))) {
                best = std::max(best, passed_share(batch_, m.answers));
            }
        }
        if (best == 1 && kind() != "albedo" && kind() != "reciprocity") {
            throw Error(w_.asked.at("name").get<std::string>() + ": trivial answers pass all");
        }
        return best;
    }

    Wanted w_;
    bool single_;
    int task_;
    Random random_;
    Batch batch_{};
    Numbers weights_;  // of the rows of an albedo
};

}  // namespace

Batch make_batch(const Wanted& wanted, const std::string& number) {
    return Maker(wanted, number).make();
}

}  // namespace glint::grading
