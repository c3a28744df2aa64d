#pragma once
/// A bar of 40 x 20 x 20 mm in uniaxial tension: step k has the stretch 1 + k/4 along x and its inverse square root across.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../mesh/blocks.hpp"
#include "io/result_file.hpp"

namespace soft::view::test {

inline double stretch_of(int step) { return 1 + 0.25 * step; }

inline model::Case bar_case() {
    model::Case model;
    model.name = "bar";
    model.formulation = model::Formulation::displacement;
    model.mesh = mesh::sample::row_of(mesh::CellType::hex8, 2);
    for (mesh::Point& point : model.mesh.points) point = {0.01 * (point[0] + 1), 0.01 * point[1], 0.01 * point[2]};
    for (const mesh::Facet& facet : mesh::boundary_facets(model.mesh)) {
        const auto nodes = mesh::facet_nodes(model.mesh, facet);
        const auto all_at = [&](double x) {
            return std::all_of(nodes.begin(), nodes.end(),
                               [&](mesh::Index n) { return std::abs(model.mesh.point(n)[0] - x) < 1e-9; });
        };
        if (all_at(0)) model.mesh.facet_sets["fixed"].push_back(facet);
        if (all_at(0.04)) model.mesh.facet_sets["end"].push_back(facet);
    }
    model.materials = {{"rubber", "neo-hookean", {{"mu", {1e5}}}, 1e7}};
    model.supports = {{"fixed", {true, false, false}}};
    model.loads = {{"end", {"end"}, true, {}}};
    model.outputs = {{"elongation", "end", {1, 0, 0}}};
    model.path.stages.emplace_back().supplies = {{model::Prescription::pressure, -2.5e4}};
    return model;
}

inline std::vector<double> bar_displacement(const model::Case& model, int step) {
    const double along = stretch_of(step), across = 1 / std::sqrt(along);
    std::vector<double> values;
    for (const mesh::Point& point : model.mesh.points)
        for (const double value : {(along - 1) * point[0], (across - 1) * point[1], (across - 1) * point[2]})
            values.push_back(value);
    return values;
}

/// `trap` is inserted wherever a result contains text of the user.
inline io::Result bar_result(int steps, const std::string& trap = "a name",
                             io::FieldsPolicy::Keep keep = io::FieldsPolicy::Keep::all) {
    const model::Case model = bar_case();
    const io::Provenance meshed{"mesh-gen", "0.1.0", "0123abc", {"gmsh 4.8.4"}, "mesh-gen " + trap};
    const io::Provenance solved{"solve", "0.1.0", "0123abc", {"PETSc 3.18"}, "solve " + trap};
    const model::Shape shape{model.kinematics, 1, {}, {1, 0, 0}, model.supports, {}, {}, {}, {}};
    const auto image = io::write_case(model.mesh, shape, {"family: tube # " + trap + "\n", {"x=" + trap}}, meshed);
    io::ResultWriter writer({image, "case.h5", model}, solved, {{keep, 1}, {}});
    for (int i = 0; i < steps; ++i) {
        model::Step step;
        step.load_factor = 0.1 * i;
        step.pressure_Pa = -1000.0 * i;
        step.outputs = {0.04 * (stretch_of(i) - 1)};
        step.tangent_outputs = {0};
        step.stretch_p99 = step.max_stretch = stretch_of(i);
        writer.append(step, bar_displacement(model, i), {});
    }
    model::PathEnd end;
    end.detail = trap;
    return io::read_result(writer.finish(end), "bar.h5",
                           [&](mesh::Mesh, const model::Shape&, std::string_view, std::string_view) { return model; });
}

}  // namespace soft::view::test
