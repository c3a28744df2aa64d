// The paper's bellows on the paper's own mesh, which is not part of the project; KRAKEN_MESHES is its folder.
#include <cstdlib>

#include "core/text.hpp"
#include "locking.hpp"
#include "table.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "The paper's own mesh (computed if KRAKEN_MESHES names its folder)";
constexpr const char* folder = "KRAKEN_MESHES";

struct Choice {
    const char* name;
    std::vector<std::string> sets;
    std::vector<double> elongations_mm;  ///< at 5, 10, 15, 20, 30, 40 kPa, from two other codes
    double tolerance;
    std::string reason;
    const char* pressure;  ///< full load
};

Run run_on(const Choice& choice) {
    std::vector<std::string> sets{std::string("geometry.file=") + std::getenv(folder) + "/bellows-actuator.msh"};
    for (const char* face : {"entry", "top_inner", "bottom_inner"})
        sets.push_back(std::string("loads.") + face + ".pressure=" + choice.pressure);
    sets.insert(sets.end(), choice.sets.begin(), choice.sets.end());
    return run_design("verification/kraken-bellows.yaml", sets);
}

void add_rows(const Choice& choice, const Run& run, std::vector<Row>& rows) {
    const std::vector<double> pressures_kPa{5, 10, 15, 20, 30, 40};
    for (std::size_t i = 0; i < pressures_kPa.size(); ++i)
        rows.push_back(
            {.quantity = "elongation at " + core::number_text(pressures_kPa[i]) + " kPa, " + choice.name + " [mm]",
             .reference = choice.elongations_mm[i],
             .source = "two independent codes",
             .ours = -1e3 * run.at("pressure", 1e3 * pressures_kPa[i]).outputs.at(0),
             .mesh = run.mesh,
             .seconds = run.seconds,
             .tolerance = choice.tolerance,
             .reason = choice.reason});
}

std::string pressure_kPa_text(const Run& run, double elongation_mm, double over_kPa) {
    if (!run.reaches("motion", -1e-3 * elongation_mm)) return "not reached";
    return core::rounded_text(1e-3 * run.at("motion", -1e-3 * elongation_mm).pressure_Pa / over_kPa, 4);
}

Outcome solve(const std::string& name, const std::vector<Choice>& choices) {
    Outcome outcome;
    std::vector<Run> runs;
    for (const Choice& choice : choices) {
        runs.push_back(run_on(choice));
        add_rows(choice, runs.back(), outcome.rows);
    }
    Table locking{
        name + ": locking",
        "Stiffness factor at kappa/mu = 100: pressure over that of the mixed second-order cells on the same mesh, at the\n"
        "same elongation.",
        {"elongation [mm]"},
        {}};
    for (std::size_t i = 0; i + 1 < choices.size(); ++i) locking.header.push_back(choices[i].name);
    for (const double elongation_mm : compared_elongations_mm) {
        locking.lines.push_back({core::number_text(elongation_mm)});
        const double mixed_kPa = 1e-3 * runs.back().at("motion", -1e-3 * elongation_mm).pressure_Pa;
        for (std::size_t i = 0; i + 1 < runs.size(); ++i)
            locking.lines.back().push_back(pressure_kPa_text(runs[i], elongation_mm, mixed_kPa));
    }
    Table exact{
        name + ": against the exact shape",
        "Pressure [kPa] at an elongation, cavity open, and its factor over the converged section of the exact shape. The\n"
        "published mesh has a different geometry, faceted and with 13 % less rubber: the mixed second-order cells show the effect of\n"
        "the geometry, the others the additional effect of locking.",
        {"elongation [mm]", "converged section [kPa]"},
        {}};
    for (const Choice& choice : choices) {
        exact.header.push_back(std::string(choice.name) + " [kPa]");
        exact.header.push_back("factor");
    }
    const auto section = converged_bellows();
    for (const double elongation_mm : compared_elongations_mm) {
        const double converged_kPa = 1e-3 * section.at("elongation", 1e-3 * elongation_mm).pressure_Pa;
        exact.lines.push_back({core::number_text(elongation_mm), core::rounded_text(converged_kPa, 5)});
        for (const Run& run : runs) {
            exact.lines.back().push_back(pressure_kPa_text(run, elongation_mm, 1));
            exact.lines.back().push_back(pressure_kPa_text(run, elongation_mm, converged_kPa));
        }
    }
    outcome.tables = {locking, exact};
    return outcome;
}

}  // namespace

std::vector<Problem> published_mesh_problems() {
    const std::string about = "the reference is approximate, to 1 %";
    const std::vector<Choice> choices{
        {"first order, displacement", {}, {11.79, 22.96, 33.45, 43.29, 61.78, 79.78}, default_tolerance, "", "80 kPa"},
        {"second order, displacement", {"mesh.order=2"}, {34.8, 57.1, 73.7, 87.4, 111.7, 141.8}, 1e-2, about, "41 kPa"},
        {"second order, mixed",
         {"mesh.order=2", "mesh.formulation=mixed"},
         {47.5, 72.0, 88.7, 102.0, 125.5, 157.1},
         1e-2,
         about,
         "41 kPa"}};
    const std::string name = "published bellows mesh";
    return {{group, name, [=] { return solve(name, choices); }, Duration::slow, folder}};
}

}  // namespace soft::verification
