#pragma once
/// Error bars of the rows of a path from the same rows on the meshes next to theirs (error_bar.hpp). Internal to the module.
/// The bar of an output is that at an equal load. The bar of the load is that at an equal value of a measure: the first of the outputs and the
/// volume that moves with the load at this row, at least a quarter as fast, of its range, as that which moves most; 0 where none moves, as
/// before an obstacle is reached, and where the load is held. There, and where all outputs stand still (a wall stops the actuator), the largest
/// bar is that of the outputs.
/// Tested by solver/accuracy_test, pipeline/tolerance.sh and the verification suite (group Error bars).
#include <vector>

#include "solver/error_bar.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

using Rows = std::vector<RowState>;

/// The measure of a row: an output, or the volume.
struct Measure {
    static constexpr std::size_t volume = static_cast<std::size_t>(-1);
    std::size_t output;
    [[nodiscard]] CurvePoint point(const model::Step& step) const {
        return {step.pressure_Pa, output == volume ? step.volume_m3.value_or(0.0) : step.outputs[output]};
    }
    [[nodiscard]] CurvePoint tangent(const model::Step& step) const {
        return {step.tangent_pressure, output == volume ? step.tangent_volume : step.tangent_outputs[output]};
    }
};

/// Rows of the levels next to the reported one; empty where a level does not exist.
struct NeighbourLevels {
    const Rows &finer, &before, &earlier;
    Walls walls;
};

/// Stores the bars in the reported rows; returns those of the measure that moves.
[[nodiscard]] std::vector<ErrorBar> set_bars(Rows& reported, const NeighbourLevels& around);

/// The largest bar of the load relative to it, or to a tenth of the largest load; of all outputs where they stand still, and on a path in
/// time, where the load may be prescribed.
[[nodiscard]] double max_relative_bar(const Rows& rows);

}  // namespace soft::solver
