#include "view/patch.hpp"

#include "mesh/shape.hpp"

namespace soft::view {

namespace {

void add_point(Patch& patch, mesh::CellType type, const std::array<double, 3>& xi) {
    for (const mesh::ShapeValue& shape : mesh::shape_values(type, xi)) patch.N.push_back(shape.value);
}

/// Reference coordinate of point i of n + 1 equidistant points in [-1, 1].
double coordinate(int i, int n) { return -1.0 + 2.0 * i / n; }

void divide_line(Patch& patch, mesh::CellType type, int n) {
    for (int i = 0; i <= n; ++i) add_point(patch, type, {coordinate(i, n), 0, 0});
    for (int i = 0; i < n; ++i) patch.pieces.push_back({i, i + 1, i + 1, i + 1});
}

void divide_quadrilateral(Patch& patch, mesh::CellType type, int n) {
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) add_point(patch, type, {coordinate(i, n), coordinate(j, n), 0});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            patch.pieces.push_back({a, a + 1, a + n + 2, a + n + 1});
        }
}

void divide_triangle(Patch& patch, mesh::CellType type, int n) {
    const auto at = [n](int i, int j) { return j * (n + 1) - j * (j - 1) / 2 + i; };
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n - j; ++i)
            add_point(patch, type, {static_cast<double>(i) / n, static_cast<double>(j) / n, 0});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n - j; ++i) {
            patch.pieces.push_back({at(i, j), at(i + 1, j), at(i, j + 1), at(i, j + 1)});
            if (i + j < n - 1) patch.pieces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), at(i, j + 1)});
        }
}

}  // namespace

Patch make_patch(mesh::CellType type, int segments) {
    const auto& cell = mesh::topology(type);
    const int n = cell.order == 1 ? 1 : segments;
    Patch patch;
    patch.nodes = cell.node_count;
    switch (cell.shape) {
        case mesh::Shape::line: divide_line(patch, type, n); break;
        case mesh::Shape::triangle: divide_triangle(patch, type, n); break;
        case mesh::Shape::quadrilateral: divide_quadrilateral(patch, type, n); break;
        case mesh::Shape::tetrahedron:
        case mesh::Shape::hexahedron:
        case mesh::Shape::wedge: break;  // not facets
    }
    return patch;
}

}  // namespace soft::view
