#include "tests/oracle/cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint::oracle {
namespace {

struct Vector {  // in pixels
    double x, y;
};
Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y};
}
Vector operator*(double s, Vector a) {
    return {s * a.x, s * a.y};
}
Vector polar(double radius, double angle) {
    return {radius * std::cos(angle), radius * std::sin(angle)};
}
Vector pixels(Point p) {
    return {double(p.x) / units_per_pixel, double(p.y) / units_per_pixel};
}
Point rounded(Vector v) {
    return from_pixels(v.x, v.y);
}
Vector quarter_turn(Vector v) {
    return {-v.y, v.x};
}

// Each draws in an order that no compiler may change: arguments of a call have none.
double any_angle(Random& random) {
    return random.real(0, 2 * std::numbers::pi);
}
double any_length(Random& random, double shortest, double longest) {
    return std::exp(random.real(std::log(shortest), std::log(longest)));
}
Vector any_vector(Random& random, double shortest, double longest) {
    const double angle = any_angle(random);
    return polar(any_length(random, shortest, longest), angle);
}

// ---- lattices: (columns + 1) x (rows + 1) points, bent and shifted -----------------------------

struct Lattice {
    int columns, rows;
    std::vector<Point> points;

    Point at(int i, int j) const {
        return points[static_cast<std::size_t>(std::int64_t{j} * (columns + 1) + i)];
    }
};

template <class Place>
Lattice make_lattice(int columns, int rows, Place place) {
    Lattice lattice{columns, rows, {}};
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            lattice.points.push_back(rounded(place(i, j)));
        }
    }
    return lattice;
}

void add_cells(Random& random, const Lattice& lattice, Case& c) {
    for (int j = 0; j < lattice.rows; ++j) {
        for (int i = 0; i < lattice.columns; ++i) {
            const Point p00 = lattice.at(i, j);
            const Point p10 = lattice.at(i + 1, j);
            const Point p01 = lattice.at(i, j + 1);
            const Point p11 = lattice.at(i + 1, j + 1);
            if (random.one_in(2)) {
                c.triangles.push_back({p00, p10, p11});
                c.triangles.push_back({p00, p11, p01});
            } else {
                c.triangles.push_back({p00, p10, p01});
                c.triangles.push_back({p10, p11, p01});
            }
        }
    }
}

void add_border(const Lattice& lattice, Case& c) {
    for (int i = 0; i < lattice.columns; ++i) {
        c.outline.push_back(lattice.at(i, 0));
    }
    for (int j = 0; j < lattice.rows; ++j) {
        c.outline.push_back(lattice.at(lattice.columns, j));
    }
    for (int i = lattice.columns; i > 0; --i) {
        c.outline.push_back(lattice.at(i, lattice.rows));
    }
    for (int j = lattice.rows; j > 0; --j) {
        c.outline.push_back(lattice.at(0, j));
    }
}

struct Cells {
    int columns, rows;
    Vector across, down;
    double jitter;  // how far points may stray, in cells: below a quarter nothing folds
};

void draw_lattice(Random& random, Case& c, const Cells& cells) {
    const Vector middle = pixels(anywhere(random, c, 0));
    const int middle_column = cells.columns / 2;
    const int middle_row = cells.rows / 2;
    const Lattice lattice = make_lattice(cells.columns, cells.rows, [&](int i, int j) {
        const double u = i - middle_column + random.real(-cells.jitter, cells.jitter);
        const double v = j - middle_row + random.real(-cells.jitter, cells.jitter);
        return middle + u * cells.across + v * cells.down;
    });
    add_cells(random, lattice, c);
    add_border(lattice, c);
}

void draw_sheared_grid(Random& random, Case& c) {
    draw_lattice(random, c,
                 {random.between(1, 12), random.between(1, 12), any_vector(random, 0.3, 3),
                  any_vector(random, 0.3, 3), 0});
}

void draw_jittered_grid(Random& random, Case& c) {
    const Vector across = any_vector(random, 1, 16);
    draw_lattice(random, c,
                 {random.between(2, 8), random.between(2, 8), across,
                  random.real(0.5, 2) * quarter_turn(across), 0.22});
}

void draw_strip(Random& random, Case& c) {
    draw_lattice(random, c,
                 {random.between(4, 60), 1, any_vector(random, 0.05, 5),
                  any_vector(random, 0.05, 20), random.one_in(2) ? 0 : 0.22});
}

// The polar angle runs with i; column 0 is also the last.
void draw_rings(Random& random, Case& c) {
    const int segments = random.between(3, 24);
    const int rings = random.between(1, 6);
    const Point centre = random.one_in(2) ? any_sample(random, c) : anywhere(random, c, 0);
    const double hole = random.real(0.1, 10);
    const double thickness = random.real(0.1, 10);
    const double start = any_angle(random);
    const Lattice lattice = make_lattice(segments, rings, [&](int i, int j) {
        const double turn = double(i % segments) / segments;
        return pixels(centre) + polar(hole + j * thickness, start + 2 * std::numbers::pi * turn);
    });
    add_cells(random, lattice, c);
    for (int i = 0; i <= segments; ++i) {
        c.outline.push_back(lattice.at(i, rings));
    }
    for (int i = segments; i >= 0; --i) {
        c.outline.push_back(lattice.at(i, 0));
    }
}

// ---- fans ---------------------------------------------------------------------------------------

void draw_fan(Random& random, Case& c, Point centre, double shortest, double longest) {
    const double radius = any_length(random, shortest, longest);
    const int spokes = random.between(3, 40);
    const bool closed = random.one_in(2);
    const double opening = closed ? 2 * std::numbers::pi : random.real(0.1, 3);
    const double start = any_angle(random);
    std::vector<Point> rim;
    for (int i = 0; i < spokes; ++i) {
        const double angle = start + opening * (i + random.real(0, 0.9)) / spokes;
        rim.push_back(rounded(pixels(centre) + polar(radius * random.real(0.3, 1), angle)));
    }
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
        c.triangles.push_back({centre, rim[i], rim[i + 1]});
    }
    if (closed) {
        c.triangles.push_back({centre, rim.back(), rim.front()});
    } else {
        c.outline.push_back(centre);
    }
    c.outline.insert(c.outline.end(), rim.begin(), rim.end());
}

void draw_fan_at_sample(Random& random, Case& c) {
    draw_fan(random, c, any_sample(random, c), 0.5, 2000);
}

void draw_fan_at_corner(Random& random, Case& c) {
    draw_fan(random, c, any_corner(random, c), 0.5, 2000);
}

void draw_fan_anywhere(Random& random, Case& c) {
    draw_fan(random, c, anywhere(random, c, 0), 0.5, 2000);
}

// ---- point sets ---------------------------------------------------------------------------------

Point any_point_of(Random& random, const Triangle& t) {
    const double u = random.real(0, 1);
    const double v = random.real(0, 1 - u);
    return rounded((1 - u - v) * pixels(t[0]) + u * pixels(t[1]) + v * pixels(t[2]));
}

bool contains(const Triangle& t, Point p) {  // with its border
    const Triangle parts[] = {{p, t[1], t[2]}, {t[0], p, t[2]}, {t[0], t[1], p}};
    return !is_folded(parts);
}

// Each point splits the triangle that it lies in into three: thinner and thinner ones.
void draw_point_set(Random& random, Case& c, double size) {
    const Vector side = polar(size, any_angle(random));
    draw_lattice(random, c, {1, 1, side, quarter_turn(side), 0.2});
    const int tries = random.between(1, 80);
    for (int i = 0; i < tries; ++i) {
        const auto which =
            static_cast<std::size_t>(random.between(0, static_cast<int>(c.triangles.size()) - 1));
        const Triangle t = c.triangles[which];
        const Point p = random.one_in(2) ? any_sample(random, c) : any_point_of(random, t);
        if (contains(t, p)) {
            c.triangles[which] = {p, t[1], t[2]};
            c.triangles.push_back({t[0], p, t[2]});
            c.triangles.push_back({t[0], t[1], p});
        }
    }
}

void draw_point_set_nearby(Random& random, Case& c) {
    draw_point_set(random, c, random.real(4, 128));
}

void draw_across_guard_band(Random& random, Case& c) {
    constexpr double shortest = 2000;
    constexpr double longest = 11000;
    switch (random.between(0, 2)) {
        case 0:
            return draw_fan(random, c, any_sample(random, c), shortest, longest);
        case 1:
            return draw_point_set(random, c, random.real(shortest, longest));
        default:
            return draw_lattice(random, c,
                                {2, 2, any_vector(random, shortest, longest),
                                 any_vector(random, shortest, longest), 0.22});
    }
}

constexpr Kind kinds[] = {
    {"sheared grids", draw_sheared_grid},
    {"jittered grids", draw_jittered_grid},
    {"strips", draw_strip},
    {"concentric rings", draw_rings},
    {"fans at a sample", draw_fan_at_sample},
    {"fans at a pixel corner", draw_fan_at_corner},
    {"fans anywhere", draw_fan_anywhere},
    {"point sets", draw_point_set_nearby},
    {"meshes across the guard band", draw_across_guard_band},
};

}  // namespace

std::span<const Kind> mesh_kinds() {
    return kinds;
}

}  // namespace glint::oracle
