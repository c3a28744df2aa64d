/// Evaluates the map at all points of a cell together.
#include "fem/cell_kinematics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/shape.hpp"

namespace soft::fem {

namespace {

std::size_t numbers(int components, int stride) {
    return static_cast<std::size_t>(components) * static_cast<std::size_t>(stride);
}

}  // namespace

CellPoints::CellPoints(const ReferenceCell& cell)
    : values(numbers(2 * cell.dimension * (cell.dimension + 1), padded(cell.points))),
      inverse(numbers(9, padded(cell.points))),
      volume(numbers(1, padded(cell.points))),
      jacobian(volume.size()),
      gradient(numbers((cell.dimension + 1) * cell.points, cell.nodes) + lane_count),
      basis(numbers(cell.pressure_dofs, padded(cell.points))),
      law(cell.points, cell.dimension == 2 ? material::Components::planar : material::Components::all) {}

namespace detail {

namespace {

/// row[m] = sum over the nodes a of component[a] x by_node[a][m], m = 0 .. length - 1.
SOFT_VECTOR_CLONES
void interpolate(int nodes, int length, const double* component, const double* by_node, double* __restrict row) {
    for (int m = 0; m < length; ++m) row[m] = component[0] * by_node[m];
    for (int a = 1; a < nodes; ++a) {
        const double value = component[a];
        const double* __restrict table = by_node + static_cast<std::ptrdiff_t>(a) * length;
        for (int m = 0; m < length; ++m) row[m] += value * table[m];
    }
}

/// Computes the inverse map, the reference volume (with 2 pi R if axisymmetric), F and det F from the interpolated values.
template <bool Axisymmetric>
inline void invert(int dim, int stride, const double* values, CellPoints& points) {
    const auto at = [&](int row, int column) { return values + ((row * (dim + 1)) + column) * stride; };
    for (int q = 0; q < stride; q += lane_count) {
        TensorOf<Lanes> dX{}, du{};
        dX[8] += 1.0;
        for (int i = 0; i < dim; ++i)
            for (int d = 0; d < dim; ++d) {
                load(at(i, d) + q, dX[3 * i + d]);
                load(at(dim + i, d) + q, du[3 * i + d]);
            }
        const Lanes det = determinant(dX);
        TensorOf<Lanes> inverse = cofactor(dX);
        for (Lanes& c : inverse) c /= det;  // [3 J + d]: the inverse, transposed
        TensorOf<Lanes> F{};
        for (int i = 0; i < 3; ++i) {
            F[4 * i] += 1.0;
            for (int J = 0; J < 3; ++J)
                for (int d = 0; d < 3; ++d) F[3 * i + J] += du[3 * i + d] * inverse[3 * J + d];
        }
        Lanes volume;
        load(&points.volume[q], volume);
        volume *= det;
        if constexpr (Axisymmetric) {
            Lanes R, u;
            load(at(1, dim) + q, R);
            load(at(dim + 1, dim) + q, u);
            F[8] = 1.0 + u / R;
            volume *= 2.0 * std::numbers::pi * R;
        }
        store(volume, &points.volume[q]);
        store(determinant(F), &points.jacobian[q]);
        for (int m = 0; m < 9; ++m) {
            store(inverse[m], &points.inverse[m * stride + q]);
            store(F[m], &points.law.F[m * stride + q]);
        }
    }
}

SOFT_VECTOR_CLONES
void invert_plane(int stride, const double* values, CellPoints& points) { invert<false>(2, stride, values, points); }
SOFT_VECTOR_CLONES
void invert_axisymmetric(int stride, const double* values, CellPoints& points) {
    invert<true>(2, stride, values, points);
}
SOFT_VECTOR_CLONES
void invert_solid(int stride, const double* values, CellPoints& points) { invert<false>(3, stride, values, points); }

/// dN/dX at all points.
SOFT_VECTOR_CLONES
void find_gradients(const ReferenceCell& cell, const double* inverse, double* __restrict gradient) {
    const int n = cell.nodes, dim = cell.dimension, stride = padded(cell.points);
    for (int J = 0; J < dim; ++J)
        for (int q = 0; q < cell.points; ++q) {
            const double* __restrict g0 = cell.dN_dxi.data() + static_cast<std::ptrdiff_t>(q) * dim * n;
            const double* __restrict g1 = g0 + n, * __restrict g2 = g1 + n;
            const double i0 = inverse[(3 * J) * stride + q], i1 = inverse[(3 * J + 1) * stride + q];
            if (dim == 3) {
                const double i2 = inverse[(3 * J + 2) * stride + q];
                for (int a = 0; a < n; ++a) gradient[a] = i0 * g0[a] + i1 * g1[a] + i2 * g2[a];
            } else {
                for (int a = 0; a < n; ++a) gradient[a] = i0 * g0[a] + i1 * g1[a];
            }
            gradient += n;
        }
}

void find_hoop_gradients(const ReferenceCell& cell, const double* radius, double* __restrict gradient) {
    for (int q = 0; q < cell.points; ++q)
        for (int a = 0; a < cell.nodes; ++a)
            *gradient++ = cell.N[static_cast<std::size_t>(q) * cell.nodes + a] / radius[q];
}

/// Bounding box of the vertices: its centre, and 2 / longest side.
struct Box {
    std::array<double, 3> centre{};
    double scale = 0;
};
Box box_of(const ReferenceCell& cell, std::span<const double> X) {
    const int n = cell.nodes, vertices = mesh::topology(cell.type).vertex_count;
    Box box;
    double extent = 0;
    for (int i = 0; i < cell.dimension; ++i) {
        const auto [low, high] = std::minmax_element(&X[i * n], &X[i * n] + vertices);
        box.centre[i] = 0.5 * (*low + *high);
        extent = std::max(extent, *high - *low);
    }
    box.scale = 2.0 / extent;
    return box;
}

void find_pressures(const ReferenceCell& cell, const CellInput& in, CellPoints& points) {
    const int stride = points.law.stride, dim = cell.dimension;
    if (cell.pressure == PressureSpace::continuous_vertex) {
        for (int s = 0; s < cell.pressure_dofs; ++s)
            for (int q = 0; q < cell.points; ++q)
                points.basis[s * stride + q] =
                    in.pressure_scale_Pa * cell.vertex_N[static_cast<std::size_t>(q) * cell.pressure_dofs + s];
    } else {  // {1, 2 (X - centre) / extent}
        const Box box = box_of(cell, in.X);
        for (int q = 0; q < stride; ++q) points.basis[q] = in.pressure_scale_Pa;
        for (int i = 0; i < dim; ++i)
            for (int q = 0; q < stride; ++q)
                points.basis[(i + 1) * stride + q] =
                    in.pressure_scale_Pa * box.scale *
                    (points.values[(i * (dim + 1) + dim) * stride + q] - box.centre[i]);
    }
    std::ranges::fill(points.law.p, 0.0);
    for (int s = 0; s < cell.pressure_dofs; ++s)
        for (int q = 0; q < stride; ++q) points.law.p[q] += points.basis[s * stride + q] * in.p[s];
}

}  // namespace

template <bool Axisymmetric>
void map_points(const ReferenceCell& cell, const CellInput& in, CellPoints& points) {
    const int n = cell.nodes, dim = cell.dimension, stride = points.law.stride, length = (dim + 1) * stride;
    points.law.memory = in.memory;
    for (int i = 0; i < dim; ++i) {
        interpolate(n, length, &in.X[i * n], cell.by_node.data(), &points.values[i * length]);
        interpolate(n, length, &in.u[i * n], cell.by_node.data(), &points.values[(dim + i) * length]);
    }
    std::ranges::fill(points.volume, 0.0);
    std::ranges::copy(cell.weight, points.volume.begin());
    if constexpr (Axisymmetric)
        invert_axisymmetric(stride, points.values.data(), points);
    else if (dim == 2)
        invert_plane(stride, points.values.data(), points);
    else
        invert_solid(stride, points.values.data(), points);
    find_gradients(cell, points.inverse.data(), points.gradient.data());
    if constexpr (Axisymmetric)
        find_hoop_gradients(cell, &points.values[length + dim * stride],
                            &points.gradient[static_cast<std::size_t>(dim) * cell.points * n]);
    if (cell.pressure != PressureSpace::none) find_pressures(cell, in, points);
}

template void map_points<true>(const ReferenceCell&, const CellInput&, CellPoints&);
template void map_points<false>(const ReferenceCell&, const CellInput&, CellPoints&);

double min_jacobian(const ReferenceCell& cell, const CellPoints& points) {
    double least = points.jacobian.front();
    for (int q = 0; q < cell.points; ++q) {
        if (std::isnan(points.jacobian[q])) return 0.0;  // NaN counts as inverted
        least = std::min(least, points.jacobian[q]);
    }
    return least;
}

void pressure_functions_at(const ReferenceCell& cell, std::span<const double> X, int node, double scale_Pa,
                           std::span<double> basis) {
    if (cell.pressure == PressureSpace::continuous_vertex) {
        const auto values = mesh::vertex_values(cell.type, mesh::topology(cell.type).nodes[node]);
        for (std::size_t s = 0; s < basis.size(); ++s) basis[s] = scale_Pa * values[s];
        return;
    }
    const Box box = box_of(cell, X);
    basis[0] = scale_Pa;
    for (int i = 0; i < cell.dimension; ++i)
        basis[i + 1] = scale_Pa * box.scale * (X[i * cell.nodes + node] - box.centre[i]);
}

double pressure_slope(const ReferenceCell& cell, std::span<const double> X, double scale_Pa) {
    return cell.pressure == PressureSpace::discontinuous_linear ? scale_Pa * box_of(cell, X).scale : 0.0;
}

template <bool Axisymmetric>
void find_fiber_axes(const ReferenceCell& cell, material::FiberFrame frame, CellPoints& points) {
    const int dim = cell.dimension, stride = points.law.stride;
    for (int q = 0; q < cell.points; ++q) {
        material::FiberAxes& axes = points.law.axes[q];
        axes = {};
        if (frame == material::FiberFrame::cartesian) continue;
        if constexpr (Axisymmetric) {
            axes = {{1, 0, 0}, {0, 0, 1}};
        } else {
            const double y = points.values[((dim + 1) + dim) * stride + q];
            const double z = dim == 3 ? points.values[(2 * (dim + 1) + dim) * stride + q] : 0.0;
            const double r = std::hypot(y, z);  // > 0 inside a cell: quadrature points do not lie on the axis
            axes = {{1, 0, 0}, {0, -z / r, y / r}};
        }
    }
}

template void find_fiber_axes<true>(const ReferenceCell&, material::FiberFrame, CellPoints&);
template void find_fiber_axes<false>(const ReferenceCell&, material::FiberFrame, CellPoints&);

}  // namespace detail
}  // namespace soft::fem
