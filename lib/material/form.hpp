#pragma once
/// Material options of a design in addition to the law, shared with the typed case.

namespace soft::material {

/// Finite element formulation. displacement: no pressure unknown. mixed: displacement-pressure elements that satisfy the inf-sup
/// condition. f_bar: displacement, with the mean dilatation of each first-order quadrilateral or hexahedron (F-bar method).
enum class Form { displacement, mixed, f_bar };

/// Theta(J) of the volumetric energy K/2 Theta^2. quadratic: J - 1; log: ln J; mixed: Theta^2 = (J^2 - 1 - 2 ln J)/2.
enum class VolumetricLaw { quadratic, log, mixed };

/// The two directions that span the plane of the fibres: x and y, or x and the hoop direction about x.
enum class FiberFrame { cartesian, cylindrical };

}  // namespace soft::material
