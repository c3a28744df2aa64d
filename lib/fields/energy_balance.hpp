#pragma once
/// Whether the rows of a path keep their energy: work of the loads = stored + kinetic + taken by damping, all since the first row.
/// The difference is that of the worst row, over the largest of the four that any row has. Along a static path only the first two
/// are there. A law that is a stress without an energy has no balance. Tested by fields/energy_balance_test,
/// Pipeline.AnEarlyEndKeepsTheStepsReached and Pipeline.AMotionInTimeKeepsItsEnergyAndItsRows.
#include <optional>
#include <string>

#include "solution/path.hpp"

namespace soft::fields {

/// Beyond it the rows are wrong, or too coarse to be trusted.
inline constexpr double tolerated_energy_error = 0.01;

class EnergyBalance {
public:
    void add(const solution::Step& row);
    [[nodiscard]] std::optional<double> error() const;  ///< empty where nothing has moved
    /// "the energies do not balance: ...; ..." beyond the tolerated error, else empty.
    [[nodiscard]] std::string problem() const;

private:
    struct Energies {
        double work_J = 0, stored_J = 0, kinetic_J = 0, damping_J = 0;
    };
    std::optional<Energies> first_;
    Energies worst_;
    double max_J_ = 0, gap_J_ = 0;
    int rows_ = 0, worst_row_ = 0;
    bool moves_ = false;
};

}  // namespace soft::fields
