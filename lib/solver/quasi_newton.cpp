#include "solver/quasi_newton.hpp"

namespace soft::solver {

namespace {

/// Smallest cosine of the angle between s and y of a pair: below it the tangent is not positive along s, or y is rounding.
constexpr double min_cosine = 1e-8;

}  // namespace

void SecantUpdates::add(linalg::Vector s, linalg::Vector y) {
    const double product = linalg::dot(s, y);
    if (!(product > min_cosine * linalg::norm(s) * linalg::norm(y))) return;
    pairs_.push_back({std::move(s), std::move(y), 1.0 / product});
}

bool SecantUpdates::apply(Vec b, Vec x, const std::function<bool(Vec, Vec)>& solve) const {
    linalg::Vector q = linalg::duplicate(b);
    linalg::copy(b, q);
    std::vector<double> alpha(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
        alpha[i] = pairs_[i].rho * linalg::dot(pairs_[i].s, q);
        linalg::add(q, -alpha[i], pairs_[i].y);
    }
    if (!solve(q, x)) return false;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const double beta = pairs_[i].rho * linalg::dot(pairs_[i].y, x);
        linalg::add(x, alpha[i] - beta, pairs_[i].s);
    }
    return true;
}

}  // namespace soft::solver
