#include "tests/grading/instructor/domains.hpp"

#include "framework/math/error.hpp"
#include "framework/math/incidence.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <numbers>

namespace glint::grading {
namespace {

using Numbers = std::vector<double>;
using Vector = Vec3<double>;

constexpr double pi = std::numbers::pi;

void put(Numbers& to, const Vector& v) {
    to.insert(to.end(), {v.x, v.y, v.z});
}

// On the sphere, where z lies between the bounds.
Vector direction(Random& r, double low = -1, double high = 1) {
    const double z = r.between(low, high);
    const double azimuth = r.between(-pi, pi);
    const double side = std::sqrt(1 - z * z);
    return {side * std::cos(azimuth), side * std::sin(azimuth), z};
}

double exponent(Random& r) {
    return std::exp2(r.between(0, 9));
}

// Where a lobe about the mirror direction R falls to something between 1 and 5 %.
Vector near_mirror(Random& r, const Vector& R, double n) {
    const double cosine = std::pow(r.between(0.05, 1), 1 / n);
    const Vector other = cross(R, normalize(cross(R, direction(r))));
    return cosine * R + std::sqrt(1 - cosine * cosine) * other;
}

void incidence(Random& r, Numbers& to) {
    const Vector L = direction(r, 0.02);
    const Vector V = direction(r, 0.02);
    put(to, {L.z, V.z, dot(L, V)});
}

void lobe(Random& r, Numbers& to) {
    const double n = exponent(r);
    Vector L;
    Vector V;
    do {
        L = direction(r, 0.05);
        V = near_mirror(r, Vector(-L.x, -L.y, L.z), n);
    } while (V.z < 0.02);
    put(to, {L.z, V.z, dot(L, V)});
    to.push_back(n);
}

// Every eighth light is below the horizon.
void highlight(Random& r, Numbers& to) {
    const double n = exponent(r);
    const Vector N = direction(r);
    Vector L = direction(r);
    L *= (dot(N, L) < 0) != (r.bits() % 8 == 0) ? -1 : 1;
    put(to, N);
    put(to, L);
    put(to, near_mirror(r, 2 * dot(N, L) * N - L, n));
    to.push_back(n);
}

int integer(Random& r, int low, int high) {
    return low + static_cast<int>(r.bits() % static_cast<std::uint64_t>(high - low + 1));
}

// A triangle that has an area, and a point, on a grid so coarse that the point often is on an edge.
void lattice(Random& r, Numbers& to) {
    Numbers n;
    do {
        n.clear();
        for (int i = 0; i < 8; ++i) {
            n.push_back(integer(r, 0, 4));
        }
    } while ((n[2] - n[0]) * (n[5] - n[1]) == (n[4] - n[0]) * (n[3] - n[1]));
    to.insert(to.end(), n.begin(), n.end());
}

using Draw = void (*)(Random&, Numbers&);

const std::map<std::string, Draw>& domains() {
    static const std::map<std::string, Draw> all{
        {"cosine", [](Random& r, Numbers& to) { to.push_back(r.between(0.02, 0.98)); }},
        {"angle", [](Random& r, Numbers& to) { to.push_back(r.between(0, pi / 2)); }},
        {"exponent", [](Random& r, Numbers& to) { to.push_back(exponent(r)); }},
        {"index", [](Random& r, Numbers& to) { to.push_back(r.between(1, 2.5)); }},
        {"metal",
         [](Random& r, Numbers& to) {
             to.push_back(r.between(0.05, 3));
             to.push_back(r.between(1.5, 8));
         }},
        {"either", [](Random& r, Numbers& to) { to.push_back(r.bits() % 2 == 0 ? 0 : 1); }},
        {"colour",
         [](Random& r, Numbers& to) {
             const double red = r.between(0.02, 0.98);
             const double green = r.between(0.02, 0.98);
             put(to, {red, green, r.between(0.02, 0.98)});
         }},
        {"direction", [](Random& r, Numbers& to) { put(to, direction(r)); }},
        {"incidence", incidence},
        {"lobe", lobe},
        {"highlight", highlight},
        {"lattice", lattice},
    };
    return all;
}

}  // namespace

void draw(const nlohmann::json& domain, Random& random, Numbers& numbers) {
    if (domain.is_array()) {
        numbers.push_back(random.between(domain.at(0), domain.at(1)));
        return;
    }
    if (domain.is_object()) {
        const nlohmann::json& range = domain.at("integer");
        numbers.push_back(integer(random, range.at(0), range.at(1)));
        return;
    }
    const auto found = domains().find(domain.get<std::string>());
    if (found == domains().end()) {
        throw Error("there is no domain " + domain.dump());
    }
    found->second(random, numbers);
}

}  // namespace glint::grading
