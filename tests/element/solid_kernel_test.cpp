#include "element/solid_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "distorted_cell.hpp"

namespace soft::element {
namespace {

using material::NeoHookean;
using material::Rubber;
using material::VolumetricLaw;
using material::Wanted;
using mesh::CellType;
using model::Kinematics;

constexpr double mu_Pa = 0.1644e6;
const Rubber<NeoHookean> rubber{{mu_Pa}, VolumetricLaw::quadratic, 1.0 / (100 * mu_Pa)};

struct Combination {
    CellType type;
    Kinematics kinematics;
    PressureChoice choice;
};

std::vector<Combination> all_combinations() {
    std::vector<Combination> list;
    for (const auto choice : {PressureChoice::mixed, PressureChoice::displacement_only}) {
        for (const auto type : {CellType::quad9, CellType::triangle6})
            for (const auto kinematics : {Kinematics::axisymmetric, Kinematics::plane_strain})
                list.push_back({type, kinematics, choice});
        for (const auto type : {CellType::hex27, CellType::tet10, CellType::wedge18})
            list.push_back({type, Kinematics::solid, choice});
    }
    return list;
}

std::string label(const Combination& c) {
    return std::string(mesh::topology(c.type).name) + (c.kinematics == Kinematics::axisymmetric ? " axisymmetric" : "") +
           (c.choice == PressureChoice::mixed ? " mixed" : " displacement");
}

/// A cell with unknowns to differentiate by.
struct Sample {
    ReferenceCell cell;
    std::vector<double> X, unknowns;
    explicit Sample(const Combination& c) : cell(make_reference_cell(c.type, c.choice)), X(distorted_nodes(c.type)) {
        unknowns = smooth_displacement(c.type, X, 1.0);
        for (int s = 0; s < cell.pressure_dofs; ++s) unknowns.push_back(0.3 + 0.1 * s);
    }
    [[nodiscard]] CellInput input(const std::vector<double>& values) const {
        const auto split = static_cast<std::size_t>(cell.displacement_dofs());
        return {X, {values.data(), split}, {values.data() + split, values.size() - split}, 1e5};
    }
    [[nodiscard]] CellOutput integrate(Kinematics kinematics, const std::vector<double>& values) const {
        CellOutput out(cell);
        integrate_cell(cell, kinematics, rubber, input(values), Wanted::stress_and_tangent, out);
        return out;
    }
    /// W integrated over the cell; its derivative is the residual.
    [[nodiscard]] double energy(Kinematics kinematics, const std::vector<double>& values) const {
        std::vector<PointState> points;
        sample_cell(cell, kinematics, input(values), points);
        double sum = 0;
        for (const auto& point : points) {
            const auto [I1, I2] = material::principal_invariants(point.F);
            const double J = determinant(point.F);
            sum += point.weight_m3 * (cell.pressure == PressureSpace::none
                                          ? material::displacement_energy(rubber, I1, I2, J)
                                          : material::mixed_energy(rubber, point.p_Pa, I1, I2, J));
        }
        return sum;
    }
};

std::vector<double> direction(std::size_t size) {
    std::vector<double> d(size);
    for (std::size_t i = 0; i < size; ++i) d[i] = std::sin(1.0 + 1.7 * static_cast<double>(i));
    return d;
}

std::vector<double> moved(std::vector<double> x, const std::vector<double>& d, std::size_t lengths, double h) {
    // Displacements are centimetres, pressure unknowns of order one.
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * (i < lengths ? 0.01 : 1.0) * d[i];
    return x;
}

double dot(const std::vector<double>& a, const std::vector<double>& b, std::size_t lengths) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i] * (i < lengths ? 0.01 : 1.0);
    return sum;
}

// |E(x + h d) - E(x) - h R.d| falls by 4 when h is halved.
TEST(SolidKernel, ResidualIsTheDerivativeOfTheEnergy) {
    for (const auto& c : all_combinations()) {
        const Sample s(c);
        const auto lengths = s.X.size();
        const auto d = direction(s.unknowns.size());
        const double E = s.energy(c.kinematics, s.unknowns);
        const double slope = dot(s.integrate(c.kinematics, s.unknowns).residual, d, lengths);
        const auto remainder = [&](double h) {
            return std::abs(s.energy(c.kinematics, moved(s.unknowns, d, lengths, h)) - E - h * slope);
        };
        EXPECT_NEAR(remainder(2e-3) / remainder(1e-3), 4.0, 0.1) << label(c);
    }
}

TEST(SolidKernel, TangentIsTheDerivativeOfTheResidual) {
    for (const auto& c : all_combinations()) {
        const Sample s(c);
        const auto lengths = s.X.size();
        const auto d = direction(s.unknowns.size());
        const auto here = s.integrate(c.kinematics, s.unknowns);
        const auto remainder = [&](double h) {
            const auto there = s.integrate(c.kinematics, moved(s.unknowns, d, lengths, h));
            double sum = 0;
            for (std::size_t i = 0; i < d.size(); ++i) {
                double linear = 0;
                for (std::size_t j = 0; j < d.size(); ++j)
                    linear += here.stiffness[i * d.size() + j] * d[j] * (j < lengths ? 0.01 : 1.0);
                const double r = there.residual[i] - here.residual[i] - h * linear;
                sum += r * r;
            }
            return std::sqrt(sum);
        };
        EXPECT_NEAR(remainder(2e-3) / remainder(1e-3), 4.0, 0.1) << label(c);
    }
}

TEST(SolidKernel, TangentIsSymmetric) {
    for (const auto& c : all_combinations()) {
        const Sample s(c);
        const auto K = s.integrate(c.kinematics, s.unknowns).stiffness;
        const std::size_t n = s.unknowns.size();
        double largest = 0;
        for (const double k : K) largest = std::max(largest, std::abs(k));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(K[i * n + j], K[j * n + i], 1e-12 * largest) << label(c);
    }
}

TEST(SolidKernel, RigidMotionGivesNoForce) {
    const double cosine = std::cos(0.9), sine = std::sin(0.9);
    for (const auto& c : all_combinations()) {
        Sample s(c);
        const int n = s.cell.nodes;
        for (int a = 0; a < n; ++a) {
            const double x = s.X[a], y = s.X[n + a];
            const bool axisymmetric = c.kinematics == Kinematics::axisymmetric;   // its only rigid motion is along x
            s.unknowns[a] = axisymmetric ? 0.3 : cosine * x - sine * y - x + 0.2;
            s.unknowns[n + a] = axisymmetric ? 0.0 : sine * x + cosine * y - y - 0.1;
            if (s.cell.dimension == 3) s.unknowns[2 * n + a] = 0.7;
        }
        for (int p = 0; p < s.cell.pressure_dofs; ++p) s.unknowns[s.X.size() + p] = 0;
        const auto out = s.integrate(c.kinematics, s.unknowns);
        double scale = 0;
        for (const double k : out.stiffness) scale = std::max(scale, std::abs(k));
        for (const double r : out.residual) EXPECT_NEAR(r, 0.0, 1e-13 * scale) << label(c);
        EXPECT_NEAR(out.min_jacobian, 1.0, 1e-13) << label(c);
    }
}

// A linear displacement field gives a constant F, exactly, on a curved and distorted cell.
TEST(SolidKernel, LinearDisplacementGivesItsConstantDeformationGradient) {
    constexpr Tensor G{0.20, 0.05, -0.03, 0.04, -0.10, 0.06, 0.02, -0.07, 0.15};
    for (const auto& c : all_combinations()) {
        Sample s(c);
        const int n = s.cell.nodes, dim = s.cell.dimension;
        const bool axisymmetric = c.kinematics == Kinematics::axisymmetric;
        for (int a = 0; a < n; ++a)
            for (int i = 0; i < dim; ++i) {
                double u = 0;
                for (int J = 0; J < dim; ++J)
                    if (!axisymmetric || i == J) u += G[3 * i + J] * s.X[J * n + a];
                s.unknowns[i * n + a] = u;
            }
        std::vector<PointState> points;
        sample_cell(s.cell, c.kinematics, s.input(s.unknowns), points);
        for (const auto& point : points) {
            for (int i = 0; i < dim; ++i)
                for (int J = 0; J < dim; ++J) {
                    const double expected = (i == J ? 1.0 : 0.0) + (axisymmetric && i != J ? 0.0 : G[3 * i + J]);
                    EXPECT_NEAR(point.F[3 * i + J], expected, 1e-13) << label(c);
                }
            const double across = axisymmetric ? 1.0 + G[4] : (dim == 2 ? 1.0 : point.F[8]);   // r/R = 1 + u_r/R
            EXPECT_NEAR(point.F[8], across, 1e-13) << label(c);
        }
    }
}

TEST(SolidKernel, ReportsAnInvertedCell) {
    for (const auto& c : all_combinations()) {
        Sample s(c);
        for (std::size_t i = 0; i < s.X.size() / s.cell.dimension; ++i) s.unknowns[i] = -2.0 * s.X[i];   // mirrored in x
        EXPECT_LT(s.integrate(c.kinematics, s.unknowns).min_jacobian, 0.0) << label(c);
    }
}

TEST(SolidKernel, NodalPressuresOfALinearFieldAreThatField) {
    for (const auto type : {CellType::quad9, CellType::tet10, CellType::hex27, CellType::wedge18}) {
        const auto cell = make_reference_cell(type, PressureChoice::mixed);
        const auto X = distorted_nodes(type);
        std::vector<double> unknowns(cell.pressure_dofs, cell.pressure == PressureSpace::continuous_vertex ? 2.5 : 0.0);
        unknowns[0] = 2.5;   // a constant field in either space
        for (const double p : nodal_pressures(cell, X, unknowns, 1e3)) EXPECT_NEAR(p, 2500.0, 1e-9);
    }
}

TEST(ReferenceCell, RefusesAnUnstablePairAndACellThatIsNoSolid) {
    EXPECT_THROW((void)make_reference_cell(CellType::tet4, PressureChoice::mixed), Error);
    EXPECT_THROW((void)make_reference_cell(CellType::line3, PressureChoice::mixed), Error);
}

}  // namespace
}  // namespace soft::element
