#pragma once
/// Drucker stability of a rubber in its principal frame: the second-order work of the Kirchhoff stress tau (Cauchy times J) on
/// increments of the logarithmic stretches e is positive,
///   d tau : d e = sum_ab (d tau_a / d e_b) d e_a d e_b > 0,
/// at the homogeneous states of the uniaxial, equibiaxial and planar test, in tension and compression.
///   - Laws with a separate volumetric energy: checked for isochoric increments, sum d e_a = 0, at J = 1. This is exact for
///     incompressible rubber and approximate for nearly incompressible rubber.
///   - Laws with a coupled energy, and kraken (with the symmetric part of d tau / d e): checked for all increments, at states without
///     lateral stress.
///   - Increments that rotate the principal axes are not checked. Small strain is stable by construction. Fibres increase the
///     stability, so only the matrix is checked.
/// Beyond the stability limit a rubber softens, and solutions are not unique.
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
    double stretch = 1;  ///< first unstable stretch, starting from 1
};

/// Default range of stretches that are checked. Silicones tear below a stretch of 5, also in biaxial tension, and compressed blocks
/// are not used below a stretch of 0.3.
inline constexpr StretchRange default_stretch_range{0.3, 5.0};

/// First unstable stretch of each mode and sense within `range`; no entry if the rubber is stable there. A search ends without a limit
/// where the law is undefined (e.g. at the locking stretch of a Gent rubber).
[[nodiscard]] std::vector<StabilityLimit> stability_limits(const AnyRubber& rubber,
                                                           const StretchRange& range = default_stretch_range);

/// "unstable beyond a stretch of equibiaxial 1.83, planar 2.01 and below a stretch of uniaxial 0.707"; empty if there are no limits.
[[nodiscard]] std::string stability_text(const std::vector<StabilityLimit>& limits);

}  // namespace soft::material
