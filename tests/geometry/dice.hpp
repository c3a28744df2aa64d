#pragma once
/// Random numbers for generated designs, reproducible on every machine for the same seed.
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace soft {

class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
    }
    /// With three decimals, as in handwritten designs.
    double operator()(double low, double high) { return std::round(1000 * between(low, high)) / 1000; }
    double between_logs(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    double scaled(double value, double by) { return value * std::exp(between(-std::log(by), std::log(by))); }
    int whole(int low, int high) { return low + static_cast<int>(between(0, high - low + 1)); }
    bool chance(double share) { return between(0, 1) < share; }
    template <class T>
    const T& one_of(const std::vector<T>& all) {
        return all[static_cast<std::size_t>(whole(0, static_cast<int>(all.size()) - 1))];
    }

private:
    std::mt19937 engine_;
};

}  // namespace soft
