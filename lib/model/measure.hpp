#pragma once
/// What an output measures on its face, and in which units it is written. Tested by assembly/reaction_test, assembly/face_shape_test, assembly/loads_test.
#include <array>
#include <span>
#include <string_view>

#include "core/units.hpp"

namespace soft::model {

/// Means are over the undeformed face; `direction` is the output's unit vector. A face that the planes of symmetry cut
/// stands for the whole one (model/face_symmetry.hpp).
///   displacement: mean displacement along `direction`, or that of one point [m]
///   bend: angle, about `direction`, from the mean deformed normal of `reference` turned round to that of `face`; 0 in the
///         undeformed state [rad]
///   twist: mean rotation of the face about the axis `direction` through the origin [rad]
///   radial: mean change of the distance from the axis `direction` through the origin [m]
///   rotation: component along `direction` of the rotation vector (axis times angle, up to half a turn) of the rigid motion
///         that fits the face best [rad]
///   curvature: of the circle that fits the deformed face best, seen along `direction` [1/m]; see assembly/curvature.hpp
///   force: with which the body pushes on what holds the face or moves it, along `direction` [N]
///   moment: of those forces about the axis `direction` through the centroid of the undeformed face [N m]
/// Force and moment are those of the whole actuator (plane strain: of a depth of 1 m).
enum class Measure { displacement, bend, twist, radial, rotation, curvature, force, moment };

inline constexpr std::array all_measures{Measure::displacement, Measure::bend,      Measure::twist, Measure::radial,
                                         Measure::rotation,     Measure::curvature, Measure::force, Measure::moment};

/// A number of this kind in files (SI) and as people read it.
struct MeasureUnit {
    std::string_view SI;         ///< "m"
    std::string_view SI_suffix;  ///< of a name, "m" in elongation_m; "per_m" of 1/m
    std::string_view shown;      ///< "mm"
    std::string_view suffix;     ///< of a column, "mm" in elongation_mm
    double SI_per_shown;
    core::Dimension dimension;
};
[[nodiscard]] const MeasureUnit& unit_of(Measure measure);

/// "bend": the word of designs and files.
[[nodiscard]] std::string_view name_of(Measure measure);
/// One clause for help and lists: "mean displacement of a face along a direction".
[[nodiscard]] std::string_view meaning_of(Measure measure);

/// An angle, which goes on beyond half a turn along a path.
[[nodiscard]] bool is_angle(Measure measure);
/// A force or moment of what holds the face: it takes the loads besides the state.
[[nodiscard]] bool is_reaction(Measure measure);

}  // namespace soft::model
