#include "fem/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linalg/rank_part.hpp"

namespace soft::fem {

namespace {

/// Of the size of a facet: pairs this close are expected to touch soon.
constexpr double nearly_in_contact = 0.2;

/// The unknowns of the displacement of an obstacle.
std::array<PetscInt, 3> dofs_of(const model::Case& input, const std::string& obstacle) {
    std::array<PetscInt, 3> dofs{-1, -1, -1};
    for (std::size_t m = 0; m < input.motions.size(); ++m)
        for (std::size_t i = 0; i < 3 && input.motions[m].face == obstacle; ++i)
            if (input.motions[m].displacement_m[i]) dofs[i] = -2 - static_cast<PetscInt>(3 * m + i);
    return dofs;
}

void sum_over_ranks(contact::Summary& summary, MPI_Comm comm, int rank) {
    const auto reduce = [comm](std::vector<double>& values, MPI_Op op) {
        MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, op, comm);
    };
    for (double* energy : {&summary.energy_J, &summary.dissipated_J})
        MPI_Allreduce(MPI_IN_PLACE, energy, 1, MPI_DOUBLE, MPI_SUM, comm);
    reduce(summary.area_m2, MPI_SUM);
    reduce(summary.pressure_Pa, MPI_MAX);
    struct {
        double value;
        int rank;
    } mine{summary.location ? summary.max_pressure_Pa : -1.0, rank}, largest{};
    MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm);
    if (largest.value < 0.0) return;
    summary.max_pressure_Pa = largest.value;
    mesh::Point location = summary.location.value_or(mesh::Point{});
    MPI_Bcast(location.data(), 3, MPI_DOUBLE, largest.rank, comm);
    MPI_Bcast(&summary.touched, 1, MPI_INT, largest.rank, comm);
    summary.location = location;
}

}  // namespace

Contact::Contact(const Discretization& fe, LocalState& state, contact::Potential& potential)
    : fe_(fe), state_(state), potential_(potential), positions_(fe.input.mesh.points) {
    for (const auto& obstacle : fe.input.obstacles) obstacle_dofs_.push_back(dofs_of(fe.input, obstacle.name));
    shifts_.resize(obstacle_dofs_.size());
}

void Contact::read_positions() {
    const auto dimension = static_cast<std::size_t>(fe_.dofs.dimension);
    for (const auto node : potential_.nodes())
        for (std::size_t i = 0; i < dimension; ++i) {
            const auto n = static_cast<std::size_t>(node);
            positions_[n][i] = fe_.input.mesh.points[n][i] + state_[fe_.dofs.displacement[n * dimension + i]];
        }
    for (std::size_t k = 0; k < shifts_.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i) shifts_[k][i] = state_[obstacle_dofs_[k][i]];
}

std::span<const Vector3> Contact::shifts(Vec x) {
    state_.read(x);
    read_positions();
    return shifts_;
}

contact::Summary Contact::evaluate(contact::Wanted wanted,
                                   const std::function<void(std::span<const PetscInt>, const contact::Block&)>& add) {
    if (rests_) return contact::Summary(shifts_.size());
    if (!potential_.is_empty()) read_positions();
    std::vector<PetscInt> dofs;
    auto summary = potential_.evaluate(
        positions_, shifts_, wanted, [this](mesh::Index cell) { return is_own(cell); },
        [&](const contact::Block& block) {
            dofs.clear();
            for (std::size_t i = 0; i < block.dimension; ++i) {
                for (const auto node : block.nodes)
                    dofs.push_back(fe_.dofs.displacement[static_cast<std::size_t>(node) * block.dimension + i]);
                if (block.obstacle >= 0) dofs.push_back(obstacle_dofs_[static_cast<std::size_t>(block.obstacle)][i]);
            }
            add(dofs, block);
        });
    sum_over_ranks(summary, fe_.comm, fe_.rank);
    return summary;
}

contact::Summary Contact::measure(Vec x) {
    state_.read(x);
    return evaluate(contact::Wanted::gradient, [](std::span<const PetscInt>, const contact::Block&) {});
}

bool Contact::touches(Vec x) {
    if (!rests_) return measure(x).touches();
    state_.read(x);
    if (!potential_.is_empty()) read_positions();
    int touches = potential_.touches(positions_, shifts_, [this](mesh::Index cell) { return is_own(cell); }) ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &touches, 1, MPI_INT, MPI_MAX, fe_.comm);
    return touches == 1;
}

void Contact::start_friction(Vec x) {
    if (!has_friction()) return;
    static_cast<void>(measure(x));
    static_cast<void>(potential_.start_friction(positions_, shifts_, potential_.friction_state(positions_, shifts_),
                                                [this](mesh::Index cell) { return is_own(cell); }));
}

bool Contact::start_friction(Vec x, std::span<const double> from) {
    constexpr std::size_t numbers = 7, head = 2;
    if (!has_friction()) return from.empty();
    if (from.size() % numbers != head || from[1] != static_cast<double>(potential_.sample_points())) return false;
    state_.read(x);
    read_positions();
    contact::FrictionState start{{}, fe_.rank == 0 ? from[0] : 0.0};
    for (std::size_t i = head; i < from.size(); i += numbers) {
        const auto n = from.subspan(i, numbers);
        if (std::ranges::any_of(n.first(2), [](double index) { return !(index >= 0 && index < 1e9); }) ||
            std::abs(n[2]) > 1e6)
            return false;
        start.slips.push_back({static_cast<std::size_t>(n[0]),
                               static_cast<std::size_t>(n[1]),
                               static_cast<int>(n[2]),
                               {n[3], n[4], n[5]},
                               n[6]});
    }
    return potential_.start_friction(positions_, shifts_, start, [this](mesh::Index cell) { return is_own(cell); });
}

std::vector<double> Contact::friction_start() const {
    if (!has_friction()) return {};
    const contact::FrictionState own = potential_.friction_start();
    std::vector<double> values;
    for (const auto& slip : own.slips) {
        values.insert(values.end(), {static_cast<double>(slip.facet), static_cast<double>(slip.point),
                                     static_cast<double>(slip.obstacle)});
        values.insert(values.end(), slip.elastic_m.begin(), slip.elastic_m.end());
        values.push_back(slip.limit_N);
    }
    double dissipated_J = own.dissipated_J;
    MPI_Allreduce(MPI_IN_PLACE, &dissipated_J, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    values = linalg::gather_all(values, MPI_DOUBLE, fe_.comm);
    values.insert(values.begin(), {dissipated_J, static_cast<double>(potential_.sample_points())});
    return values;
}

Contact::Motion Contact::motion(Vec from, const LoadLevels& levels, Vec to, const LoadLevels& levels_to) {
    state_.prescribe(levels);
    state_.read(from);
    read_positions();
    Motion motion{positions_, shifts_};
    state_.prescribe(levels_to);
    state_.read(to);
    read_positions();
    double largest = std::numeric_limits<double>::min();
    for (const auto node : potential_.nodes()) {
        const auto n = static_cast<std::size_t>(node);
        largest = std::max(largest, norm(difference(positions_[n], motion.positions[n])));
    }
    for (std::size_t k = 0; k < shifts_.size(); ++k)
        largest = std::max(largest, norm(difference(shifts_[k], motion.shifts[k])));
    motion.is_harmless = 2 * largest < potential_.harmless_step_m();
    return motion;
}

double Contact::share_without_crossing(Vec from, const LoadLevels& levels, Vec to, const LoadLevels& levels_to) {
    if (rests_ || potential_.is_empty()) return 1;
    const Motion of = motion(from, levels, to, levels_to);
    double share = of.is_harmless ? 1 : potential_.share_without_crossing(of.positions, of.shifts, positions_, shifts_);
    MPI_Allreduce(MPI_IN_PLACE, &share, 1, MPI_DOUBLE, MPI_MIN, fe_.comm);
    return share;
}

bool Contact::passes_through_obstacle(Vec from, const LoadLevels& levels, Vec to, const LoadLevels& levels_to) {
    if (fe_.input.obstacles.empty() || potential_.is_empty()) return false;
    const Motion of = motion(from, levels, to, levels_to);
    int passes = potential_.passes_through(of.positions, of.shifts, positions_, shifts_) ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &passes, 1, MPI_INT, MPI_MAX, fe_.comm);
    return passes == 1;
}

void Contact::couple(Vec x) {
    if (potential_.is_empty()) return;
    state_.read(x);
    couple();
}

void Contact::couple() {
    couplings_.clear();
    int acts = 0;
    static_cast<void>(
        evaluate(contact::Wanted::gradient, [&](std::span<const PetscInt>, const contact::Block&) { acts = 1; }));
    MPI_Allreduce(MPI_IN_PLACE, &acts, 1, MPI_INT, MPI_MAX, fe_.comm);
    if (acts == 1)
        for (const auto& [first, second] : potential_.near_pairs(positions_, shifts_, nearly_in_contact)) {
            auto nodes = mesh::facet_nodes(fe_.input.mesh, first);
            const auto others = mesh::facet_nodes(fe_.input.mesh, second);
            nodes.insert(nodes.end(), others.begin(), others.end());
            fe_.dofs.node_dofs(nodes, couplings_.emplace_back());
        }
}

}  // namespace soft::fem
