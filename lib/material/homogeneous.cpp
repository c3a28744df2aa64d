#include "material/homogeneous.hpp"

#include <cmath>

#include "core/error.hpp"
#include "material/catalogue.hpp"
#include "material/response.hpp"

namespace soft::material {
namespace {

/// Enough halvings of a bracket with a width of 2 % to reach machine precision.
constexpr int max_halvings = 200;
/// The bracket is searched in steps of this factor, up to a factor of about 50 in both directions. No rubber is in equilibrium
/// beyond that.
constexpr double search_factor = 1.02;
constexpr int max_search_steps = 200;

Tensor gradient_of(Mode mode, double stretch, double lateral) {
    switch (mode) {
        case Mode::uniaxial: return {stretch, 0, 0, 0, lateral, 0, 0, 0, lateral};
        case Mode::equibiaxial: return {stretch, 0, 0, 0, stretch, 0, 0, 0, lateral};
        case Mode::planar: return {stretch, 0, 0, 0, 1, 0, 0, 0, lateral};
        case Mode::simple_shear: return {1, stretch, 0, 0, 1, 0, 0, 0, 1};
    }
    return identity_tensor;
}

/// The t for which Theta = 0.
template <class L>
double isochoric_lateral(const Rubber<L>&, Mode mode, double stretch) {
    if constexpr (std::same_as<L, LinearElastic>) {  // tr e = 0
        switch (mode) {
            case Mode::uniaxial: return 0.5 * (3.0 - stretch);
            case Mode::equibiaxial: return 3.0 - 2.0 * stretch;
            case Mode::planar: return 2.0 - stretch;
            case Mode::simple_shear: return 1.0;
        }
    }
    switch (mode) {
        case Mode::uniaxial: return 1.0 / std::sqrt(stretch);
        case Mode::equibiaxial: return 1.0 / (stretch * stretch);
        case Mode::planar: return 1.0 / stretch;
        case Mode::simple_shear: return 1.0;
    }
    return 1.0;
}

struct Lateral {
    double stress_Pa = 0;  ///< P_33
    double slope_Pa = 0;   ///< its derivative by t
};

template <class L>
Lateral lateral_stress(const Rubber<L>& rubber, Mode mode, double stretch, double lateral) {
    PointResponse point;
    displacement_response(rubber, {}, gradient_of(mode, stretch, lateral), Wanted::stress_and_tangent, point);
    const double along_2 = mode == Mode::uniaxial ? point.tangent[9 * 8 + 4] : 0.0;
    return {point.first_piola[8], point.tangent[9 * 8 + 8] + along_2};
}

/// Newton's method with bisection whenever an iterate leaves the bracket.
template <class L>
double root_between(const Rubber<L>& rubber, Mode mode, double stretch, double negative, double positive) {
    double t = 0.5 * (negative + positive);
    for (int i = 0; i < max_halvings; ++i) {
        const Lateral at = lateral_stress(rubber, mode, stretch, t);
        if (at.stress_Pa == 0.0) return t;
        (at.stress_Pa < 0.0 ? negative : positive) = t;
        double next = t - at.stress_Pa / at.slope_Pa;
        const bool inside = (next - negative) * (next - positive) < 0.0;
        if (!inside) next = 0.5 * (negative + positive);
        if (std::abs(next - t) <= 1e-16 * t) return next;
        t = next;
    }
    return t;
}

template <class L>
std::optional<double> free_lateral(const Rubber<L>& rubber, Mode mode, double stretch) {
    double start = isochoric_lateral(rubber, mode, stretch);
    if (!(start > 0.0)) start = 1.0;  // linear-elastic far outside its range of validity
    const double here = lateral_stress(rubber, mode, stretch, start).stress_Pa;
    if (here == 0.0) return start;
    for (int side : {here > 0.0 ? -1 : 1, here > 0.0 ? 1 : -1}) {  // tension is relieved by a smaller t
        double before = start;
        for (int i = 1; i <= max_search_steps; ++i) {
            const double t = start * std::pow(search_factor, side * i);
            const double stress = lateral_stress(rubber, mode, stretch, t).stress_Pa;
            if (!std::isfinite(stress)) break;
            if ((stress > 0.0) != (here > 0.0))
                return stress > 0.0 ? root_between(rubber, mode, stretch, before, t)
                                    : root_between(rubber, mode, stretch, t, before);
            before = t;
        }
    }
    return std::nullopt;
}

/// Adds p dTheta/dF such that P_33 = 0.
void remove_lateral_stress(PointResponse& point) {
    const double p = -point.first_piola[8] / point.dtheta_dF[8];
    for (std::size_t m = 0; m < 9; ++m) point.first_piola[m] += p * point.dtheta_dF[m];
    point.first_piola[8] = 0.0;
}

template <class L>
Tensor cauchy_of(const PointResponse& point, const Tensor& F) {
    if constexpr (std::same_as<L, LinearElastic>) return point.first_piola;
    Tensor sigma{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t K = 0; K < 3; ++K)
                sigma[3 * i + j] += point.first_piola[3 * i + K] * F[3 * j + K] / point.jacobian;
    return sigma;
}

template <class L>
std::optional<HomogeneousState> state_of(const Rubber<L>& rubber, Mode mode, double stretch) {
    const bool incompressible = rubber.inverse_bulk_modulus == 0.0;
    std::optional<double> lateral = isochoric_lateral(rubber, mode, stretch);
    if (!incompressible && mode != Mode::simple_shear) lateral = free_lateral(rubber, mode, stretch);
    if (!lateral) return std::nullopt;
    HomogeneousState state{.deformation_gradient = gradient_of(mode, stretch, *lateral), .lateral_stretch = *lateral};
    PointResponse point;
    if (incompressible) {
        mixed_response(rubber, {}, state.deformation_gradient, 0.0, Wanted::stress, point);
        remove_lateral_stress(point);
    } else {
        displacement_response(rubber, {}, state.deformation_gradient, Wanted::stress, point);
    }
    state.first_piola_Pa = point.first_piola;
    state.cauchy_Pa = cauchy_of<L>(point, state.deformation_gradient);
    if (!std::isfinite(state.cauchy_Pa[0]) || !std::isfinite(state.cauchy_Pa[1])) return std::nullopt;
    return state;
}

}  // namespace

std::optional<HomogeneousState> homogeneous_state(const AnyRubber& rubber, Mode mode, double stretch) {
    if (fibers_of(rubber))
        throw Error(ExitCode::bad_input, "law", std::string(info_of(rubber).name) + " with fibres is not isotropic",
                    "use a law without fibres for homogeneous states");
    return std::visit([&](const auto& r) { return state_of(r, mode, stretch); }, rubber);
}

double cauchy_stress_Pa(const HomogeneousState& state, Mode mode) {
    return state.cauchy_Pa[mode == Mode::simple_shear ? 1 : 0];
}

double nominal_stress_Pa(const HomogeneousState& state, Mode mode) {
    return state.first_piola_Pa[mode == Mode::simple_shear ? 1 : 0];
}

}  // namespace soft::material
