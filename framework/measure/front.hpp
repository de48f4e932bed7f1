// Which of many ways to do the same are worth choosing: the Pareto front of cost and error.
#pragma once

#include "framework/math/error.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace glint {

struct CostAndError {
    double cost, error;
};

// No worse in either, and better in one.
inline bool beats(const CostAndError& a, const CostAndError& b) {
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

// For each point, whether none beats it; of equal ones all or none are on the front. Infinity is
// as bad as can be; a NaN is an Error.
inline std::vector<bool> pareto_front(std::span<const CostAndError> points) {
    std::vector<bool> on_front;
    for (const CostAndError& p : points) {
        if (std::isnan(p.cost) || std::isnan(p.error)) {
            throw Error("front: point " + std::to_string(on_front.size()) + " is not a number");
        }
        on_front.push_back(std::none_of(points.begin(), points.end(),
                                        [&](const CostAndError& q) { return beats(q, p); }));
    }
    return on_front;
}

}  // namespace glint
