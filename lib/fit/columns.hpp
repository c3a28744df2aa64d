#pragma once
/// Which columns of a table are strain and stress, in which measure and unit. Private to the module.
/// Tested by fit/test_data_test.
#include <string>

#include "fit/test_data.hpp"

namespace soft::fit {

struct Columns {
    std::size_t strain = 0, stress = 0;  ///< from 0
    StrainMeasure strain_measure = StrainMeasure::engineering;
    StressMeasure stress_measure = StressMeasure::engineering;
    std::string strain_unit;  ///< empty or %; of a displacement its unit
    std::string stress_unit;
};

/// Errors as read_test.
[[nodiscard]] Columns columns_of(const table::Table& table, const ReadSettings& settings);

}  // namespace soft::fit
