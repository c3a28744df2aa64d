// Viscoelasticity and softening of one point, against the formulas of their sources.
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "material/point_history.hpp"
#include "samples.hpp"

namespace soft::material {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

AnyRubber rubber_with(const Inelastic& inelastic, std::string_view law = "yeoh") {
    Description description = sample::description_of(law, std::nullopt);
    description.inelastic = inelastic;
    return make_rubber(description);
}

/// Uniaxial stretch of an incompressible rubber.
Tensor stretched(double l) { return {l, 0, 0, 0, 1 / std::sqrt(l), 0, 0, 0, 1 / std::sqrt(l)}; }

/// Nominal stress: the pressure removes the transverse one.
double nominal_Pa(const SymmetricTensor& S, double l) { return l * S[0] - S[1] / (l * l); }

double elastic_nominal_Pa(const AnyRubber& rubber, double l) {
    const Tensor P = std::visit([&](const auto& r) { return isochoric_stress(r, stretched(l), {}); }, rubber);
    return nominal_Pa(second_piola(stretched(l), P), l);
}

struct Point {
    AnyRubber rubber;
    std::vector<double> history = std::vector(history_size(*inelastic_of(rubber)), 0.0);
    double last_s = 0;

    PointStep move(double l, double dt_s) {
        std::vector<double> next(history.size());
        const auto coefficients = step_coefficients(*inelastic_of(rubber), dt_s);
        const PointStep step = advance(rubber, coefficients, {dt_s, last_s}, stretched(l), history, next);
        history = next;
        last_s = dt_s;
        return step;
    }
};

const Inelastic two_branches{{0.2, 0.1}, {0.5, 10}, false, {}};
const Inelastic softening{{}, {}, false, Softening{2, 1e4, 0.1}};

// Holzapfel (2000), 6.10: after a jump the nominal stress is P_inf (1 + sum g_i exp(-t/tau_i)), whatever the steps.
TEST(Inelastic, AStretchHeldRelaxesExactly) {
    for (const LawInfo& law : laws()) {
        if (law.bulk == Bulk::finite || law.fibers || law.name == "linear-elastic" ||
            law.name == "neo-hookean-compressible")
            continue;  // no isochoric energy, or fibres
        Point point{rubber_with(two_branches, law.name)};
        const double l = 1.4, P = elastic_nominal_Pa(point.rubber, l);
        EXPECT_NEAR(nominal_Pa(point.move(l, 0).stress, l), 1.3 * P, 1e-12 * P) << law.name;
        double t = 0;
        for (const double dt : {0.01, 0.3, 2.0, 0.5, 7.0}) {
            t += dt;
            const double expected = P * (1 + 0.2 * std::exp(-t / 0.5) + 0.1 * std::exp(-t / 10));
            EXPECT_NEAR(nominal_Pa(point.move(l, dt).stress, l), expected, 1e-12 * P) << law.name << ", " << t << " s";
        }
    }
}

// The same with constants measured in very fast loading.
TEST(Inelastic, InstantaneousConstantsDescribeTheJump) {
    Inelastic inelastic = two_branches;
    inelastic.instantaneous = true;
    Point point{rubber_with(inelastic)};
    const double P = elastic_nominal_Pa(point.rubber, 1.4);
    EXPECT_NEAR(nominal_Pa(point.move(1.4, 0).stress, 1.4), P, 1e-12 * P);
    EXPECT_NEAR(nominal_Pa(point.move(1.4, infinite).stress, 1.4), P / 1.3, 1e-12 * P);
}

/// Q of one branch for S(t) by Simpson's rule of the convolution, in the smooth history l = 1 + 0.2 sin^2(2 t).
double convolved_Pa(const AnyRubber& rubber, double t, const Inelastic& inelastic) {
    const auto stretch = [](double s) { return 1 + 0.2 * std::sin(2 * s) * std::sin(2 * s); };
    const auto S = [&](double s) {
        const double l = stretch(s);
        const Tensor P = std::visit([&](const auto& r) { return isochoric_stress(r, stretched(l), {}); }, rubber);
        return second_piola(stretched(l), P);
    };
    constexpr int intervals = 20000;
    SymmetricTensor sum = S(t);
    for (std::size_t i = 0; i < inelastic.moduli.size(); ++i)
        for (std::size_t c = 0; c < 2; ++c) {  // by parts: g [S(t) - int S exp(-(t - s)/tau) ds/tau]
            double integral = 0;
            for (int k = 0; k <= intervals; ++k) {
                const double s = t * k / intervals, weight = k == 0 || k == intervals ? 1 : k % 2 == 1 ? 4 : 2;
                integral += weight * S(s)[c] * std::exp(-(t - s) / inelastic.times_s[i]);
            }
            integral *= t / intervals / 3 / inelastic.times_s[i];
            sum[c] += inelastic.moduli[i] * (S(t)[c] - integral);
        }
    return nominal_Pa(sum, stretch(t));
}

TEST(Inelastic, StepsConvergeToTheConvolutionWithSecondOrder) {
    const Inelastic inelastic{{0.4, 0.3}, {0.2, 2}, false, {}};
    constexpr double end_s = 1.3;
    const double exact = convolved_Pa(rubber_with(inelastic), end_s, inelastic);
    const auto error = [&](int steps) {
        Point point{rubber_with(inelastic)};
        double found = 0;
        for (int k = 1; k <= steps; ++k) {
            const double t = end_s * k / steps, l = 1 + 0.2 * std::sin(2 * t) * std::sin(2 * t);
            found = nominal_Pa(point.move(l, end_s / steps).stress, l);
        }
        return std::abs(found - exact);
    };
    EXPECT_LT(error(80), 1e-3 * std::abs(exact));
    EXPECT_NEAR(error(80) / error(160), 4, 0.3);
    EXPECT_NEAR(error(160) / error(320), 4, 0.3);
}

// The estimate is that of a history with constant second derivative: halving the step reduces it to a quarter.
TEST(Inelastic, TheErrorOfAStepIsEstimated) {
    EXPECT_NEAR(step_coefficients({{1}, {2}, false, {}}, 0.02).error[0], 4 * 0.01 * 0.01 / 12, 1e-8);
    const double z = 0.3, tau = 0.7, e = std::exp(-z);
    const double per_step = tau * tau * (0.5 * z - 1 + (1 + 0.5 * z) * e);  // Taylor, Pister, Goudreau, see the header
    double accumulated = 0;
    for (int k = 0; k < 200; ++k) accumulated = accumulated * e + per_step;
    EXPECT_NEAR(step_coefficients({{1}, {tau}, false, {}}, z * tau).error[0], accumulated, 1e-12);
    EXPECT_EQ(step_coefficients({{1}, {tau}, false, {}}, infinite).error[0], 0);
}

// Ogden and Roxburgh: virgin loading is that of the law, unloading has the factor eta, and reloading retraces unloading.
TEST(Inelastic, SofteningFollowsTheFormula) {
    for (const char* law : {"yeoh", "ogden"}) {
        Point point{rubber_with(softening, law)};
        double W_max = 0;
        for (const double l : {1.2, 1.5, 1.3, 1.1, 1.4, 1.5, 1.7, 1.6, 1.0, 1.7}) {
            const double W = std::visit([&](const auto& r) { return isochoric_energy(r, stretched(l)); }, point.rubber);
            W_max = std::max(W, W_max);
            const double eta = 1 - std::erf((W_max - W) / (1e4 + 0.1 * W_max)) / 2;
            const double P = elastic_nominal_Pa(point.rubber, l);
            EXPECT_NEAR(nominal_Pa(point.move(l, 0).stress, l), eta * P, 1e-10 * std::abs(P) + 1e-9) << law << ' ' << l;
        }
    }
}

// Phi' = eta and Phi'' = d eta/dW; what unloading does not give back is dissipated.
TEST(Inelastic, TheSoftenedEnergyHasTheFactorAsDerivative) {
    const Softening law{1.7, 8e3, 0.2};
    constexpr double W_max = 3e4, h = 1;
    for (const double W : {2e3, 1e4, 2.5e4, 4e4}) {
        const auto [eta, slope] = law.slopes(W, W_max);
        EXPECT_NEAR((law.energy(W + h, W_max) - law.energy(W - h, W_max)) / (2 * h), eta, 1e-8);
        EXPECT_NEAR((law.slopes(W + h, W_max).eta - law.slopes(W - h, W_max).eta) / (2 * h), slope, 1e-12);
    }
    EXPECT_NEAR(law.energy(0, W_max), 0, 1e-9);
    EXPECT_NEAR(law.energy(W_max, W_max) + law.dissipated(W_max), W_max, 1e-9);
}

// A closed cycle dissipates the area of its loop, both effects together.
TEST(Inelastic, DissipationIsTheAreaOfTheLoop) {
    Inelastic both = two_branches;
    both.softening = softening.softening;
    Point point{rubber_with(both)};
    double work = 0, dissipated = 0, stress = 0, stretch = 1, stored = 0;
    constexpr int steps = 4000;
    for (int k = 1; k <= steps; ++k) {
        const double l = 1 + 0.5 * std::sin(std::numbers::pi * k / steps);
        const PointStep step = point.move(l, 1e-3);
        const double next = nominal_Pa(step.stress, l);
        work += 0.5 * (stress + next) * (l - stretch);
        dissipated += step.dissipated_J_m3;
        stored = step.stored_change_J_m3;
        stress = next;
        stretch = l;
    }
    EXPECT_NEAR(stored, 0, 1e-6 * work);
    EXPECT_NEAR(dissipated, work, 1e-4 * work);
}

TEST(Inelastic, ConstantsOutOfRangeAreRefused) {
    const auto refused = [](const Inelastic& inelastic, const char* law = "yeoh") {
        Description description = sample::description_of(law);
        description.inelastic = inelastic;
        try {
            static_cast<void>(make_rubber(description));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(refused({{0.1}, {1, 2}, false, {}}).find("viscoelastic.times"), std::string::npos);
    EXPECT_NE(refused({{-0.1}, {1}, false, {}}).find("viscoelastic.moduli"), std::string::npos);
    EXPECT_NE(refused({{0.1}, {0}, false, {}}).find("viscoelastic.times"), std::string::npos);
    EXPECT_NE(refused({{}, {}, false, Softening{1, 1e3, 0}}).find("softening.r"), std::string::npos);
    EXPECT_NE(refused({{}, {}, false, Softening{2, 0, 0}}).find("softening.m"), std::string::npos);
    EXPECT_NE(refused({{}, {}, false, Softening{2, 1, -1}}).find("softening.beta"), std::string::npos);
    EXPECT_NE(refused(two_branches, "kraken").find("isochoric"), std::string::npos);
    EXPECT_EQ(refused(two_branches), "");
}

}  // namespace
}  // namespace soft::material
