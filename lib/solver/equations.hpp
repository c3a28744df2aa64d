#pragma once
/// The equations of motion of a case (motion.hpp) at a state, for the integrators; internal to the module.
///   r = M a + C v + R(x, levels(t, p)),      C = mass_damping M + stiffness_damping K0
/// K0 is the displacement block of the undeformed tangent without contact. The pressure rows are not damped, so that an incompressible body
/// stays incompressible; for mixed cells K0 has no volumetric part (design/plausibility warns).
/// Lines: the gas behind the resistance of load k has mass m_k and pressure p_k = P(V_k(x), m_k);
///   dm_k/dt = rho (source_k(t) - p_k) / resistance_k.
/// Tested by solver/dynamics_test.
#include <span>
#include <vector>

#include "fem/mass.hpp"
#include "model/time_function.hpp"
#include "solver/stage_loads.hpp"

namespace soft::solver {

/// The state of the motion at one time.
struct MotionState {
    double time_s = 0;
    linalg::Vector x, v, a;         ///< v, a: 0 at pressure unknowns
    linalg::Vector load_force;      ///< of all loads at this time, without the push of obstacles
    std::vector<double> masses_kg;  ///< of the gas of each line, dead volume included
};

/// The dynamics settings of a case. Throws Error (bad_input) if it has none, or no positive duration.
[[nodiscard]] const model::Dynamics& dynamics_of(const model::Case& input);

[[nodiscard]] MotionState copy_of(const MotionState& state);

/// Fills `out` with entries between -1 and 1 without a pattern, which have a component along every mode.
void fill_with_waves(Vec out);

/// Levels with every time function at 1, obstacles not displaced; cavities with lines have the pressure of their source.
[[nodiscard]] fem::LoadLevels full_levels(const model::Case& input);
/// The shortest of the changes of all time functions (model/time_function.hpp).
[[nodiscard]] double shortest_change_s(const model::Case& input);

/// The supply lines of a case, k in the order of their loads; rho is the ambient density.
class SupplyLines {
public:
    /// Throws Error (bad_input) for a line without a cavity or resistance.
    explicit SupplyLines(fem::System& system);

    [[nodiscard]] std::size_t count() const noexcept { return lines_.size(); }
    [[nodiscard]] std::size_t load(std::size_t k) const { return lines_.at(k).load; }
    /// Of the gas in the undeformed body.
    [[nodiscard]] std::vector<double> masses_at_rest_kg() const;
    [[nodiscard]] double volume(std::size_t k, Vec x, Vec gradient) const;
    /// p = P(V, m) with its slopes by volume and mass.
    struct GasPressure {
        double value_Pa = 0, by_volume = 0, by_mass = 0;
    };
    [[nodiscard]] GasPressure pressure(std::size_t k, double volume_m3, double mass_kg) const;
    [[nodiscard]] std::vector<double> pressures(Vec x, std::span<const double> masses_kg) const;
    /// dm/dt [kg/s]; conductance is -d(dm/dt)/dp.
    [[nodiscard]] double flow(std::size_t k, double time_s, double pressure_Pa) const;
    [[nodiscard]] double conductance(std::size_t k) const;
    [[nodiscard]] std::vector<double> flows(double time_s, std::span<const double> pressures_Pa) const;
    /// Time derivative of the pressures behind the lines at a state.
    [[nodiscard]] std::vector<double> pressure_rates(const MotionState& state) const;

private:
    struct Line {
        std::size_t load;
        model::Gas gas;
        double source_Pa, resistance_Pa_s_m3;
    };
    fem::System& system_;
    std::vector<Line> lines_;
};

enum class MassKind { consistent, lumped };

class MotionEquations {
public:
    /// Throws Error (bad_input): see integrate_motion.
    MotionEquations(fem::System& system, MassKind kind);

    [[nodiscard]] MotionState rest() const;

    // Loads
    [[nodiscard]] fem::LoadLevels levels(double time_s, std::span<const double> line_pressures_Pa) const;
    /// d levels/dt; `line_rates`: of the pressures behind the lines [Pa/s].
    [[nodiscard]] fem::LoadLevels rates(double time_s, std::span<const double> line_rates) const;

    [[nodiscard]] const SupplyLines& lines() const noexcept { return lines_; }

    // Forces
    /// Fills residual() with R and load_force(); if K is given, also K with the tangent and line_force() (1 Pa in each line).
    [[nodiscard]] fem::Evaluation evaluate(Vec x, const fem::LoadLevels& levels, Mat K);
    [[nodiscard]] Vec residual() const { return R_; }
    [[nodiscard]] Vec load_force() const { return load_force_; }
    [[nodiscard]] Vec line_force(std::size_t k) const { return line_forces_.at(k); }
    void add_inertia(Vec out, double factor, Vec a) const;  ///< out += factor M a
    void add_damping(Vec out, double factor, Vec v) const;  ///< out += factor C v
    void add_matrices(Mat K, double by_velocity,
                      double by_acceleration) const;  ///< K += by_velocity C + by_acceleration M
    [[nodiscard]] bool has_damping() const noexcept {
        return dynamics_.mass_damping_1_s != 0.0 || dynamics_.stiffness_damping_s != 0.0;
    }
    [[nodiscard]] Vec lumped_mass() const { return lumped_; }
    [[nodiscard]] Vec mask() const { return mask_; }
    /// Euclidean norm of the displacement unknowns.
    [[nodiscard]] double displacement_norm(Vec x) const;
    [[nodiscard]] fem::System& system() const noexcept { return system_; }
    [[nodiscard]] const model::Dynamics& dynamics() const noexcept { return dynamics_; }

private:
    void make_damping();

    fem::System& system_;
    const model::Case& input_;
    const model::Dynamics& dynamics_;
    SupplyLines lines_;
    linalg::Matrix M_, K0_;  // M_ for consistent mass, K0_ for stiffness damping
    linalg::Vector lumped_, mask_, R_, load_force_, scratch_;
    std::vector<linalg::Vector> line_forces_;
};

/// Of the modelled part [J].
[[nodiscard]] double kinetic_energy(const MotionEquations& equations, Vec v);

}  // namespace soft::solver
