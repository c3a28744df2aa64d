#pragma once
/// Mass matrix of a cell's pressure functions in the reference configuration, in the scale of the pressure unknowns:
///   M_st = integral of phi_s phi_t dV  [Pa^2 m^3 with phi = scale x basis; includes 2 pi R]
/// The Schur complement of an incompressible solid with shear modulus mu is spectrally equivalent to M / mu (Boffi, Brezzi, Fortin, Mixed
/// Finite Element Methods (2013) 8.5). Tested by fem/pressure_mass_test.
#include "fem/cell_kinematics.hpp"

namespace soft::fem {

/// `X`: nodal coordinates, component by component [m]. Returns [pressure x pressure]; empty without a pressure unknown.
[[nodiscard]] std::vector<double> pressure_mass(const ReferenceCell& cell, model::Kinematics kinematics,
                                                std::span<const double> X, double pressure_scale_Pa);

}  // namespace soft::fem
