#include "framework/app/plan.hpp"

#include "framework/app/picture.hpp"
#include "framework/raster/renderer.hpp"
#include "framework/image/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace glint {
namespace {

constexpr int least_rounds = 5;  // frames that a way is timed by ...
constexpr int most_rounds = 25;  // ... more, if all take less time together
constexpr double enough_ms = 150;
constexpr double pays = 0.98;   // a saving below 2 % of the time is none
constexpr double safety = 2.0;  // on errors that a sample of the picture shows
constexpr int one_in = 4;       // columns, and rows, of the picture that the sample has

// What can be done in several ways, the full model's first, then ever cheaper.
struct Choice {
    std::string parameter;  // empty: the samples that are shaded
    std::vector<std::string> forms;
};

std::vector<Choice> choices(const Options& o) {
    std::vector<Choice> all;
    for (const Parameter& p : o.parameters.all()) {
        if (!p.forms.empty() && std::find(o.set.begin(), o.set.end(), p.name) == o.set.end()) {
            all.push_back({p.name, p.forms});
        }
    }
    if (o.settings.sample_shading && o.settings.samples > 1) {
        all.push_back({"", {"every sample shaded", "pixels shaded once a triangle"}});
    }
    return all;
}

using Levels = std::vector<std::size_t>;  // one a choice

class Planner {
  public:
    Planner(const Lesson& lesson, const Options& o, const Scene& scene)
        : lesson_(lesson), options_(o), scene_(scene), choices_(choices(o)) {}

    Plan plan() {
        Plan plan{.tolerance = options_.tolerance};
        own_error_ = safety * error_of_the_full_model();
        full_ = picture(way(Levels(choices_.size())));
        Levels levels = cheapest_together();
        for (;;) {
            plan.savings.clear();
            plan.full = way(Levels(choices_.size()));
            plan.chosen = way(levels);
            for (std::size_t i = 0; i < levels.size(); ++i) {
                if (levels[i] > 0) {
                    plan.savings.push_back({choices_[i].forms.front(), choices_[i].forms[levels[i]],
                                            without(levels, i)});
                }
            }
            measure(plan);
            const std::size_t useless = first_that_does_not_pay(plan, levels);
            if (useless == levels.size()) {
                break;
            }
            levels[useless] = 0;
        }
        if (plan.savings.empty() || plan.chosen.ms > plan.full.ms) {
            plan.savings.clear();
            plan.chosen = plan.full;
        }
        return plan;
    }

  private:
    Way way(const Levels& levels) const {
        Way w{.parameters = options_.parameters,
              .sample_shading = options_.settings.sample_shading};
        for (std::size_t i = 0; i < levels.size(); ++i) {
            if (choices_[i].parameter.empty()) {
                w.sample_shading = levels[i] == 0;
            } else {
                w.parameters.set(choices_[i].parameter, static_cast<float>(levels[i]));
            }
        }
        return w;
    }
    Way without(Levels levels, std::size_t choice) const {
        levels[choice] = 0;
        return way(levels);
    }

    Options options_for(const Way& w) const { return planned({.chosen = w}, options_); }

    LinearImage picture(const Way& w) const { return draw_linear(options_for(w)); }
    LinearImage draw_linear(const Options& o) const {
        LinearImage linear;
        Renderer renderer(o.settings);
        const ShaderSet set = lesson_.shaders(scene_, o.parameters);
        renderer.render(scene_.mesh, view_of(scene_, o.width, o.height), set.shaders,
                        {.linear = &linear, .background = scene_.background});
        return linear;
    }

    double error_of_the_full_model() const {
        Options o = options_for(way(Levels(choices_.size())));
        o.width = (o.width + one_in - 1) / one_in;
        o.height = (o.height + one_in - 1) / one_in;
        o.settings.samples = 1;
        const LinearImage full = draw_linear(o);
        o.settings.rasterizer = Rasterizer::reference;
        return largest_code_difference(draw_linear(o), full);
    }

    double error(const Way& w) const {
        return own_error_ + largest_code_difference(full_, picture(w));
    }
    bool is_within(const Levels& levels) const { return error(way(levels)) <= options_.tolerance; }

    // Each choice alone, then all at once; where that is too much, the one that then costs least is
    // made dearer.
    Levels cheapest_together() const {
        Levels levels(choices_.size());
        if (own_error_ > options_.tolerance) {
            return levels;
        }
        for (std::size_t i = 0; i < levels.size(); ++i) {
            Levels alone(choices_.size());
            alone[i] = choices_[i].forms.size() - 1;
            while (alone[i] > 0 && !is_within(alone)) {
                --alone[i];
            }
            levels[i] = alone[i];
        }
        while (!is_within(levels)) {
            std::vector<Levels> dearer;
            for (std::size_t i = 0; i < levels.size(); ++i) {
                if (levels[i] > 0) {
                    dearer.push_back(levels);
                    --dearer.back()[i];
                }
            }
            levels = fastest(dearer);
        }
        return levels;
    }

    Levels fastest(const std::vector<Levels>& all) const {
        std::vector<Way> ways(all.size());
        std::vector<Way*> timed(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            ways[i] = way(all[i]);
            timed[i] = &ways[i];
        }
        measure_times(timed);
        const auto least = std::ranges::min_element(ways, {}, &Way::ms);
        return all[static_cast<std::size_t>(least - ways.begin())];
    }

    // Errors and times.
    void measure(Plan& plan) const {
        std::vector<Way*> ways{&plan.full, &plan.chosen};
        for (Saving& s : plan.savings) {
            ways.push_back(&s.without);
        }
        for (Way* w : ways) {
            w->error = error(*w);
        }
        measure_times(ways);
    }

    // In turns.
    void measure_times(const std::vector<Way*>& ways) const {
        std::vector<Renderer> renderers;
        std::vector<ShaderSet> sets;
        for (Way* w : ways) {
            w->ms = std::numeric_limits<double>::infinity();
            renderers.emplace_back(options_for(*w).settings);
            sets.push_back(lesson_.shaders(scene_, w->parameters));
        }
        SrgbImage srgb;
        const View view = view_of(scene_, options_.width, options_.height);
        double spent = 0;
        for (int round = 0; round < least_rounds || (round < most_rounds && spent < enough_ms);
             ++round) {
            for (std::size_t i = 0; i < ways.size(); ++i) {
                const Statistics s =
                    renderers[i].render(scene_.mesh, view, sets[i].shaders,
                                        {.srgb = &srgb, .background = scene_.background});
                ways[i]->ms = std::min(ways[i]->ms, s.frame_ms);
                spent += s.frame_ms;
            }
        }
    }

    static std::size_t first_that_does_not_pay(const Plan& plan, const Levels& levels) {
        auto saving = plan.savings.begin();
        for (std::size_t i = 0; i < levels.size(); ++i) {
            if (levels[i] > 0 && plan.chosen.ms > pays * (saving++)->without.ms) {
                return i;
            }
        }
        return levels.size();
    }

    const Lesson& lesson_;
    const Options& options_;
    const Scene& scene_;
    std::vector<Choice> choices_;
    double own_error_ = 0;
    LinearImage full_;
};

std::ostream& operator<<(std::ostream& out, const Way& w) {
    return out << std::fixed << std::setprecision(2) << std::setw(9) << w.ms << " ms, error "
               << std::setprecision(3) << w.error << " codes";
}

}  // namespace

Plan make_plan(const Lesson& lesson, const Options& options, const Scene& scene) {
    return Planner(lesson, options, scene).plan();
}

Options planned(const Plan& plan, Options o) {
    o.parameters = plan.chosen.parameters;
    o.settings.sample_shading = plan.chosen.sample_shading;
    o.tolerance = 0;
    return o;
}

std::string plan_table(const Plan& plan) {
    std::ostringstream out;
    out << "plan for a tolerance of " << plan.tolerance << " codes"
        << (plan.met() ? "" : ": nothing meets it, this is the best") << '\n'
        << "  full model" << plan.full << '\n'
        << "  chosen    " << plan.chosen << ", " << std::setprecision(2)
        << plan.full.ms / plan.chosen.ms << " times as fast\n";
    for (const Saving& s : plan.savings) {
        out << "    " << s.cheaper << "; with " << s.full << ": " << std::showpos
            << std::setprecision(0) << 100 * (s.without.ms / plan.chosen.ms - 1) << std::noshowpos
            << " % time, error " << std::setprecision(3) << plan.chosen.error << " -> "
            << s.without.error << '\n';
    }
    return out.str();
}

}  // namespace glint
