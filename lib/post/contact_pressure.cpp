#include "post/contact_pressure.hpp"

#include "contact/potential.hpp"
#include "model/rubber.hpp"
#include "model/time_function.hpp"

namespace soft::post {

namespace {

/// Levels of the motions in a row.
std::vector<double> motion_levels(const model::Case& model, std::span<const model::Step> steps, std::size_t row) {
    std::vector<double> levels(model.motions.size(), 0.0);
    if (const auto& motion = steps[row].motion) {
        for (std::size_t i = 0; i < levels.size(); ++i)
            levels[i] = model.path.stages[0].motions.at(i) *
                        model::share_at(model.motions[i].time_function, model.dynamics->duration_s, motion->time_s);
        return levels;
    }
    std::vector<double> reached(model.path.stages.size(), 0.0);  // load factor of each stage
    for (const model::Step& step : steps.first(row + 1))
        reached.at(static_cast<std::size_t>(step.stage)) = step.load_factor;
    for (std::size_t s = 0; s <= static_cast<std::size_t>(steps[row].stage); ++s)
        for (std::size_t i = 0; i < levels.size(); ++i)
            levels[i] += reached[s] * (model.path.stages[s].motions.at(i) - levels[i]);
    return levels;
}

}  // namespace

std::vector<Vector3> obstacle_shifts(const model::Case& model, std::span<const model::Step> steps, std::size_t row) {
    std::vector<Vector3> shifts(model.obstacles.size());
    if (shifts.empty() || model.motions.empty()) return shifts;
    const std::vector<double> levels = motion_levels(model, steps, row);
    for (std::size_t k = 0; k < shifts.size(); ++k)
        for (std::size_t i = 0; i < levels.size(); ++i)
            if (model.motions[i].face == model.obstacles[k].name)
                for (std::size_t d = 0; d < 3; ++d)
                    shifts[k][d] += levels[i] * model.motions[i].displacement_m[d].value_or(0);
    return shifts;
}

bool has_contact(const model::Case& model) {
    return !model.obstacles.empty() || (model.contact.self && model.path.contact == model::Contact::solve);
}

std::vector<double> contact_pressures_Pa(const model::Case& model, const NodalState& state) {
    std::vector<mesh::Point> positions = model.mesh.points;
    for (std::size_t n = 0; n < positions.size(); ++n)
        for (std::size_t d = 0; d < 3; ++d) positions[n][d] += state.displacement_m[3 * n + d];
    auto shifts = state.shifts;
    shifts.resize(model.obstacles.size());
    return contact::Potential(model, model::young_moduli_Pa(model)).nodal_pressures_Pa(positions, shifts);
}

}  // namespace soft::post
