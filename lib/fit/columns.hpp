#pragma once
/// Which columns of a table are strain and stress, in which measure and unit. Private to the room.
/// Held by fit/test_data_test.
#include "fit/test_data.hpp"

namespace soft::fit {

struct Columns {
    std::size_t strain = 0, stress = 0;  ///< from 0
    StrainMeasure strain_measure = StrainMeasure::engineering;
    StressMeasure stress_measure = StressMeasure::engineering;
    double strain_factor = 1;  ///< to a ratio
    double stress_Pa = 1;      ///< one unit of the column
};

/// Errors as read_test.
[[nodiscard]] Columns columns_of(const Table& table, const ReadSettings& settings);

}  // namespace soft::fit
