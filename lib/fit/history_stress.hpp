#pragma once
/// The stress of a viscoelastic or softening law along the strain of a test, linear between the rows. Internal to the module.
/// Tested by fit/history_fit_test.
#include <array>

#include "fit/test_data.hpp"
#include "material/catalogue.hpp"

namespace soft::fit {

/// Principal stretches of incompressible rubber.
[[nodiscard]] std::array<double, 3> stretches_of(Mode mode, double stretch);

/// Nominal stress [Pa] at the rows.
[[nodiscard]] std::vector<double> stress_of_test(const material::AnyRubber& rubber, const TestCurve& test);

}  // namespace soft::fit
