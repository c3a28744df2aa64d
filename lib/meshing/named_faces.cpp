#include "meshing/named_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "surface/facet_map.hpp"
#include "surface/near.hpp"

namespace soft::meshing {
namespace {

using Edge = std::array<int, 2>;

Vector3 unit_normal(const BodySurface& surface, std::size_t t) {
    return triangle_geometry(surface.points, surface.triangles[t]).normal;
}

bool is_sharp(const BodySurface& surface, const std::array<std::size_t, 2>& sides) {
    static const double min_cosine = std::cos(sharp_rad);
    return dot(unit_normal(surface, sides[0]), unit_normal(surface, sides[1])) < min_cosine;
}

/// Triangles connected to `start`; the search does not cross `barred` triangles, nor sharp edges unless `across_sharp_edges`.
std::vector<bool> flooded(const BodySurface& surface, std::size_t start, const std::vector<bool>& barred,
                          bool across_sharp_edges) {
    std::vector<std::array<std::size_t, 3>> around(surface.triangles.size());
    std::vector<std::size_t> count(surface.triangles.size());
    for (const auto& [edge, sides] : edges_with_sides(surface)) {
        if (!across_sharp_edges && is_sharp(surface, sides)) continue;
        around[sides[0]][count[sides[0]]++] = sides[1];
        around[sides[1]][count[sides[1]]++] = sides[0];
    }
    std::vector<bool> in(surface.triangles.size());
    std::vector<std::size_t> pending{start};
    in[start] = true;
    while (!pending.empty()) {
        const std::size_t t = pending.back();
        pending.pop_back();
        for (std::size_t k = 0; k < count[t]; ++k)
            if (const std::size_t next = around[t][k]; !in[next] && !barred[next]) {
                in[next] = true;
                pending.push_back(next);
            }
    }
    return in;
}

std::vector<bool> flood(const BodySurface& surface, const FaceRule::Flood& rule,
                        const std::vector<NamedFace>& earlier) {
    std::vector<bool> barred(surface.triangles.size());
    for (const std::string& name : rule.up_to) {
        const auto face = std::ranges::find(earlier, name, &NamedFace::name);
        if (face == earlier.end())
            throw std::logic_error("named_faces: up_to names face " + name + ", which is not defined before");
        for (std::size_t t = 0; t < barred.size(); ++t) barred[t] = barred[t] || face->facets[t];
    }
    const auto start =
        static_cast<std::size_t>(surface::NearestOnTriangles(surface.points, surface.triangles)(rule.point).element);
    return flooded(surface, start, barred, !rule.up_to.empty());
}

std::vector<bool> facets_of(const BodySurface& surface, const FaceRule& rule, const std::vector<NamedFace>& earlier) {
    constexpr double rounding = 1e-6;  // files of floats have seven significant digits
    const double tolerance_m = rounding * surface.extent_m();
    const auto all_corners = [&](std::size_t t, auto&& is_in) {
        return std::ranges::all_of(surface.triangles[t],
                                   [&](int corner) { return is_in(surface.points[static_cast<std::size_t>(corner)]); });
    };
    std::vector<bool> in(surface.triangles.size(), true);
    if (rule.flood) in = flood(surface, *rule.flood, earlier);
    for (std::size_t t = 0; t < in.size(); ++t) {
        if (rule.plane)
            in[t] = in[t] && all_corners(t, [&](const mesh::Point& p) {
                        return std::abs(p[rule.plane->component] - rule.plane->at_m) <= tolerance_m;
                    });
        if (rule.box)
            in[t] = in[t] && all_corners(t, [&](const mesh::Point& p) {
                        for (std::size_t d = 0; d < 3; ++d)
                            if (p[d] < rule.box->from[d] - tolerance_m || p[d] > rule.box->to[d] + tolerance_m)
                                return false;
                        return true;
                    });
        if (rule.direction)
            in[t] = in[t] && dot(unit_normal(surface, t), rule.direction->normal) >=
                                 std::cos(rule.direction->within_rad) * norm(rule.direction->normal);
    }
    return in;
}

}  // namespace

std::map<Edge, std::array<std::size_t, 2>> edges_with_sides(const BodySurface& surface) {
    std::map<Edge, std::array<std::size_t, 2>> found;  // two per edge, because the surface is closed
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]);
            const auto [entry, fresh] = found.try_emplace({a, b}, std::array{t, t});
            if (!fresh) entry->second[1] = t;
        }
    return found;
}

std::vector<NamedFace> named_faces(const BodySurface& surface, const std::vector<FaceRule>& rules) {
    std::vector<NamedFace> faces;
    for (std::size_t s = 0; s < surface.shells.size(); ++s) {
        NamedFace& face = faces.emplace_back(surface.shells[s].name, std::vector<bool>(surface.triangles.size()));
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            face.facets[t] = surface.shell_of[t] == static_cast<int>(s);
    }
    for (const FaceRule& rule : rules) faces.push_back({rule.name, facets_of(surface, rule, faces)});
    return faces;
}

Creases creases_of(const BodySurface& surface, const std::vector<NamedFace>& faces) {
    Creases edges;
    for (const auto& [edge, sides] : edges_with_sides(surface)) {
        const bool border = std::ranges::any_of(
            faces, [&](const NamedFace& face) { return face.facets[sides[0]] != face.facets[sides[1]]; });
        if (border || is_sharp(surface, sides)) edges.push_back(edge);
    }
    return edges;
}

}  // namespace soft::meshing
