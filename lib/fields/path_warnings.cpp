#include "fields/reached.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "core/units.hpp"
#include "material/stability.hpp"
#include "model/location.hpp"
#include "model/rubber.hpp"

namespace soft::fields {
namespace {

using Warnings = std::vector<std::string>;

/// Hooke's law errs by as much as the strain is large.
constexpr double max_small_stretch = 1.1;
/// Of the goal: nearer is there.
constexpr double met = 1e-6;

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
           ": states past that are not unique";
}

void check_law(const model::Material& material, double stretch, Warnings& warnings) {
    const std::string rubber = material.source + ": the rubber is stretched to " + core::rounded_text(stretch, 3);
    if (is_small_strain(material)) {
        if (stretch > max_small_stretch)
            warnings.push_back(rubber + "; small strains (" + material.law +
                               ") hold to about 1.05, a law of finite strain "
                               "(neo-hookean) goes on");
        return;
    }
    if (const auto passed = limits_below(material, stretch); !passed.empty())
        warnings.push_back(rubber + "; " + unstable_text(material, passed) +
                           ", fit the constants over a wider range or with a stable law");
}

/// Where the rubber is stretched most, and no more than 1 % of it.
void check_softening(const model::Case& solved, const model::Material& material, const Reached& reached,
                     Warnings& warnings) {
    const solution::Step& row = reached.most_stretched;
    if (is_small_strain(material) || !limits_below(material, reached.max_stretch_p99).empty()) return;
    const auto passed = limits_below(material, row.max_stretch);
    if (passed.empty()) return;
    const std::string where =
        row.extremes ? " (" + model::location_text(solved.kinematics, row.extremes->stretch_at_m) + ")" : "";
    warnings.push_back(
        material.source + ": at one place" + where + " the rubber is stretched to " +
        core::rounded_text(row.max_stretch, 3) + "; " + unstable_text(material, passed) +
        ", and the body may have given way for the law alone; fit the constants over a wider range or with "
        "a stable law");
}

double value_of(const model::Case& solved, const model::Until& until, const solution::Step& step,
                const solution::Step& first) {
    if (until.quantity == "pressure") return step.pressure_Pa;
    if (until.quantity == "volume_ratio") return step.volume_m3.value_or(0) / first.volume_m3.value_or(1);
    for (std::size_t i = 0; i < solved.outputs.size(); ++i)
        if (solved.outputs[i].name == until.quantity) return step.outputs.at(i);
    return until.value;
}

std::string shown(const model::Case& solved, const model::Until& until, double value) {
    if (until.quantity == "pressure") return core::quantity_text(value, core::Dimension::pressure);
    for (const model::Output& output : solved.outputs)
        if (output.name == until.quantity) {
            const model::MeasureUnit& unit = model::unit_of(output.measure);
            return core::rounded_text(value / unit.SI_per_shown, 4) + " " + std::string{unit.shown};
        }
    return core::rounded_text(value, 4);
}

/// Of the last stage, where its full load has ended it and no goal has.
void check_goals(const model::Case& solved, const Reached& path, Warnings& warnings) {
    const auto& goals = solved.path.stages.back().until;
    std::vector<std::string> missed;
    for (const model::Until& until : goals) {
        const double value = value_of(solved, until, path.last, path.first);
        if (until.quantity == "steps" || std::abs(value - until.value) <= met * std::abs(until.value)) return;
        missed.push_back(until.quantity + " " + shown(solved, until, until.value) + " is not reached, it ends with " +
                         shown(solved, until, value));
    }
    if (!missed.empty())
        warnings.push_back("path.until: the path ends at its full load: " + core::join(missed) +
                           "; a larger load goes on");
}

void check_crushed(const model::Case& solved, const Reached& path, Warnings& warnings) {
    constexpr double hardly_compressible = 50;
    const auto keeps_volume = [](const model::Material& material) {
        return !material.bulk_modulus_Pa ||
               *material.bulk_modulus_Pa >
                   hardly_compressible * material::initial_shear_modulus_Pa(model::make_rubber(material));
    };
    if (!path.first_crushed_row || !std::ranges::all_of(solved.materials, keeps_volume)) return;
    warnings.push_back(
        "from row " + std::to_string(*path.first_crushed_row) +
        " on the mesh presses rubber that keeps its volume to " + core::rounded_text(path.min_jacobian, 2) +
        " of it at a point (min_J), as beside a held edge or a sharp corner: maxima and turns of the curve from "
        "there on may be the mesh's own; round or free that edge, compare another mesh.size, or ask for error "
        "bars (--tolerance)");
}

/// Of the first load, where its pressure is prescribed; maxima of a negative pressure are minima.
void check_maximum(const model::Case& solved, const Reached& path, Warnings& warnings) {
    const model::Stage& stage = solved.path.stages.at(static_cast<std::size_t>(path.last.stage));
    if (stage.supplies.empty() || stage.supplies.front().what != model::Prescription::pressure) return;
    const double asked_Pa = stage.supplies.front().value, sense = asked_Pa < 0 ? -1 : 1;
    double max_Pa = 0;
    for (const solution::LimitPoint& point : path.limit_points)
        max_Pa = std::max(max_Pa, sense * point.pressure_Pa);
    if (!(max_Pa > 0) || max_Pa >= std::abs(asked_Pa) || sense * path.last.pressure_Pa >= max_Pa) return;
    warnings.push_back("loads." + solved.loads.front().name + ": " +
                       core::quantity_text(sense * max_Pa, core::Dimension::pressure) +
                       " is the largest pressure that the body bears on its way to " +
                       core::quantity_text(asked_Pa, core::Dimension::pressure) +
                       "; behind that maximum it gives way, and the path has ended there");
}

}  // namespace

bool is_crushed_at_a_point(const solution::Step& row) {
    constexpr double same_stretch = 1e-6;
    return row.min_jacobian < crushed_jacobian && row.max_stretch > (1 + same_stretch) * row.stretch_p99;
}

std::vector<std::string> warnings_at(const model::Case& solved, const Reached& reached, solution::StopReason end) {
    Warnings warnings;
    if (solved.dynamics) return warnings;
    std::vector<std::string> seen;
    for (const model::Material& material : solved.materials)
        if (std::ranges::find(seen, material.source) == seen.end()) {
            seen.push_back(material.source);
            check_law(material, reached.max_stretch_p99, warnings);
            if (reached.gave_way || end == solution::StopReason::diverged || end == solution::StopReason::step_limit)
                check_softening(solved, material, reached, warnings);
        }
    if (end == solution::StopReason::done) check_goals(solved, reached, warnings);
    check_crushed(solved, reached, warnings);
    if (end != solution::StopReason::done && end != solution::StopReason::limit_point)
        check_maximum(solved, reached, warnings);
    return warnings;
}

}  // namespace soft::fields
