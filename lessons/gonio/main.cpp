// gonio: evaluates a lesson's model on rows of numbers, in float, in lanes and in double.
#include "lessons/gonio/csv.hpp"
#include "lessons/gonio/models.hpp"
#include "framework/math/lanes.hpp"

#include <functional>
#include <iostream>
#include <map>
#include <sstream>

namespace {

using namespace glint;

using Widest = Float<max_lanes>;

struct Model {
    models::Columns in, out;
    std::function<models::Row<double>(const models::Row<double>&)> in_float, in_lanes, in_double;
};

double as_double(double value) {
    return value;
}
double as_double(float value) {
    return double{value};
}
double as_double(const Widest& value) {
    float lanes[lanes_of<Widest>];
    store(lanes, value);
    return double{lanes[0]};
}

template <class M, Real T>
models::Row<double> eval(const models::Row<double>& row) {
    models::Row<T> in;
    for (const double value : row) {
        in.push_back(
            T(static_cast<std::conditional_t<std::same_as<T, double>, double, float>>(value)));
    }
    models::Row<double> out;
    for (const T& value : M::eval(in)) {
        out.push_back(as_double(value));
    }
    return out;
}

template <class M>
Model model() {
    return {M::in(), M::out(), eval<M, float>, eval<M, Widest>, eval<M, double>};
}

const std::map<std::string, Model>& all_models() {
    static const std::map<std::string, Model> all{
        {"fresnel_dielectric", model<models::FresnelDielectric>()},
        {"fresnel_conductor", model<models::FresnelConductor>()},
        {"fresnel_conductor_approx", model<models::FresnelConductorApprox>()},
        {"schlick", model<models::SchlickModel>()},
        {"lambert", model<models::Lambert>()},
        {"phong_adhoc", model<models::Phong<false>>()},
        {"phong_normalised", model<models::Phong<true>>()},
        {"final", model<models::Final>()},
        {"albedo", model<models::Albedo>()},
    };
    return all;
}

std::string joined(const models::Columns& columns) {
    std::string text;
    for (const std::string& column : columns) {
        text += (text.empty() ? "" : ",") + column;
    }
    return text;
}

std::string help() {
    std::string text =
        "gonio MODEL: evaluates a lesson's model on rows of numbers (CSV with a header) from\n"
        "standard input and prints each result in float, in SIMD lanes and in double.\n"
        "Directions are made unit length; other columns are passed over.\n\n";
    for (const auto& [name, m] : all_models()) {
        text += "  " + name + "\n      " + joined(m.in) + " -> " + joined(m.out) + "\n";
    }
    return text + "\nExample:\n  printf 'n1,n2,cos_i\\n1,1.5,0.5\\n' | gonio fresnel_dielectric\n";
}

void print(const Model& m, const models::Row<double>& row) {
    const auto f = m.in_float(row);
    const auto lanes = m.in_lanes(row);
    const auto d = m.in_double(row);
    std::ostringstream line;
    for (std::size_t i = 0; i < d.size(); ++i) {
        line.precision(9);
        line << (i == 0 ? "" : ",") << f[i] << ',' << lanes[i] << ',';
        line.precision(17);
        line << d[i];
    }
    std::cout << line.str() << '\n';
}

void run(const std::string& name) {
    const auto found = all_models().find(name);
    if (found == all_models().end()) {
        throw Error("there is no model " + name + "; gonio --help lists them");
    }
    const Model& m = found->second;
    CsvReader rows(std::cin, m.in);
    std::string header;
    for (const std::string& column : m.out) {
        for (const char* type : {"_f32", "_lanes", "_f64"}) {
            header += (header.empty() ? "" : ",") + column + type;
        }
    }
    std::cout << header << '\n';
    for (models::Row<double> row; rows.next(row);) {
        print(m, row);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && (std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h")) {
        std::cout << help();
        return 0;
    }
    try {
        if (argc != 2) {
            throw Error("gonio needs the name of one model; gonio --help lists them");
        }
        run(argv[1]);
        return 0;
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
