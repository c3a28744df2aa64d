#include "view/creases.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "math/tensor.hpp"

namespace soft::view {

namespace {

constexpr double sharp_cosine = 0.7071067811865476;  // 45 degrees: more than a coarse mesh of a smooth wall has

struct Use {
    std::array<std::int32_t, 2> edge;
    std::size_t face;
};

/// The edges whose faces (one `Use` each) satisfy a condition, in order.
template <class Wanted>
std::vector<std::array<std::int32_t, 2>> edges_where(std::span<const Face> faces, Wanted wanted) {
    std::vector<Use> uses;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto a = faces[f][i], b = faces[f][(i + 1) % 4];
            if (a != b) uses.push_back({{std::min(a, b), std::max(a, b)}, f});
        }
    std::ranges::sort(uses,
                      [](const Use& a, const Use& b) { return std::tie(a.edge, a.face) < std::tie(b.edge, b.face); });
    std::vector<std::array<std::int32_t, 2>> edges;
    for (std::size_t k = 0; k < uses.size();) {
        std::size_t end = k;
        while (end < uses.size() && uses[end].edge == uses[k].edge) ++end;
        if (wanted(std::span{uses}.subspan(k, end - k))) edges.push_back(uses[k].edge);
        k = end;
    }
    return edges;
}

}  // namespace

Point face_normal(const Face& face, std::span<const Point> positions) {
    const auto& a = positions[static_cast<std::size_t>(face[0])];
    const auto& b = positions[static_cast<std::size_t>(face[1])];
    const auto& c = positions[static_cast<std::size_t>(face[2])];
    const auto& d = positions[static_cast<std::size_t>(face[3])];
    Point diagonal1, diagonal2;  // their cross product is the sum of the normals of both halves
    for (std::size_t i = 0; i < 3; ++i) {
        diagonal1[i] = c[i] - a[i];
        diagonal2[i] = (face[3] == face[2] ? c[i] : d[i]) - b[i];
    }
    return cross(diagonal1, diagonal2);
}

std::vector<std::array<std::int32_t, 2>> creases(std::span<const Face> faces, std::span<const Point> positions) {
    std::vector<Point> normals;
    for (const Face& face : faces) {
        Point n = face_normal(face, positions);
        const double length = norm(n);
        for (double& component : n) component /= length > 0 ? length : 1.0;
        normals.push_back(n);
    }
    return edges_where(faces, [&](std::span<const Use> uses) {
        return uses.size() != 2 || dot(normals[uses[0].face], normals[uses[1].face]) < sharp_cosine;
    });
}

std::vector<std::array<std::int32_t, 2>> silhouette(std::span<const Face> faces, std::span<const Point> positions,
                                                    const Point& eye) {
    std::vector<bool> seen;
    for (const Face& face : faces) seen.push_back(dot(face_normal(face, positions), eye) > 0);
    return edges_where(
        faces, [&](std::span<const Use> uses) { return uses.size() == 2 && seen[uses[0].face] != seen[uses[1].face]; });
}

}  // namespace soft::view
