#include "problem.hpp"

#include <cmath>
#include <cstdlib>

namespace soft::verification {

bool Row::is_within_tolerance() const {
    const double e = std::abs(error());
    return std::isfinite(e) && e <= tolerance && (tolerance <= default_tolerance || !reason.empty());
}

bool can_run(const Problem& problem) { return problem.needs.empty() || std::getenv(problem.needs.c_str()) != nullptr; }

std::vector<Problem> all_problems() {
    std::vector<Problem> all;
    for (const auto& list :
         {homogeneous_problems(), sheared_layer_problems(), inflation_problems(),    long_tube_problems(),
          fiber_tube_problems(),  limit_point_problems(),   branch_problems(),       snap_problems(),
          actuator_problems(),    family_problems(),        closing_wall_problems(), work_problems(),
          panel_problems(),       sample_problems(),        locking_problems(),      published_mesh_problems(),
          motion_problems(),      error_bar_problems(),     reaction_problems(),     contact_problems(),
          inelastic_problems()})
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace soft::verification
