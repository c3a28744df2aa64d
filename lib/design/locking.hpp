#pragma once
/// Measured stiffness error of cell choices that lock. Used only by the warnings of a design. Private to the module. Tested by
/// design/plausibility_test.
#include <array>
#include <string_view>

namespace soft::design {

enum class LockingChoice { first_order_simplices, first_order_displacement, second_order_displacement };

struct LockingFactor {
    LockingChoice choice;
    double stiffness;  ///< pressure divided by that of the converged curve at the same elongation
};

/// Source of the factors: tests/verification/README.md, 'Locking', elongation 20 mm, solids.
inline constexpr std::string_view locking_measured_on = "the bellows with one cell through the wall, kappa/mu = 100";
inline constexpr std::array locking_factors{
    LockingFactor{LockingChoice::first_order_simplices, 3.6},
    LockingFactor{LockingChoice::first_order_displacement, 3.2},
    LockingFactor{LockingChoice::second_order_displacement, 1.2},
};

/// Above this ratio of bulk to shear modulus the displacement formulation locks visibly.
inline constexpr double locking_bulk_ratio = 50.0;

[[nodiscard]] constexpr double locking_factor(LockingChoice choice) {
    for (const LockingFactor& row : locking_factors)
        if (row.choice == choice) return row.stiffness;
    return 1.0;
}

}  // namespace soft::design
