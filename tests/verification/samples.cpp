// The paper's two samples for each law: stress at given stretch compared with that of the incompressible rubber.
#include <cmath>

#include "core/text.hpp"
#include "problem.hpp"
#include "table.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "The paper's samples side by side";

struct Law {
    const char* name;
    std::vector<std::string> sets;
};

const std::vector<Law>& laws() {
    static const std::vector<Law> all{
        {"neo-Hookean, incompressible", {"material.kappa=incompressible"}},
        {"kraken", {"material.law=kraken", "mesh.formulation=displacement"}},
        {"neo-Hookean split, kappa/mu = 100", {}},
        {"linear elastic", {"material.law=linear-elastic"}},
    };
    return all;
}

/// One of the paper's samples: a box 100 mm long, stretched to `strain`.
struct Sample {
    const char* title;
    const char* text;
    const char* design;
    double strain;
    int compression;  ///< exponent n of the exact stress mu (l^2 - l^-n): 1 uniaxial, 4 equibiaxial
};

struct Measure {
    double mean_kPa = 0, max_kPa = 0, mean_percent = 0, max_percent = 0;
};

/// Errors at 20 evenly spaced strains up to that of the sample or to the end of the path; the stress difference is interpolated linearly
/// between rows.
Measure measure(const Run& run, const Sample& sample, double mu_Pa) {
    constexpr int points = 20;
    const auto exact_kPa = [&](double l) { return 1e-3 * mu_Pa * (l * l - std::pow(l, -sample.compression)); };
    const auto stretch = [&](std::size_t i) { return 1 + 10 * run.steps[i].outputs.at(0); };
    const auto difference = [&](std::size_t i) { return -1e-3 * run.steps[i].pressure_Pa - exact_kPa(stretch(i)); };
    const double last = std::min(1 + sample.strain, stretch(run.steps.size() - 1));
    Measure m;
    std::size_t row = 1;
    for (int k = 1; k <= points; ++k) {
        const double l = 1 + (last - 1) * k / points;
        while (row + 1 < run.steps.size() && stretch(row) < l) ++row;
        const double along = (l - stretch(row - 1)) / (stretch(row) - stretch(row - 1));
        const double error = std::abs((1 - along) * difference(row - 1) + along * difference(row));
        m.mean_kPa += error / points;
        m.mean_percent += 100 * error / exact_kPa(l) / points;
        m.max_kPa = std::max(m.max_kPa, error);
        m.max_percent = std::max(m.max_percent, 100 * error / exact_kPa(l));
    }
    return m;
}

std::string short_number(double value) { return std::abs(value) < 5e-5 ? "0" : core::rounded_text(value, 5); }

Outcome compare(const std::string& problem, const Sample& sample) {
    Table table{problem + ": " + sample.title,
                sample.text,
                {"law", "strain at full load [%]", "stress at full load [kPa]", "exact stress at full load [kPa]",
                 "mean error [kPa]", "largest error [kPa]", "mean error [% of exact]", "largest error [% of exact]",
                 "stop reason"},
                {}};
    for (const Law& law : laws()) {
        const auto run = run_design(sample.design, law.sets);
        const double mu = run.model.materials.front().constants.at("mu").front();
        const double l = 1 + 10 * run.steps.back().outputs.at(0);
        const auto m = measure(run, sample, mu);
        table.lines.push_back({law.name, printed_number(100 * (l - 1)), printed_number(-run.pressure_kPa()),
                               printed_number(1e-3 * mu * (l * l - std::pow(l, -sample.compression))),
                               short_number(m.mean_kPa), short_number(m.max_kPa), short_number(m.mean_percent),
                               short_number(m.max_percent), std::string(model::name(run.end.reason))});
    }
    return {{}, {table}};
}

}  // namespace

std::vector<Problem> sample_problems() {
    const char* text =
        "Stress of each law at given stretch against mu (l^2 - 1/l) (rod) or mu (l^2 - 1/l^4) (plate), at 20 strains evenly\n"
        "spaced up to the strain in the title or to the end of the path. The load is a follower traction; its full value is the\n"
        "exact stress at that strain. Nothing is fitted to the paper's figures, which cannot be reproduced from its formulas:\n"
        "rod largest 10.8 kPa, mean 7.8 kPa; plate largest 7.0 kPa, mean 4.1 kPa.";
    const std::vector<Sample> samples{
        {"uniaxial rod of Table 1, to 503.4 %", text, "verification/rod-table1.yaml", 5.034, 1},
        {"uniaxial rod, to 192 %", text, "verification/rod-uniaxial.yaml", 1.92, 1},
        {"equibiaxial plate, to 129 %", text, "verification/plate-equibiaxial.yaml", 1.29, 4}};
    std::vector<Problem> problems;
    for (const Sample& sample : samples) {
        const std::string name = sample.compression == 4 ? "Plate" : sample.strain > 2 ? "Rod of Table 1" : "Rod";
        problems.push_back({group, name, [name, sample] { return compare(name, sample); }});
    }
    return problems;
}

}  // namespace soft::verification
