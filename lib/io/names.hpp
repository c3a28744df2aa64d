#pragma once
/// The words that stand for enumerators in the file: one table each, used in both directions.
#include <array>
#include <optional>
#include <string_view>

#include "model/case.hpp"
#include "solution/path.hpp"

namespace soft::io {

template <class Enum>
struct Named {
    Enum value;
    std::string_view name;
};

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
inline constexpr std::array measure_names{
    Named{model::Measure::displacement, std::string_view{"displacement"}},
    Named{model::Measure::bend, std::string_view{"bend"}},
    Named{model::Measure::twist, std::string_view{"twist"}},
};
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
inline constexpr std::array stop_reason_names{
    Named{solution::StopReason::done, name(solution::StopReason::done)},
    Named{solution::StopReason::limit_point, name(solution::StopReason::limit_point)},
    Named{solution::StopReason::diverged, name(solution::StopReason::diverged)},
    Named{solution::StopReason::inverted_element, name(solution::StopReason::inverted_element)},
    Named{solution::StopReason::self_contact, name(solution::StopReason::self_contact)},
    Named{solution::StopReason::step_limit, name(solution::StopReason::step_limit)},
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
