#include "fit/given_law.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::fit {

Fit given_law(const std::string& law, const material::Constants& constants) {
    const bool has_terms = law == "ogden";
    const std::size_t terms = has_terms ? constants.at("mu").size() : 0;
    const Candidate* candidate = nullptr;  // the one with the most constants
    for (const Candidate& other : candidates())
        if (other.law == law && (!has_terms || static_cast<std::size_t>(other.linear) == terms)) candidate = &other;
    if (candidate == nullptr)
        throw Error(ExitCode::usage, "--elastic", "the law " + core::quoted(law) + " cannot be fitted",
                    "use one of those that --law names");
    Fit fit;
    fit.candidate = *candidate;
    fit.constants = constants;
    if (has_terms) {
        for (const char* name : {"mu", "alpha"})
            for (std::size_t k = 0; k < terms; ++k)
                fit.list.push_back(
                    {std::string{name} + " " + std::to_string(k + 1), constants.at(name)[k], 0, name[0] == 'm'});
        return fit;
    }
    const auto& parameters = material::find_law(law)->parameters;
    for (std::size_t i = 0; i < static_cast<std::size_t>(candidate->linear + candidate->shapes); ++i)
        fit.list.push_back({std::string{parameters[i].name}, constants.at(std::string{parameters[i].name}).front(), 0,
                            static_cast<int>(i) < candidate->linear});
    return fit;
}

}  // namespace soft::fit
