#include "io/case_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string>

#include "core/text.hpp"

namespace soft::io {
namespace {

/// Directions are written with 16 digits by us; by hand three or four are usual. A millionth turns no force noticeably.
constexpr double unit_length_tolerance = 1e-6;
/// gmsh leaves points of the axis off it by rounding; relative to the largest radius.
constexpr double axis_tolerance = 1e-8;

using core::quoted;

class Checker {
public:
    Checker(const model::Case& model, std::string_view source, ExitCode code)
        : case_(model), source_(source), code_(code) {}

    void check_all() const {
        check_header();
        check_points();
        check_cells();
        check_sets();
        check_materials();
        check_supports();
        check_cavities();
        check_loads();
        check_outputs();
        check_control();
    }

private:
    [[noreturn]] void refuse(const std::string& place, const std::string& problem) const {
        throw Error(code_, std::string{source_} + ":" + place, problem, "rebuild the case with mesh-gen");
    }
    void require(bool condition, const std::string& place, const std::string& problem) const {
        if (!condition) refuse(place, problem);
    }
    static std::string item(const std::string& list, std::size_t i) { return list + "[" + std::to_string(i) + "]"; }

    void require_finite(double value, const std::string& place) const {
        require(std::isfinite(value), place, "is not a finite number");
    }
    void require_name(const std::string& text, const std::string& place) const {
        require(is_name(text), place, quoted(text) + " is not a name (letters, digits, '_', '-', '.')");
    }
    void require_face(const std::string& face, const std::string& place) const {
        const auto found = case_.mesh.facet_sets.find(face);
        require(found != case_.mesh.facet_sets.end(), place, "there is no face named " + quoted(face));
        require(!found->second.empty(), place, "the face " + quoted(face) + " is empty");
    }
    void require_unit(const std::array<double, 3>& direction, const std::string& place) const {
        const double length = std::hypot(direction[0], direction[1], direction[2]);
        require(std::abs(length - 1) <= unit_length_tolerance, place, "is not a unit vector");
    }
    template <class List, class NameOf>
    void require_unique(const List& list, const std::string& place, NameOf name_of_item) const {
        std::set<std::string> seen;
        for (const auto& entry : list) {
            const std::string& text = name_of_item(entry);
            require_name(text, item(place, seen.size()));
            if (!seen.insert(text).second) refuse(item(place, seen.size()), quoted(text) + " stands there twice");
        }
    }

    void check_header() const {
        require(case_.model_fraction > 0 && case_.model_fraction <= 1, "/mesh/model_fraction",
                "must be greater than 0 and at most 1");
        const int expected = case_.kinematics == model::Kinematics::solid ? 3 : 2;
        require(case_.mesh.dimension == expected, "/mesh/dimension",
                "must be " + std::to_string(expected) + " for these kinematics");
    }

    void check_points() const {
        const auto& points = case_.mesh.points;
        require(!points.empty(), "/VTKHDF/Points", "there are no points");
        double largest = 0;
        double least = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!std::all_of(points[i].begin(), points[i].end(), [](double x) { return std::isfinite(x); }))
                refuse(item("/VTKHDF/Points", i), "is not a finite number");
            largest = std::max(largest, points[i][1]);
            least = std::min(least, points[i][1]);
        }
        if (case_.kinematics == model::Kinematics::axisymmetric)
            require(least >= -axis_tolerance * largest, "/VTKHDF/Points", "a section has points at a negative radius");
    }

    // The loops over the mesh make their messages only when they are needed: text for a million nodes takes a second.
    void check_cells() const {
        const mesh::Mesh& mesh = case_.mesh;
        const std::size_t cells = mesh.cell_types.size();
        require(cells > 0, "/VTKHDF/Types", "there are no cells");
        require(mesh.offsets.size() == cells + 1 && mesh.offsets[0] == 0, "/VTKHDF/Offsets",
                "must start at 0 and be one more than the cells");
        require(mesh.cell_regions.size() == cells, "/mesh/cell_regions", "must be one a cell");
        const auto nodes = static_cast<mesh::Index>(mesh.connectivity.size());
        for (std::size_t c = 0; c < cells; ++c) {
            const auto& topology = mesh::topology(mesh.cell_types[c]);
            if (topology.dimension != mesh.dimension)
                refuse(item("/VTKHDF/Types", c), std::string{topology.name} + " has not the dimension of the mesh");
            if (mesh.offsets[c] > nodes || mesh.offsets[c + 1] != mesh.offsets[c] + topology.node_count)
                refuse(item("/VTKHDF/Offsets", c + 1), "does not fit the nodes of a " + std::string{topology.name});
            const auto region = mesh.cell_regions[c];
            if (region < 0 || static_cast<std::size_t>(region) >= mesh.region_names.size())
                refuse(item("/mesh/cell_regions", c), "region " + std::to_string(region) + " does not exist");
        }
        require(mesh.offsets.back() == nodes, "/VTKHDF/Connectivity", "its length does not fit the offsets");
        for (std::size_t i = 0; i < mesh.connectivity.size(); ++i)
            require_point(mesh.connectivity[i], "/VTKHDF/Connectivity", i);
    }
    void require_point(mesh::Index point, const std::string& list, std::size_t i) const {
        if (point < 0 || point >= static_cast<mesh::Index>(case_.mesh.points.size()))
            refuse(item(list, i), "point " + std::to_string(point) + " does not exist");
    }

    void check_sets() const {
        for (const auto& [name, facets] : case_.mesh.facet_sets) {
            const std::string place = "/mesh/facets/" + name;
            require_name(name, place);
            for (std::size_t i = 0; i < facets.size(); ++i) check_facet(facets[i], place, i);
        }
        for (const auto& [name, points] : case_.mesh.point_sets) {
            const std::string place = "/mesh/points/" + name;
            require_name(name, place);
            for (std::size_t i = 0; i < points.size(); ++i) require_point(points[i], place, i);
        }
    }
    void check_facet(const mesh::Facet& facet, const std::string& list, std::size_t i) const {
        const std::string cell = "cell " + std::to_string(facet.cell);
        if (facet.cell < 0 || facet.cell >= case_.mesh.cell_count()) refuse(item(list, i), cell + " does not exist");
        const auto count = static_cast<int>(mesh::topology(case_.mesh.cell_type(facet.cell)).facets.size());
        if (facet.local < 0 || facet.local >= count)
            refuse(item(list, i), cell + " has no facet " + std::to_string(facet.local));
    }

    void check_materials() const {
        const auto& regions = case_.mesh.region_names;
        require_unique(regions, "/mesh/region_names", [](const std::string& name) { return name; });
        require_unique(case_.materials, "/materials", [](const model::Material& material) { return material.name; });
        for (const model::Material& material : case_.materials) {
            const std::string place = "/materials/" + material.name;
            require(std::find(regions.begin(), regions.end(), material.name) != regions.end(), place,
                    "there is no region of that name");
            require_name(material.law, place + "/law");
            for (const auto& [key, values] : material.constants) {
                require_name(key, place + "/constants");
                for (const double value : values) require_finite(value, place + "/constants/" + key);
            }
            const double kappa = material.bulk_modulus_Pa.value_or(1);
            require(std::isfinite(kappa) && kappa > 0, place + "/bulk_modulus", "must be positive");
        }
        require(regions.size() == case_.materials.size(), "/materials", "a region is without material");
    }

    void check_supports() const {
        for (std::size_t i = 0; i < case_.supports.size(); ++i) {
            const model::Support& support = case_.supports[i];
            require_face(support.face, item("/supports/face", i));
            require(support.fixed[0] || support.fixed[1] || support.fixed[2], item("/supports/fixed", i),
                    "holds no component");
        }
    }

    void check_cavities() const {
        require_unique(case_.cavities, "/loads/cavities", [](const model::Cavity& cavity) { return cavity.name; });
        for (const model::Cavity& cavity : case_.cavities) {
            const std::string place = "/loads/cavities/" + cavity.name;
            require_face(cavity.wall, place + "/wall");
            for (std::size_t i = 0; i < cavity.inner_faces.size(); ++i)
                require_face(cavity.inner_faces[i], item(place + "/inner_faces", i));
            for (std::size_t i = 0; i < cavity.openings.size(); ++i) {
                const model::Opening& opening = cavity.openings[i];
                require_face(opening.face, item(place + "/openings/face", i));
                require(std::isfinite(opening.area_m2) && opening.area_m2 > 0, item(place + "/openings/area", i),
                        "must be positive");
                require_unit(opening.direction, item(place + "/openings/direction", i));
            }
        }
    }

    void check_loads() const {
        for (std::size_t i = 0; i < case_.loads.size(); ++i) {
            const model::PressureLoad& load = case_.loads[i];
            const bool cavity = std::any_of(case_.cavities.begin(), case_.cavities.end(),
                                            [&](const model::Cavity& other) { return other.name == load.target; });
            require(cavity || case_.mesh.facet_sets.contains(load.target), item("/loads/target", i),
                    "there is no cavity or face named " + quoted(load.target));
            require_finite(load.pressure_Pa, item("/loads/pressure", i));
        }
        for (std::size_t i = 0; i < case_.tractions.size(); ++i) {
            require_face(case_.tractions[i].face, item("/loads/tractions/face", i));
            for (const double component : case_.tractions[i].traction_Pa)
                require_finite(component, item("/loads/tractions/traction", i));
        }
    }

    void check_outputs() const {
        require_unique(case_.outputs, "/outputs/name", [](const model::Output& output) { return output.name; });
        for (std::size_t i = 0; i < case_.outputs.size(); ++i) {
            require_face(case_.outputs[i].face, item("/outputs/face", i));
            require_unit(case_.outputs[i].direction, item("/outputs/direction", i));
        }
    }

    void check_control() const {
        constexpr std::array<std::string_view, 3> quantities{"pressure", "volume_ratio", "steps"};
        for (std::size_t i = 0; i < case_.path.until.size(); ++i) {
            const model::Until& until = case_.path.until[i];
            const bool known = std::find(quantities.begin(), quantities.end(), until.quantity) != quantities.end() ||
                               std::any_of(case_.outputs.begin(), case_.outputs.end(),
                                           [&](const model::Output& output) { return output.name == until.quantity; });
            require(known, item("/control/until/quantity", i), "there is no output named " + quoted(until.quantity));
            require_finite(until.value, item("/control/until/value", i));
        }
        const model::SolverSettings& solver = case_.solver;
        require(solver.residual_tolerance > 0 && solver.residual_tolerance < 1, "/control/solver/residual_tolerance",
                "must lie between 0 and 1");
        require(solver.newton_limit >= 1, "/control/solver/newton_limit", "must be at least 1");
        require(solver.step_limit >= 1, "/control/solver/step_limit", "must be at least 1");
        require_positive(solver.first_step, "/control/solver/first_step");
        require_positive(solver.smallest_step, "/control/solver/smallest_step");
        require_positive(solver.step_accuracy, "/control/solver/step_accuracy");
        require(std::isfinite(solver.largest_step) && solver.largest_step >= 0, "/control/solver/largest_step",
                "must not be negative");
    }
    void require_positive(double value, const std::string& place) const {
        require(std::isfinite(value) && value > 0, place, "must be positive");
    }

    const model::Case& case_;
    std::string_view source_;
    ExitCode code_;
};

}  // namespace

void check_case(const model::Case& model, std::string_view source, ExitCode code) {
    Checker{model, source, code}.check_all();
}

bool is_name(std::string_view text) noexcept {
    constexpr std::size_t longest = 100;
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
               c == '.';
    };
    return !text.empty() && text.size() <= longest && text[0] != '.' && std::all_of(text.begin(), text.end(), allowed);
}

}  // namespace soft::io
