#pragma once
/// What is known of choices that lock: how much too stiff they are. Private to the room. The warnings of a design quote
/// this table, nothing else does. Held by design/plausibility_test.
#include <array>
#include <optional>
#include <string_view>

namespace soft::design {

enum class LockingChoice { first_order_simplices, displacement_penalty };

struct LockingFactor {
    LockingChoice choice;
    std::optional<double> stiffness;   ///< load over the converged load at the same deformation; nullopt: not measured
    std::string_view measured_on;      ///< case and source of the number
};

inline constexpr std::array locking_factors{
    // Published with the job of this version: linear tetrahedra against the converged curve, kappa/mu = 100.
    LockingFactor{LockingChoice::first_order_simplices, 6.7, "the paper's bellows, kappa/mu = 100"},
    LockingFactor{LockingChoice::displacement_penalty, std::nullopt, ""},
};

/// Above this bulk over shear modulus displacements alone lock visibly.
inline constexpr double locking_bulk_ratio = 50.0;

[[nodiscard]] constexpr LockingFactor locking_factor(LockingChoice choice) {
    for (const LockingFactor& row : locking_factors)
        if (row.choice == choice) return row;
    return {choice, std::nullopt, ""};
}

}  // namespace soft::design
