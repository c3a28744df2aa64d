#include "fit/candidates.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <variant>

#include "core/error.hpp"
#include "fit/nominal.hpp"

namespace soft::fit {
namespace {

constexpr std::array table{Candidate{"neo-hookean", "neo-hookean", 1, 0, StableBy::signs},
                           Candidate{"mooney-rivlin-2", "mooney-rivlin", 2, 0, StableBy::signs},
                           Candidate{"mooney-rivlin-5", "mooney-rivlin", 5, 0},
                           Candidate{"yeoh", "yeoh", 3, 0, StableBy::signs},
                           Candidate{"yeoh-5", "yeoh", 4, 1, StableBy::signs},
                           Candidate{"ogden-1", "ogden", 1, 1, StableBy::signs},
                           Candidate{"ogden-2", "ogden", 2, 2, StableBy::signs},
                           Candidate{"ogden-3", "ogden", 3, 3, StableBy::signs},
                           Candidate{"ogden-4", "ogden", 4, 4, StableBy::signs},
                           Candidate{"gent", "gent", 1, 1, StableBy::signs},
                           Candidate{"arruda-boyce", "arruda-boyce", 1, 1, StableBy::signs}};

}  // namespace

std::span<const Candidate> candidates() { return table; }

const Candidate* find_candidate(std::string_view name) {
    if (name == "mooney-rivlin") name = "mooney-rivlin-2";
    if (name == "ogden") name = "ogden-3";
    const auto found = std::ranges::find(table, name, &Candidate::name);
    return found == table.end() ? nullptr : &*found;
}

material::Constants constants_of(const Candidate& candidate, std::span<const double> linear,
                                 std::span<const double> shapes) {
    material::Constants constants;
    if (candidate.law == "ogden") {
        for (std::size_t i = 0; i < linear.size(); ++i) constants["mu"].push_back(linear[i] / shapes[i]);
        constants["alpha"].assign(shapes.begin(), shapes.end());
        return constants;
    }
    const std::vector<material::Parameter>& parameters = material::find_law(candidate.law)->parameters;
    std::size_t next = 0;
    for (const double c : linear) constants[std::string{parameters[next++].name}] = {c};
    for (const double shape : shapes) constants[std::string{parameters[next++].name}] = {shape};
    return constants;
}

void add_stresses(const Candidate& candidate, const material::Constants& constants, const CurvePoints& points,
                  std::span<double> stress_Pa) {
    const auto add = [&]<class L>(const material::Rubber<L>& rubber) {
        if constexpr (material::InvariantLaw<L> || material::StretchLaw<L>)
            for (std::size_t i = 0; i < points.stretch.size(); ++i)
                stress_Pa[i] += nominal_stress_Pa(rubber.law, points.mode[i], points.stretch[i]);
        else
            throw std::logic_error("add_stresses: the law has no incompressible form");
    };
    std::visit(add, material::make_unchecked_rubber(candidate.law, constants));
}

std::optional<material::AnyRubber> rubber_of(const Candidate& candidate, const material::Constants& constants) {
    try {
        return material::make_rubber({.law = candidate.law, .constants = constants});
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace soft::fit
