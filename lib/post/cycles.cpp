#include "post/cycles.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::post {

namespace {

int cycle_of(const model::Case& model, const model::Step& step) {
    return model.path.stages[static_cast<std::size_t>(step.stage)].cycle;
}

}  // namespace

CycleRows rows_of_cycle(const model::Case& model, std::span<const model::Step> steps, int cycle) {
    const auto is_here = [&](const model::Step& step) { return cycle_of(model, step) == cycle; };
    const auto first = std::ranges::find_if(steps, is_here);
    if (model.path.cycles == 1 || first == steps.end())
        throw Error(ExitCode::usage, "--cycle", "the path has no cycle " + std::to_string(cycle),
                    model.path.cycles == 1
                        ? "path.repeat of the design repeats its stages"
                        : "it has " + core::counted(steps.empty() ? 0 : cycle_of(model, steps.back()), "cycle"));
    const auto last = std::find_if_not(first, steps.end(), is_here);
    const auto begin = static_cast<std::size_t>(first - steps.begin());
    return {begin > 0 ? begin - 1 : 0, static_cast<std::size_t>(last - steps.begin()) - 1};
}

std::vector<CycleEnergy> cycle_energies(const model::Case& model, std::span<const model::Step> steps) {
    std::vector<CycleEnergy> energies;
    if (model.path.cycles == 1 || steps.empty()) return energies;
    const int last_stage = static_cast<int>(model.path.stages.size()) / model.path.cycles - 1;
    for (int cycle = 1; cycle <= cycle_of(model, steps.back()); ++cycle) {
        const auto [first, last] = rows_of_cycle(model, steps, cycle);
        const model::Step &from = steps[first], &to = steps[last];
        const bool is_complete = to.stage % (last_stage + 1) == last_stage && to.load_factor == 1.0;
        if (!is_complete || !from.energies || !to.energies) break;
        energies.push_back({cycle, to.energies->load_work_J - from.energies->load_work_J,
                            to.energies->dissipated_J.value_or(0) - from.energies->dissipated_J.value_or(0)});
        if (to.friction_J) energies.back().friction_J = *to.friction_J - from.friction_J.value_or(0);
    }
    return energies;
}

void keep_cycle(const model::Case& model, int cycle, std::vector<model::Step>& steps, model::PathEnd& end) {
    const auto [first, last] = rows_of_cycle(model, steps, cycle);
    const int shift = static_cast<int>(first);
    const auto keep = [&](auto& events, auto&& point_of) {
        std::erase_if(events, [&](auto& event) {
            const int row = point_of(event).step;
            return row < shift || row > static_cast<int>(last);
        });
        for (auto& event : events) point_of(event).step -= shift;
    };
    keep(
        end.limit_points, [](auto& event) -> auto& { return event; });
    keep(
        end.bifurcations, [](auto& event) -> auto& { return event.at; });
    keep(
        end.first_contacts, [](auto& event) -> auto& { return event.at; });
    steps = {steps.begin() + shift, steps.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

}  // namespace soft::post
