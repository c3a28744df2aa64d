#pragma once
/// A case with the loads of its first stage and a Newton solver with these loads; and whole paths without files.
#include "fem/system.hpp"
#include "solver/newton.hpp"
#include "solver/path.hpp"
#include "solver/row_state.hpp"
#include "solver/stage_loads.hpp"

namespace soft::solver {

struct Bench {
    explicit Bench(const model::Case& input, const model::SolverSettings& settings)
        : system(input, PETSC_COMM_WORLD),
          loads(input, 0, unloaded(input, undeformed_volumes_m3(system)), undeformed_volumes_m3(system)),
          newton(system, settings) {
        newton.set_loads(loads);
    }
    [[nodiscard]] State rest() const {
        return {system.make_vector(), 0.0, std::vector(loads.free_supplies().size(), 0.0)};
    }
    fem::System system;
    StageLoads loads;
    Newton newton;
};

struct Run {
    std::vector<model::Step> steps;
    model::PathEnd end;
    std::vector<std::string> log;
};

inline Run run(const model::Case& input, const ContactCheck& contact = {}) {
    fem::System system(input, PETSC_COMM_WORLD);
    Run result;
    result.end = follow_path(system, {.step = [&](const model::Step& step, Vec) { result.steps.push_back(step); },
                                      .log = [&](const std::string& line) { result.log.push_back(line); },
                                      .contact = contact});
    return result;
}

}  // namespace soft::solver
