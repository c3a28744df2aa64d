#pragma once
/// Drucker's stability of a rubber in its principal frame: the second work of the Kirchhoff stress tau (Cauchy times J) on
/// increments of the logarithmic stretches e is positive,
///   d tau : d e = sum_ab (d tau_a / d e_b) d e_a d e_b > 0,
/// on the homogeneous states of the uniaxial, equibiaxial and planar test, in tension and compression. Laws whose energy
/// splits off the change of volume are held to it on the isochoric increments sum d e_a = 0 at J = 1: exact for
/// incompressible, near it for nearly incompressible rubber. Laws with a coupled energy, and kraken (whose d tau / d e has
/// no symmetry: its symmetric part), are held to it in all three increments, on states free of lateral stress. Increments
/// that turn the principal axes are not looked at. Small strain is stable by construction, and fibres only add to the
/// stability of their matrix, which alone is looked at. Past its limit a rubber softens: a result there is not unique.
/// Sources: Drucker, J. Appl. Mech. 26 (1959) 101; Reinisch, ASCE 1st Conf. (1976), after which finite element codes check
/// rubber. Tested by material/stability_test (closed-form limits of Mooney-Rivlin and Saint Venant-Kirchhoff).
#include <string>
#include <vector>

#include "material/homogeneous.hpp"
#include "material/law.hpp"

namespace soft::material {

enum class Sense { tension, compression };

struct StabilityLimit {
    Mode mode = Mode::uniaxial;
    Sense sense = Sense::tension;
    double stretch = 1;  ///< first unstable stretch, coming from 1
};

/// The stretches along the pull that are looked at unless told otherwise. 5 is past what silicones reach before they tear,
/// also in two directions; 0.3 is past where a compressed block is usable.
inline constexpr StretchRange usual_range{0.3, 5.0};

/// First unstable stretch of each mode and sense within `range`; none for what is stable there. A mode ends without a limit
/// where the law has no state (a Gent rubber's locking stretch).
[[nodiscard]] std::vector<StabilityLimit> stability_limits(const AnyRubber& rubber,
                                                           const StretchRange& range = usual_range);

/// "unstable beyond a stretch of equibiaxial 1.83, planar 2.01 and below a stretch of uniaxial 0.707"; empty for no limits.
[[nodiscard]] std::string stability_text(const std::vector<StabilityLimit>& limits);

}  // namespace soft::material
