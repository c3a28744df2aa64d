#pragma once
/// Names of enumerators in the file. Each table is used for reading and for writing.
#include <array>
#include <optional>
#include <string_view>

#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::io {

template <class Enum>
struct Named {
    Enum value;
    std::string_view name;
};
template <class Enum>
Named(Enum, std::string_view) -> Named<Enum>;  // clang 16 does not deduce aggregates

inline constexpr std::array kinematics_names{
    Named{model::Kinematics::axisymmetric, std::string_view{"axisymmetric"}},
    Named{model::Kinematics::plane_strain, std::string_view{"plane_strain"}},
    Named{model::Kinematics::solid, std::string_view{"solid"}},
};
inline constexpr std::array formulation_names{
    Named{model::Formulation::displacement, std::string_view{"displacement"}},
    Named{model::Formulation::mixed, std::string_view{"mixed"}},
    Named{model::Formulation::f_bar, std::string_view{"f_bar"}},
};
inline constexpr std::array volumetric_names{
    Named{model::Volumetric::quadratic, std::string_view{"quadratic"}},
    Named{model::Volumetric::log, std::string_view{"log"}},
    Named{model::Volumetric::mixed, std::string_view{"mixed"}},
};
inline constexpr std::array fiber_frame_names{
    Named{model::FiberFrame::cartesian, std::string_view{"cartesian"}},
    Named{model::FiberFrame::cylindrical, std::string_view{"cylindrical"}},
};
inline constexpr std::array control_names{
    Named{model::Control::automatic, std::string_view{"auto"}},
    Named{model::Control::pressure, std::string_view{"pressure"}},
    Named{model::Control::volume, std::string_view{"volume"}},
    Named{model::Control::displacement, std::string_view{"displacement"}},
    Named{model::Control::arc_length, std::string_view{"arc_length"}},
};
inline const auto measure_names = [] {
    std::array<Named<model::Measure>, model::all_measures.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = {model::all_measures[i], model::name_of(model::all_measures[i])};
    return names;
}();
inline constexpr std::array prescription_names{
    Named{model::Prescription::pressure, std::string_view{"pressure"}},
    Named{model::Prescription::volume, std::string_view{"volume"}},
    Named{model::Prescription::volume_ratio, std::string_view{"volume_ratio"}},
    Named{model::Prescription::mass, std::string_view{"mass"}},
    Named{model::Prescription::closed, std::string_view{"closed"}},
};
inline constexpr std::array branch_names{
    Named{model::Branch::stay, std::string_view{"stay"}},
    Named{model::Branch::follow, std::string_view{"follow"}},
};
inline constexpr std::array contact_names{
    Named{model::Contact::stop, std::string_view{"stop"}},
    Named{model::Contact::ignore, std::string_view{"ignore"}},
};
inline constexpr std::array strain_names{
    Named{model::Strain::finite, std::string_view{"finite"}},
    Named{model::Strain::small, std::string_view{"small"}},
};
inline constexpr std::array load_shape_names{
    Named{model::LoadShape::deformed, std::string_view{"deformed"}},
    Named{model::LoadShape::undeformed, std::string_view{"undeformed"}},
};
inline constexpr std::array time_function_names{
    Named{model::TimeFunctionKind::ramp, std::string_view{"ramp"}},
    Named{model::TimeFunctionKind::step, std::string_view{"step"}},
    Named{model::TimeFunctionKind::sine, std::string_view{"sine"}},
    Named{model::TimeFunctionKind::table, std::string_view{"table"}},
};
inline constexpr std::array newton_names{
    Named{model::NewtonMethod::full, std::string_view{"full"}},
    Named{model::NewtonMethod::modified, std::string_view{"modified"}},
    Named{model::NewtonMethod::bfgs, std::string_view{"bfgs"}},
};
inline constexpr std::array line_search_names{
    Named{model::LineSearch::backtracking, std::string_view{"backtracking"}},
    Named{model::LineSearch::secant, std::string_view{"secant"}},
    Named{model::LineSearch::none, std::string_view{"none"}},
};
inline constexpr std::array tangent_names{
    Named{model::TangentSource::exact, std::string_view{"exact"}},
    Named{model::TangentSource::finite_difference, std::string_view{"finite_difference"}},
};
inline constexpr std::array linear_names{
    Named{model::LinearMethod::automatic, std::string_view{"auto"}},
    Named{model::LinearMethod::mumps_ldlt, std::string_view{"mumps_ldlt"}},
    Named{model::LinearMethod::mumps_lu, std::string_view{"mumps_lu"}},
    Named{model::LinearMethod::superlu_dist, std::string_view{"superlu_dist"}},
    Named{model::LinearMethod::cholmod, std::string_view{"cholmod"}},
    Named{model::LinearMethod::krylov, std::string_view{"krylov"}},
    Named{model::LinearMethod::jacobian_free, std::string_view{"jacobian_free"}},
};
inline constexpr std::array preconditioner_names{
    Named{model::Preconditioner::lu, std::string_view{"lu"}},
    Named{model::Preconditioner::asm_lu, std::string_view{"asm_lu"}},
    Named{model::Preconditioner::asm_ilu, std::string_view{"asm_ilu"}},
    Named{model::Preconditioner::asm_boomeramg, std::string_view{"asm_boomeramg"}},
    Named{model::Preconditioner::boomeramg, std::string_view{"boomeramg"}},
    Named{model::Preconditioner::gamg, std::string_view{"gamg"}},
    Named{model::Preconditioner::multigrid, std::string_view{"multigrid"}},
    Named{model::Preconditioner::jacobi, std::string_view{"jacobi"}},
    Named{model::Preconditioner::none, std::string_view{"none"}},
};
inline constexpr std::array step_rule_names{
    Named{model::StepRule::error_adaptive, std::string_view{"error_adaptive"}},
    Named{model::StepRule::iteration_adaptive, std::string_view{"iteration_adaptive"}},
    Named{model::StepRule::constant, std::string_view{"constant"}},
};
inline constexpr std::array predictor_names{
    Named{model::Predictor::cubic, std::string_view{"cubic"}},
    Named{model::Predictor::tangent, std::string_view{"tangent"}},
    Named{model::Predictor::none, std::string_view{"none"}},
};
inline constexpr std::array integrator_names{
    Named{model::Integrator::generalized_alpha, std::string_view{"generalized_alpha"}},
    Named{model::Integrator::hht, std::string_view{"hht"}},
    Named{model::Integrator::newmark, std::string_view{"newmark"}},
    Named{model::Integrator::implicit_euler, std::string_view{"implicit_euler"}},
    Named{model::Integrator::ark4, std::string_view{"ark4"}},
    Named{model::Integrator::rosenbrock, std::string_view{"rosenbrock"}},
    Named{model::Integrator::heun, std::string_view{"heun"}},
    Named{model::Integrator::explicit_euler, std::string_view{"explicit_euler"}},
    Named{model::Integrator::central_difference, std::string_view{"central_difference"}},
};
inline constexpr std::array stop_reason_names{
    Named{model::StopReason::done, name(model::StopReason::done)},
    Named{model::StopReason::limit_point, name(model::StopReason::limit_point)},
    Named{model::StopReason::diverged, name(model::StopReason::diverged)},
    Named{model::StopReason::inverted_element, name(model::StopReason::inverted_element)},
    Named{model::StopReason::self_contact, name(model::StopReason::self_contact)},
    Named{model::StopReason::step_limit, name(model::StopReason::step_limit)},
};

template <class Enum, std::size_t count>
[[nodiscard]] constexpr std::string_view name_of(const std::array<Named<Enum>, count>& table, Enum value) {
    for (const auto& entry : table)
        if (entry.value == value) return entry.name;
    return {};
}

template <class Enum, std::size_t count>
[[nodiscard]] constexpr std::optional<Enum> value_of(const std::array<Named<Enum>, count>& table,
                                                     std::string_view word) {
    for (const auto& entry : table)
        if (entry.name == word) return entry.value;
    return std::nullopt;
}

}  // namespace soft::io
