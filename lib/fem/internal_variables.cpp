#include "fem/internal_variables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace soft::fem {

namespace {

/// Relative to the shortest relaxation time: how far a trial state may lie before the state accepted last, for differences in time.
constexpr double backwards = 1e-2;
constexpr std::size_t header_size = 4;

}  // namespace

InternalVariables::InternalVariables(const Discretization& fe) : fe_(fe), index_(fe.groups.size(), -1) {
    const model::Case& input = fe.input;
    clock_ = model::runs_in_time(input)                            ? Clock::runs
             : input.path.modulus == model::Modulus::instantaneous ? Clock::is_infinitely_fast
                                                                   : Clock::is_infinitely_slow;
    for (std::size_t g = 0; g < fe.groups.size(); ++g) {
        const CellGroup& cells = fe.groups[g];
        const material::Inelastic* inelastic = material::inelastic_of(*cells.rubber);
        if (inelastic == nullptr) continue;
        const std::size_t size = material::history_size(*inelastic);
        index_[g] = static_cast<int>(groups_.size());
        const std::size_t points = cells.cells.size() * static_cast<std::size_t>(cells.reference->points);
        const std::vector virgin(points * size, 0.0);
        groups_.push_back({&cells, inelastic, size, {}, virgin, virgin, {}, {}});
        groups_.back().W_max.resize(inelastic->softening ? points : 0);
        groups_.back().overstress.resize(inelastic->moduli.empty() ? 0 : points);
    }
    for (const auto& rubber : fe.rubbers) {  // the same on every rank
        const material::Inelastic* inelastic = material::inelastic_of(rubber);
        if (inelastic == nullptr) continue;
        is_empty_ = false;
        soften_ = soften_ || inelastic->softening.has_value();
        for (std::size_t i = 0; i < inelastic->times_s.size(); ++i) {
            const double tau = inelastic->times_s[i];
            if (clock_ == Clock::runs && inelastic->moduli[i] > 0 && (shortest_time_s_ == 0 || tau < shortest_time_s_))
                shortest_time_s_ = tau;
        }
    }
    set_time(0.0);
}

void InternalVariables::set_time(double time_s) {
    time_s_ = time_s;
    step_s_ = time_s - start_s_;
    if (step_s_ < -backwards * shortest_time_s_) step_s_ = 0;
    const double dt = clock_ == Clock::runs ? step_s_ : std::numeric_limits<double>::infinity();
    if (prepared_for_s_ == dt) return;
    const bool has_new_values = !prepared_for_s_;
    prepared_for_s_ = dt;
    for (Group& group : groups_) {
        group.step = clock_ == Clock::is_infinitely_fast ? material::instantaneous_coefficients(*group.inelastic)
                                                         : material::step_coefficients(*group.inelastic, dt);
        const auto& values = std::as_const(group.values);
        for (std::size_t i = 0; i < group.overstress.size(); ++i)
            group.overstress[i] = material::overstress(*group.inelastic, group.step, at_point(values, group, i));
        for (std::size_t i = 0; has_new_values && i < group.W_max.size(); ++i)
            group.W_max[i] = (1.0 - margin_) * material::largest_energy(at_point(values, group, i));
    }
}

void InternalVariables::set_margin(double share) {
    margin_ = share;
    prepared_for_s_.reset();
    set_time(time_s_);
}

const InternalVariables::Group* InternalVariables::find(const CellGroup& group) const {
    const int index = index_[static_cast<std::size_t>(&group - fe_.groups.data())];
    return index < 0 ? nullptr : &groups_[static_cast<std::size_t>(index)];
}

std::size_t InternalVariables::index_of(const Group& group, const PointLocation& at) {
    return at.cell * static_cast<std::size_t>(group.cells->reference->points) + at.point;
}

bool InternalVariables::read(const CellGroup& cells, std::size_t cell, material::StepMemory& memory) const {
    const Group* group = is_empty_ ? nullptr : find(cells);
    if (group == nullptr) return false;
    const material::Inelastic& inelastic = *group->inelastic;
    const auto points = static_cast<std::size_t>(cells.reference->points);
    memory.factor = group->step.factor;
    memory.softening = inelastic.softening ? &*inelastic.softening : nullptr;
    const std::size_t first = index_of(*group, {cells, cell, 0});
    const auto of_cell = [&](const auto& list) {
        return list.empty() ? std::span(list) : std::span(list).subspan(first, points);
    };
    memory.W_max = of_cell(group->W_max);
    memory.overstress = of_cell(group->overstress);
    return true;
}

material::PointStep InternalVariables::step_at(const PointLocation& at, const PointState& point) {
    const Group* found = find(at.group);
    if (found == nullptr) return {};
    Group& group = groups_[static_cast<std::size_t>(found - groups_.data())];
    const std::size_t index = index_of(group, at);
    return material::advance(*at.group.rubber, group.step, {step_s_, last_step_s_}, point.F_law,
                             at_point(std::as_const(group.values), group, index), at_point(group.next, group, index));
}

void InternalVariables::accept(double dissipated_J) {
    MPI_Allreduce(MPI_IN_PLACE, &dissipated_J, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    dissipated_J_ += dissipated_J;
    for (Group& group : groups_) std::swap(group.values, group.next);
    ++accepted_;
    last_step_s_ = step_s_;
    start_s_ = time_s_;
    prepared_for_s_.reset();
    set_time(start_s_);
}

std::optional<double> InternalVariables::relative_error(double error2, double stress2) {
    largest_stress2_ = std::max(largest_stress2_, stress2);
    if (shortest_time_s_ == 0 || last_step_s_ == 0 || largest_stress2_ == 0) return std::nullopt;
    return std::sqrt(error2 / largest_stress2_);
}

std::vector<double> InternalVariables::gather() const {
    if (is_empty_) return {};
    std::vector<double> mine;
    if (fe_.rank == 0) mine = {start_s_, last_step_s_, dissipated_J_, largest_stress2_};
    for (const Group& group : groups_) mine.insert(mine.end(), group.values.begin(), group.values.end());
    int ranks = 1;
    MPI_Comm_size(fe_.comm, &ranks);
    const int count = static_cast<int>(mine.size());
    std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(counts.size(), 0);
    MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, fe_.comm);
    std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
    std::vector<double> all(fe_.rank == 0 ? static_cast<std::size_t>(starts.back() + counts.back()) : 0);
    MPI_Gatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, 0, fe_.comm);
    return all;
}

bool InternalVariables::restore(std::span<const double> values) {
    std::size_t own = 0;
    for (const Group& group : groups_) own += group.values.size();
    std::size_t before = 0, total = 0;
    MPI_Exscan(&own, &before, 1, MPI_UNSIGNED_LONG, MPI_SUM, fe_.comm);
    MPI_Allreduce(&own, &total, 1, MPI_UNSIGNED_LONG, MPI_SUM, fe_.comm);
    if (fe_.rank == 0) before = 0;
    if (values.size() != (total == 0 ? 0 : header_size + total)) return false;
    if (total == 0) return true;
    ++accepted_;
    start_s_ = values[0];
    last_step_s_ = values[1];
    dissipated_J_ = values[2];
    largest_stress2_ = values[3];
    auto from = values.begin() + static_cast<std::ptrdiff_t>(header_size + before);
    for (Group& group : groups_) {
        std::copy_n(from, group.values.size(), group.values.begin());
        from += static_cast<std::ptrdiff_t>(group.values.size());
    }
    prepared_for_s_.reset();
    set_time(start_s_);
    return true;
}

}  // namespace soft::fem
