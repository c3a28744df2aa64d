#include "post/step_fields.hpp"

#include <algorithm>
#include <concepts>
#include <map>
#include <string>
#include <variant>

#include "core/error.hpp"
#include "fem/solid_kernel.hpp"
#include "model/rubber.hpp"
#include "post/recovery.hpp"

namespace soft::post {

namespace {

using fem::PointState;
using fem::ReferenceCell;

/// sum += factor x part for all members of LocalState.
void add_scaled(LocalState& sum, double factor, const LocalState& part) {
    for (std::size_t i = 0; i < 9; ++i) {
        sum.deformation_gradient[i] += factor * part.deformation_gradient[i];
        sum.first_piola_Pa[i] += factor * part.first_piola_Pa[i];
        sum.cauchy_Pa[i] += factor * part.cauchy_Pa[i];
    }
    sum.jacobian += factor * part.jacobian;
    sum.energy_J_m3 += factor * part.energy_J_m3;
}

LocalState zero_state() {
    LocalState zero;
    zero.jacobian = 0;
    return zero;
}

template <class L>
LocalState local_state(const material::Rubber<L>& rubber, material::Form form, const PointState& point,
                       const material::PointStep* inelastic) {
    material::PointResponse response;
    if constexpr (material::StressLaw<L>) {
        material::displacement_response(rubber, point.axes, point.F_law, material::Wanted::stress, response);
    } else {
        if (form == material::Form::mixed)
            material::mixed_response(rubber, point.axes, point.F_law, point.p_Pa, material::Wanted::stress, response);
        else
            material::displacement_response(rubber, point.axes, point.F_law, material::Wanted::stress, response);
    }
    LocalState state;
    state.deformation_gradient = point.F;
    state.jacobian = determinant(point.F);
    state.energy_J_m3 = fem::energy_density(form, rubber, point);
    if constexpr (std::same_as<L, material::LinearElastic>) {
        state.first_piola_Pa = state.cauchy_Pa = response.first_piola;
        return state;
    }
    if (rubber.inelastic && inelastic != nullptr) {
        const Tensor elastic = material::isochoric_stress(rubber, point.F_law, {}),
                     whole = multiply(point.F_law, material::full(inelastic->stress));
        for (std::size_t m = 0; m < 9; ++m) response.first_piola[m] += whole[m] - elastic[m];
        state.energy_J_m3 += inelastic->stored_change_J_m3;
    }
    const double law_jacobian = determinant(point.F_law);
    const Tensor cofactor_F = cofactor(point.F);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t K = 0; K < 3; ++K)
                state.cauchy_Pa[3 * i + j] += response.first_piola[3 * i + K] * point.F_law[3 * j + K] / law_jacobian;
    state.first_piola_Pa = multiply(state.cauchy_Pa, cofactor_F);
    return state;
}

class Evaluator {
public:
    Evaluator(const model::Case& model, const RegionPoints& region_points, const NodalState& state)
        : model_(model), region_points_(region_points), state_(state), shared_(model.mesh.points.size(), false) {
        for (const std::string& region : model.mesh.region_names) {
            const auto material = std::ranges::find(model.materials, region, &model::Material::name);
            if (material == model.materials.end())
                throw Error(ExitCode::bad_input, "materials/" + region, "the region has no material");
            rubbers_.push_back(model::make_rubber(*material));
        }
        for (std::size_t k = 1; k < region_points.size(); ++k)
            if (region_points.node[k] == region_points.node[k - 1])
                shared_[static_cast<std::size_t>(region_points.node[k])] = true;
    }

    StepFields run() {
        StepFields out;
        out.first_point.push_back(0);
        out.nodes.assign(region_points_.size(), zero_state());
        std::vector<double> node_volumes(region_points_.size(), 0.0);
        for (mesh::Index cell = 0; cell < model_.mesh.cell_count(); ++cell) {
            const ReferenceCell& reference = reference_of(model_.mesh.cell_type(cell));
            const double volume = add_points(cell, reference, out);
            extrapolate_to_nodes(cell, reference, volume, out);
            for (const std::int32_t k : region_points_.of_cell(model_.mesh, cell))
                node_volumes[static_cast<std::size_t>(k)] += volume;
        }
        for (std::size_t k = 0; k < out.nodes.size(); ++k) {
            LocalState mean = zero_state();
            add_scaled(mean, 1.0 / node_volumes[k], out.nodes[k]);
            mean.energy_J_m3 = std::max(mean.energy_J_m3, 0.0);  // linear extrapolation can undershoot the minimum 0
            out.nodes[k] = mean;
        }
        return out;
    }

private:
    const ReferenceCell& reference_of(mesh::CellType type) {
        const auto found = references_.find(type);
        if (found != references_.end()) return found->second;
        return references_.emplace(type, fem::make_reference_cell(type, model_.formulation)).first->second;
    }

    /// Appends the cell's points and its mean; returns its reference volume.
    double add_points(mesh::Index cell, const ReferenceCell& reference, StepFields& out) {
        const auto& rubber =
            rubbers_[static_cast<std::size_t>(model_.mesh.cell_regions[static_cast<std::size_t>(cell)])];
        const auto frame = std::visit([](const auto& r) { return r.fiber_frame; }, rubber);
        samples_.clear();
        gather(cell, reference);
        fem::sample_cell(reference, model_.kinematics, frame, {X_, u_, p_, 1.0},
                         work_.try_emplace(reference.type, reference).first->second, samples_);
        LocalState mean = zero_state();
        double volume = 0;
        for (const PointState& sample : samples_) {
            if (!(determinant(sample.F) > 0.0))
                throw Error(ExitCode::bad_input, "/fields/displacement",
                            "cell " + std::to_string(cell) + " is inverted (det F <= 0)", "solve the case again");
            const auto* inelastic = state_.inelastic.empty() ? nullptr : &state_.inelastic[out.points.size()];
            out.points.push_back(std::visit(
                [&](const auto& r) { return local_state(r, model_.formulation, sample, inelastic); }, rubber));
            out.point_volumes_m3.push_back(sample.weight_m3);
            add_scaled(mean, sample.weight_m3, out.points.back());
            volume += sample.weight_m3;
        }
        out.first_point.push_back(out.points.size());
        out.cells.push_back(zero_state());
        add_scaled(out.cells.back(), 1.0 / volume, mean);
        return volume;
    }

    void gather(mesh::Index cell, const ReferenceCell& reference) {
        const auto nodes = model_.mesh.cell_nodes(cell);
        const std::size_t n = nodes.size();
        X_.resize(static_cast<std::size_t>(reference.displacement_dofs()));
        u_.resize(X_.size());
        for (std::size_t i = 0; i < static_cast<std::size_t>(reference.dimension); ++i)
            for (std::size_t a = 0; a < n; ++a) {
                X_[i * n + a] = model_.mesh.point(nodes[a])[i];
                u_[i * n + a] = state_.displacement_m[3 * static_cast<std::size_t>(nodes[a]) + i];
            }
        p_.clear();
        if (reference.pressure_dofs == 0) return;
        std::array<double, 27> pressure{};
        std::array<bool, 27> shared{};
        for (std::size_t a = 0; a < n; ++a) {
            pressure[a] = state_.pressure_Pa[static_cast<std::size_t>(nodes[a])];
            shared[a] = shared_[static_cast<std::size_t>(nodes[a])];
        }
        p_ = cell_pressure(reference, {X_, {pressure.data(), n}, {shared.data(), n}});
    }

    /// `cell` must be the one gathered last.
    void extrapolate_to_nodes(mesh::Index cell, const ReferenceCell& reference, double volume, StepFields& out) const {
        const auto points = static_cast<std::size_t>(reference.points);
        const std::vector<double> to_nodes = extrapolation(reference, X_);
        const auto* values = &out.points[out.points.size() - points];
        const auto nodes = region_points_.of_cell(model_.mesh, cell);
        for (std::size_t a = 0; a < nodes.size(); ++a)
            for (std::size_t q = 0; q < points; ++q)
                add_scaled(out.nodes[static_cast<std::size_t>(nodes[a])], volume * to_nodes[a * points + q], values[q]);
    }

    const model::Case& model_;
    const RegionPoints& region_points_;
    const NodalState& state_;
    std::vector<material::AnyRubber> rubbers_;  ///< one per region
    std::vector<bool> shared_;                  ///< [mesh point] belongs to several regions
    std::map<mesh::CellType, ReferenceCell> references_;
    std::map<mesh::CellType, fem::CellPoints> work_;
    std::vector<PointState> samples_;
    std::vector<double> X_, u_, p_;
};

void check(const model::Case& model, const NodalState& state) {
    const std::size_t points = model.mesh.points.size();
    if (state.displacement_m.size() != 3 * points)
        throw Error(ExitCode::bad_input, "/fields/displacement",
                    std::to_string(state.displacement_m.size()) + " values for " + std::to_string(points) + " points");
    const bool mixed = model.formulation == model::Formulation::mixed;
    if (state.pressure_Pa.size() != (mixed ? points : 0))
        throw Error(
            ExitCode::bad_input, "/fields/pressure",
            std::to_string(state.pressure_Pa.size()) + " values for " + std::to_string(mixed ? points : 0) + " points");
}

}  // namespace

StepFields step_fields(const model::Case& model, const RegionPoints& region_points, const NodalState& state) {
    check(model, state);
    StepFields fields = Evaluator(model, region_points, state).run();
    fields.stress_is_known = !model::is_inelastic(model) || !state.inelastic.empty();
    return fields;
}

bool has_energy(const model::Case& model) {
    return std::ranges::all_of(model.materials, [](const model::Material& material) {
        return material::has_symmetric_tangent(model::make_rubber(material));
    });
}

}  // namespace soft::post
