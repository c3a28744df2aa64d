#include "consistency.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace soft::campaign {
namespace {

using solution::Step;

constexpr double balanced = 0.01;
/// Of the motion that is asked for.
constexpr double in_place = 1e-6;
/// Stretches below which a response is linear; rows that it takes with steps that grow from a fiftieth of the load.
constexpr double tiny_strain = 1e-6;
constexpr std::size_t rows_of_a_line = 8;

std::string shown(double value) { return core::rounded_text(value, 4); }

std::string energies(std::span<const Step> rows) {
    double gap = 0, largest = 0;
    for (const Step& step : rows) {
        if (!step.energies || !rows.front().energies) return "";  // a stress without an energy
        const double work = step.energies->load_work_J - rows.front().energies->load_work_J,
                     stored = step.energies->stored_J - rows.front().energies->stored_J;
        gap = std::max(gap, std::abs(work - stored));
        largest = std::max({largest, std::abs(work), std::abs(stored)});
    }
    return gap <= balanced * largest ? "" : "the energies differ by " + shown(100 * gap / largest) + " %";
}

std::string motions(const io::Result& result) {
    if (result.model.path.stages.size() != 1) return "";
    const auto last = result.fields.read(static_cast<std::int64_t>(result.steps.size()) - 1);
    const bool is_there =
        result.end && result.end->reason == solution::StopReason::done && result.model.path.stages[0].until.empty();
    const mesh::Mesh& mesh = result.model.mesh;
    for (const model::Motion& motion : result.model.motions) {
        for (const mesh::Facet& facet : mesh.facet_sets.at(motion.face))
            for (const mesh::Index node : mesh::facet_nodes(mesh, facet))
                for (std::size_t i = 0; i < 3 && last; ++i) {
                    const double asked = motion.displacement_m[i].value_or(0);
                    if (asked == 0) continue;
                    const double share = last->displacement_m[3 * static_cast<std::size_t>(node) + i] / asked;
                    if (share < -in_place || share > 1 + in_place || (is_there && share < 1 - in_place))
                        return "the moved face " + motion.face + " is at " + shown(share) + " of its way";
                }
    }
    return "";
}

std::string tiny_loads(std::span<const Step> rows, solution::StopReason end) {
    const auto is_tiny = [](const Step& step) {
        return step.max_stretch < 1 + tiny_strain && step.min_jacobian > 1 - tiny_strain;
    };
    if (!std::ranges::all_of(rows, is_tiny)) return "";
    if (end != solution::StopReason::done) return "a linear response ends as " + std::string{solution::name(end)};
    if (rows.size() > rows_of_a_line) return "a linear response takes " + std::to_string(rows.size()) + " rows";
    return "";
}

}  // namespace

std::string inconsistency(const model::Case& model, std::span<const Step> rows, solution::StopReason end) {
    if (model.dynamics || rows.empty()) return "";
    std::string wrong = energies(rows);
    return wrong.empty() && model.path.stages.size() == 1 ? tiny_loads(rows, end) : wrong;
}

std::string inconsistency(const io::Result& result) {
    if (!result.end) return "";
    std::string wrong = inconsistency(result.model, result.steps, result.end->reason);
    return wrong.empty() && !result.model.dynamics ? motions(result) : wrong;
}

}  // namespace soft::campaign
