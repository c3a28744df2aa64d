#include "design/formulation.hpp"

#include "design/materials.hpp"

namespace soft::design {

void check_formulation(const Values& values) {
    const auto has_value = [&](const char* path, std::string_view word) {
        return values.has(path) && values.text(path) == word;
    };
    constexpr const char* formulation = "mesh.formulation";
    const bool first_order = values.has("mesh.order") && values.text("mesh.order") == "1";
    const bool second_order = values.has("mesh.order") && values.text("mesh.order") == "2";
    if (has_value(formulation, "mixed") && first_order)
        throw values.refuse(values.given("mesh.order") ? "mesh.order" : formulation,
                            "first-order cells have no stable pair with a pressure (formulation: mixed)",
                            "order: 2, or formulation: f-bar for quadrilaterals and hexahedra");
    if (has_value(formulation, "f-bar")) {
        if (second_order)
            throw values.refuse(formulation, "f-bar is for first-order cells",
                                "add order: 1, or take formulation: mixed");
        if (has_value("mesh.cells", "simplices"))
            throw values.refuse(formulation,
                                "f-bar does nothing for triangles and tetrahedra: their change of volume is constant",
                                "cells: auto, or formulation: mixed with order: 2");
    }
    if (!values.has(formulation) || has_value(formulation, "mixed")) return;
    for (const std::string& section : material_sections(values))
        if (const std::string kappa = section + ".kappa"; has_value(kappa.c_str(), "incompressible"))
            throw values.refuse(formulation, values.text(formulation) + " needs a finite bulk modulus",
                                "formulation: mixed, or a value for " + kappa);
}

}  // namespace soft::design
