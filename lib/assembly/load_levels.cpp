#include "assembly/load_levels.hpp"

namespace soft::assembly {

LoadLevels no_loads(const model::Case& input) {
    return {std::vector(input.loads.size(), 0.0), std::vector(input.tractions.size(), 0.0),
            std::vector(input.body_forces.size(), 0.0), std::vector(input.motions.size(), 0.0)};
}

LoadLevels moved(const LoadLevels& levels, double share, const LoadLevels& direction) {
    LoadLevels result = levels;
    for (const auto list : {&LoadLevels::pressures_Pa, &LoadLevels::tractions, &LoadLevels::body_forces, &LoadLevels::motions})
        for (std::size_t i = 0; i < (result.*list).size(); ++i) (result.*list)[i] += share * (direction.*list)[i];
    return result;
}

}  // namespace soft::assembly
