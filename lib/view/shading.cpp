#include "view/shading.hpp"

#include <algorithm>
#include <cmath>

#include "view/creases.hpp"

namespace soft::view {

namespace {

constexpr double smooth_cosine = 0.7071067811865476;  // 45 degrees, as for the creases

/// Faces at each vertex: those of vertex v are faces[first[v]] .. faces[first[v + 1] - 1].
struct FacesAt {
    std::vector<std::size_t> first, faces;
};

FacesAt faces_at(std::span<const Face> faces, std::size_t vertices) {
    FacesAt at;
    at.first.assign(vertices + 1, 0);
    const auto corners = [](const Face& face) { return face[3] == face[2] ? std::size_t{3} : std::size_t{4}; };
    for (const Face& face : faces)
        for (std::size_t i = 0; i < corners(face); ++i) ++at.first[static_cast<std::size_t>(face[i]) + 1];
    for (std::size_t v = 0; v < vertices; ++v) at.first[v + 1] += at.first[v];
    at.faces.resize(at.first.back());
    std::vector<std::size_t> next(at.first.begin(), at.first.end() - 1);
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t i = 0; i < corners(faces[f]); ++i) at.faces[next[static_cast<std::size_t>(faces[f][i])]++] = f;
    return at;
}

/// Direction from the body to the lamp.
Point lamp(const Screen& screen) {
    Point direction;
    for (std::size_t i = 0; i < 3; ++i)
        direction[i] = -0.25 * screen.right[i] + 0.45 * screen.up[i] + 0.85 * screen.eye[i];
    const double size = norm(direction);
    for (double& component : direction) component /= size;
    return direction;
}

}  // namespace

std::vector<std::array<double, 4>> corner_light(std::span<const Face> faces, std::span<const Point> positions,
                                                const Screen& screen) {
    std::vector<Point> normals;
    for (const Face& face : faces) normals.push_back(face_normal(face, positions));
    const FacesAt at = faces_at(faces, positions.size());
    const Point to_lamp = lamp(screen);
    std::vector<std::array<double, 4>> light(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto v = static_cast<std::size_t>(faces[f][i]);
            Point sum{};
            for (std::size_t k = at.first[v]; k < at.first[v + 1]; ++k) {
                const Point& n = normals[at.faces[k]];
                if (dot(n, normals[f]) < smooth_cosine * norm(n) * norm(normals[f])) continue;
                for (std::size_t d = 0; d < 3; ++d) sum[d] += n[d];
            }
            const double side = dot(sum, screen.eye) < 0 ? -1.0 : 1.0, size = norm(sum);
            light[f][i] = size > 0 ? std::max(0.0, side * dot(sum, to_lamp) / size) : 1.0;
        }
    return light;
}

}  // namespace soft::view
