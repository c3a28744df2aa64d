#pragma once
/// Small cases built by hand, so that the solver modules are tested without the geometry module.
#include <array>
#include <cmath>
#include <numbers>

#include "model/case.hpp"

namespace soft {

inline constexpr double sample_mu_Pa = 0.1644e6;

inline model::Material sample_material(bool incompressible) {
    model::Material material;
    material.name = "rubber";
    material.law = "neo-hookean";
    material.constants["mu"] = {sample_mu_Pa};
    if (!incompressible) material.bulk_modulus_Pa = 100 * sample_mu_Pa;
    return material;
}

/// Adds every outer facet to the set that `name_of` returns for the mean of its vertices.
template <class Name>
void name_boundary(mesh::Mesh& mesh, Name&& name_of) {
    for (const auto& facet : mesh::boundary_facets(mesh)) {
        const auto nodes = mesh::facet_nodes(mesh, facet);
        mesh::Point middle{};
        for (int v = 0; v < mesh::topology(mesh::facet_type(mesh, facet)).vertex_count; ++v)
            for (int i = 0; i < 3; ++i) middle[i] += mesh.point(nodes[v])[i];
        for (double& m : middle) m /= mesh::topology(mesh::facet_type(mesh, facet)).vertex_count;
        mesh.facet_sets[name_of(middle)].push_back(facet);
    }
}

/// One stage that brings the pressures to these values and everything else to level 1.
inline model::Stage full_load(const model::Case& input, const std::vector<double>& pressures_Pa) {
    model::Stage stage;
    for (const double pressure : pressures_Pa) stage.supplies.push_back({model::Prescription::pressure, pressure});
    stage.dead_loads.assign(input.dead_loads.size(), 1.0);
    stage.motions.assign(input.motions.size(), 1.0);
    return stage;
}

/// Thick sphere, inner radius 10 mm, outer 20 mm, as the quarter section x >= 0, r >= 0: `layers` quad9 through the
/// wall, `sectors` along the quarter circle. Loaded by a cavity pressure of mu at load factor 1.
inline model::Case sphere_case(int layers, int sectors) {
    constexpr double A = 0.01, B = 0.02;
    model::Case input;
    input.kinematics = model::Kinematics::axisymmetric;
    input.model_fraction = 0.5;
    input.symmetry_planes = {true, false, false};
    auto& mesh = input.mesh;
    mesh.dimension = 2;
    mesh.region_names = {"rubber"};
    const int columns = 2 * layers + 1;
    for (int j = 0; j <= 2 * sectors; ++j)
        for (int i = 0; i < columns; ++i) {
            const double radius = A + (B - A) * i / (2 * layers), angle = 0.5 * std::numbers::pi * j / (2 * sectors);
            mesh.points.push_back(
                {j == 0 ? 0.0 : radius * std::sin(angle), j == 2 * sectors ? 0.0 : radius * std::cos(angle), 0.0});
        }
    for (int j = 0; j < 2 * sectors; j += 2)
        for (int i = 0; i < 2 * layers; i += 2) {
            const auto id = [&](int di, int dj) { return static_cast<mesh::Index>(j + dj) * columns + i + di; };
            mesh::add_cell(
                mesh, mesh::CellType::quad9,
                std::array{id(0, 0), id(0, 2), id(2, 2), id(2, 0), id(0, 1), id(1, 2), id(2, 1), id(1, 0), id(1, 1)},
                0);
        }
    // Angle grows from the r axis to the x axis, clockwise in (x, r): (angle, radius) is a positively oriented frame.
    name_boundary(mesh, [&](const mesh::Point& p) {
        if (p[1] < 1e-9) return "axis";
        if (p[0] < 1e-9) return "symmetry_x";
        return std::hypot(p[0], p[1]) < 0.5 * (A + B) ? "cavity" : "outer";
    });
    input.supports = {{"axis", {false, true, false}}, {"symmetry_x", {true, false, false}}};
    input.cavities = {{"cavity", "cavity", {}, {}}};
    input.materials = {sample_material(true)};
    input.loads = {{.name = "cavity", .targets = {"cavity"}, .gas = {}}};
    input.path.stages = {full_load(input, {sample_mu_Pa})};
    return input;
}

/// Two such spheres, separate bodies (no common node, although at the same position), with a common gas: a
/// volume of `ratio` times both cavities at load factor 1. Cavities "left" and "right".
inline model::Case two_spheres_case(int layers, int sectors, double ratio) {
    model::Case input = sphere_case(layers, sectors);
    auto& mesh = input.mesh;
    const auto points = mesh.points;
    const auto first = static_cast<mesh::Index>(points.size()), cells = mesh.cell_count();
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
    for (mesh::Index cell = 0; cell < cells; ++cell) {
        std::vector<mesh::Index> nodes(mesh.cell_nodes(cell).begin(), mesh.cell_nodes(cell).end());
        for (auto& node : nodes) node += first;
        mesh::add_cell(mesh, mesh.cell_type(cell), nodes, 0);
    }
    for (auto& [name, facets] : mesh.facet_sets) {
        if (name == "cavity") continue;
        const auto one = facets;
        for (auto facet : one) {
            facet.cell += cells;
            facets.push_back(facet);
        }
    }
    auto& right = mesh.facet_sets["right"];
    for (auto facet : mesh.facet_sets.at("cavity")) {
        facet.cell += cells;
        right.push_back(facet);
    }
    mesh.facet_sets["left"] = mesh.facet_sets.at("cavity");
    input.path.contact = model::Contact::ignore;
    input.cavities = {{"left", "left", {}, {}}, {"right", "right", {}, {}}};
    input.loads = {{.name = "left", .targets = {"left", "right"}, .gas = {}}};
    input.path.stages[0].supplies = {{model::Prescription::volume_ratio, ratio}};
    return input;
}

/// Box of n x n x n hex27 cells, edge 10 mm, fixed at x = 0, symmetry at y = 0 and z = 0, pressure on x = 10 mm ("end").
inline model::Case box_case(int n, bool incompressible) {
    constexpr double edge = 0.01;
    model::Case input;
    input.kinematics = model::Kinematics::solid;
    auto& mesh = input.mesh;
    mesh.dimension = 3;
    mesh.region_names = {"rubber"};
    const int m = 2 * n + 1;
    for (int k = 0; k < m; ++k)
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i)
                mesh.points.push_back({edge * i / (m - 1), edge * j / (m - 1), edge * k / (m - 1)});
    const auto& nodes = mesh::topology(mesh::CellType::hex27).nodes;
    for (int k = 0; k < 2 * n; k += 2)
        for (int j = 0; j < 2 * n; j += 2)
            for (int i = 0; i < 2 * n; i += 2) {
                std::array<mesh::Index, 27> cell{};
                for (int a = 0; a < 27; ++a)
                    cell[a] =
                        ((k + 1 + static_cast<int>(nodes[a][2])) * m + j + 1 + static_cast<int>(nodes[a][1])) * m + i +
                        1 + static_cast<int>(nodes[a][0]);
                mesh::add_cell(mesh, mesh::CellType::hex27, cell, 0);
            }
    name_boundary(mesh, [&](const mesh::Point& p) {
        if (p[0] < 1e-9) return "fixed";
        if (p[0] > edge - 1e-9) return "end";
        if (p[1] < 1e-9) return "left";
        if (p[2] < 1e-9) return "bottom";
        return p[1] > edge - 1e-9 ? "right" : "top";
    });
    input.supports = {
        {"fixed", {true, false, false}}, {"left", {false, true, false}}, {"bottom", {false, false, true}}};
    input.materials = {sample_material(incompressible)};
    input.loads = {{.name = "end", .targets = {"end"}, .gas = {}}};
    input.outputs = {{"elongation", "end", {1, 0, 0}}};
    input.path.stages = {full_load(input, {-sample_mu_Pa})};
    input.path.stages[0].control = model::Control::pressure;
    return input;
}

}  // namespace soft
