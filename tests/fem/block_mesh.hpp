#pragma once
/// A block of n x n (x n) squares (cubes), each one cell or split into simplices or wedges, placed by a map. Vertices inside
/// are moved by up to `shake` of the cell size, so that no two cells are equal; edges stay straight.
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "mesh/shape.hpp"
#include "model/case.hpp"
#include "sample_cases.hpp"

namespace soft {

struct BlockShape {
    int n = 2;
    double shake = 0;
};

namespace detail {

using Corner = std::array<int, 3>;

/// Vertices, in the unit cube, of the cells of a type that fill it.
inline std::vector<std::vector<Corner>> cells_of_a_cube(mesh::CellType type) {
    using mesh::Shape;
    const std::vector<Corner> lower{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, upper{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<Corner> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto prism = [](std::vector<Corner> base) {
        const std::size_t n = base.size();
        for (std::size_t v = 0; v < n; ++v) base.push_back({base[v][0], base[v][1], 1});
        return base;
    };
    switch (mesh::topology(type).shape) {
        case Shape::quadrilateral: return {square};
        case Shape::triangle: return {lower, upper};
        case Shape::hexahedron: return {prism(square)};
        case Shape::wedge: return {prism(lower), prism(upper)};
        case Shape::tetrahedron: {  // Kuhn: one for each order in which the axes are walked from (0,0,0) to (1,1,1)
            std::vector<std::vector<Corner>> list;
            for (int first = 0; first < 3; ++first)
                for (const int turn : {1, 2}) {
                    Corner one{}, two{};
                    one[first] = two[first] = two[(first + turn) % 3] = 1;
                    if (turn == 1)
                        list.push_back({{0, 0, 0}, one, two, {1, 1, 1}});
                    else
                        list.push_back({{0, 0, 0}, one, {1, 1, 1}, two});
                }
            return list;
        }
        case Shape::line: break;
    }
    return {};
}

/// Position of the vertex (i, j, k) of the block in the unit cube.
inline std::array<double, 3> block_vertex(const Corner& v, int dimension, const BlockShape& shape) {
    std::array<double, 3> s{};
    bool inside = true;
    for (int i = 0; i < dimension; ++i) {
        s[i] = static_cast<double>(v[i]) / shape.n;
        inside = inside && v[i] > 0 && v[i] < shape.n;
    }
    if (inside)
        for (int i = 0; i < dimension; ++i)
            s[i] += shape.shake / shape.n * std::sin(1.3 + 12.9 * v[0] + 78.2 * v[1] + 37.7 * v[2] + 2.1 * i);
    return s;
}

}  // namespace detail

/// `type_of(i, j, k)` gives the cell type of a cube, `position_of(s)` the position [m] of a point s of the unit cube.
template <class TypeOf, class PositionOf>
mesh::Mesh block_mesh(int dimension, const BlockShape& shape, TypeOf&& type_of, PositionOf&& position_of) {
    using detail::Corner;
    mesh::Mesh mesh;
    mesh.dimension = dimension;
    mesh.region_names = {"rubber"};
    std::map<Corner, mesh::Index> numbers;  // by twice the logical position: mid-nodes are whole numbers too
    for (int k = 0; k < (dimension == 3 ? shape.n : 1); ++k)
        for (int j = 0; j < shape.n; ++j)
            for (int i = 0; i < shape.n; ++i) {
                const mesh::CellType type = type_of(i, j, k);
                for (const auto& corners : detail::cells_of_a_cube(type)) {
                    std::vector<mesh::Index> nodes;
                    for (const auto& xi : mesh::topology(type).nodes) {
                        const auto share = mesh::vertex_values(type, xi);
                        std::array<double, 3> twice{}, s{};
                        for (std::size_t v = 0; v < corners.size(); ++v) {
                            const Corner vertex{i + corners[v][0], j + corners[v][1], k + corners[v][2]};
                            const auto at = detail::block_vertex(vertex, dimension, shape);
                            for (int d = 0; d < 3; ++d) {
                                twice[d] += 2.0 * share[v] * vertex[d];
                                s[d] += share[v] * at[d];
                            }
                        }
                        const Corner key{static_cast<int>(std::lround(twice[0])),
                                         static_cast<int>(std::lround(twice[1])),
                                         static_cast<int>(std::lround(twice[2]))};
                        const auto [entry, fresh] =
                            numbers.try_emplace(key, static_cast<mesh::Index>(mesh.points.size()));
                        if (fresh) mesh.points.push_back(position_of(s));
                        nodes.push_back(entry->second);
                    }
                    mesh::add_cell(mesh, type, nodes, 0);
                }
            }
    mesh.facet_sets["boundary"] = mesh::boundary_facets(mesh);
    return mesh;
}

/// The block as a case: unit square, cube, or the ring section 0 < x < 1, 1 < r < 2 [m]; no supports, no loads.
inline model::Case block_case(mesh::CellType type, model::Kinematics kinematics, model::Formulation formulation,
                              const BlockShape& shape) {
    model::Case input;
    input.kinematics = kinematics;
    input.formulation = formulation;
    const double lowest = kinematics == model::Kinematics::axisymmetric ? 1.0 : 0.0;
    input.mesh = block_mesh(
        mesh::dimension(type), shape, [&](int, int, int) { return type; },
        [&](const std::array<double, 3>& s) {
            return mesh::Point{s[0], s[1] + lowest, s[2]};
        });
    input.materials = {sample_material(false)};
    return input;
}

}  // namespace soft
