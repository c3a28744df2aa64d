#pragma once
/// Helper of the consistency checks: the case, the name of its file, and error reporting. Internal to the module.
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/case_check.hpp"
#include "model/case.hpp"

namespace soft::io {

class Checker {
public:
    Checker(const model::Case& model, std::string_view source, ExitCode code)
        : case_(model), source_(source), code_(code) {}

    [[nodiscard]] const model::Case& model() const noexcept { return case_; }

    [[noreturn]] void refuse(const std::string& location, const std::string& problem) const {
        throw Error(code_, std::string{source_} + ":" + location, problem, "rebuild the case with mesh-gen");
    }
    void require(bool condition, const std::string& location, const std::string& problem) const {
        if (!condition) refuse(location, problem);
    }
    static std::string item(const std::string& list, std::size_t i) { return list + "[" + std::to_string(i) + "]"; }

    void require_finite(double value, const std::string& location) const {
        require(std::isfinite(value), location, "is not a finite number");
    }
    void require_positive(double value, const std::string& location) const {
        require(std::isfinite(value) && value > 0, location, "must be positive");
    }
    void require_name(const std::string& text, const std::string& location) const {
        require(is_name(text), location, core::quoted(text) + " is not a valid name (letters, digits, '_', '-', '.')");
    }
    void require_face(const std::string& face, const std::string& location) const {
        const auto found = case_.mesh.facet_sets.find(face);
        require(found != case_.mesh.facet_sets.end(), location, "there is no face named " + core::quoted(face));
        require(!found->second.empty(), location, "the face " + core::quoted(face) + " is empty");
    }
    void require_unit(const std::array<double, 3>& direction, const std::string& location) const {
        // mesh-gen writes directions with 16 digits. An error of 1e-6 in the length has no noticeable effect on forces.
        constexpr double unit_length_tolerance = 1e-6;
        const double length = std::hypot(direction[0], direction[1], direction[2]);
        require(std::abs(length - 1) <= unit_length_tolerance, location, "is not a unit vector");
    }
    template <class List, class NameOf>
    void require_unique(const List& list, const std::string& location, NameOf name_of_item) const {
        std::set<std::string> seen;
        for (const auto& entry : list) {
            const std::string& text = name_of_item(entry);
            require_name(text, item(location, seen.size()));
            if (!seen.insert(text).second) refuse(item(location, seen.size()), core::quoted(text) + " occurs twice");
        }
    }

private:
    const model::Case& case_;
    std::string_view source_;
    ExitCode code_;
};

/// Cavities, pressures, tractions, body forces, prescribed motions and outputs.
void check_loads(const Checker& check);
/// The time function of row `load` of the group `loads`.
void check_time_function(const Checker& check, const model::TimeFunction& time_function, const std::string& loads,
                         std::size_t load);
/// Stages and path settings.
void check_path(const Checker& check);
/// Settings of the solver and of the time integration; call after check_path.
void check_settings(const Checker& check);

}  // namespace soft::io
