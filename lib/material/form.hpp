#pragma once
/// The choices a design makes beside the law: plain words, shared with the typed case.

namespace soft::material {

/// How elements run a law. displacement: no pressure unknown. mixed: pressure unknown in a stable pair. f_bar:
/// displacement with the mean dilatation of each first-order quadrilateral or hexahedron in place of its own.
enum class Form { displacement, mixed, f_bar };

/// Theta(J) of the volumetric energy K/2 Theta^2: J - 1; ln J; Theta^2 = (J^2 - 1 - 2 ln J)/2.
enum class VolumetricLaw { quadratic, log, mixed };

/// The two directions in whose surface fibres lie: x and y, or x and the hoop direction about x.
enum class FiberFrame { cartesian, cylindrical };

}  // namespace soft::material
