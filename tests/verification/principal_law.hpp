#pragma once
/// Closed forms of the laws in principal stretches along x, y, z, written out by hand from the energies: the reference of
/// the homogeneous states and, in spheres and tubes, of the quadratures. Nothing here comes from lib/material.
/// The constants are those of the case that is verified.
#include <array>
#include <functional>

#include "model/case.hpp"

namespace soft::verification {

using Triple = std::array<double, 3>;  ///< along x, y, z (or axial, hoop, radial)

/// l_i dW/dl_i [Pa] of the part of the energy that is written in isochoric stretches, at stretches of product 1; of an
/// incompressible rubber the Cauchy stress but for a pressure. Throws std::logic_error for a law that has no such form.
[[nodiscard]] std::function<Triple(const Triple&)> pulls_of(const model::Material& material);

/// Principal Cauchy stresses [Pa] of a rubber with a finite bulk modulus.
[[nodiscard]] std::function<Triple(const Triple&)> cauchy_of(const model::Material& material);

/// What a homogeneous state prescribes along an axis: a Cauchy stress, or a stretch of 1.
struct Prescribed {
    double stress_Pa = 0;
    bool held = false;
};

/// Principal stretches in equilibrium with the stresses, the third axis free; reached from 1 by a ramp of the stresses
/// and Newton's method on the closed forms.
[[nodiscard]] Triple stretches_at(const model::Material& material, const Prescribed& x, const Prescribed& y);

}  // namespace soft::verification
