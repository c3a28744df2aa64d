#include "fit/candidates.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/error.hpp"
#include "fit/nominal.hpp"

namespace soft::fit {
namespace {

constexpr std::array table{Candidate{"neo-hookean", "neo-hookean", 1, 0},
                           Candidate{"mooney-rivlin-2", "mooney-rivlin", 2, 0},
                           Candidate{"mooney-rivlin-5", "mooney-rivlin", 5, 0},
                           Candidate{"yeoh", "yeoh", 3, 0},
                           Candidate{"yeoh-5", "yeoh", 4, 1},
                           Candidate{"ogden-1", "ogden", 1, 1},
                           Candidate{"ogden-2", "ogden", 2, 2},
                           Candidate{"ogden-3", "ogden", 3, 3},
                           Candidate{"ogden-4", "ogden", 4, 4},
                           Candidate{"gent", "gent", 1, 1},
                           Candidate{"arruda-boyce", "arruda-boyce", 1, 1}};

double value(const material::Constants& constants, std::string_view name) {
    const auto found = constants.find(name);
    return found == constants.end() ? 0.0 : found->second.front();
}

material::Ogden ogden_of(const material::Constants& constants) {
    const std::vector<double>&mu = constants.at("mu"), &alpha = constants.at("alpha");
    material::Ogden law;
    for (std::size_t i = 0; i < mu.size(); ++i, ++law.count) law.terms[i] = {mu[i], alpha[i]};
    return law;
}

template <class L>
void add(const L& law, const CurvePoints& points, std::span<double> stress_Pa) {
    for (std::size_t i = 0; i < points.stretch.size(); ++i)
        stress_Pa[i] += nominal_stress_Pa(law, points.mode[i], points.stretch[i]);
}

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
    const auto c = [&](std::string_view name) { return value(constants, name); };
    if (candidate.law == "neo-hookean") return add(material::NeoHookean{c("mu")}, points, stress_Pa);
    if (candidate.law == "mooney-rivlin")
        return add(material::MooneyRivlin{c("c10"), c("c01"), c("c20"), c("c11"), c("c02")}, points, stress_Pa);
    if (candidate.law == "yeoh")
        return add(material::Yeoh{c("c1"), c("c2"), c("c3"), c("a"), c("b")}, points, stress_Pa);
    if (candidate.law == "gent") return add(material::Gent{c("mu"), c("jm")}, points, stress_Pa);
    if (candidate.law == "arruda-boyce")
        return add(material::ArrudaBoyce{c("mu"), c("locking_stretch")}, points, stress_Pa);
    if (candidate.law != "ogden") throw std::logic_error("no stress of the law " + std::string{candidate.law});
    add(ogden_of(constants), points, stress_Pa);
}

std::optional<material::AnyRubber> rubber_of(const Candidate& candidate, const material::Constants& constants) {
    try {
        return material::make_rubber({.law = candidate.law, .constants = constants});
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace soft::fit
