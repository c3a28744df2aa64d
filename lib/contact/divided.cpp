#include "contact/divided.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/shape.hpp"

namespace soft::contact {
namespace {

using mesh::Point;

constexpr int coarse_parts = 4, medium_parts = 6;
constexpr int fine_parts_of_a_line = 64, fine_parts_of_a_side = 16;

void divide_line(int parts, Division& division) {
    for (int i = 0; i <= parts; ++i) division.xi.push_back({-1 + 2.0 * i / parts, 0});
    for (int i = 0; i < parts; ++i) division.pieces.push_back({i, i + 1, -1});
}

void divide_quadrilateral(int parts, Division& division) {
    for (int j = 0; j <= parts; ++j)
        for (int i = 0; i <= parts; ++i) division.xi.push_back({-1 + 2.0 * i / parts, -1 + 2.0 * j / parts});
    const auto at = [parts](int i, int j) { return j * (parts + 1) + i; };
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            division.pieces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            division.pieces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
}

void divide_triangle(int parts, Division& division) {
    const auto at = [parts](int i, int j) {
        return j * (parts + 1) - j * (j - 1) / 2 + i;
    };  // row j has parts + 1 - j points
    for (int j = 0; j <= parts; ++j)
        for (int i = 0; i + j <= parts; ++i)
            division.xi.push_back({static_cast<double>(i) / parts, static_cast<double>(j) / parts});
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i + j < parts; ++i) {
            division.pieces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (i + j + 1 < parts) division.pieces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
}

}  // namespace

Division divide(mesh::CellType facet, Fineness fineness) {
    const mesh::CellTopology& cell = mesh::topology(facet);
    const bool straight = cell.order == 1 && cell.shape != mesh::Shape::quadrilateral;
    const int fine = cell.dimension == 1 ? fine_parts_of_a_line : fine_parts_of_a_side;
    const int parts = straight                       ? 1
                      : fineness == Fineness::coarse ? coarse_parts
                      : fineness == Fineness::medium ? medium_parts
                                                     : fine;
    Division division;
    division.corners = cell.dimension == 1 ? 2 : 3;
    if (cell.shape == mesh::Shape::line) divide_line(parts, division);
    if (cell.shape == mesh::Shape::triangle) divide_triangle(parts, division);
    if (cell.shape == mesh::Shape::quadrilateral) divide_quadrilateral(parts, division);
    for (const surface::FacetPoint& xi : division.xi)
        for (const mesh::ShapeValue& shape : mesh::shape_values(facet, {xi[0], xi[1], 0}))
            division.N.push_back(shape.value);
    return division;
}

DividedFacets::DividedFacets(const mesh::Mesh& mesh, std::span<const mesh::Facet> facets, Fineness fineness) {
    std::size_t points = 0;
    for (const mesh::Facet& facet : facets) {
        const mesh::CellType type = mesh::facet_type(mesh, facet);
        const auto found = divisions_.find(type);
        const Division& division =
            found != divisions_.end() ? found->second : divisions_.emplace(type, divide(type, fineness)).first->second;
        Entry entry{facet, type, {}, &division, points};
        const std::vector<mesh::Index> nodes = mesh::facet_nodes(mesh, facet);
        std::copy(nodes.begin(), nodes.end(), entry.nodes.begin());
        facets_.push_back(entry);
        points += division.xi.size();
    }
}

DividedShape DividedFacets::shape(std::span<const Point> positions) const {
    DividedShape result;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const auto own = nodes(f);
        const double* N = facets_[f].division->N.data();
        for (std::size_t p = 0; p < facets_[f].division->xi.size(); ++p, N += own.size()) {
            Point x{};
            for (std::size_t a = 0; a < own.size(); ++a)
                for (std::size_t d = 0; d < 3; ++d) x[d] += N[a] * positions[static_cast<std::size_t>(own[a])][d];
            result.points.push_back(x);
        }
    }
    for (std::size_t f = 0; f < facets_.size(); ++f) result.boxes.push_back(box_of(points(result, f)));
    return result;
}

std::array<Point, 3> piece_corners(std::span<const Point> points, const std::array<int, 3>& piece) {
    const auto at = [&](int i) { return i < 0 ? Point{} : points[static_cast<std::size_t>(i)]; };
    return {at(piece[0]), at(piece[1]), at(piece[2])};
}

surface::Box box_of(std::span<const Point> points) {
    surface::Box box{points[0], points[0]};
    for (const Point& p : points)
        for (std::size_t d = 0; d < 3; ++d) {
            box.low[d] = std::min(box.low[d], p[d]);
            box.high[d] = std::max(box.high[d], p[d]);
        }
    return box;
}

}  // namespace soft::contact
