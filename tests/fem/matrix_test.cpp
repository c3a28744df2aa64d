/// Every law in every cell, form and kinematics is either verified or refused with a message.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "matrix.hpp"

namespace soft::fem {
namespace {

using material::AnyRubber;
using material::LawInfo;

/// Calls visit(sample, law) for every supported entry of the matrix.
template <class Visit>
void for_each_entry(Visit&& visit) {
    for (const LawInfo& law : material::laws()) {
        const AnyRubber rubber = rubber_of(law);
        for (const auto& c : all_combinations())
            if (material::explain_incompatibility(rubber, c.form).empty()) visit(Sample(c, rubber), law);
    }
}

std::string label(const Sample& sample, const LawInfo& law) {
    return std::string(law.name) + " in " + label(sample.combination);
}

/// remainder(h) falls by 4 when h is halved.
template <class Remainder>
void expect_second_order(Remainder&& remainder, const std::string& name) {
    EXPECT_NEAR(remainder(2e-3) / remainder(1e-3), 4.0, 0.1) << name;
}

// |E(x + h d) - E(x) - h R.d| = O(h^2).
TEST(LawElementMatrix, ResidualIsTheDerivativeOfTheEnergy) {
    for_each_entry([](const Sample& s, const LawInfo& law) {
        if (!material::has_symmetric_tangent(s.rubber)) return;  // no energy
        const auto d = s.direction();
        const double E = s.energy(s.unknowns), slope = inner_product(s.integrate(s.unknowns).residual, d);
        expect_second_order([&](double h) { return std::abs(s.energy(moved(s.unknowns, d, h)) - E - h * slope); },
                            label(s, law));
    });
}

// |R(x + h d) - R(x) - h K d| = O(h^2); of a linear law zero to rounding.
TEST(LawElementMatrix, TangentIsTheDerivativeOfTheResidual) {
    for_each_entry([](const Sample& s, const LawInfo& law) {
        const auto d = s.direction();
        const auto here = s.integrate(s.unknowns);
        const auto Kd = product(here.stiffness, d);
        const auto remainder = [&](double h) {
            auto r = s.integrate(moved(s.unknowns, d, h)).residual;
            for (std::size_t i = 0; i < r.size(); ++i) r[i] -= here.residual[i] + h * Kd[i];
            return norm(r);
        };
        if (law.name == "linear-elastic") {
            EXPECT_LT(remainder(0.05), 1e-11 * norm(Kd)) << label(s, law);
        } else {
            expect_second_order(remainder, label(s, law));
        }
    });
}

// Against central differences. The functions of a discontinuous pressure stay if the vertices do.
TEST(LawElementMatrix, ShapeGradientIsTheDerivativeByTheNodes) {
    for_each_entry([](const Sample& s, const LawInfo& law) {
        const bool turns = s.combination.kinematics != model::Kinematics::axisymmetric && material::fibers_of(s.rubber);
        if (s.combination.form == Form::f_bar || turns) return;
        const auto psi = s.direction();
        const int vertices =
            s.cell.pressure == PressureSpace::discontinuous_linear ? mesh::topology(s.cell.type).vertex_count : 0;
        std::vector<double> V(s.X.size(), 0.0);
        for (int i = 0; i < s.cell.dimension; ++i)
            for (int a = vertices; a < s.cell.nodes; ++a)
                V[static_cast<std::size_t>(i * s.cell.nodes + a)] = Sample::length * std::sin(1.0 + 2.3 * i + 1.9 * a);
        CellOutput out(s.cell);
        std::vector<std::vector<double>> shape;
        const std::vector<std::vector<double>> psis{psi};
        std::visit(
            [&](const auto& rubber) {
                find_shape_gradients(s.cell, s.combination.kinematics, rubber, s.input(s.unknowns), psis, out, shape);
            },
            s.rubber);
        const auto at = [&](double h) {
            Sample there = s;
            there.X = moved(s.X, V, h);
            return inner_product(there.integrate(s.unknowns).residual, psi);
        };
        constexpr double h = 1e-5;
        EXPECT_NEAR((at(h) - at(-h)) / (2 * h), inner_product(shape[0], V), 1e-7 * norm(shape[0]) * norm(V))
            << label(s, law);
    });
}

TEST(LawElementMatrix, TangentIsSymmetricExactlyForLawsWithAnEnergy) {
    for_each_entry([](const Sample& s, const LawInfo& law) {
        const auto K = s.integrate(s.unknowns).stiffness;
        const std::size_t n = s.unknowns.size();
        double largest = 0, difference = 0;
        for (const double k : K) largest = std::max(largest, std::abs(k));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j)
                difference = std::max(difference, std::abs(K[i * n + j] - K[j * n + i]));
        if (material::has_symmetric_tangent(s.rubber))
            EXPECT_LT(difference, 1e-12 * largest) << label(s, law);
        else
            EXPECT_GT(difference, 1e-3 * largest) << label(s, law);
    });
}

/// Every law with an isochoric energy, viscoelastic and softened, half of the points below their largest energy so far.
template <class Visit>
void for_each_inelastic_entry(Visit&& visit) {
    static const material::Inelastic inelastic{{0.5}, {1}, false, material::Softening{1.5, 1e4, 0.2}};
    for (const LawInfo& law : material::laws()) {
        auto description = material::sample::description_of(law.name);
        description.fiber_frame = material::FiberFrame::cylindrical;
        description.inelastic = inelastic;
        AnyRubber rubber;
        try {
            rubber = material::make_rubber(description);
        } catch (const Error&) {
            continue;  // no isochoric energy: material/inelastic_test
        }
        for (const auto& c : all_combinations()) {
            if (!material::explain_incompatibility(rubber, c.form).empty()) continue;
            Sample sample(c, rubber);
            sample.memory.factor = 1.3;
            sample.memory.softening = &*inelastic.softening;
            for (int q = 0; q < sample.cell.points; ++q) {
                sample.W_max.push_back(q % 2 == 0 ? 0.0 : 1e6);
                sample.overstress.push_back({1e3, -2e3, 3e3 * q, 5e2, 7e2, -4e2});
            }
            sample.memory.W_max = sample.W_max;
            sample.memory.overstress = sample.overstress;
            visit(sample, law);
        }
    }
}

TEST(InelasticElementMatrix, TangentIsTheSymmetricDerivativeOfTheResidual) {
    int entries = 0;
    for_each_inelastic_entry([&](const Sample& s, const LawInfo& law) {
        ++entries;
        const auto d = s.direction();
        const auto here = s.integrate(s.unknowns);
        const auto Kd = product(here.stiffness, d);
        expect_second_order(
            [&](double h) {
                auto r = s.integrate(moved(s.unknowns, d, h)).residual;
                for (std::size_t i = 0; i < r.size(); ++i) r[i] -= here.residual[i] + h * Kd[i];
                return norm(r);
            },
            label(s, law));
        const std::size_t n = s.unknowns.size();
        double largest = 0, difference = 0;
        for (const double k : here.stiffness) largest = std::max(largest, std::abs(k));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j)
                difference = std::max(difference, std::abs(here.stiffness[i * n + j] - here.stiffness[j * n + i]));
        EXPECT_LT(difference, 1e-12 * largest) << label(s, law);
    });
    EXPECT_GT(entries, 100);
}

/// A rigid motion: along x only for bodies of revolution; a translation only for linear elasticity.
std::vector<double> rigid_motion(const Sample& s, bool rotates) {
    const bool axisymmetric = s.combination.kinematics == model::Kinematics::axisymmetric;
    const double angle = rotates && !axisymmetric ? 0.9 : 0.0, cosine = std::cos(angle), sine = std::sin(angle);
    std::vector<double> u(s.unknowns.size(), 0.0);
    const int n = s.cell.nodes;
    for (int a = 0; a < n; ++a) {
        const double x = s.X[a], y = s.X[n + a];
        u[a] = cosine * x - sine * y - x + 0.2;
        u[n + a] = axisymmetric ? 0.0 : sine * x + cosine * y - y - 0.1;
        if (s.cell.dimension == 3) u[2 * n + a] = 0.7;
    }
    return u;
}

// kraken is excluded: it has the initial stress mu.
TEST(LawElementMatrix, RigidMotionGivesNoForce) {
    for_each_entry([](const Sample& s, const LawInfo& law) {
        if (!material::has_symmetric_tangent(s.rubber)) return;
        const auto out = s.integrate(rigid_motion(s, law.name != "linear-elastic"));
        double scale = 0;
        for (const double k : out.stiffness) scale = std::max(scale, std::abs(k));
        for (const double r : out.residual) EXPECT_NEAR(r, 0.0, 1e-13 * scale) << label(s, law);
        EXPECT_NEAR(out.min_jacobian, 1.0, 1e-12) << label(s, law);
    });
}

TEST(LawElementMatrix, AnInvertedCellIsReported) {
    for_each_entry([](const Sample& s, const LawInfo& law) {
        std::vector<double> mirrored(s.unknowns.size(), 0.0);
        for (int a = 0; a < s.cell.nodes; ++a) mirrored[a] = -2.0 * s.X[a];
        EXPECT_LT(s.integrate(mirrored).min_jacobian, 0.0) << label(s, law);
    });
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

// The rules: first-order cells have no stable pressure space, F-bar is for quad4 and hex8.
TEST(LawElementMatrix, CellsAreRefusedInUnsupportedForms) {
    for (const auto& c : every_combination()) {
        const auto& cell = mesh::topology(c.type);
        const bool has_mean_dilatation = c.type == mesh::CellType::quad4 || c.type == mesh::CellType::hex8;
        const std::string reason = model::explain_incompatibility(c.type, c.form);
        if (c.form == Form::mixed && cell.order == 1)
            EXPECT_TRUE(contains(reason, "have no stable pressure space; use mesh.order 2"))
                << label(c) << ": " << reason;
        else if (c.form == Form::f_bar && !has_mean_dilatation)
            EXPECT_TRUE(contains(reason, "F-bar is for first-order quadrilaterals and hexahedra"))
                << label(c) << reason;
        else
            EXPECT_EQ(reason, "") << label(c);
        if (reason.empty()) continue;
        EXPECT_TRUE(contains(reason, cell.name));
        try {
            (void)make_reference_cell(c.type, c.form);
            FAIL() << label(c) << " was not refused";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_TRUE(contains(error.what(), cell.name)) << error.what();
        }
    }
}

TEST(LawElementMatrix, LawsAreRefusedInUnsupportedForms) {
    for (const LawInfo& law : material::laws()) {
        const AnyRubber rubber = rubber_of(law);
        EXPECT_EQ(material::explain_incompatibility(rubber, Form::displacement), "") << law.name;
        const std::string mixed = material::explain_incompatibility(rubber, Form::mixed),
                          f_bar = material::explain_incompatibility(rubber, Form::f_bar);
        if (law.name == "kraken")
            EXPECT_TRUE(contains(mixed, "kraken is a stress without an energy and has no mixed form; use formulation"));
        else
            EXPECT_EQ(mixed, "") << law.name;
        if (law.name == "kraken" || law.name == "linear-elastic")
            EXPECT_TRUE(contains(f_bar, std::string(law.name) + " has no F-bar form; use formulation displacement"));
        else
            EXPECT_EQ(f_bar, "") << law.name;
    }
}

// Material and kernel agree on the laws supported in F-bar and mixed form; the kernel throws std::logic_error for the others.
TEST(LawElementMatrix, TheKernelAcceptsExactlyTheSupportedCombinations) {
    for (const LawInfo& law : material::laws())
        for (const auto& c : all_combinations()) {
            const Sample s(c, rubber_of(law));
            if (material::explain_incompatibility(s.rubber, c.form).empty())
                EXPECT_NO_THROW((void)s.integrate(s.unknowns)) << label(s, law);
            else
                EXPECT_THROW((void)s.integrate(s.unknowns), std::logic_error) << label(s, law);
        }
}

}  // namespace
}  // namespace soft::fem
