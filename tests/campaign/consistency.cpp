#include "consistency.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "shape_checks.hpp"

namespace soft::campaign {
namespace {

using model::Step;

constexpr double max_energy_gap = 0.01;
/// Relative to the prescribed displacement.
constexpr double motion_tolerance = 1e-6;
/// Strain below which a response is linear; largest number of rows that it may take, with steps growing from a fiftieth of the load.
constexpr double tiny_strain = 1e-6;
constexpr std::size_t max_linear_rows = 8;

std::string text_of(double value) { return core::rounded_text(value, 4); }

std::string energies(std::span<const Step> rows) {
    double gap = 0, largest = 0;
    for (const Step& step : rows) {
        if (!step.energies || !rows.front().energies) return "";  // a law without a strain energy
        const double work = step.energies->load_work_J - rows.front().energies->load_work_J,
                     stored = step.energies->stored_J - rows.front().energies->stored_J +
                              step.energies->dissipated_J.value_or(0) + step.friction_J.value_or(0);
        gap = std::max(gap, std::abs(work - stored));
        largest = std::max({largest, std::abs(work), std::abs(stored)});
    }
    return gap <= max_energy_gap * largest ? "" : "the energies differ by " + text_of(100 * gap / largest) + " %";
}

std::string motions(const io::Result& result) {
    if (result.model.path.stages.size() != 1) return "";
    const auto last = result.fields.read(static_cast<std::int64_t>(result.steps.size()) - 1);
    const bool is_complete =
        result.end && result.end->reason == model::StopReason::done && result.model.path.stages[0].until.empty();
    const mesh::Mesh& mesh = result.model.mesh;
    for (const model::Motion& motion : result.model.motions) {
        for (const mesh::Facet& facet : mesh.facet_sets.at(motion.face))
            for (const mesh::Index node : mesh::facet_nodes(mesh, facet))
                for (std::size_t i = 0; i < 3 && last; ++i) {
                    const double asked = motion.displacement_m[i].value_or(0);
                    if (asked == 0) continue;
                    const double share = last->displacement_m[3 * static_cast<std::size_t>(node) + i] / asked;
                    if (share < -motion_tolerance || share > 1 + motion_tolerance ||
                        (is_complete && share < 1 - motion_tolerance))
                        return "the moved face " + motion.face + " has moved by " + text_of(share) +
                               " of the prescribed displacement";
                }
    }
    return "";
}

std::string walls(const io::Result& result) {
    const model::Case& model = result.model;
    const auto last = result.fields.read(static_cast<std::int64_t>(result.steps.size()) - 1);
    if (!last || model.path.contact != model::Contact::solve) return "";
    const auto& u = last->displacement_m;
    const ShapeChecks checks{model};
    const double allowed_m = checks.contact_distance_m();
    const auto [depth_m, obstacle] = checks.deepest_in_obstacle(u);
    if (depth_m > allowed_m) return "a wall is " + text_of(1e3 * depth_m) + " mm inside the obstacle " + obstacle;
    return checks.contact(u, u, allowed_m);
}

std::string tiny_loads(std::span<const Step> rows, model::StopReason end) {
    const auto is_tiny = [](const Step& step) {
        return step.max_stretch < 1 + tiny_strain && step.min_jacobian > 1 - tiny_strain;
    };
    if (!std::ranges::all_of(rows, is_tiny)) return "";
    if (end != model::StopReason::done) return "a linear response ends as " + std::string{model::name(end)};
    if (rows.size() > max_linear_rows) return "a linear response needs " + std::to_string(rows.size()) + " rows";
    return "";
}

}  // namespace

std::string inconsistency(const model::Case& model, std::span<const Step> rows, model::StopReason end) {
    if (model.dynamics || rows.empty()) return "";
    std::string wrong = energies(rows);
    return wrong.empty() && model.path.stages.size() == 1 ? tiny_loads(rows, end) : wrong;
}

std::string inconsistency(const io::Result& result) {
    if (!result.end) return "";
    std::string wrong = inconsistency(result.model, result.steps, result.end->reason);
    if (wrong.empty() && !result.model.dynamics) wrong = motions(result);
    return wrong.empty() ? walls(result) : wrong;
}

}  // namespace soft::campaign
