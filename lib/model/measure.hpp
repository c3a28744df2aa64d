#pragma once
/// Quantities that outputs measure, and their units.
/// Tested by fem/reaction_test, fem/face_shape_test, fem/loads_test.
#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

#include "core/units.hpp"

namespace soft::model {

/// Means are taken over the undeformed face; `direction` is the output's unit vector. A face that is cut by symmetry planes
/// represents the whole face (model/face_symmetry.hpp).
///   displacement: mean displacement of the face, or displacement of one point, along `direction` [m]
///   bend: angle about `direction` from the reversed mean deformed normal of `reference` to that of `face`, relative to the
///         undeformed state [rad]
///   twist: mean rotation of the face about the axis `direction` through the origin [rad]
///   radial: mean change of the distance from the axis `direction` through the origin [m]
///   rotation: component along `direction` of the rotation vector (axis times angle, angle at most pi) of the best-fit rigid
///         motion of the face [rad]
///   curvature: curvature of the best-fit circle of the deformed face, projected along `direction` [1/m]; fem/circle_fit.hpp
///   force: force of the actuator on its support or drive at the face, along `direction` [N]
///   moment: moment of those forces about the axis `direction` through the centroid of the undeformed face [N m]
/// Of an obstacle, or of the contact of the actuator with itself (model::Output::obstacle):
///   displacement: of the obstacle, along `direction` [m]
///   force: force of the actuator on the obstacle along `direction` [N]; not of self-contact, where it is 0
///   contact_area: part of the deformed surface that is in contact [m^2]
///   contact_pressure: maximum contact pressure [Pa]
/// Force, moment and area are those of the whole actuator (plane strain: for a depth of 1 m).
enum class Measure {
    displacement,
    bend,
    twist,
    radial,
    rotation,
    curvature,
    force,
    moment,
    contact_area,
    contact_pressure
};

/// Units of a measure: SI in files, practical units in tables and messages.
struct MeasureUnit {
    std::string_view SI;         ///< "m"
    std::string_view SI_suffix;  ///< suffix of names: "m" in elongation_m; "per_m" for 1/m
    std::string_view shown;      ///< "mm"
    std::string_view suffix;     ///< suffix of columns: "mm" in elongation_mm
    double SI_per_shown;
    core::Dimension dimension;
};
inline constexpr MeasureUnit length_unit{"m", "m", "mm", "mm", 1e-3, core::Dimension::length},
    angle_unit{"rad", "rad", "deg", "deg", std::numbers::pi / 180, core::Dimension::angle},
    curvature_unit{"1/m", "per_m", "1/m", "per_m", 1, core::Dimension::curvature},
    force_unit{"N", "N", "N", "N", 1, core::Dimension::force},
    moment_unit{"N.m", "Nm", "N.mm", "Nmm", 1e-3, core::Dimension::moment},
    area_unit{"m2", "m2", "mm2", "mm2", 1e-6, core::Dimension::area},
    pressure_unit{"Pa", "Pa", "kPa", "kPa", 1e3, core::Dimension::pressure};

/// Meaning of the direction of an output.
enum class Along {
    direction,        ///< of a displacement
    force_direction,  ///< not r, because the forces along r cancel around the circumference
    axis,             ///< of a rotation or moment, not in axisymmetric models; in plane strain it is z
    distance_axis,    ///< from which a distance is taken, not in plane strain
    none,             ///< the measure has no direction
};

/// What a measure is taken of.
enum class MeasuredObject { face, obstacle, face_or_obstacle };

/// The words, the unit and the restrictions of a measure. Designs, files, columns, messages and docs/reference take them from here.
struct MeasureInfo {
    Measure measure;
    std::string_view name;     ///< in designs and files: "bend"
    std::string_view meaning;  ///< for help texts: "mean displacement of a face along a direction"
    const MeasureUnit& unit;
    Along along;
    bool has_default_axis = false;  ///< whether `along` may be omitted
    bool solid_only = false;        ///< not in sections
    bool reaction = false;          ///< of a face: depends on the loads as well as on the state; static paths only
    MeasuredObject object = MeasuredObject::face;
};
inline constexpr std::array measures{
    MeasureInfo{.measure = Measure::displacement,
                .name = "displacement",
                .meaning = "mean displacement of a face, or displacement of an obstacle, along a direction",
                .unit = length_unit,
                .along = Along::direction,
                .has_default_axis = true,
                .object = MeasuredObject::face_or_obstacle},
    MeasureInfo{.measure = Measure::bend,
                .name = "bend",
                .meaning = "bending angle of a face relative to another face, about a direction",
                .unit = angle_unit,
                .along = Along::axis},
    MeasureInfo{.measure = Measure::twist,
                .name = "twist",
                .meaning = "mean rotation of a face about an axis through the origin",
                .unit = angle_unit,
                .along = Along::axis,
                .has_default_axis = true},
    MeasureInfo{.measure = Measure::radial,
                .name = "radial",
                .meaning = "mean change of a face's distance from an axis through the origin",
                .unit = length_unit,
                .along = Along::distance_axis,
                .has_default_axis = true},
    MeasureInfo{.measure = Measure::rotation,
                .name = "rotation",
                .meaning = "component of the rotation vector of a face's mean rotation",
                .unit = angle_unit,
                .along = Along::axis,
                .solid_only = true},
    MeasureInfo{.measure = Measure::curvature,
                .name = "curvature",
                .meaning = "curvature of the best-fit circle of a face, projected along a direction",
                .unit = curvature_unit,
                .along = Along::axis,
                .solid_only = true},
    MeasureInfo{.measure = Measure::force,
                .name = "force",
                .meaning = "force of the actuator on its support or drive at a face, or on an obstacle",
                .unit = force_unit,
                .along = Along::force_direction,
                .has_default_axis = true,
                .reaction = true,
                .object = MeasuredObject::face_or_obstacle},
    MeasureInfo{
        .measure = Measure::moment,
        .name = "moment",
        .meaning = "moment of the actuator on its support or drive at a face, about an axis through its centroid",
        .unit = moment_unit,
        .along = Along::axis,
        .reaction = true},
    MeasureInfo{.measure = Measure::contact_area,
                .name = "area",
                .meaning = "area of the deformed surface in contact with an obstacle",
                .unit = area_unit,
                .along = Along::none,
                .object = MeasuredObject::obstacle},
    MeasureInfo{.measure = Measure::contact_pressure,
                .name = "pressure",
                .meaning = "maximum contact pressure at an obstacle",
                .unit = pressure_unit,
                .along = Along::none,
                .object = MeasuredObject::obstacle},
};

static_assert(std::ranges::is_sorted(measures, {}, &MeasureInfo::measure), "in the order of the enumeration");

[[nodiscard]] constexpr const MeasureInfo& info_of(Measure measure) {
    return measures.at(static_cast<std::size_t>(measure));
}
[[nodiscard]] constexpr const MeasureUnit& unit_of(Measure measure) { return info_of(measure).unit; }
[[nodiscard]] constexpr std::string_view name_of(Measure measure) { return info_of(measure).name; }

/// True for angles, which are continued beyond pi along a path.
[[nodiscard]] constexpr bool is_angle(Measure measure) { return unit_of(measure).dimension == core::Dimension::angle; }
/// Whether the solver knows its slope along the path; not that of sums and largest values over sample points in contact.
[[nodiscard]] constexpr bool has_slope(Measure measure) {
    return measure != Measure::contact_area && measure != Measure::contact_pressure;
}
[[nodiscard]] constexpr bool is_reaction(Measure measure) { return info_of(measure).reaction; }

}  // namespace soft::model
