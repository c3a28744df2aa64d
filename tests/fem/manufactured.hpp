#pragma once
/// Manufactured solutions at finite strain: a displacement u*(X) that vanishes on the boundary, the body force
/// B = -Div P(F*) per undeformed volume that equilibrates it, and the errors of the finite-element solution.
/// div P from the law's tangent and second derivatives of u*: dP/dX_M = A : dF/dX_M. In a body of revolution
/// (Div P)_x = P_xx,x + P_xr,r + P_xr/R and (Div P)_r = P_rx,x + P_rr,r + (P_rr - P_hoop)/R.
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "block_mesh.hpp"
#include "fem/system.hpp"
#include "linalg/linear_solver.hpp"
#include "math/dual.hpp"
#include "mesh/quadrature.hpp"

namespace soft::manufactured {

using Number = Dual<3>;

inline Number sine(const Number& a) { return Number::compose(a, std::sin(a.v), std::cos(a.v), -std::sin(a.v)); }

/// The bump sin^2(pi s), 0 with its slope at s = 0 and 1.
inline Number bump(const Number& s) {
    const Number w = sine(std::numbers::pi * s);
    return w * w;
}
/// Its slope / pi, sin(2 pi s).
inline Number wave(const Number& s) { return sine(2.0 * std::numbers::pi * s); }

/// general: products of sines, with a change of volume of some 20 %. isochoric: the flow of a stream function, J = 1 but for
/// a small given part, so that the pressure of a nearly incompressible rubber is of the order of its shear modulus.
enum class Flow { general, isochoric };

/// The field and the kinematics of the block.
struct Problem {
    model::Kinematics kinematics = model::Kinematics::solid;
    Flow flow = Flow::general;
};

/// In-plane displacement with J = 1 nearly: the implicit midpoint rule d = (psi_,y, -psi_,x) at X + d/2 keeps areas exactly
/// (Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), VI.4); four of its fixed-point steps to about 1e-5.
/// psi = a bump(x) bump(y). In a body of revolution the plane is (x, r^2/2), whose areas are volumes.
inline std::array<Number, 2> isochoric(model::Kinematics kinematics, double a, const std::array<Number, 3>& X,
                                       const Number& depth) {
    const bool axisymmetric = kinematics == model::Kinematics::axisymmetric;
    const Number across = axisymmetric ? 0.5 * X[1] * X[1] : X[1];
    Number dx = 0.0, dy = 0.0;
    for (int step = 0; step < 4; ++step) {
        const Number x = X[0] + 0.5 * dx, middle = across + 0.5 * dy;
        const Number r = axisymmetric ? sqrt(2.0 * middle) : Number(1.0), y = axisymmetric ? r - 1.0 : middle;
        dx = a * depth * bump(x) * wave(y) / r;
        dy = -a * depth * wave(x) * bump(y);
    }
    if (axisymmetric) dy = sqrt(2.0 * (across + dy)) - X[1];
    return {dx, dy};
}

/// u* on the unit block, [m]; the largest entry of grad u* is about 0.25.
inline std::array<Number, 3> displacement(const Problem& problem, const std::array<Number, 3>& X) {
    const bool solid = problem.kinematics == model::Kinematics::solid;
    const Number x = X[0], y = problem.kinematics == model::Kinematics::axisymmetric ? X[1] - 1.0 : X[1];
    const Number depth = solid ? sine(std::numbers::pi * X[2]) : Number(1.0);
    const Number arch = 0.08 * depth * sine(std::numbers::pi * x) * sine(std::numbers::pi * y);
    if (problem.flow == Flow::general) return {arch, -0.7 * arch, solid ? 0.4 * arch : Number(0.0)};
    const auto [ux, uy] = isochoric(problem.kinematics, 0.03, X, depth);
    return {ux, uy + 1e-3 * arch, solid ? 1e-3 * arch : Number(0.0)};
}

/// u*, F* and dF*/dX_M.
struct Field {
    std::array<double, 3> u{};
    Tensor F = identity_tensor;
    std::array<Tensor, 3> slope{};
};

inline Field field(const Problem& problem, const mesh::Point& X) {
    std::array<Number, 3> at;
    for (int i = 0; i < 3; ++i) at[i] = Number::variable(X[i], i);
    const auto u = displacement(problem, at);
    Field result;
    for (int i = 0; i < 3; ++i) {
        result.u[i] = u[i].v;
        for (int J = 0; J < 3; ++J) {
            result.F[3 * i + J] += u[i].g[J];
            for (int M = 0; M < 3; ++M) result.slope[M][3 * i + J] = u[i].hessian(J, M);
        }
    }
    if (problem.kinematics != model::Kinematics::axisymmetric) return result;
    const double R = X[1];
    result.F[8] = 1.0 + u[1].v / R;
    for (int M = 0; M < 2; ++M) result.slope[M][8] = u[1].g[M] / R - (M == 1 ? u[1].v / (R * R) : 0.0);
    return result;
}

inline std::array<double, 3> body_force(const material::AnyRubber& rubber, const Problem& problem,
                                        const mesh::Point& X) {
    const Field at = field(problem, X);
    material::PointResponse point;
    std::visit([&](const auto& r) { displacement_response(r, {}, at.F, material::Wanted::stress_and_tangent, point); },
               rubber);
    std::array<double, 3> B{};
    for (int i = 0; i < 3; ++i)
        for (int M = 0; M < 3; ++M)
            for (int n = 0; n < 9; ++n) B[i] -= point.tangent[9 * (3 * i + M) + n] * at.slope[M][n];
    if (problem.kinematics == model::Kinematics::axisymmetric) {
        B[0] -= point.first_piola[1] / X[1];
        B[1] -= (point.first_piola[4] - point.first_piola[8]) / X[1];
    }
    return B;
}

/// A quadrature point of a cell with the data of the integrals.
struct QuadraturePoint {
    mesh::Point X{};
    double volume = 0;                ///< 2 pi R included
    std::vector<double> N, gradient;  ///< [node], [direction x node + node]
};

/// Calls visit(cell, point) for every point of a rule two degrees higher than that of the elements.
template <class Visit>
void for_each_quadrature_point(const model::Case& input, Visit&& visit) {
    const auto& mesh = input.mesh;
    const int dim = mesh.dimension;
    QuadraturePoint point;
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto& type = mesh::topology(mesh.cell_type(cell));
        const bool tensor = type.shape == mesh::Shape::quadrilateral || type.shape == mesh::Shape::hexahedron;
        const auto nodes = mesh.cell_nodes(cell);
        for (const auto& [xi, weight] : mesh::quadrature(type.shape, tensor ? 7 : 5)) {
            const auto shapes = mesh::shape_values(type.type, xi);
            Tensor dX = identity_tensor;
            point.X = {};
            for (int i = 0; i < dim; ++i)
                for (int d = 0; d < dim; ++d) dX[3 * i + d] = 0;
            for (std::size_t a = 0; a < nodes.size(); ++a)
                for (int i = 0; i < dim; ++i) {
                    point.X[i] += shapes[a].value * mesh.point(nodes[a])[i];
                    for (int d = 0; d < dim; ++d) dX[3 * i + d] += shapes[a].gradient[d] * mesh.point(nodes[a])[i];
                }
            const double det = determinant(dX);
            const Tensor cof = cofactor(dX);
            point.volume = det * weight;
            if (input.kinematics == model::Kinematics::axisymmetric) point.volume *= 2 * std::numbers::pi * point.X[1];
            point.N.clear();
            point.gradient.assign(3 * nodes.size(), 0.0);
            for (std::size_t a = 0; a < nodes.size(); ++a) {
                point.N.push_back(shapes[a].value);
                for (int J = 0; J < dim; ++J)
                    for (int d = 0; d < dim; ++d)
                        point.gradient[J * nodes.size() + a] += cof[3 * J + d] * shapes[a].gradient[d] / det;
            }
            visit(cell, point);
        }
    }
}

/// Forces of the body force on the unknowns.
inline linalg::Vector force(const fem::System& system, const material::AnyRubber& rubber, Flow flow) {
    const auto& input = system.input();
    const int dim = input.mesh.dimension;
    auto f = system.make_vector();
    for_each_quadrature_point(input, [&](mesh::Index cell, const QuadraturePoint& point) {
        const auto B = body_force(rubber, {input.kinematics, flow}, point.X);
        const auto nodes = input.mesh.cell_nodes(cell);
        for (std::size_t a = 0; a < nodes.size(); ++a)
            for (int i = 0; i < dim; ++i)
                SOFT_PETSC(VecSetValue(f, system.dofs().displacement[nodes[a] * dim + i],
                                       point.volume * point.N[a] * B[i],
                                       ADD_VALUES));  // fixed components have index -1, which PETSc ignores
    });
    linalg::assemble(f);
    return f;
}

/// Far below the errors measured (1e-5), above the rounding of forces that cancel 1000-fold near incompressibility.
inline constexpr double converged = 1e-9;

/// Newton's method from the undeformed state with full steps.
inline linalg::Vector solve(fem::System& system, const material::AnyRubber& rubber, Flow flow) {
    auto x = system.make_vector(), R = system.make_vector(), step = system.make_vector();
    const auto f = force(system, rubber, flow);
    const auto K = system.make_matrix();
    linalg::LinearSolver solver(K);
    for (const double share : {0.5, 1.0})  // half the force first: a single step may invert a cell
        for (int iteration = 0;; ++iteration) {
            if (iteration == 12 || !system.evaluate(x, fem::no_loads(system.input()), R, K).admissible())
                throw std::runtime_error("manufactured::solve: Newton did not converge");
            linalg::add(R, -share, f);
            if (iteration > 0 && linalg::norm(R) < (share < 1.0 ? 1e-2 : converged) * linalg::norm(f)) break;
            if (!solver.factorize().succeeded || !solver.solve(R, step).converged)
                throw std::runtime_error("manufactured::solve: the stiffness is singular");
            linalg::add(x, -1.0, step);
        }
    return x;
}

struct Errors {
    double displacement = 0, gradient = 0, pressure = 0;  ///< L2 norms
};

/// The pressure in a cell is interpolated from its nodal values, which is exact in the pressure space.
inline Errors errors(const fem::System& system, const material::AnyRubber& rubber, Flow flow, Vec x) {
    const auto& input = system.input();
    const int dim = input.mesh.dimension;
    const PetscScalar* value = nullptr;
    SOFT_PETSC(VecGetArrayRead(x, &value));
    Errors sum;
    mesh::Index last = -1;
    std::vector<double> u, pressures;
    std::vector<PetscInt> dofs;
    fem::ReferenceCell reference;
    for_each_quadrature_point(input, [&](mesh::Index cell, const QuadraturePoint& point) {
        const auto nodes = input.mesh.cell_nodes(cell);
        const std::size_t n = nodes.size();
        if (cell != last) {
            last = cell;
            reference = fem::make_reference_cell(input.mesh.cell_type(cell), input.formulation);
            system.dofs().cell_dofs(input.mesh, cell, reference, dofs);
            u.assign(dim * n, 0.0);
            for (std::size_t m = 0; m < u.size(); ++m)
                if (dofs[m] >= 0) u[m] = value[dofs[m]];
            std::vector<double> X(dim * n), unknowns;
            for (int i = 0; i < dim; ++i)
                for (std::size_t a = 0; a < n; ++a) X[i * n + a] = input.mesh.point(nodes[a])[i];
            for (std::size_t m = u.size(); m < dofs.size(); ++m) unknowns.push_back(value[dofs[m]]);
            if (!unknowns.empty())
                pressures = fem::nodal_pressures(reference, X, unknowns, system.dofs().pressure_scale_Pa);
        }
        const Field exact = field({input.kinematics, flow}, point.X);
        for (int i = 0; i < dim; ++i) {
            double difference = -exact.u[i];
            for (std::size_t a = 0; a < n; ++a) difference += point.N[a] * u[i * n + a];
            sum.displacement += point.volume * difference * difference;
            for (int J = 0; J < dim; ++J) {
                double slope = (i == J ? 1.0 : 0.0) - exact.F[3 * i + J];
                for (std::size_t a = 0; a < n; ++a) slope += point.gradient[J * n + a] * u[i * n + a];
                sum.gradient += point.volume * slope * slope;
            }
        }
        if (reference.pressure_dofs == 0) return;
        const double kappa_Pa = material::bulk_modulus_Pa(rubber).value();
        double difference = -kappa_Pa * (determinant(exact.F) - 1.0);  // volumetric: quadratic
        for (std::size_t a = 0; a < n; ++a) difference += point.N[a] * pressures[a];
        sum.pressure += point.volume * difference * difference;
    });
    SOFT_PETSC(VecRestoreArrayRead(x, &value));
    return {std::sqrt(sum.displacement), std::sqrt(sum.gradient), std::sqrt(sum.pressure)};
}

}  // namespace soft::manufactured
