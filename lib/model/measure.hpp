#pragma once
/// Quantities that outputs measure, and their units.
/// Tested by fem/reaction_test, fem/face_shape_test, fem/loads_test.
#include <array>
#include <span>
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
/// Force and moment are those of the whole actuator (plane strain: for a depth of 1 m).
enum class Measure { displacement, bend, twist, radial, rotation, curvature, force, moment };

inline constexpr std::array all_measures{Measure::displacement, Measure::bend,      Measure::twist, Measure::radial,
                                         Measure::rotation,     Measure::curvature, Measure::force, Measure::moment};

/// Units of a measure: SI in files, practical units in tables and messages.
struct MeasureUnit {
    std::string_view SI;         ///< "m"
    std::string_view SI_suffix;  ///< suffix of names: "m" in elongation_m; "per_m" for 1/m
    std::string_view shown;      ///< "mm"
    std::string_view suffix;     ///< suffix of columns: "mm" in elongation_mm
    double SI_per_shown;
    core::Dimension dimension;
};
[[nodiscard]] const MeasureUnit& unit_of(Measure measure);

/// The name in designs and files: "bend".
[[nodiscard]] std::string_view name_of(Measure measure);
/// A short description for help texts: "mean displacement of a face along a direction".
[[nodiscard]] std::string_view meaning_of(Measure measure);

/// True for angles, which are continued beyond pi along a path.
[[nodiscard]] bool is_angle(Measure measure);
/// True for reaction forces and moments, which depend on the loads as well as on the state.
[[nodiscard]] bool is_reaction(Measure measure);

}  // namespace soft::model
