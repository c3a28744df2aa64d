#pragma once
/// Polygon soups as read from a file, in mm: boxes and balls, combined, and corrupted by the tests.
#include <cmath>
#include <numbers>

#include "meshing/body_surface.hpp"

namespace soft::meshing::test {

/// 12 facets with their normals outward.
inline FacetSoup box_soup(const mesh::Point& low, const mesh::Point& high) {
    FacetSoup soup;
    for (int n = 0; n < 8; ++n)
        soup.points.push_back(
            {(n & 1) != 0 ? high[0] : low[0], (n & 2) != 0 ? high[1] : low[1], (n & 4) != 0 ? high[2] : low[2]});
    soup.facets = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return soup;
}

/// Meridians and circles of latitude; smooth, without sharp edges.
inline FacetSoup ball_soup(const mesh::Point& centre, double radius, std::size_t around = 48) {
    FacetSoup soup;
    const std::size_t rows = around / 2;
    const auto at = [&](std::size_t row, std::size_t column) {
        const double polar = std::numbers::pi * static_cast<double>(row) / static_cast<double>(rows),
                     angle = 2 * std::numbers::pi * static_cast<double>(column) / static_cast<double>(around);
        return mesh::Point{centre[0] + radius * std::cos(polar), centre[1] + radius * std::sin(polar) * std::cos(angle),
                           centre[2] + radius * std::sin(polar) * std::sin(angle)};
    };
    soup.points = {at(0, 0), {centre[0] - radius, centre[1], centre[2]}};
    for (std::size_t row = 1; row < rows; ++row)
        for (std::size_t c = 0; c < around; ++c) soup.points.push_back(at(row, c));
    const auto number = [&](std::size_t row, std::size_t c) { return 2 + (row - 1) * around + c % around; };
    for (std::size_t c = 0; c < around; ++c) {
        soup.facets.push_back({0, number(1, c), number(1, c + 1)});
        soup.facets.push_back({1, number(rows - 1, c + 1), number(rows - 1, c)});
        for (std::size_t row = 1; row + 1 < rows; ++row) {
            soup.facets.push_back({number(row, c), number(row + 1, c), number(row + 1, c + 1)});
            soup.facets.push_back({number(row, c), number(row + 1, c + 1), number(row, c + 1)});
        }
    }
    return soup;
}

inline FacetSoup joined(FacetSoup a, const FacetSoup& b) {
    const std::size_t first = a.points.size();
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (std::vector<std::size_t> facet : b.facets) {
        for (std::size_t& node : facet) node += first;
        a.facets.push_back(facet);
    }
    return a;
}

/// Gives every facet its own corners, as in an STL file.
inline FacetSoup torn(const FacetSoup& soup) {
    FacetSoup result;
    for (const auto& facet : soup.facets) {
        std::vector<std::size_t>& own = result.facets.emplace_back();
        for (const std::size_t node : facet) {
            own.push_back(result.points.size());
            result.points.push_back(soup.points[node]);
        }
    }
    return result;
}

inline BodySurface made(const FacetSoup& soup) { return body_surface(soup, {"part.stl", "mm", 1e-3}); }

}  // namespace soft::meshing::test
