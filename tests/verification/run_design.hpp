#pragma once
/// Runs a design through the libraries, as the tools do, without files in between.
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "design/design.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "solution/path.hpp"
#include "solver/path.hpp"

namespace soft::verification {

struct Run {
    model::Case model;
    std::vector<solution::Step> steps;
    solution::PathEnd end;

    [[nodiscard]] double pressure_kPa() const { return 1e-3 * steps.back().pressure_Pa; }
    [[nodiscard]] double output_mm() const { return 1e3 * steps.back().outputs_m.at(0); }
};

/// `sets`: "key.path=value", as after --set.
inline Run run_design(const std::string& file, const std::vector<std::string>& sets) {
    const std::string path = std::string(SOFT_SOURCE_DIR) + "/designs/" + file;
    std::ifstream stream(path);
    std::stringstream text;
    text << stream.rdbuf();
    std::vector<design::Override> overrides;
    for (const auto& set : sets) overrides.push_back(design::parse_override(set));
    const auto design = design::read_design(text.str(), path, geometry::catalogue_keys(), overrides);
    Run run;
    run.model = geometry::build_case(design);
    assembly::System system(run.model, PETSC_COMM_WORLD);
    run.end = solver::follow_path(
        system, {.step = [&](const solution::Step& step, Vec) { run.steps.push_back(step); }});
    return run;
}

}  // namespace soft::verification
