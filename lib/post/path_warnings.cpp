#include "post/path_warnings.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "core/units.hpp"
#include "material/stability.hpp"
#include "model/location.hpp"
#include "model/rubber.hpp"

namespace soft::post {
namespace {

using Warnings = std::vector<std::string>;

/// The relative error of Hooke's law is of the order of the strain.
constexpr double max_small_stretch = 1.1;
/// Relative distance at which a goal counts as reached.
constexpr double goal_tolerance = 1e-6;

bool is_small_strain(const model::Material& material) {
    return material.strain == model::Strain::small || material.law == "linear-elastic";
}

std::vector<material::StabilityLimit> limits_below(const model::Material& material, double stretch) {
    std::vector<material::StabilityLimit> passed = material::stability_limits(model::make_rubber(material));
    std::erase_if(passed, [&](const material::StabilityLimit& limit) {
        return limit.sense != material::Sense::tension || limit.stretch >= stretch;
    });
    return passed;
}

std::string unstable_text(const model::Material& material, const std::vector<material::StabilityLimit>& passed) {
    return material.law + " with these constants is " + material::stability_text(passed) +
           ", where its states are not unique";
}

void check_law(const model::Material& material, double stretch, Warnings& warnings) {
    const std::string rubber = material.source + ": the rubber is stretched to " + core::rounded_text(stretch, 3);
    if (is_small_strain(material)) {
        if (stretch > max_small_stretch)
            warnings.push_back(rubber + ", but small strains (" + material.law +
                               ") are accurate to about 1.05 only; "
                               "use a finite-strain law such as neo-hookean");
        return;
    }
    if (const auto passed = limits_below(material, stretch); !passed.empty())
        warnings.push_back(rubber + ", but " + unstable_text(material, passed) +
                           "; fit the constants over a wider range or use a stable law");
}

/// Warns if at most 1 % of the rubber is stretched beyond the stability limit.
void check_softening(const model::Case& solved, const model::Material& material, const PathSummary& reached,
                     Warnings& warnings) {
    const model::Step& row = reached.max_stretch_step;
    if (is_small_strain(material) || !limits_below(material, reached.max_stretch_p99).empty()) return;
    const auto passed = limits_below(material, row.max_stretch);
    if (passed.empty()) return;
    const std::string where =
        row.extremes ? " (" + model::location_text(solved.kinematics, row.extremes->stretch_at_m) + ")" : "";
    warnings.push_back(
        material.source + ": at one point" + where + " the rubber is stretched to " +
        core::rounded_text(row.max_stretch, 3) + ", but " + unstable_text(material, passed) +
        ", so the instability of the part may be an artefact of the law; fit the constants over a wider range or use "
        "a stable law");
}

double value_of(const model::Case& solved, const model::Until& until, const model::Step& step,
                const model::Step& first) {
    if (until.quantity == "pressure") return step.pressure_Pa;
    if (until.quantity == "volume_ratio") return step.volume_m3.value_or(0) / first.volume_m3.value_or(1);
    for (std::size_t i = 0; i < solved.outputs.size(); ++i)
        if (solved.outputs[i].name == until.quantity) return step.outputs.at(i);
    return until.value;
}

std::string goal_text(const model::Case& solved, const model::Until& until, double value) {
    if (until.quantity == "pressure") return core::quantity_text(value, core::Dimension::pressure);
    for (const model::Output& output : solved.outputs)
        if (output.name == until.quantity) {
            const model::MeasureUnit& unit = model::unit_of(output.measure);
            return core::rounded_text(value / unit.SI_per_shown, 4) + " " + std::string{unit.shown};
        }
    return core::rounded_text(value, 4);
}

/// Warns if the last stage ended at its full load without reaching a goal.
void check_goals(const model::Case& solved, const PathSummary& path, Warnings& warnings) {
    const auto& goals = solved.path.stages.back().until;
    std::vector<std::string> missed;
    for (const model::Until& until : goals) {
        const double value = value_of(solved, until, path.last, path.first);
        if (until.quantity == "steps" || std::abs(value - until.value) <= goal_tolerance * std::abs(until.value))
            return;
        missed.push_back(until.quantity + " " + goal_text(solved, until, until.value) + " is not reached, it is " +
                         goal_text(solved, until, value));
    }
    if (!missed.empty())
        warnings.push_back("path.until: the path ended at its full load: " + core::join(missed) +
                           "; use a larger load");
}

/// The first row at which rubber that hardly changes its volume is crushed at a point.
std::optional<int> crushed_row(const model::Case& solved, const PathSummary& path) {
    constexpr double hardly_compressible = 10;
    const auto keeps_volume = [](const model::Material& material) {
        return !material.bulk_modulus_Pa ||
               *material.bulk_modulus_Pa >
                   hardly_compressible * material::initial_shear_modulus_Pa(model::make_rubber(material));
    };
    return std::ranges::all_of(solved.materials, keeps_volume) ? path.first_crushed_row : std::nullopt;
}

void check_crushed(const model::Case& solved, const PathSummary& path, Warnings& warnings) {
    const auto row = crushed_row(solved, path);
    if (!row) return;
    warnings.push_back(
        "from row " + std::to_string(*row) + " on, nearly incompressible rubber is compressed to " +
        core::rounded_text(path.min_jacobian, 2) +
        " of its volume at a point (min_J), as next to a fixed edge or a sharp corner: limit points and turning points of "
        "the curve from there on may be mesh artefacts; round or release that edge, compare another mesh.size, or request "
        "error bars (--tolerance)");
}

void check_snaps(const PathSummary& path, Warnings& warnings) {
    constexpr double noticeable = 0.01;
    const auto& energies = path.last.energies;
    if (path.is_inelastic || !energies || !(energies->dissipated_J.value_or(0) > noticeable * path.largest_work_J))
        return;
    warnings.push_back("where edges slip, or creases close or form, small parts snap and set energy free, " +
                       core::rounded_text(100 * *energies->dissipated_J / path.largest_work_J, 2) +
                       " % of the largest work of the loads (dissipated_energy): compare another mesh.size");
}

/// Warns if the first load prescribes a pressure beyond its limit point; for a negative pressure the limit point is a minimum.
void check_maximum(const model::Case& solved, const PathSummary& path, Warnings& warnings) {
    const model::Stage& stage = solved.path.stages.at(static_cast<std::size_t>(path.last.stage));
    if (stage.supplies.empty() || stage.supplies.front().what != model::Prescription::pressure) return;
    const double asked_Pa = stage.supplies.front().value, sense = asked_Pa < 0 ? -1 : 1;
    double max_Pa = 0;
    int limit_row = 0;
    for (const model::LimitPoint& point : path.limit_points)
        if (sense * point.pressure_Pa > max_Pa) {
            max_Pa = sense * point.pressure_Pa;
            limit_row = point.step;
        }
    if (!(max_Pa > 0) || max_Pa >= std::abs(asked_Pa) || sense * path.last.pressure_Pa >= max_Pa) return;
    const auto crushed = crushed_row(solved, path);
    warnings.push_back(
        "loads." + solved.loads.front().name + ": " + core::quantity_text(sense * max_Pa, core::Dimension::pressure) +
        " is the limit pressure on the way to " + core::quantity_text(asked_Pa, core::Dimension::pressure) +
        (crushed && *crushed <= limit_row ? ", perhaps only on this mesh (min_J)" : "") +
        ", and the path has ended past that limit point; request less than the limit pressure");
}

}  // namespace

bool is_crushed_at_a_point(const model::Step& row) {
    constexpr double same_stretch = 1e-6;
    return row.min_jacobian < crushed_jacobian && row.max_stretch > (1 + same_stretch) * row.stretch_p99;
}

std::vector<std::string> path_warnings(const model::Case& solved, const PathSummary& reached, model::StopReason end) {
    Warnings warnings;
    if (solved.dynamics) return warnings;
    std::vector<std::string> seen;
    for (const model::Material& material : solved.materials)
        if (std::ranges::find(seen, material.source) == seen.end()) {
            seen.push_back(material.source);
            check_law(material, reached.max_stretch_p99, warnings);
            if (reached.became_unstable || end == model::StopReason::diverged || end == model::StopReason::step_limit)
                check_softening(solved, material, reached, warnings);
        }
    if (end == model::StopReason::done) check_goals(solved, reached, warnings);
    check_crushed(solved, reached, warnings);
    check_snaps(reached, warnings);
    if (end != model::StopReason::done && end != model::StopReason::limit_point)
        check_maximum(solved, reached, warnings);
    return warnings;
}

}  // namespace soft::post
