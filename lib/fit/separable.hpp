#pragma once
/// The rows of all tests, and the parts P_j of a candidate on them. Private to the module. Tested by fit/fit_test.
///   weighted residual of row i:  w_i (sum_j c_j P_j(l_i; shape_j) + offset_t - s_i) / S,    S = largest |s|
/// with w^2 = weight of the test times weight of the row. Rows are sorted by mode and stretch, so that sums do not depend on the order
/// of the input. The scale S makes the result independent of the unit of stress. The search variables are q, one per shape:
///   ogden  alpha = q;   yeoh-5  ln b linear in q, from its lower bound at q = 0 to its upper bound at q = 1 (see rise_at)
///   gent  jm = (1 + exp q) max(I1 - 3);   arruda-boyce  locking_stretch^2 = (1 + exp q) max(I1)/3
/// The last two keep the pole (the locking stretch) outside the data; derived here.
#include <Eigen/Dense>
#include <vector>

#include "fit/bounded.hpp"
#include "fit/candidates.hpp"
#include "fit/fit.hpp"

namespace soft::fit {

struct Rows {
    std::vector<Mode> mode;
    std::vector<double> stretch;
    std::vector<std::size_t> test;  ///< index of the test of each row
    std::size_t test_count = 0;
    Eigen::VectorXd weight, target;  ///< w, w s/S
    double scale_Pa = 1;             ///< S
    double max_I1 = 3;
    Offset offset = Offset::none;
    Eigen::MatrixXd mix = {};  ///< multiplies every column unless empty (condensed)
};

[[nodiscard]] Rows rows_of(const std::vector<TestCurve>& tests, const Settings& settings);

enum class Signs { free, stable };  ///< stable: the signs that suffice for stability (see bounds_of)

struct SearchBounds {
    double low = 0, high = 0;
};
[[nodiscard]] SearchBounds search_bounds(const Candidate& candidate, double start);
[[nodiscard]] bool is_at_search_bound(const Candidate& candidate, double q);

/// Shape constant of a design as a function of q, and its derivative.
[[nodiscard]] double shape_of(const Candidate& candidate, const Rows& rows, double q);
[[nodiscard]] double shape_slope(const Candidate& candidate, const Rows& rows, double q);

/// w_i P_j at q_j, per unit of c_j.
[[nodiscard]] Eigen::VectorXd part(const Candidate& candidate, const Rows& rows, std::size_t j, double q);
/// Its derivative with respect to q_j.
[[nodiscard]] Eigen::VectorXd part_slope(const Candidate& candidate, const Rows& rows, std::size_t j, double q);

struct Projection {
    Eigen::MatrixXd A;  ///< parts, then one offset column per test
    BoundedFit linear;  ///< c and offsets, in units of S
    Eigen::VectorXd residual;
};

/// The best linear constants for given q.
[[nodiscard]] Projection project(const Candidate& candidate, const Rows& rows, const std::vector<double>& q,
                                 Signs signs);

/// The same least-squares problem with far fewer rows, for laws whose stress is smooth in the stretch for all searched shapes
/// (ogden: sums of powers, no pole). Over one test a part equals the polynomial through its values at Chebyshev points in ln l to
/// better than 1e-12 of its largest value (l^12 over a factor of 19 in stretch: error of order (a/2)^n/n!, a = 18). All rows are
/// therefore a matrix times these values, and the QR of this matrix leaves a triangle. The minimisers equal those of the full
/// problem; the sum of squares differs by a constant. Source: Trefethen, Approximation Theory (2013), 5 and 8.
/// Returns the rows unchanged if condensation would not halve their number.
/// Tested by fit/condensed_test.
[[nodiscard]] Rows condensed(const Rows& rows);

/// Initial guesses for the exponents of Ogden's law: for every pattern of signs the best set from a dense, log-spaced list. The
/// moduli are linear for given exponents, so each set costs one small linear solve with precomputed inner products. The list is
/// coarser for more terms. Tested by fit/fit_test.
[[nodiscard]] std::vector<std::vector<double>> ogden_starts(const Candidate& candidate, const Rows& rows, Signs signs);

}  // namespace soft::fit
