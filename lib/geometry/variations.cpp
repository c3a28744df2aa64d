#include "geometry/variations.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "core/text.hpp"
#include "meshing/cell_counts.hpp"

namespace soft::geometry {
namespace {

constexpr std::string_view all = "all";
constexpr const char* option = "--sensitivity";

bool has_same_cells(const mesh::Mesh& a, const mesh::Mesh& b) {
    const auto same_facets = [](const auto& one, const auto& other) {
        return one.first == other.first &&
               std::ranges::equal(one.second, other.second, [](const mesh::Facet& f, const mesh::Facet& g) {
                   return f.cell == g.cell && f.local == g.local;
               });
    };
    return a.points.size() == b.points.size() && a.connectivity == b.connectivity && a.offsets == b.offsets &&
           a.cell_types == b.cell_types && a.cell_regions == b.cell_regions &&
           std::ranges::equal(a.facet_sets, b.facet_sets, same_facets);
}

/// Whether a pressure follows from an amount of gas.
bool has_gas(const model::Case& model) {
    using What = model::Prescription;
    return std::ranges::any_of(model.path.stages, [](const model::Stage& stage) {
        return std::ranges::any_of(stage.supplies, [](const model::SupplyTarget& supply) {
            return supply.what == What::mass || supply.what == What::closed;
        });
    });
}

bool changes_mesh(const std::string& key) { return key.starts_with("geometry.") || key.starts_with("obstacles."); }

/// The shape of a design with the cells of another one, where its generator can repeat their numbers.
MeshedShape make_shape_with_cells_of(const design::Design& varied, const design::Design& base, const mesh::Mesh& mesh) {
    MeshedShape made = make_shape(varied);
    if (has_same_cells(made.mesh, mesh)) return made;
    const auto counts = meshing::record_counts([&] { static_cast<void>(make_shape(base)); });
    MeshedShape repeated;
    const bool is_repeated = meshing::repeat_counts(counts, [&] { repeated = make_shape(varied); });
    return is_repeated ? std::move(repeated) : std::move(made);
}

/// The case with the value, and the value as read. Throws Error (bad_input) where the design or the generator refuses it.
std::pair<model::Variation::Side, double> side_at(const design::Design& design, const Built& built,
                                                  const model::DesignParameter& parameter, double value,
                                                  std::string_view source) {
    const auto text_of = [&](double number) {
        const std::string text = core::number_text(number / parameter.SI_per_unit);
        return parameter.unit.empty() ? text : text + " " + parameter.unit;
    };
    const design::Override change{parameter.key, text_of(value), {}};
    const design::Design varied = design::read_design(design.effective_yaml, source, catalogue_keys(), {&change, 1});
    const double read = varied.values.number(parameter.key);
    if (!changes_mesh(parameter.key)) return {{built.model.mesh.points, built.shape, varied.effective_yaml}, read};
    MeshedShape made = make_shape_with_cells_of(varied, design, built.model.mesh);
    if (!has_same_cells(made.mesh, built.model.mesh))
        throw Error(ExitCode::bad_input, parameter.key,
                    "the mesh has other cells with a slightly different value, so there is no derivative",
                    "change mesh.size slightly, or compare two runs");
    return {{std::move(made.mesh.points), std::move(made.shape), varied.effective_yaml}, read};
}

/// Varied to both sides, or to the side that is possible.
model::Variation vary(const design::Design& design, const Built& built, const model::DesignParameter& parameter,
                      double step, std::string_view source) {
    model::Variation::Side base{built.model.mesh.points, built.shape, design.effective_yaml};
    model::Variation varied{parameter, base, base};
    varied.parameter.lower = varied.parameter.higher = parameter.value;
    std::optional<Error> refused;
    const auto try_side = [&](model::Variation::Side& side, double& value, double change) {
        try {
            std::tie(side, value) = side_at(design, built, parameter, parameter.value + change, source);
        } catch (const Error& error) {
            refused = error;
        }
    };
    const double change = step * std::abs(parameter.value);
    try_side(varied.lower, varied.parameter.lower, -change);
    try_side(varied.higher, varied.parameter.higher, change);
    if (!(varied.parameter.higher > varied.parameter.lower) && refused) throw *refused;
    return varied;
}

/// Largest move of a node between both sides, and largest difference between its moves from the case to both sides.
struct Moves {
    double largest = 0, difference = 0;
};
Moves moves_of(const model::Variation& varied, const mesh::Mesh& mesh) {
    Moves moves;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        for (std::size_t d = 0; d < 3; ++d) {
            const double low = varied.lower.points[i][d], high = varied.higher.points[i][d];
            moves.largest = std::max(moves.largest, std::abs(high - low));
            moves.difference = std::max(moves.difference, std::abs(high - 2 * mesh.points[i][d] + low));
        }
    return moves;
}

model::Variation vary(const design::Design& design, const Built& built, const model::DesignParameter& parameter,
                      std::string_view source) {
    constexpr double without_motion = 1e-7, usual = 1e-6, of_rough_positions = 1e-5, rough = 1e-4;
    model::Variation varied =
        vary(design, built, parameter, changes_mesh(parameter.key) ? usual : without_motion, source);
    if (!changes_mesh(parameter.key)) return varied;
    const Moves moves = moves_of(varied, built.model.mesh);
    const bool to_both = varied.parameter.lower < parameter.value && parameter.value < varied.parameter.higher;
    if (moves.largest == 0) return vary(design, built, parameter, without_motion, source);
    if (!to_both || moves.difference < rough * moves.largest) return varied;
    return vary(design, built, parameter, of_rough_positions, source);
}

}  // namespace

void require_differentiable(const model::Case& model) {
    if (model.outputs.empty())
        throw Error(ExitCode::bad_input, option, "the design has no outputs",
                    "add one, for example outputs: {elongation: {face: moving}}");
    if (model.dynamics)
        throw Error(ExitCode::bad_input, option, "a motion in time has no sensitivities", "omit dynamics.duration");
    if (model::has_friction(model))
        throw Error(ExitCode::bad_input, option, "paths with friction have no sensitivities",
                    "set contact.friction and that of the obstacles to 0");
}

Variations make_variations(const design::Design& design, const Built& built, std::span<const std::string> keys,
                           std::string_view source) {
    require_differentiable(built.model);
    Variations result;
    for (auto at = keys.begin(); at != keys.end(); ++at) {
        const std::string& key = *at;
        if (key == all || std::find(keys.begin(), at, key) != at) continue;
        const auto found = std::ranges::find(design.parameters, key, &model::DesignParameter::key);
        if (found == design.parameters.end()) {
            std::vector<std::string> known{std::string{all}};
            for (const model::DesignParameter& parameter : design.parameters) known.push_back(parameter.key);
            throw Error(ExitCode::usage, std::string{option} + " " + key,
                        "not a number of the design that differs from 0", core::did_you_mean(key, known));
        }
        result.variations.push_back(vary(design, built, *found, source));
    }
    if (std::ranges::find(keys, all) == keys.end()) return result;
    for (const model::DesignParameter& parameter : design.parameters) {
        const bool is_of_unused_gas = parameter.key.find(".gas.") != std::string::npos && !has_gas(built.model);
        if (is_of_unused_gas || std::ranges::find(keys, parameter.key) != keys.end()) continue;
        try {
            result.variations.push_back(vary(design, built, parameter, source));
        } catch (const Error& error) {
            result.notes.push_back(std::string{option} + " leaves out " + parameter.key + ": " + error.what());
        }
    }
    return result;
}

}  // namespace soft::geometry
