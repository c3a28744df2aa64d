/// The sums over the points of a cell, which dominate the floating-point operations of the assembly.
#include "fem/cell_kinematics.hpp"
#include "math/small_product.hpp"

namespace soft::fem::detail {

namespace {

/// Number of directions in which component i has a gradient: the spatial ones, and for u_r the hoop (N/R, third row of the gradient).
template <bool Axisymmetric>
int directions_of(int dimension, int i) {
    return Axisymmetric && i == 1 ? 3 : dimension;
}

/// Index of the component of F for (component i, direction J): the hoop direction of u_r is F_33.
template <bool Axisymmetric>
int tensor_index(int i, int J) {
    return Axisymmetric && J == 2 ? 8 : 3 * i + J;
}

/// Output row for the tangent of the law at a point.
struct Row {
    int nodes, length;  // length of a row of the product, which equals that of a row of the stiffness
    double* out;
};

/// out[block][b] = sum over the directions L of A[L] gradient[L][b], for one component k; the gradients are `next` entries apart.
/// Writes whole lanes: entries beyond the end of the block are overwritten by the next block.
inline void combine(const Row& row, int block, int directions, const double* A, const double* gradient,
                    std::ptrdiff_t next) {
    double* out = row.out + block * row.nodes;
    Lanes g0, g1, g2;
    if (directions == 3) {
        for (int b = 0; b < row.nodes; b += lane_count) {
            load(gradient + b, g0);
            load(gradient + next + b, g1);
            load(gradient + 2 * next + b, g2);
            store(A[0] * g0 + A[1] * g1 + A[2] * g2, out + b);
        }
    } else {
        for (int b = 0; b < row.nodes; b += lane_count) {
            load(gradient + b, g0);
            load(gradient + next + b, g1);
            store(A[0] * g0 + A[1] * g1, out + b);
        }
    }
}

/// [direction J][point] rows of: volume A_iJkL dN_b/dX_L for the components k >= first of all nodes b, then volume dTheta/dF_iJ times
/// the pressure functions.
template <bool Axisymmetric>
inline void fill_product(const ReferenceCell& cell, const CellPoints& points, int i, int first, double* product) {
    const int n = cell.nodes, dim = cell.dimension, stride = points.law.stride;
    const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(cell.points) * n;
    Row row{n, cell.dofs() - first * n, product};
    for (int J = 0; J < directions_of<Axisymmetric>(dim, i); ++J) {
        const int m = tensor_index<Axisymmetric>(i, J);
        for (int q = 0; q < cell.points; ++q, row.out += row.length) {
            const double volume = points.volume[q];
            const double* gradient = &points.gradient[static_cast<std::size_t>(q) * n];
            for (int k = first; k < dim; ++k) {
                double A[3] = {0, 0, 0};
                const int directions = directions_of<Axisymmetric>(dim, k);
                for (int L = 0; L < directions; ++L)
                    A[L] = volume * points.law.tangent[(9 * m + tensor_index<Axisymmetric>(k, L)) * stride + q];
                combine(row, k - first, directions, A, gradient, next);
            }
            const double coupling = cell.pressure_dofs > 0 ? volume * points.law.dtheta_dF[m * stride + q] : 0.0;
            for (int s = 0; s < cell.pressure_dofs; ++s)
                row.out[(dim - first) * n + s] = coupling * points.basis[s * stride + q];
        }
    }
}

SOFT_VECTOR_CLONES
void fill_product_of_revolution(const ReferenceCell& cell, const CellPoints& points, int i, int first,
                                double* product) {
    fill_product<true>(cell, points, i, first, product);
}
SOFT_VECTOR_CLONES
void fill_product_of_unit_depth(const ReferenceCell& cell, const CellPoints& points, int i, int first,
                                double* product) {
    fill_product<false>(cell, points, i, first, product);
}

/// - int basis_s basis_t / K dV.
void fill_compliance(const ReferenceCell& cell, const CellPoints& points, double inverse_bulk_modulus,
                     std::vector<double>& stiffness) {
    const int first = cell.displacement_dofs(), size = cell.dofs(), stride = points.law.stride;
    for (int s = 0; s < cell.pressure_dofs; ++s)
        for (int t = s; t < cell.pressure_dofs; ++t) {
            double sum = 0;
            for (int q = 0; q < cell.points; ++q)
                sum += points.volume[q] * points.basis[s * stride + q] * points.basis[t * stride + q];
            stiffness[static_cast<std::size_t>(first + s) * size + first + t] = -inverse_bulk_modulus * sum;
        }
}

/// Copies the blocks above the diagonal to below it.
void mirror(const ReferenceCell& cell, std::vector<double>& stiffness) {
    const int n = cell.nodes, size = cell.dofs(), last = cell.displacement_dofs();
    double* K = stiffness.data();
    for (int column = 0; column < size; ++column) {
        const int end = column < last ? column / n * n : column;  // blocks on the diagonal are already complete
        for (int row = 0; row < end; ++row)
            K[static_cast<std::size_t>(column) * size + row] = K[static_cast<std::size_t>(row) * size + column];
    }
}

SOFT_VECTOR_CLONES
void add_force(int n, double stress, const double* __restrict gradient, double* __restrict residual) {
    for (int a = 0; a < n; ++a) residual[a] += stress * gradient[a];
}

}  // namespace

template <bool Axisymmetric>
void sum_residual(const ReferenceCell& cell, double inverse_bulk_modulus, CellOutput& out) {
    const int n = cell.nodes, dim = cell.dimension;
    const CellPoints& points = out.points;
    const int stride = points.law.stride;
    out.residual.assign(out.residual.size(), 0.0);
    for (int i = 0; i < dim; ++i)
        for (int J = 0; J < directions_of<Axisymmetric>(dim, i); ++J) {
            const double* P = &points.law.first_piola[tensor_index<Axisymmetric>(i, J) * stride];
            for (int q = 0; q < cell.points; ++q)
                add_force(n, points.volume[q] * P[q],
                          &points.gradient[static_cast<std::size_t>(J * cell.points + q) * n],
                          &out.residual[static_cast<std::size_t>(i) * n]);
        }
    for (int s = 0; s < cell.pressure_dofs; ++s)
        for (int q = 0; q < cell.points; ++q)
            out.residual[static_cast<std::size_t>(dim * n + s)] +=
                points.volume[q] * points.basis[s * stride + q] *
                (points.law.theta[q] - points.law.p[q] * inverse_bulk_modulus);
}

template <bool Axisymmetric, TangentKind Kind>
void sum_stiffness(const ReferenceCell& cell, double inverse_bulk_modulus, CellOutput& out) {
    const int n = cell.nodes, dim = cell.dimension, size = cell.dofs();
    const CellPoints& points = out.points;
    out.product.resize(static_cast<std::size_t>(3) * cell.points * size + gemm_padding);
    for (int i = 0; i < dim; ++i) {
        const int first = Kind == TangentKind::symmetric ? i : 0, columns = size - first * n;
        const int depth = directions_of<Axisymmetric>(dim, i) * cell.points;
        if constexpr (Axisymmetric)
            fill_product_of_revolution(cell, points, i, first, out.product.data());
        else
            fill_product_of_unit_depth(cell, points, i, first, out.product.data());
        transposed_product(depth, {points.gradient.data(), n}, {out.product.data(), columns},
                           &out.stiffness[static_cast<std::size_t>(i * n) * size + first * n], size);
    }
    fill_compliance(cell, points, inverse_bulk_modulus, out.stiffness);
    if constexpr (Kind == TangentKind::symmetric) mirror(cell, out.stiffness);
}

template <bool Axisymmetric>
void sum_shape_gradient(const ReferenceCell& cell, double inverse_bulk_modulus, const CellInput& in,
                        std::span<const double> psi, std::span<const double> stress, CellOutput& out,
                        std::vector<double>& shape) {
    const int n = cell.nodes, dim = cell.dimension, stride = out.points.law.stride;
    CellPoints& points = out.points;
    const double slope = pressure_slope(cell, in.X, in.pressure_scale_Pa);
    std::vector<double> forces(static_cast<std::size_t>(dim * cell.points), 0.0);  // b dV
    for (int q = 0; q < cell.points; ++q) {
        const auto at = [&](std::span<const double> values, int m) { return values[m * stride + q]; };
        Tensor H = points.law.gradient(q), G{}, T{};  // grad u, grad psi
        for (int i = 0; i < 3; ++i) H[4 * i] -= 1.0;
        double psi_p = 0, theta = 0, along = 0;  // theta: Theta - p / K; along: dTheta/dF : grad psi
        for (int s = 0; s < cell.pressure_dofs; ++s) psi_p += at(points.basis, s) * psi[dim * n + s];
        if (cell.pressure_dofs > 0) theta = points.law.theta[q] - points.law.p[q] * inverse_bulk_modulus;
        double w = psi_p * theta;
        const auto for_each = [&](auto&& visit) {  // components of a gradient
            for (int i = 0; i < dim; ++i)
                for (int J = 0; J < directions_of<Axisymmetric>(dim, i); ++J)
                    visit(i, J, tensor_index<Axisymmetric>(i, J));
        };
        for_each([&](int i, int J, int m) {
            const double* gradient = &points.gradient[static_cast<std::size_t>(J * cell.points + q) * n];
            for (int a = 0; a < n; ++a) G[m] += psi[i * n + a] * gradient[a];
            w += at(stress, m) * G[m];
        });
        for_each([&](int, int, int m) {
            for_each([&](int, int, int k) { T[m] += at(points.law.tangent, 9 * k + m) * G[k]; });
            if (cell.pressure_dofs == 0) return;
            T[m] += psi_p * at(points.law.dtheta_dF, m);
            along += G[m] * at(points.law.dtheta_dF, m);
        });
        for_each([&](int, int, int m) {
            double S = m % 4 == 0 ? w : 0.0;
            for (int i = 0; i < 9; i += 3) S -= H[i + m / 3] * T[i + m % 3] + G[i + m / 3] * at(stress, i + m % 3);
            points.law.first_piola[m * stride + q] = S;
        });
        for (int K = 0; K < dim && slope != 0.0; ++K)
            forces[static_cast<std::size_t>(K * cell.points + q)] =
                points.volume[q] * slope *
                (in.p[K + 1] * (along - psi_p * inverse_bulk_modulus) + psi[dim * n + K + 1] * theta);
    }
    sum_residual<Axisymmetric>(cell, inverse_bulk_modulus, out);
    shape.assign(out.residual.begin(), out.residual.begin() + dim * n);
    for (int K = 0; K < dim && slope != 0.0; ++K)
        for (int q = 0; q < cell.points; ++q)
            add_force(n, forces[static_cast<std::size_t>(K * cell.points + q)],
                      &cell.N[static_cast<std::size_t>(q) * n], &shape[static_cast<std::size_t>(K) * n]);
}

template void sum_residual<true>(const ReferenceCell&, double, CellOutput&);
template void sum_residual<false>(const ReferenceCell&, double, CellOutput&);
template void sum_shape_gradient<true>(const ReferenceCell&, double, const CellInput&, std::span<const double>,
                                       std::span<const double>, CellOutput&, std::vector<double>&);
template void sum_shape_gradient<false>(const ReferenceCell&, double, const CellInput&, std::span<const double>,
                                        std::span<const double>, CellOutput&, std::vector<double>&);
template void sum_stiffness<true, TangentKind::symmetric>(const ReferenceCell&, double, CellOutput&);
template void sum_stiffness<false, TangentKind::symmetric>(const ReferenceCell&, double, CellOutput&);
template void sum_stiffness<true, TangentKind::full>(const ReferenceCell&, double, CellOutput&);
template void sum_stiffness<false, TangentKind::full>(const ReferenceCell&, double, CellOutput&);

}  // namespace soft::fem::detail
