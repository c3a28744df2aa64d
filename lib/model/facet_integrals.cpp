#include "model/facet_integrals.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "core/error.hpp"
#include "math/vector.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace soft::model {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Position and tangents at a point of the facet.
struct Surface {
    Vector3 x{}, t1{}, t2{};
};

Surface evaluate(const ReferenceFacet& facet, std::span<const double> x, int q) {
    const int n = facet.nodes;
    const double* N = &facet.N[static_cast<std::size_t>(q) * n];
    const int directions = mesh::dimension(facet.type);
    const double* dN = &facet.dN_dxi[static_cast<std::size_t>(q) * directions * n];
    Surface s;
    const int dim = static_cast<int>(x.size()) / n;
    for (int i = 0; i < dim; ++i)
        for (int a = 0; a < n; ++a) {
            s.x[i] += N[a] * x[i * n + a];
            s.t1[i] += dN[a] * x[i * n + a];
            if (directions == 2) s.t2[i] += dN[n + a] * x[i * n + a];
        }
    return s;
}

constexpr int most_nodes = 9;

/// d(t1 x t2)_i / dx_k of node b = N_b,1 (e_k x t2)_i + N_b,2 (t1 x e_k)_i = +-(N_b,1 t2 - N_b,2 t1)_c, with c the third axis and + where
/// (k, c, i) is cyclic; 0 for i = k. So three sums over the points make up the stiffness.
void solid_pressure(const ReferenceFacet& facet, std::span<const double> x, std::span<double> force,
                    std::span<double> stiffness) {
    const int n = facet.nodes, size = facet.dofs();
    std::array<double, most_nodes> slopes{};
    std::array<std::array<double, most_nodes * most_nodes>, 3> sums{};  // [c][a n + b]
    for (int q = 0; q < facet.points; ++q) {
        const Surface s = evaluate(facet, x, q);
        const Vector3 normal = cross(s.t1, s.t2);
        const double* N = &facet.N[static_cast<std::size_t>(q) * n];
        const double* dN = &facet.dN_dxi[static_cast<std::size_t>(q) * 2 * n];
        for (int i = 0; i < 3; ++i)
            for (int a = 0; a < n; ++a) force[i * n + a] += -facet.weight[q] * N[a] * normal[i];
        if (stiffness.empty()) continue;
        for (int c = 0; c < 3; ++c) {
            for (int b = 0; b < n; ++b) slopes[b] = dN[b] * s.t2[c] - dN[n + b] * s.t1[c];
            for (int a = 0; a < n; ++a) {
                const double weight = -facet.weight[q] * N[a];
                for (int b = 0; b < n; ++b) sums[c][a * n + b] += weight * slopes[b];
            }
        }
    }
    if (stiffness.empty()) return;
    for (int i = 0; i < 3; ++i)
        for (int a = 0; a < n; ++a)
            for (const int k : {(i + 1) % 3, (i + 2) % 3}) {
                const int c = 3 - i - k;
                const double sign = (k + 1) % 3 == c ? 1.0 : -1.0;
                double* row = &stiffness[static_cast<std::size_t>(i * n + a) * size + static_cast<std::size_t>(k * n)];
                for (int b = 0; b < n; ++b) row[b] += sign * sums[c][a * n + b];
            }
}

/// Section facets: n da = depth (t_y, -t_x) dxi with depth = 2 pi r (axisymmetric) or 1 (plane strain).
void section_pressure(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> x,
                      std::span<double> force, std::span<double> stiffness) {
    const int n = facet.nodes, size = facet.dofs();
    const bool axisymmetric = kinematics == Kinematics::axisymmetric;
    for (int q = 0; q < facet.points; ++q) {
        const Surface s = evaluate(facet, x, q);
        const double depth = axisymmetric ? two_pi * s.x[1] : 1.0;
        const double* N = &facet.N[static_cast<std::size_t>(q) * n];
        const double* dN = &facet.dN_dxi[static_cast<std::size_t>(q) * n];
        for (int a = 0; a < n; ++a) {
            const double weight = -facet.weight[q] * N[a];
            force[a] += weight * depth * s.t1[1];
            force[n + a] -= weight * depth * s.t1[0];
            if (stiffness.empty()) continue;
            double* row_x = &stiffness[static_cast<std::size_t>(a) * size];
            double* row_y = &stiffness[static_cast<std::size_t>(n + a) * size];
            for (int b = 0; b < n; ++b) {
                const double depth_slope = axisymmetric ? two_pi * N[b] : 0.0;
                row_x[n + b] += weight * (depth * dN[b] + depth_slope * s.t1[1]);
                row_y[b] -= weight * depth * dN[b];
                row_y[n + b] -= weight * depth_slope * s.t1[0];
            }
        }
    }
}

double solid_volume(const ReferenceFacet& facet, std::span<const double> x, std::span<double> gradient) {
    const int n = facet.nodes;
    double volume = 0;
    for (int q = 0; q < facet.points; ++q) {
        const Surface s = evaluate(facet, x, q);
        const Vector3 normal = cross(s.t1, s.t2), by_t1 = cross(s.t2, s.x), by_t2 = cross(s.x, s.t1);
        const double weight = -facet.weight[q] / 3.0;
        volume += weight * dot(s.x, normal);
        const double* N = &facet.N[static_cast<std::size_t>(q) * n];
        const double* dN = &facet.dN_dxi[static_cast<std::size_t>(q) * 2 * n];
        for (int i = 0; i < 3; ++i)
            for (int a = 0; a < n; ++a)
                gradient[i * n + a] += weight * (N[a] * normal[i] + dN[a] * by_t1[i] + dN[n + a] * by_t2[i]);
    }
    return volume;
}

double section_volume(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> x,
                      std::span<double> gradient) {
    const int n = facet.nodes;
    double volume = 0;
    for (int q = 0; q < facet.points; ++q) {
        const Surface s = evaluate(facet, x, q);
        const double weight = facet.weight[q], r = s.x[1];
        const double* N = &facet.N[static_cast<std::size_t>(q) * n];
        const double* dN = &facet.dN_dxi[static_cast<std::size_t>(q) * n];
        if (kinematics == Kinematics::axisymmetric) {
            volume += weight * std::numbers::pi * r * r * s.t1[0];
            for (int a = 0; a < n; ++a) {
                gradient[a] += weight * std::numbers::pi * r * r * dN[a];
                gradient[n + a] += weight * two_pi * r * s.t1[0] * N[a];
            }
        } else {
            volume -= 0.5 * weight * (s.x[0] * s.t1[1] - s.x[1] * s.t1[0]);
            for (int a = 0; a < n; ++a) {
                gradient[a] -= 0.5 * weight * (N[a] * s.t1[1] - s.x[1] * dN[a]);
                gradient[n + a] -= 0.5 * weight * (s.x[0] * dN[a] - N[a] * s.t1[0]);
            }
        }
    }
    return volume;
}

ReferenceFacet make_reference(mesh::CellType type) {
    const auto& cell = mesh::topology(type);
    ReferenceFacet facet;
    facet.type = type;
    facet.dimension = cell.dimension + 1;
    facet.nodes = cell.node_count;
    // A higher degree than for a stiffness: x . (t1 x t2) of a curved second-order facet is a polynomial of high degree.
    const int degree = cell.shape == mesh::Shape::triangle ? 5 : (cell.order == 1 ? 3 : 7);
    for (const auto& point : mesh::quadrature(cell.shape, degree)) {
        const auto shapes = mesh::shape_values(type, point.xi);
        facet.weight.push_back(point.weight);
        for (const auto& shape : shapes) facet.N.push_back(shape.value);
        for (int d = 0; d < cell.dimension; ++d)
            for (const auto& shape : shapes) facet.dN_dxi.push_back(shape.gradient[d]);
        ++facet.points;
    }
    return facet;
}

}  // namespace

const ReferenceFacet& reference_facet(mesh::CellType type) {
    using enum mesh::CellType;
    static const std::array facets{make_reference(line2),     make_reference(line3), make_reference(triangle3),
                                   make_reference(triangle6), make_reference(quad4), make_reference(quad9)};
    for (const ReferenceFacet& facet : facets)
        if (facet.type == type) return facet;
    throw std::logic_error("reference_facet: not a facet");
}

void pressure_force(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> x,
                    std::span<double> force, std::span<double> stiffness) {
    if (kinematics == Kinematics::solid) return solid_pressure(facet, x, force, stiffness);
    section_pressure(facet, kinematics, x, force, stiffness);
}

double swept_volume(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> x,
                    std::span<double> gradient) {
    if (kinematics == Kinematics::solid) return solid_volume(facet, x, gradient);
    return section_volume(facet, kinematics, x, gradient);
}

double facet_area(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> X,
                  std::span<double> weights) {
    const int n = facet.nodes;
    double area = 0;
    for (int q = 0; q < facet.points; ++q) {
        const Surface s = evaluate(facet, X, q);
        const Vector3 normal = kinematics == Kinematics::solid ? cross(s.t1, s.t2) : s.t1;
        const double depth = kinematics == Kinematics::axisymmetric ? two_pi * s.x[1] : 1.0;
        const double share = facet.weight[q] * depth * std::sqrt(dot(normal, normal));
        area += share;
        for (int a = 0; a < n; ++a) weights[a] += share * facet.N[static_cast<std::size_t>(q) * n + a];
    }
    return area;
}

const std::vector<mesh::Facet>& facets_of(const mesh::Mesh& mesh, const std::string& face) {
    const auto found = mesh.facet_sets.find(face);
    if (found == mesh.facet_sets.end() || found->second.empty())
        throw Error(ExitCode::bad_input, "loads", "no face is called '" + face + "'");
    return found->second;
}

FaceWeights face_weights(const mesh::Mesh& mesh, Kinematics kinematics, const std::string& face) {
    std::map<mesh::Index, double> shares;  // ascending, so that sums run in the same order on every rank
    FaceWeights weights;
    for (const auto& facet : facets_of(mesh, face)) {
        const auto nodes = mesh::facet_nodes(mesh, facet);
        std::vector<double> share(nodes.size(), 0.0);
        weights.area_m2 += facet_area(reference_facet(mesh::facet_type(mesh, facet)), kinematics,
                                      mesh::by_component(mesh.points, nodes, mesh.dimension), share);
        for (std::size_t a = 0; a < nodes.size(); ++a) shares[nodes[a]] += share[a];
    }
    for (const auto& [node, share] : shares) {
        weights.nodes.push_back(node);
        weights.weights_m2.push_back(share);
    }
    return weights;
}

double cap_volume(const ReferenceFacet& edge, std::span<const double> y, std::span<const double, 3> apex,
                  std::span<double> gradient, std::span<double, 3> apex_gradient) {
    const int n = edge.nodes;
    const Vector3 c{apex[0], apex[1], apex[2]};
    double volume = 0;
    for (int q = 0; q < edge.points; ++q) {
        const Surface s = evaluate(edge, y, q);
        const Vector3 area = cross(s.x, s.t1), by_y = cross(s.t1, c), by_t = cross(c, s.x);
        const double weight = edge.weight[q] / 6.0;
        volume += weight * dot(c, area);
        const double* N = &edge.N[static_cast<std::size_t>(q) * n];
        const double* dN = &edge.dN_dxi[static_cast<std::size_t>(q) * n];
        for (int i = 0; i < 3; ++i) {
            apex_gradient[i] += weight * area[i];
            for (int a = 0; a < n; ++a) gradient[i * n + a] += weight * (N[a] * by_y[i] + dN[a] * by_t[i]);
        }
    }
    return volume;
}

}  // namespace soft::model
