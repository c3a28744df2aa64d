#pragma once
/// What a formulation asks of the cells of a finished mesh. Held by geometry/build_test.
#include <optional>
#include <string>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::geometry {

struct CellProblem {
    std::string problem;
    std::string remedy;
};

/// nullopt where the formulation can be used: mixed needs second-order cells (a stable pair of displacement and
/// pressure), f_bar first-order quadrilaterals or hexahedra only; displacement takes all.
[[nodiscard]] std::optional<CellProblem> problem_of(model::Formulation formulation, const mesh::Mesh& mesh);

}  // namespace soft::geometry
