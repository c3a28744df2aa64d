#pragma once
/// Values that are of the right dimension and most likely of a wrong unit or sign: gravity, density, fibre angles. Private to the
/// room; plausibility() tells them. Tested by design/plausibility_test.
#include <string>
#include <vector>

#include "design/design.hpp"

namespace soft::design {

void check_units(const Design& design, std::vector<std::string>& warnings);

}  // namespace soft::design
