#include "solver/work.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mesh.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

namespace {

/// An energy that hardly changes over a step is compared to this fraction of itself.
constexpr double flat_energy = 0.1;
/// Halving a smooth interval reduces the error of its work to a sixteenth, at a kink to a half. A difference that does not fall is no
/// error of the quadrature.
constexpr double falling = 0.7;
constexpr int work_halvings = 7;
/// Of the larger of both energies: half of what ends a solve with an error (post/energy_balance.hpp).
constexpr double energy_jump = 0.005;
/// Mean displacement over the extent of the part below which rounding decides which fibres are taut.
constexpr double rounding_strain = 1e-10;

double stored_energy_of(fem::System& system, PathPoint& point) {
    if (!point.stored_J) {
        system.prescribe(point.levels);
        point.stored_J = system.fields().stored_energy(point.state.x);
    }
    return *point.stored_J;
}

/// Two points, the work of the loads between them, and its difference from the gain of stored energy.
struct WorkInterval {
    WorkInterval(fem::System& system, PathPoint& a, PathPoint& b) : from(a), to(b) {
        let_contact_rest(system, a, b);
        work_J = work_between(system, a, b, FromTangent::along_the_path);
        if (system.has_energy()) gain_J = stored_energy_of(system, b) - stored_energy_of(system, a);
    }
    PathPoint &from, &to;
    double work_J = 0, gain_J = 0;
    [[nodiscard]] double gap_J() const { return std::abs(work_J - gain_J); }
};

/// How much the work from one point to another may differ from the gain of stored energy on one equilibrium path; both energies are known.
double allowed_gap_J(Corrector& corrector, const PathPoint& from, const PathPoint& to) {
    return energy_jump * std::max({*from.stored_J, *to.stored_J, std::abs(*to.step_work_J)}) +
           corrector.newton().rounding_N() * distance(to.state.x, from.state.x);
}

/// Recursively bisects the interval at its equilibrium state in the middle.
double refined_work(Corrector& corrector, const Frame& frame, const WorkInterval& whole, double wanted_J,
                    int halvings_left) {
    const PathPoint &from = whole.from, &to = whole.to;
    if (!(whole.gap_J() > wanted_J) || halvings_left == 0 || !(std::abs(to.q - from.q) > 0.0)) return whole.work_J;
    auto middle = corrector.solve_between(frame, from, to, 0.5 * (from.q + to.q));
    if (!middle) return whole.work_J;
    const WorkInterval first(corrector.system(), whole.from, *middle), second(corrector.system(), *middle, whole.to);
    if (!(first.gap_J() + second.gap_J() < falling * whole.gap_J())) return whole.work_J;
    return refined_work(corrector, frame, first, 0.5 * wanted_J, halvings_left - 1) +
           refined_work(corrector, frame, second, 0.5 * wanted_J, halvings_left - 1);
}

}  // namespace

void find_work_of_step(Corrector& corrector, PathState& path, PathPoint& to) {
    fem::System& system = corrector.system();
    PathPoint& from = *path.last;
    const WorkInterval whole(system, from, to);
    to.step_work_J = whole.work_J;
    if (!system.has_energy()) return;
    const double size_J = std::max(std::abs(whole.gain_J), flat_energy * std::abs(*to.stored_J));
    const Corrector::Memory memory = corrector.memory();
    const double wanted_J = corrector.input().solver.step_accuracy * size_J;
    to.step_work_J = refined_work(corrector, frame_of(path), whole, wanted_J, work_halvings);
    corrector.restore(memory);
    const double left_J = *to.step_work_J - whole.gain_J;
    if (from.touches && to.touches && left_J > wanted_J) to.lost_J = left_J;
}

bool find_work_of_jump(Corrector& corrector, PathPoint& from, PathPoint& to) {
    fem::System& system = corrector.system();
    const linalg::Vector motion = copy_of(to.state.x);
    linalg::add(motion, -1.0, from.state.x);
    const fem::LoadLevels change = fem::moved(to.levels, -1.0, from.levels);
    let_contact_rest(system, from, to);
    to.step_work_J = 0.5 * (system.assembler().load_power(from.state.x, motion, from.levels, change) +
                            system.assembler().load_power(to.state.x, motion, to.levels, change));
    if (!system.has_energy()) return true;
    const double left_J = *to.step_work_J - (stored_energy_of(system, to) - stored_energy_of(system, from));
    to.lost_J = std::max(left_J, 0.0);
    return -left_J <= allowed_gap_J(corrector, from, to);
}

bool breaks_energy_balance(Corrector& corrector, PathState& path, PathPoint& to) {
    fem::System& system = corrector.system();
    const double mean_m = linalg::norm(to.state.x) / std::sqrt(static_cast<double>(system.dofs().total));
    if (!system.has_energy() || mean_m < rounding_strain * mesh::extent_m(system.input().mesh)) return false;
    find_work_of_step(corrector, path, to);
    if (to.lost_J > 0) return false;  // a snap sets energy free
    const double gap_J = *to.step_work_J - (*to.stored_J - *path.last->stored_J);
    return std::abs(gap_J) > allowed_gap_J(corrector, *path.last, to);
}

}  // namespace soft::solver
