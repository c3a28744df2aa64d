#pragma once
/// Constants of a fitted law, shifted by their standard errors. The uncertainty of a curve is computed from these sets of constants.
/// With the covariance C = L L' (Cholesky, lower triangle) and the constants c, the sets are, in this order:
///     c;   c + L_1, c - L_1, ... c + L_n, c - L_n   (L_k the k-th column of L);   c + L z, one per sample, z standard normal.
/// The linearised variance of a quantity q is sum_k ((q(c + L_k) - q(c - L_k)) / 2)^2 (first-order propagation; Bjorck, Numerical
/// Methods for Least Squares Problems (1996), 2.8). A constant at a bound has no error: its column of L is zero.
/// Tested by fit/shifted_constants_test.
#include <string>
#include <vector>

namespace soft::fit {

/// A law as in the --json output of fit-material.
struct FittedLaw {
    struct Constant {
        std::string name;  ///< "mu"; with several terms "mu 1", "mu 2", ...
        double value = 0;  ///< SI
        bool is_stress = true;
    };
    std::string law;
    std::vector<Constant> constants;
    std::vector<double> covariance;  ///< by rows [SI]
};

/// Lower triangle L of C = L L', by rows. A pivot that is zero to rounding gives a zero column. Throws Error(bad_input, "covariance")
/// for a matrix that has the wrong size, is not symmetric, is not finite or has a negative pivot.
[[nodiscard]] std::vector<double> cholesky_factor(const FittedLaw& fitted);

/// 1 + 2 n + `samples` sets, in the order above. The samples are equal on every machine, and fewer samples are a prefix of more.
[[nodiscard]] std::vector<std::vector<double>> shifted_constants(const FittedLaw& fitted, int samples);

/// "{law: yeoh, kappa: incompressible, c1: 1000 Pa, ...}": the value of the key `material` in a design.
[[nodiscard]] std::string material_text(const FittedLaw& fitted, const std::vector<double>& constants);

}  // namespace soft::fit
