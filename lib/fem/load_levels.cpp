#include "fem/load_levels.hpp"

#include <array>

namespace soft::fem {

namespace {

constexpr std::array lists{&LoadLevels::pressures_Pa, &LoadLevels::dead_loads, &LoadLevels::motions};

}  // namespace

LoadLevels no_loads(const model::Case& input) {
    return {std::vector(input.loads.size(), 0.0), std::vector(input.dead_loads.size(), 0.0),
            std::vector(input.motions.size(), 0.0), 0.0};
}

double product(const LoadLevels& a, const LoadLevels& b) {
    double sum = 0;
    for (const auto list : lists)
        for (std::size_t i = 0; i < (a.*list).size(); ++i) sum += (a.*list)[i] * (b.*list)[i];
    return sum;
}

LoadLevels moved(const LoadLevels& levels, double share, const LoadLevels& direction) {
    LoadLevels result = levels;
    for (const auto list : lists)
        for (std::size_t i = 0; i < (result.*list).size(); ++i) (result.*list)[i] += share * (direction.*list)[i];
    result.time_s += share * direction.time_s;
    return result;
}

}  // namespace soft::fem
