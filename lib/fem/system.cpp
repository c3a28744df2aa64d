#include "fem/system.hpp"

#include <algorithm>

namespace soft::fem {

System::System(const model::Case& input, MPI_Comm comm)
    : discretization_(input, comm),
      state_(discretization_),
      loads_(discretization_),
      assembler_(discretization_, loads_, state_),
      volumes_(discretization_, state_),
      outputs_(discretization_, loads_, state_),
      fields_(discretization_, state_) {}

bool System::has_initial_stress() const {
    return std::ranges::any_of(discretization_.rubbers,
                               [](const auto& rubber) { return material::reference_stress_Pa(rubber) > 0.0; });
}

bool System::has_fibers() const {
    return std::ranges::any_of(discretization_.rubbers,
                               [](const auto& rubber) { return material::fibers_of(rubber).has_value(); });
}

bool System::has_symmetric_tangent() const {
    return std::ranges::all_of(discretization_.rubbers, material::has_symmetric_tangent);
}

}  // namespace soft::fem
