#pragma once
/// Closed forms of the laws in principal stretches along x, y, z, derived by hand from the energies. They are the reference for the
/// homogeneous states and for the quadratures of spheres and tubes, independent of lib/material. The constants are those of the verified
/// case.
#include <array>
#include <functional>

#include "model/case.hpp"

namespace soft::verification {

using Triple = std::array<double, 3>;  ///< along x, y, z (or axial, hoop, radial)

/// Extra stress l_i dW/dl_i [Pa] of the isochoric part of the energy, at stretches with product 1; for an incompressible rubber the Cauchy
/// stress up to a pressure. Throws std::logic_error for a law without such a form.
[[nodiscard]] std::function<Triple(const Triple&)> extra_stress_of(const model::Material& material);

/// Principal Cauchy stresses [Pa] of a rubber with a finite bulk modulus.
[[nodiscard]] std::function<Triple(const Triple&)> cauchy_of(const model::Material& material);

/// Condition along an axis of a homogeneous state: a Cauchy stress, or a stretch of 1.
struct Prescribed {
    double stress_Pa = 0;
    bool fixed = false;
};

/// Principal stretches in equilibrium with the stresses, with a free third axis; computed by Newton's method on the closed forms while the
/// stresses are ramped from 0.
[[nodiscard]] Triple stretches_at(const model::Material& material, const Prescribed& x, const Prescribed& y);

}  // namespace soft::verification
