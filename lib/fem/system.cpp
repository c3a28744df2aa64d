#include "fem/system.hpp"

#include <algorithm>

namespace soft::fem {

System::System(const model::Case& input, MPI_Comm comm)
    : fe_(input, comm),
      state_(fe_),
      loads_(fe_),
      assembler_(fe_, loads_, state_),
      volumes_(fe_, state_),
      outputs_(fe_, loads_, state_),
      fields_(fe_, state_) {}

bool System::has_initial_stress() const {
    return std::ranges::any_of(fe_.rubbers,
                               [](const auto& rubber) { return material::reference_stress_Pa(rubber) > 0.0; });
}

bool System::has_fibers() const {
    return std::ranges::any_of(fe_.rubbers, [](const auto& rubber) { return material::fibers_of(rubber).has_value(); });
}

bool System::has_symmetric_tangent() const { return std::ranges::all_of(fe_.rubbers, material::has_symmetric_tangent); }

}  // namespace soft::fem
