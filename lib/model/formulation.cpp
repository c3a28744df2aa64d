#include "model/formulation.hpp"

namespace soft::model {

std::string explain_incompatibility(mesh::CellType type, material::Form form) {
    using material::Form;
    const auto& cell = mesh::topology(type);
    const std::string name(cell.name);
    const bool tensor = cell.shape == mesh::Shape::quadrilateral || cell.shape == mesh::Shape::hexahedron;
    if (cell.dimension < 2) return name + " is not a solid cell; use cells of the dimension of the model";
    if (form == Form::mixed && cell.order == 1)
        return "first-order cells (" + name +
               ") have no stable pressure space; use mesh.order 2 or another formulation";
    if (form == Form::f_bar && (cell.order != 1 || !tensor))
        return "F-bar is for first-order quadrilaterals and hexahedra, not " + name +
               (cell.order == 1 ? "; use mesh.order 2 with formulation mixed" : "; use formulation mixed");
    return {};
}

}  // namespace soft::model
