#pragma once
/// Warnings about values of the right dimension but probably of a wrong unit or sign: gravity, density, fibre angles. Private to the
/// module; called by plausibility(). Tested by design/plausibility_test.
#include <string>
#include <vector>

#include "design/design.hpp"

namespace soft::design {

void check_units(const Design& design, std::vector<std::string>& warnings);

}  // namespace soft::design
