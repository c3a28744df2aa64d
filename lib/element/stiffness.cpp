/// The innermost loops of the assembly: three quarters of its time for second-order hexahedra.
#include "element/cell_kinematics.hpp"

namespace soft::element::detail {

namespace {

// One build runs on every x86-64 processor and uses the widest vectors it has; elsewhere the plain loop is compiled.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SOFT_VECTOR_CLONES __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define SOFT_VECTOR_CLONES
#endif

/// A short linear combination of rows: sum_t factor[t] row[t].
struct Terms {
    int count = 0;
    const double* factor[3];
    const double* row[3];
};

/// K[a][b] += sum_t factor[t][a] row[t][b] for a n x n block with row length `stride`.
SOFT_VECTOR_CLONES
void add_outer_products(int n, const Terms& terms, double* __restrict K, int stride) {
    const double *__restrict r0 = terms.row[0], *__restrict r1 = terms.row[1], *__restrict r2 = terms.row[2];
    if (terms.count == 3) {
        for (int a = 0; a < n; ++a, K += stride) {
            const double f0 = terms.factor[0][a], f1 = terms.factor[1][a], f2 = terms.factor[2][a];
            for (int b = 0; b < n; ++b) K[b] += f0 * r0[b] + f1 * r1[b] + f2 * r2[b];
        }
    } else {
        for (int a = 0; a < n; ++a, K += stride) {
            const double f0 = terms.factor[0][a], f1 = terms.factor[1][a];
            for (int b = 0; b < n; ++b) K[b] += f0 * r0[b] + f1 * r1[b];
        }
    }
}

/// row[b] = sum over the directions L of A[L] G[L][b].
SOFT_VECTOR_CLONES
void combine(int n, int directions, const double* A, const double* __restrict G, double* __restrict row) {
    const double *__restrict g0 = G, *__restrict g1 = G + n, *__restrict g2 = G + 2 * n;
    if (directions == 3)
        for (int b = 0; b < n; ++b) row[b] = A[0] * g0[b] + A[1] * g1[b] + A[2] * g2[b];
    else
        for (int b = 0; b < n; ++b) row[b] = A[0] * g0[b] + A[1] * g1[b];
}

/// The directions in which component i has a gradient: those of space, and for u_r the hoop (N/R, third row of G).
template <bool Axisymmetric>
int directions_of(int dimension, int i) {
    return Axisymmetric && i == 1 ? 3 : dimension;
}

/// Index of F's component for (component i, direction J): the hoop of u_r is F_33.
template <bool Axisymmetric>
int tensor_index(int i, int J) {
    return Axisymmetric && J == 2 ? 8 : 3 * i + J;
}

}  // namespace

template <bool Axisymmetric, TangentKind Kind>
void add_stiffness(const ReferenceCell& cell, const material::PointResponse& point, double volume,
                   double inverse_bulk_modulus, CellOutput& out) {
    const int n = cell.nodes, dim = cell.dimension, size = cell.dofs();
    const double* G = out.gradient.data();
    for (int i = 0; i < dim; ++i)
        for (int k = Kind == TangentKind::symmetric ? i : 0; k < dim; ++k) {
            Terms terms;
            terms.count = directions_of<Axisymmetric>(dim, i);
            for (int J = 0; J < terms.count; ++J) {
                double A[3] = {0, 0, 0};
                for (int L = 0; L < directions_of<Axisymmetric>(dim, k); ++L)
                    A[L] = volume * point.tangent[9 * tensor_index<Axisymmetric>(i, J) + tensor_index<Axisymmetric>(k, L)];
                double* row = &out.product[static_cast<std::size_t>(J) * n];
                combine(n, directions_of<Axisymmetric>(dim, k), A, G, row);
                terms.factor[J] = G + J * n;
                terms.row[J] = row;
            }
            add_outer_products(n, terms, &out.stiffness[static_cast<std::size_t>(i * n) * size + k * n], size);
        }
    if (cell.pressure_dofs == 0) return;
    for (int i = 0; i < dim; ++i) {
        double coupling[3] = {0, 0, 0};
        for (int J = 0; J < directions_of<Axisymmetric>(dim, i); ++J)
            coupling[J] = volume * point.dtheta_dF[tensor_index<Axisymmetric>(i, J)];
        combine(n, directions_of<Axisymmetric>(dim, i), coupling, G, out.product.data());
        for (int a = 0; a < n; ++a) {
            double* row = &out.stiffness[static_cast<std::size_t>(i * n + a) * size + dim * n];
            for (int s = 0; s < cell.pressure_dofs; ++s) row[s] += out.product[a] * out.basis[s];
        }
    }
    for (int s = 0; s < cell.pressure_dofs; ++s)
        for (int t = s; t < cell.pressure_dofs; ++t)
            out.stiffness[static_cast<std::size_t>(dim * n + s) * size + dim * n + t] -=
                volume * inverse_bulk_modulus * out.basis[s] * out.basis[t];
}

template void add_stiffness<true, TangentKind::symmetric>(const ReferenceCell&, const material::PointResponse&, double,
                                                          double, CellOutput&);
template void add_stiffness<false, TangentKind::symmetric>(const ReferenceCell&, const material::PointResponse&, double,
                                                           double, CellOutput&);
template void add_stiffness<true, TangentKind::full>(const ReferenceCell&, const material::PointResponse&, double, double,
                                                     CellOutput&);
template void add_stiffness<false, TangentKind::full>(const ReferenceCell&, const material::PointResponse&, double,
                                                      double, CellOutput&);

void mirror_stiffness(const ReferenceCell& cell, CellOutput& out) {
    const int n = cell.nodes, size = cell.dofs(), last = cell.dimension * n;
    double* K = out.stiffness.data();
    for (int row = 0; row < size; ++row) {
        const int first = row < last ? (row / n + 1) * n : row + 1;   // blocks on the diagonal are full already
        for (int column = first; column < size; ++column)
            K[static_cast<std::size_t>(column) * size + row] = K[static_cast<std::size_t>(row) * size + column];
    }
}

}  // namespace soft::element::detail
