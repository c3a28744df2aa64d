#pragma once
/// Stress of inelastic rubber (material/inelastic.hpp) at the rows of a result. The file has no internal variables: they are recomputed from
/// the displacements of all rows, each of which is a step of the path (but for located limit points, which lie within a step).
/// Tested by post/rubber_history_test.
#include <functional>
#include <map>
#include <vector>

#include "fem/solid_kernel.hpp"
#include "material/point_history.hpp"
#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::post {

class RubberHistory {
public:
    /// Displacements [point x 3] of a row; nullopt if the file does not have them.
    using Displacements = std::function<std::optional<std::vector<double>>(std::int64_t row)>;

    /// `inside_steps`: rows that are not ends of steps, ascending. `has_all_rows`: no row is without displacements.
    RubberHistory(const model::Case& model, std::span<const model::Step> rows, std::vector<int> inside_steps,
                  Displacements displacements, bool has_all_rows);

    /// Elastic rubber, or a static path all of whose rows have fields.
    [[nodiscard]] bool is_known() const { return regions_.empty() || (has_all_rows_ && !model_.dynamics); }

    /// By quadrature point, cell by cell, for a state at or before `row` and after the row before it; empty for elastic rubber. Throws
    /// Error (bad_input) where a row before has no fields, and for a motion, whose rows are not its steps.
    [[nodiscard]] std::vector<material::PointStep> at(std::int64_t row, std::span<const double> displacement_m,
                                                      double time_s);
    [[nodiscard]] std::vector<material::PointStep> at(std::int64_t row, std::span<const double> displacement_m) {
        return at(row, displacement_m, time_of(row));
    }
    /// Empty where it is not known.
    [[nodiscard]] std::vector<material::PointStep> at_if_known(std::int64_t row, std::span<const double> displacement_m,
                                                               double time_s);
    [[nodiscard]] double time_of(std::int64_t row) const;  ///< 0 on a path without times

private:
    struct Region {
        material::AnyRubber rubber;
        const material::Inelastic* inelastic;
        material::StepCoefficients step;
    };
    void set_step(double time_s);
    /// Advances all points from the state before to the displacements; keeps the result if `accept`.
    [[nodiscard]] std::vector<material::PointStep> advance(std::span<const double> displacement_m, bool accept);

    const model::Case& model_;
    std::span<const model::Step> rows_;
    std::vector<int> inside_steps_;
    Displacements displacements_;
    bool has_all_rows_;
    std::vector<Region> regions_;
    std::map<mesh::CellType, fem::ReferenceCell> references_;
    std::map<mesh::CellType, fem::CellPoints> work_;
    std::vector<double> history_;  ///< [cell][point][history_size]
    std::int64_t accepted_ = 0;    ///< row of the history; row 0 is the virgin state
    double start_s_ = 0, step_s_ = 0;
};

}  // namespace soft::post
