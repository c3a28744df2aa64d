#pragma once
/// Names of enumerators in the file. Each table is used for reading and for writing.
#include <array>
#include <optional>
#include <string_view>

#include "model/path.hpp"
#include "model/shape.hpp"

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
inline constexpr std::array fiber_frame_names{
    Named{model::FiberFrame::cartesian, std::string_view{"cartesian"}},
    Named{model::FiberFrame::cylindrical, std::string_view{"cylindrical"}},
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
