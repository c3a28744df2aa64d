#include "geometry/cell_check.hpp"

#include <algorithm>

namespace soft::geometry {

std::optional<CellProblem> problem_of(model::Formulation formulation, const mesh::Mesh& mesh) {
    const auto fits = [&](mesh::CellType type) {
        switch (formulation) {
            case model::Formulation::displacement: return true;
            case model::Formulation::mixed: return mesh::topology(type).order == 2;
            case model::Formulation::f_bar: return type == mesh::CellType::quad4 || type == mesh::CellType::hex8;
        }
        return false;
    };
    const auto misfit = std::find_if_not(mesh.cell_types.begin(), mesh.cell_types.end(), fits);
    if (misfit == mesh.cell_types.end()) return std::nullopt;
    const std::string name{mesh::topology(*misfit).name};
    if (formulation == model::Formulation::mixed)
        return CellProblem{"the mesh has " + name + " cells, which have no stable pair with a pressure",
                           "mixed needs second-order cells; f-bar suits first-order quadrilaterals and hexahedra"};
    return CellProblem{"the mesh has " + name + " cells, and f-bar is for first-order quadrilaterals and hexahedra alone",
                       "a section (axisymmetric, plane-strain), or formulation: mixed with order: 2"};
}

}  // namespace soft::geometry
