#include "sweep/sampling.hpp"

#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace soft::sweep {
namespace {

using Engine = std::mt19937_64;

/// Uniform number in [0, 1) from the upper 53 bits: exact in double precision, and less than 1.
double uniform(Engine& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

/// Uniform integer in [0, bound) by rejection: draws beyond the last multiple of `bound` are repeated.
std::uint64_t below(Engine& engine, std::uint64_t bound) {
    const std::uint64_t excess = (Engine::max() % bound + 1) % bound;
    std::uint64_t drawn = engine();
    while (drawn > Engine::max() - excess) drawn = engine();
    return drawn % bound;
}

/// Random permutation by the Fisher-Yates shuffle.
std::vector<int> permutation(Engine& engine, int count) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t left = order.size(); left > 1; --left) std::swap(order[left - 1], order[below(engine, left)]);
    return order;
}

Points empty_points(SampleSize size) {
    return Points(static_cast<std::size_t>(size.samples),
                  std::vector<double>(static_cast<std::size_t>(size.dimensions)));
}

}  // namespace

Points random_points(SampleSize size, std::uint64_t seed) {
    Engine engine{seed};
    Points points = empty_points(size);
    for (auto& point : points)
        for (double& coordinate : point) coordinate = uniform(engine);
    return points;
}

Points latin_hypercube(SampleSize size, std::uint64_t seed) {
    Engine engine{seed};
    Points points = empty_points(size);
    for (std::size_t d = 0; d < static_cast<std::size_t>(size.dimensions); ++d) {
        const std::vector<int> intervals = permutation(engine, size.samples);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i][d] = (intervals[i] + uniform(engine)) / static_cast<double>(size.samples);
    }
    return points;
}

double GrayCode::size() const noexcept { return std::pow(base, digits); }

std::vector<int> GrayCode::at(std::size_t k) const {
    const auto b = static_cast<std::size_t>(base);
    std::vector<int> code;
    for (int i = 0; i < digits; ++i, k /= b) {
        const int digit = static_cast<int>(k % b);
        const bool is_reflected = k / b % 2 == 1;  // the faster digits decrease in every other block
        code.push_back(is_reflected ? base - 1 - digit : digit);
    }
    return code;
}

}  // namespace soft::sweep
