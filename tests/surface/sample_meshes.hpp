#pragma once
/// Second-order meshes built by hand from maps of the unit square or cube; nodes lie exactly on the map.
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <tuple>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::surface::test {

using mesh::Index;
using mesh::Point;
using Map = std::function<Point(double u, double v, double w)>;

/// Adds blocks of cells and merges coincident nodes.
class MeshBuilder {
public:
    explicit MeshBuilder(int dimension) {
        mesh_.dimension = dimension;
        mesh_.region_names = {"rubber"};
    }

    /// nu x nv (x nw) cells; the map must preserve the orientation.
    void add_block(const Map& map, int nu, int nv, int nw = 1) {
        const mesh::CellType type = mesh_.dimension == 2 ? mesh::CellType::quad9 : mesh::CellType::hex27;
        for (int k = 0; k < (mesh_.dimension == 2 ? 1 : nw); ++k)
            for (int j = 0; j < nv; ++j)
                for (int i = 0; i < nu; ++i) {
                    std::vector<Index> nodes;
                    for (const auto& xi : mesh::topology(type).nodes)
                        nodes.push_back(node(
                            map((i + (xi[0] + 1) / 2) / nu, (j + (xi[1] + 1) / 2) / nv, (k + (xi[2] + 1) / 2) / nw)));
                    add_cell(mesh_, type, nodes, 0);
                }
    }

    /// Boundary facets whose nodes all satisfy `is_there`.
    void name_facets(const std::string& name, const std::function<bool(const Point&)>& is_there) {
        for (const mesh::Facet& facet : boundary_facets(mesh_)) {
            bool all = true;
            for (const Index n : facet_nodes(mesh_, facet)) all = all && is_there(mesh_.point(n));
            if (all) mesh_.facet_sets[name].push_back(facet);
        }
    }

    [[nodiscard]] mesh::Mesh take() { return std::move(mesh_); }

private:
    Index node(const Point& p) {
        const auto round = [](double x) { return std::llround(x * 1e10); };
        const auto [found, is_new] = numbers_.emplace(std::tuple(round(p[0]), round(p[1]), round(p[2])),
                                                      static_cast<Index>(mesh_.points.size()));
        if (is_new) mesh_.points.push_back(p);
        return found->second;
    }

    mesh::Mesh mesh_;
    std::map<std::tuple<long long, long long, long long>, Index> numbers_;
};

inline model::Case make_case(mesh::Mesh mesh, model::Kinematics kinematics) {
    model::Case model;
    model.kinematics = kinematics;
    model.mesh = std::move(mesh);
    model.path.contact = model::Contact::stop;  // the first touch is found to rounding
    model.cavities.push_back({.name = "cavity", .wall = "cavity", .inner_faces = {}, .openings = {}});
    return model;
}

/// Grid lines of a box with a hollow in its middle cell, m.
struct BoxLines {
    std::array<double, 4> x{0, 1, 2.2, 3.4}, y{-1.6, -0.5, 0.5, 1.5}, z{-2, -0.9, 0.9, 1.8};
};

enum class Hole { none, to_the_right };  ///< right: the cell at the end of x is missing too

/// 26 (25) hexahedra around a hollow of 1.2 x 1 x 1.8 m.
inline model::Case hollow_box(Hole hole, const BoxLines& at = {}) {
    MeshBuilder builder(3);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) {
                if (j == 1 && k == 1 && (i == 1 || (i == 2 && hole == Hole::to_the_right))) continue;
                builder.add_block(
                    [&](double u, double v, double w) {
                        return Point{std::lerp(at.x[i], at.x[i + 1], u), std::lerp(at.y[j], at.y[j + 1], v),
                                     std::lerp(at.z[k], at.z[k + 1], w)};
                    },
                    1, 1);
            }
    builder.name_facets("cavity", [&](const Point& p) {
        return p[0] >= at.x[1] && p[1] >= at.y[1] && p[1] <= at.y[2] && p[2] >= at.z[1] && p[2] <= at.z[2] &&
               (hole == Hole::to_the_right || p[0] <= at.x[2]);
    });
    builder.name_facets("outer", [&](const Point& p) {
        return p[0] == at.x[0] || p[0] == at.x[3] || p[1] == at.y[0] || p[1] == at.y[3] || p[2] == at.z[0] ||
               p[2] == at.z[3];
    });
    return make_case(builder.take(), model::Kinematics::solid);
}

/// The hollow box cut at y = 0 and z = 0; hollow 1.2 x (2 x 0.5) x (2 x 0.9) m of the whole, walls 1, 0.7, 1.1 m.
inline model::Case quarter_box(Hole hole) {
    MeshBuilder builder(3);
    const std::array<double, 4> x{0, 1, 2.2, 3.4};
    const std::array<double, 3> y{0, 0.5, 1.2}, z{0, 0.9, 2};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            for (std::size_t k = 0; k < 2; ++k) {
                if (j == 0 && k == 0 && (i == 1 || (i == 2 && hole == Hole::to_the_right))) continue;
                builder.add_block(
                    [&](double u, double v, double w) {
                        return Point{std::lerp(x[i], x[i + 1], u), std::lerp(y[j], y[j + 1], v),
                                     std::lerp(z[k], z[k + 1], w)};
                    },
                    1, 1);
            }
    builder.name_facets("cavity", [&](const Point& p) {
        return p[0] >= 1 && p[1] <= 0.5 && p[2] <= 0.9 && (hole == Hole::to_the_right || p[0] <= 2.2);
    });
    model::Case model = make_case(builder.take(), model::Kinematics::solid);
    // facets on the symmetry planes do not belong to the cavity
    std::erase_if(model.mesh.facet_sets["cavity"], [&](const mesh::Facet& facet) {
        bool on_y = true, on_z = true;
        for (const Index n : facet_nodes(model.mesh, facet)) {
            on_y = on_y && model.mesh.point(n)[1] == 0;
            on_z = on_z && model.mesh.point(n)[2] == 0;
        }
        return on_y || on_z;
    });
    model.model_fraction = 0.25;
    model.symmetry_planes = {false, true, true};
    return model;
}

/// Spherical shell, radii 1 and 2 m: six blocks of n x n x 1 cells over the sides of a cube.
inline model::Case sphere_shell(int n) {
    MeshBuilder builder(3);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            builder.add_block(
                [&](double u, double v, double w) {
                    Point p{};
                    p[axis] = side;
                    p[(axis + 1) % 3] = side * std::tan((2 * u - 1) * std::numbers::pi / 4);
                    p[(axis + 2) % 3] = std::tan((2 * v - 1) * std::numbers::pi / 4);
                    const double r = (1 + w) / std::hypot(p[0], p[1], p[2]);
                    return Point{r * p[0], r * p[1], r * p[2]};
                },
                n, n);
    builder.name_facets("cavity", [](const Point& p) { return std::hypot(p[0], p[1], p[2]) < 1.2; });
    builder.name_facets("outer", [](const Point& p) { return std::hypot(p[0], p[1], p[2]) > 1.8; });
    return make_case(builder.take(), model::Kinematics::solid);
}

/// Region between two circles in the meridian plane; the centre of the inner circle is offset by `shift` [m] from that of the outer one.
struct Annulus {
    double centre_r = 0;  ///< of the outer circle; 0: a hollow ball, else a hollow ring
    double inner_radius = 1, outer_radius = 2;
    std::array<double, 2> shift{0, 0};  ///< (x, r)
};

/// n cells around (the half circle r >= 0 of a ball, the full circle of a ring), one through the wall.
inline model::Case annulus_section(const Annulus& a, int n) {
    MeshBuilder builder(2);
    const bool ring = a.centre_r > 0;
    const auto circle = [&](double angle, double radius, double along) {
        const double sine = !ring && (angle < 1e-12 || angle > std::numbers::pi - 1e-12) ? 0 : std::sin(angle);
        return Point{along * a.shift[0] + radius * std::cos(angle), a.centre_r + along * a.shift[1] + radius * sine, 0};
    };
    builder.add_block(
        [&](double u, double v, double) {
            const double angle = ring ? 2 * std::numbers::pi * (1 - u) : std::numbers::pi * (1 - u);
            const Point inner = circle(ring && u == 1 ? 2 * std::numbers::pi : angle, a.inner_radius, 1),
                        outer = circle(angle, a.outer_radius, 0);
            return Point{std::lerp(inner[0], outer[0], v), std::lerp(inner[1], outer[1], v), 0};
        },
        n, 1);
    builder.name_facets("cavity", [&](const Point& p) {
        return std::abs(std::hypot(p[0] - a.shift[0], p[1] - a.centre_r - a.shift[1]) - a.inner_radius) < 1e-9;
    });
    return make_case(builder.take(), model::Kinematics::axisymmetric);
}

}  // namespace soft::surface::test
