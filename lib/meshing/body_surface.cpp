#include "meshing/body_surface.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "core/error.hpp"
#include "core/files.hpp"
#include "meshing/shells.hpp"
#include "surface/facet_map.hpp"

namespace soft::meshing {
namespace {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

constexpr double max_coordinate = 1e30;  // keeps products of several coordinates finite

std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

bool read(std::istream& stream, const std::string& ending, std::vector<CgalPoint>& points,
          std::vector<std::vector<std::size_t>>& facets) {
    if (ending == ".obj") return CGAL::IO::read_OBJ(stream, points, facets);
    return CGAL::IO::read_STL(stream, points, facets);
}

mesh::Point corner(const BodySurface& surface, std::size_t t, std::size_t k) {
    return surface.points[static_cast<std::size_t>(surface.triangles[t][k])];
}

/// Merges points that coincide to rounding: a file of floats has seven significant digits.
std::size_t merge_points(FacetSoup& soup) {
    constexpr double same = 1e-7;
    mesh::Point low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-low[0]);
    for (const mesh::Point& p : soup.points)
        for (std::size_t d = 0; d < 3; ++d) {
            low[d] = std::min(low[d], p[d]);
            high[d] = std::max(high[d], p[d]);
        }
    const double tolerance = same * std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    using Cell = std::tuple<long long, long long, long long>;
    std::map<Cell, std::vector<std::size_t>> cells;
    std::vector<mesh::Point> kept;
    std::vector<std::size_t> numbers;
    const auto cell_of = [&](double x, std::size_t d) {
        return tolerance > 0 ? std::llround((x - low[d]) / tolerance) : 0;
    };
    const auto find = [&](const mesh::Point& p, const Cell& at) {
        const auto [i, j, k] = at;
        for (long long a = -1; a <= 1; ++a)
            for (long long b = -1; b <= 1; ++b)
                for (long long c = -1; c <= 1; ++c)
                    if (const auto found = cells.find({i + a, j + b, k + c}); found != cells.end())
                        for (const std::size_t other : found->second)
                            if (std::hypot(kept[other][0] - p[0], kept[other][1] - p[1], kept[other][2] - p[2]) <=
                                tolerance)
                                return other;
        return kept.size();
    };
    for (const mesh::Point& p : soup.points) {
        const Cell at{cell_of(p[0], 0), cell_of(p[1], 1), cell_of(p[2], 2)};
        numbers.push_back(find(p, at));
        if (numbers.back() != kept.size()) continue;
        cells[at].push_back(kept.size());
        kept.push_back(p);
    }
    const std::size_t merged = soup.points.size() - kept.size();
    soup.points = std::move(kept);
    for (auto& facet : soup.facets)
        for (std::size_t& node : facet) node = numbers[node];
    return merged;
}

/// Splits polygons into triangles about their first corner; removes triangles with fewer than three different corners and duplicates.
std::size_t drop_degenerate_facets(FacetSoup& soup) {
    std::vector<std::vector<std::size_t>> kept;
    std::set<std::array<std::size_t, 3>> seen;
    std::size_t dropped = 0;
    for (const auto& facet : soup.facets)
        for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
            const std::array<std::size_t, 3> t{facet[0], facet[k], facet[k + 1]};
            std::array<std::size_t, 3> key = t;
            std::ranges::sort(key);
            if (key[0] == key[1] || key[1] == key[2] || !seen.insert(key).second)
                ++dropped;
            else
                kept.push_back({t[0], t[1], t[2]});
        }
    soup.facets = std::move(kept);
    return dropped;
}

/// OBJ may list more points than its facets use; CGAL assumes that each point is the corner of a facet.
void drop_unused_points(FacetSoup& soup) {
    std::vector<bool> used(soup.points.size());
    for (const auto& facet : soup.facets)
        for (const std::size_t node : facet) used[node] = true;
    std::vector<std::size_t> numbers(soup.points.size());
    std::vector<mesh::Point> kept;
    for (std::size_t n = 0; n < used.size(); ++n) {
        numbers[n] = kept.size();
        if (used[n]) kept.push_back(soup.points[n]);
    }
    for (auto& facet : soup.facets)
        for (std::size_t& node : facet) node = numbers[node];
    soup.points = std::move(kept);
}

}  // namespace

std::string counted(std::size_t count, const std::string& one, const std::string& several) {
    return std::to_string(count) + " " + (count == 1 ? one : several);
}

TriangleGeometry triangle_geometry(const std::vector<mesh::Point>& points, const std::array<int, 3>& t) {
    const auto at = [&](std::size_t k) -> const mesh::Point& { return points[static_cast<std::size_t>(t[k])]; };
    TriangleGeometry result;
    const Vector3 twice_area = cross(along(at(1), -1, at(0)), along(at(2), -1, at(0)));
    const double length = norm(twice_area);
    result.area = length / 2;
    for (std::size_t d = 0; d < 3; ++d) {
        result.normal[d] = length > 0 ? twice_area[d] / length : 0;
        result.centre[d] = (at(0)[d] + at(1)[d] + at(2)[d]) / 3;
    }
    return result;
}

double BodySurface::volume_m3() const {
    double sum = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        sum += dot(corner(*this, t, 0), cross(corner(*this, t, 1), corner(*this, t, 2))) / 6;
    return sum;
}

double BodySurface::area_m2() const {
    double sum = 0;
    for (const auto& t : triangles) sum += triangle_geometry(points, t).area;
    return sum;
}

double BodySurface::extent_m() const {
    double longest = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        const auto [low, high] = std::ranges::minmax(points, {}, [d](const mesh::Point& p) { return p[d]; });
        longest = std::max(longest, high[d] - low[d]);
    }
    return longest;
}

bool is_surface_file(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".stl" || ending == ".obj";
}

FacetSoup read_soup(const std::filesystem::path& path) {
    const core::Bytes bytes = core::read_regular_file(path, max_file);
    return read_soup(std::string{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

FacetSoup read_soup(std::string content, const std::filesystem::path& path) {
    std::istringstream stream(std::move(content));
    std::vector<CgalPoint> points;
    FacetSoup soup;
    const bool whole = read(stream, ending_of(path), points, soup.facets);
    if (!whole || soup.facets.empty())
        throw Error(ExitCode::bad_input, path.string(),
                    whole ? "the file contains no facets" : "the file cannot be read as " + ending_of(path).substr(1),
                    "export the part again as STL or OBJ");
    for (const CgalPoint& p : points) soup.points.push_back({p.x(), p.y(), p.z()});
    for (const mesh::Point& p : soup.points)
        for (const double component : p)
            if (!(std::abs(component) <= max_coordinate))
                throw Error(ExitCode::bad_input, path.string(),
                            std::isfinite(component) ? "a coordinate is out of range" : "a coordinate is not a number",
                            "export the part again");
    for (const auto& facet : soup.facets)
        for (const std::size_t node : facet)
            if (node >= soup.points.size())
                throw Error(ExitCode::bad_input, path.string(), "a facet refers to a point that is not in the file",
                            "export the part again");
    return soup;
}

BodySurface body_surface(FacetSoup soup, const SoupOrigin& origin) {
    std::vector<std::string> repairs;
    if (const std::size_t merged = merge_points(soup); merged > 0)
        repairs.push_back(counted(merged, "duplicate point", "duplicate points") + " merged");
    if (const std::size_t dropped = drop_degenerate_facets(soup); dropped > 0)
        repairs.push_back(counted(dropped, "degenerate or duplicate facet", "degenerate or duplicate facets") +
                          " removed");
    drop_unused_points(soup);
    BodySurface surface = closed_shells(soup, origin);
    surface.repairs.insert(surface.repairs.begin(), repairs.begin(), repairs.end());
    return surface;
}

}  // namespace soft::meshing
