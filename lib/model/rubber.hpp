#pragma once
/// Creates the constitutive law from a case's material (law name and constants).
/// Tested by fem/system_test, design/material_test.
#include "material/catalogue.hpp"
#include "model/case.hpp"

namespace soft::model {

/// Throws Error (bad_input) as material::make_rubber does, with the constant's name as location, and with the location "strain"
/// for a law without a linear form.
[[nodiscard]] material::AnyRubber make_rubber(const Material& material);

/// Young's modulus of each region of the mesh without strain, for the stiffness of the contact.
[[nodiscard]] std::vector<double> young_moduli_Pa(const Case& model);

/// Reason why a case with these kinematics and symmetry planes cannot represent the material ("problem; remedy"); empty if it can.
/// A single family of inclined fibres twists a tube: an axisymmetric section has no twist, and the fibres have no mirror symmetry.
[[nodiscard]] std::string explain_incompatibility(const Material& material, Kinematics kinematics,
                                                  const std::array<bool, 3>& symmetry_planes);

}  // namespace soft::model
