#pragma once
/// Constants of a fitted law, shifted by their standard errors: the sets of constants from which the uncertainty of a curve is
/// computed. With the covariance C = L L' (Cholesky, lower triangle) and the constants c, in this order:
///     c;   c + L_1, c - L_1, ... c + L_n, c - L_n   (L_k the k-th column of L);   c + L z, one per sample, z standard normal.
/// The linearised variance of a quantity q is sum_k ((q(c + L_k) - q(c - L_k)) / 2)^2 (first-order propagation; Bjorck, Numerical
/// Methods for Least Squares Problems (1996), 2.8). A constant at a bound has no error: its column of L is zero.
/// Tested by fit/shifted_constants_test.
#include <string>
#include <vector>

namespace soft::fit {

/// A law as the --json of fit-material states it.
struct FittedLaw {
    struct Constant {
        std::string name;  ///< "mu", of several terms "mu 1", "mu 2", ...
        double value = 0;  ///< SI
        bool is_stress = true;
    };
    std::string law;
    std::vector<Constant> constants;
    std::vector<double> covariance;  ///< by rows [SI]
};

/// Lower triangle of C = L L', by rows. A pivot that is zero to rounding has a zero column. Throws Error(bad_input, "covariance")
/// for a matrix of another size, that is not symmetric, not finite or has a negative pivot.
[[nodiscard]] std::vector<double> cholesky_factor(const FittedLaw& fitted);

/// 1 + 2 n + `samples` sets, in the order above; the same samples on every machine, and the first of more.
[[nodiscard]] std::vector<std::vector<double>> shifted_constants(const FittedLaw& fitted, int samples);

/// "{law: yeoh, kappa: incompressible, c1: 1000 Pa, ...}": the value of a design's key `material`, incompressible.
[[nodiscard]] std::string material_text(const FittedLaw& fitted, const std::vector<double>& constants);

}  // namespace soft::fit
