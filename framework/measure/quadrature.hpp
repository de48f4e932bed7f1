// Integrals as sums.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace glint {

struct Quadrature {
    std::vector<double> node, weight;  // on [-1, 1]
};

// Gauss and Legendre's rule of count >= 1 points: exact for polynomials of degree 2 count - 1.
// Nodes are the roots of the Legendre polynomial, by Newton's iteration (Abramowitz and Stegun
// 25.4.29).
inline Quadrature gauss_legendre(int count) {
    Quadrature q;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        double slope = 0;
        for (double step = 1; std::abs(step) > 1e-15;) {
            double p = 1;
            double before = 0;
            for (int k = 1; k <= count; ++k) {
                const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            slope = count * (x * p - before) / (x * x - 1);
            step = p / slope;
            x -= step;
        }
        q.node.push_back(x);
        q.weight.push_back(2 / ((1 - x * x) * slope * slope));
    }
    return q;
}

// The integral of f from a to b.
template <class F>
auto integrate(const Quadrature& q, double a, double b, F&& f) {
    const double half = (b - a) / 2;
    auto sum = f((a + b) / 2 + half * q.node[0]) * (half * q.weight[0]);
    for (std::size_t i = 1; i < q.node.size(); ++i) {
        sum += f((a + b) / 2 + half * q.node[i]) * (half * q.weight[i]);
    }
    return sum;
}

}  // namespace glint
