#include "principal_law.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace soft::verification {
namespace {

using PrincipalStress = std::function<Triple(const Triple&)>;

const std::vector<double>& list(const model::Material& material, const std::string& key) {
    return material.constants.at(key);
}
double value(const model::Material& material, const std::string& key, double fallback = 0) {
    const auto at = material.constants.find(key);
    return at == material.constants.end() || at->second.empty() ? fallback : at->second.front();
}

struct Slopes {
    double by_I1, by_I2;
};

/// W(I1, I2): l dI1/dl = 2 l^2, and with l1 l2 l3 = 1, I2 = sum l^-2, l dI2/dl = -2 l^-2.
PrincipalStress from_invariants(std::function<Slopes(double I1, double I2)> slopes) {
    return [slopes = std::move(slopes)](const Triple& l) {
        double I1 = 0, I2 = 0;
        for (const double li : l) {
            I1 += li * li;
            I2 += 1.0 / (li * li);
        }
        const auto [w1, w2] = slopes(I1, I2);
        Triple pull;
        for (std::size_t i = 0; i < 3; ++i) pull[i] = 2.0 * l[i] * l[i] * w1 - 2.0 / (l[i] * l[i]) * w2;
        return pull;
    };
}

/// Two families of fibres at plus and minus the angle from x towards y: their shear stresses cancel.
/// sigma_i = (2/J) families k1 (I4 - 1) exp(k2 (I4 - 1)^2) l_i^2 a_i^2, I4 = sum l_i^2 a_i^2 > 1.
void add_fibers(const model::Material& material, const Triple& l, double J, Triple& stress) {
    if (material.law != "holzapfel-gasser-ogden") return;
    const double angle = value(material, "angle"), k1 = value(material, "k1"), k2 = value(material, "k2");
    const Triple a{std::cos(angle), std::sin(angle), 0.0};
    double I4 = 0;
    for (std::size_t i = 0; i < 3; ++i) I4 += l[i] * l[i] * a[i] * a[i];
    if (I4 <= 1.0) return;
    const double slope = value(material, "families", 2) * k1 * (I4 - 1.0) * std::exp(k2 * (I4 - 1.0) * (I4 - 1.0));
    for (std::size_t i = 0; i < 3; ++i) stress[i] += 2.0 * slope * l[i] * l[i] * a[i] * a[i] / J;
}

/// dU/dJ of U = kappa/2 Theta^2, per kappa.
double volumetric_stress(model::Volumetric law, double J) {
    switch (law) {
        case model::Volumetric::quadratic: return J - 1.0;
        case model::Volumetric::log: return std::log(J) / J;
        case model::Volumetric::mixed: return 0.5 * (J - 1.0 / J);
    }
    return 0;
}

/// Arruda and Boyce (1993), five terms: dW/dI1 = C sum i a_i I1^(i-1) lm^(2-2i); over its value at I1 = 3.
double eight_chain_stiffening(double I1, double locking_stretch) {
    const auto slope = [&](double x) {
        const double q = x / (locking_stretch * locking_stretch);
        return 1.0 / 2.0 +
               q * (2.0 / 20.0 + q * (3.0 * 11.0 / 1050.0 + q * (4.0 * 19.0 / 7000.0 + q * 5.0 * 519.0 / 673750.0)));
    };
    return slope(I1) / slope(3.0);
}

struct Unknowns {
    std::vector<std::size_t> axes;  ///< axes with unknown stretch
    bool isochoric;                 ///< the third stretch then follows from the others
};

Triple stepped(Triple l, const Unknowns& unknowns, std::size_t which, double step) {
    l[unknowns.axes[which]] *= std::exp(step);
    if (unknowns.isochoric) l[2] = 1.0 / (l[0] * l[1]);
    return l;
}

/// Gaussian elimination with pivoting for one to three equations.
std::vector<double> solve(std::vector<std::vector<double>> A, std::vector<double> b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(A[i][k]) > std::abs(A[pivot][k])) pivot = i;
        std::swap(A[k], A[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double f = A[i][k] / A[k][k];
            for (std::size_t j = k; j < n; ++j) A[i][j] -= f * A[k][j];
            b[i] -= f * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) b[k] -= A[k][j] * b[j];
        b[k] /= A[k][k];
    }
    return b;
}

}  // namespace

PrincipalStress extra_stress_of(const model::Material& material) {
    const auto c = [&](const char* key) { return value(material, key); };
    if (material.law == "neo-hookean" || material.law == "holzapfel-gasser-ogden")
        return from_invariants([w1 = 0.5 * c("mu")](double, double) { return Slopes{w1, 0.0}; });
    if (material.law == "mooney-rivlin")
        return from_invariants(
            [c10 = c("c10"), c01 = c("c01"), c20 = c("c20"), c11 = c("c11"), c02 = c("c02")](double I1, double I2) {
                const double x = I1 - 3.0, y = I2 - 3.0;
                return Slopes{c10 + 2.0 * c20 * x + c11 * y, c01 + c11 * x + 2.0 * c02 * y};
            });
    if (material.law == "yeoh")
        return from_invariants([c1 = c("c1"), c2 = c("c2"), c3 = c("c3")](double I1, double) {
            const double x = I1 - 3.0;
            return Slopes{c1 + 2.0 * c2 * x + 3.0 * c3 * x * x, 0.0};
        });
    if (material.law == "gent")
        return from_invariants([mu = c("mu"), jm = c("jm")](double I1, double) {
            return Slopes{0.5 * mu * jm / (jm - (I1 - 3.0)), 0.0};
        });
    if (material.law == "arruda-boyce")  // mu is the initial modulus
        return from_invariants([mu = c("mu"), lock = c("locking_stretch")](double I1, double) {
            return Slopes{0.5 * mu * eight_chain_stiffening(I1, lock), 0.0};
        });
    if (material.law == "ogden")
        return [mu = list(material, "mu"), alpha = list(material, "alpha")](const Triple& l) {
            Triple pull{};
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t k = 0; k < mu.size(); ++k) pull[i] += mu[k] * std::pow(l[i], alpha[k]);
            return pull;
        };
    throw std::logic_error("no closed form in isochoric stretches for " + material.law);
}

PrincipalStress cauchy_of(const model::Material& material) {
    const double mu = value(material, "mu"), kappa = material.bulk_modulus_Pa.value();
    if (material.law == "kraken")
        return [=](const Triple& l) {
            const double volumetric = kappa * (l[0] * l[1] * l[2] - 1.0);
            return Triple{volumetric + mu * l[0] * l[0], volumetric + mu * l[1] * l[1], volumetric + mu * l[2] * l[2]};
        };
    if (material.law == "neo-hookean-compressible")
        return [=, law = material.volumetric](const Triple& l) {
            const double J = l[0] * l[1] * l[2];
            const double volumetric = (kappa - 2.0 * mu / 3.0) * volumetric_stress(law, J);
            Triple sigma;
            for (std::size_t i = 0; i < 3; ++i) sigma[i] = mu / J * (l[i] * l[i] - 1.0) + volumetric;
            return sigma;
        };
    if (material.law == "saint-venant-kirchhoff" || material.law == "linear-elastic")
        return [=, green = material.law == "saint-venant-kirchhoff"](const Triple& l) {
            Triple e, sigma;  // of the second Piola stress S = P / l in the Green strain, of P in the small one
            for (std::size_t i = 0; i < 3; ++i) e[i] = green ? 0.5 * (l[i] * l[i] - 1.0) : l[i] - 1.0;
            const double trace = e[0] + e[1] + e[2], J = l[0] * l[1] * l[2];
            for (std::size_t i = 0; i < 3; ++i)
                sigma[i] = (2.0 * mu * (e[i] - trace / 3.0) + kappa * trace) * (green ? l[i] * l[i] : l[i]) / J;
            return sigma;
        };
    return [=, extra_stress = extra_stress_of(material)](const Triple& l) {
        const double J = l[0] * l[1] * l[2], contraction = std::cbrt(1.0 / J);
        Triple sigma = extra_stress({contraction * l[0], contraction * l[1], contraction * l[2]});
        const double mean = (sigma[0] + sigma[1] + sigma[2]) / 3.0;
        for (double& s : sigma) s = (s - mean) / J + kappa * volumetric_stress(material.volumetric, J);
        add_fibers(material, l, J, sigma);
        return sigma;
    };
}

Triple stretches_at(const model::Material& material, const Prescribed& x, const Prescribed& y) {
    constexpr int ramp = 100, corrections = 50;
    constexpr double difference = 1e-6, enough = 1e-14;
    Unknowns unknowns{{}, !material.bulk_modulus_Pa};
    if (!x.fixed) unknowns.axes.push_back(0);
    if (!y.fixed) unknowns.axes.push_back(1);
    if (!unknowns.isochoric) unknowns.axes.push_back(2);
    const auto stress = unknowns.isochoric ? extra_stress_of(material) : cauchy_of(material);
    const auto residual = [&](const Triple& l, double factor) {
        Triple sigma = stress(l);
        if (unknowns.isochoric) {
            add_fibers(material, l, 1.0, sigma);
            for (const std::size_t i : {0, 1}) sigma[i] -= sigma[2];
        }
        const Triple wanted{factor * x.stress_Pa, factor * y.stress_Pa, 0.0};
        std::vector<double> r;
        for (const std::size_t axis : unknowns.axes) r.push_back(sigma[axis] - wanted[axis]);
        return r;
    };
    Triple l{1, 1, 1};
    const std::size_t n = unknowns.axes.size();
    for (int step = 1; step <= ramp; ++step)
        for (int i = 0; i < corrections; ++i) {
            const double factor = static_cast<double>(step) / ramp;
            std::vector<std::vector<double>> A(n, std::vector<double>(n));
            for (std::size_t k = 0; k < n; ++k) {
                const auto up = residual(stepped(l, unknowns, k, difference), factor);
                const auto down = residual(stepped(l, unknowns, k, -difference), factor);
                for (std::size_t j = 0; j < n; ++j) A[j][k] = (up[j] - down[j]) / (2.0 * difference);
            }
            const auto correction = solve(A, residual(l, factor));
            double size = 0;
            for (std::size_t k = 0; k < n; ++k) {
                l = stepped(l, unknowns, k, -correction[k]);
                size = std::max(size, std::abs(correction[k]));
            }
            if (size < enough) break;
        }
    return l;
}

}  // namespace soft::verification
