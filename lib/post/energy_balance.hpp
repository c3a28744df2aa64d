#pragma once
/// Energy balance of the rows of a path: work of the loads = stored + kinetic energy + dissipation by damping and friction, all relative to the
/// first row. The error is the difference in the worst row divided by the largest of the four energies in any row. A static path has
/// the first two terms, friction, and the energy that snaps set free. For a law without an energy function there is no balance. Tested by post/energy_balance_test,
/// Pipeline.AnEarlyEndKeepsTheConvergedSteps and Pipeline.MotionInTimeKeepsItsEnergyBalanceAndItsRows.
#include <optional>
#include <string>

#include "model/path.hpp"

namespace soft::post {

/// A larger error means that the rows are wrong or too coarse.
inline constexpr double max_energy_error = 0.01;
/// Of |largest stretch - 1|: rows of a static path below it are not compared. The deformation gradient has rounding errors of 2e-16, so
/// that which fibres are taut, and the stress of the others to a percent, may be rounding there.
inline constexpr double min_strain = 1e-10;

class EnergyBalance {
public:
    void add(const model::Step& row);
    [[nodiscard]] std::optional<double> error() const;  ///< empty if all energies are zero
    /// "the energies do not balance: ...; ..." if the error exceeds max_energy_error, else empty.
    [[nodiscard]] std::string problem() const;

private:
    struct Energies {
        double work_J = 0, stored_J = 0, kinetic_J = 0, dissipated_J = 0;
    };
    std::optional<Energies> first_;
    Energies worst_;
    double max_J_ = 0, gap_J_ = 0;
    int rows_ = 0, worst_row_ = 0;
    bool moves_ = false;
};

}  // namespace soft::post
