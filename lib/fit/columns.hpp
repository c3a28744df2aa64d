#pragma once
/// Finds the strain and stress columns of a table, with their measure and unit. Private to the module.
/// Tested by fit/test_data_test.
#include <string>

#include "fit/test_data.hpp"

namespace soft::fit {

struct Columns {
    std::size_t strain = 0, stress = 0;  ///< column indices from 0
    StrainMeasure strain_measure = StrainMeasure::engineering;
    StressMeasure stress_measure = StressMeasure::engineering;
    std::string strain_unit;  ///< empty or %; for a displacement its unit of length
    std::size_t time = 0;     ///< if requested
    std::string time_unit = "s";
    std::string stress_unit;
};

/// Errors as read_test.
[[nodiscard]] Columns columns_of(const core::Table& table, const ReadSettings& settings);

}  // namespace soft::fit
