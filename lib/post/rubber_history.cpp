#include "post/rubber_history.hpp"

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "model/rubber.hpp"

namespace soft::post {

RubberHistory::RubberHistory(const model::Case& model, std::span<const model::Step> rows, std::vector<int> inside_steps,
                             Displacements displacements, bool has_all_rows)
    : model_(model),
      rows_(rows),
      inside_steps_(std::move(inside_steps)),
      displacements_(std::move(displacements)),
      has_all_rows_(has_all_rows) {
    if (!model::is_inelastic(model)) return;
    for (const std::string& region : model.mesh.region_names)
        regions_.push_back(
            {model::make_rubber(*std::ranges::find(model.materials, region, &model::Material::name)), nullptr, {}});
    for (Region& region : regions_) region.inelastic = material::inelastic_of(region.rubber);
    std::size_t size = 0;
    for (mesh::Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
        const auto type = model.mesh.cell_type(cell);
        if (!references_.contains(type)) {
            references_.emplace(type, fem::make_reference_cell(type, model.formulation));
            work_.try_emplace(type, references_.at(type));
        }
        const Region& region =
            regions_[static_cast<std::size_t>(model.mesh.cell_regions[static_cast<std::size_t>(cell)])];
        if (region.inelastic != nullptr)
            size += static_cast<std::size_t>(references_.at(type).points) * material::history_size(*region.inelastic);
    }
    history_.resize(size);
}

double RubberHistory::time_of(std::int64_t row) const {
    return rows_[static_cast<std::size_t>(row)].time_s.value_or(0);
}

void RubberHistory::set_step(double time_s) {
    const bool is_timed = model::is_timed(model_), is_slow = model_.path.modulus == model::Modulus::long_term;
    step_s_ = time_s - start_s_;
    const double dt = is_timed ? step_s_ : std::numeric_limits<double>::infinity();
    for (Region& region : regions_)
        if (region.inelastic != nullptr)
            region.step = is_timed || is_slow ? material::step_coefficients(*region.inelastic, dt)
                                              : material::instantaneous_coefficients(*region.inelastic);
}

std::vector<material::PointStep> RubberHistory::advance(std::span<const double> displacement_m, bool accept) {
    std::vector<material::PointStep> steps;
    std::vector<fem::PointState> points;
    std::vector<double> X, u, next;
    double* history = history_.data();
    for (mesh::Index cell = 0; cell < model_.mesh.cell_count(); ++cell) {
        const auto type = model_.mesh.cell_type(cell);
        const Region& region =
            regions_[static_cast<std::size_t>(model_.mesh.cell_regions[static_cast<std::size_t>(cell)])];
        const fem::ReferenceCell& reference = references_.at(type);
        if (region.inelastic == nullptr) {
            steps.resize(steps.size() + static_cast<std::size_t>(reference.points));
            continue;
        }
        const auto nodes = model_.mesh.cell_nodes(cell);
        X = mesh::by_component(model_.mesh.points, nodes, reference.dimension);
        u.clear();
        for (std::size_t i = 0; i < static_cast<std::size_t>(reference.dimension); ++i)
            for (const auto node : nodes) u.push_back(displacement_m[3 * static_cast<std::size_t>(node) + i]);
        points.clear();
        const std::vector<double> no_pressure(static_cast<std::size_t>(reference.pressure_dofs), 0.0);
        fem::sample_cell(reference, model_.kinematics, material::FiberFrame::cartesian, {X, u, no_pressure, 1.0},
                         work_.at(type), points);
        const std::size_t size = material::history_size(*region.inelastic);
        next.resize(size);
        for (const fem::PointState& point : points) {
            const std::span<double> values{history, size};
            steps.push_back(material::advance(region.rubber, region.step, {step_s_, 0.0}, point.F_law, values, next));
            if (accept) std::ranges::copy(next, values.begin());
            history += size;
        }
    }
    return steps;
}

std::vector<material::PointStep> RubberHistory::at_if_known(std::int64_t row, std::span<const double> displacement_m,
                                                            double time_s) {
    return is_known() ? at(row, displacement_m, time_s) : std::vector<material::PointStep>{};
}

std::vector<material::PointStep> RubberHistory::at(std::int64_t row, std::span<const double> displacement_m,
                                                   double time_s) {
    if (regions_.empty()) return {};
    const auto refuse = [](const std::string& problem, const char* remedy) {
        throw Error(ExitCode::bad_input, "/fields", problem, remedy);
    };
    if (model_.dynamics)
        refuse("the stress of inelastic rubber in a motion is not known: its rows are not its steps",
               "use stages with times on a static path, or plot the curve alone");
    if (row <= accepted_ && accepted_ > 0) {  // from the start again
        std::ranges::fill(history_, 0.0);
        accepted_ = 0;
        start_s_ = 0;
    }
    for (std::int64_t next = accepted_ + 1; next < row; ++next) {
        if (std::ranges::find(inside_steps_, next) != inside_steps_.end()) continue;
        const auto there = displacements_(next);
        if (!there)
            refuse("the stress of inelastic rubber depends on row " + std::to_string(next) +
                       ", whose fields are not stored",
                   "solve again with --fields all");
        set_step(time_of(next));
        static_cast<void>(advance(*there, true));
        accepted_ = next;
        start_s_ = time_of(next);
    }
    set_step(time_s);
    return advance(displacement_m, false);
}

}  // namespace soft::post
