#include "post/monotone_slopes.hpp"

#include <algorithm>
#include <cmath>

namespace soft::post {
namespace {

/// The slope limited to three times the smaller of the adjacent secants, which keeps the cubics monotone; 0 if the signs of the slope
/// and the secants differ.
double limited(double slope, double left, double right) {
    if (!(left * right > 0 && slope * left > 0)) return 0;
    return std::copysign(std::min({std::abs(slope), 3 * std::abs(left), 3 * std::abs(right)}), left);
}

/// Slope at the first row, in Newton's form: of the cubic through four rows, the parabola through three, or the line through two. If the
/// values are not monotonic, they may have a kink, next to which a cubic would oscillate: the parabola is used.
double end_slope(std::span<const double> s, std::span<const double> q) {
    const auto secant = [&](std::size_t i) { return (q[i + 1] - q[i]) / (s[i + 1] - s[i]); };
    const double first = secant(0);
    if (s.size() == 2) return first;
    const double second = secant(1), bend = (second - first) / (s[2] - s[0]);
    double slope = first - bend * (s[1] - s[0]);
    if (s.size() > 3 && first * second > 0 && second * secant(2) > 0) {
        const double next_bend = (secant(2) - second) / (s[3] - s[1]);
        slope += (next_bend - bend) / (s[3] - s[0]) * (s[1] - s[0]) * (s[2] - s[0]);
    }
    return limited(slope, first, first);
}

}  // namespace

std::vector<double> monotone_slopes(std::span<const double> s, std::span<const double> q) {
    const std::size_t n = s.size();
    std::vector<double> slopes(n, 0.0);
    if (n < 2) return slopes;
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double h_left = s[i] - s[i - 1], h_right = s[i + 1] - s[i];
        const double left = (q[i] - q[i - 1]) / h_left, right = (q[i + 1] - q[i]) / h_right;
        slopes[i] = limited((h_right * left + h_left * right) / (h_left + h_right), left, right);
    }
    const std::size_t count = std::min<std::size_t>(n, 4);  // rows used for the slope at an end
    slopes.front() = end_slope(s.first(count), q.first(count));
    const auto last = s.last(count), values = q.last(count);
    slopes.back() =
        end_slope(std::vector<double>(last.rbegin(), last.rend()), std::vector<double>(values.rbegin(), values.rend()));
    return slopes;
}

}  // namespace soft::post
