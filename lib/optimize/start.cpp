#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "optimize/goal.hpp"

namespace soft::optimize {

std::vector<double> start_of(Goal& goal, std::span<const design::Design> designs) {
    std::vector<double> values;
    for (std::size_t i = 0; i < goal.variables.size(); ++i) {
        Variable& variable = goal.variables[i];
        const std::string location = "vary." + variable.key;
        std::vector<std::string> known;
        const design::Design* first = nullptr;
        variable.is_whole = false;
        for (std::size_t run = 0; run < designs.size(); ++run) {
            const design::Design& design = designs[run];
            for (const model::DesignParameter& parameter : design.parameters) known.push_back(parameter.key);
            if (!design.values.has(variable.key)) continue;
            goal.runs[run].variables.push_back(i);
            const bool is_continuous = std::ranges::find(design.parameters, variable.key,
                                                         &model::DesignParameter::key) != design.parameters.end();
            if (!is_continuous && !std::holds_alternative<long>(core::parse_count(design.values.text(variable.key))))
                continue;
            if (first != nullptr) continue;
            first = &design;
            variable.is_whole = !is_continuous;
        }
        if (first == nullptr)
            throw Error(ExitCode::bad_input, location,
                        "is neither a number of the design that differs from 0 nor a count",
                        core::did_you_mean(variable.key, known));
        const auto is_round = [](double value) { return value == std::round(value); };
        if (variable.is_whole && (!variable.unit.empty() || !is_round(variable.from) || !is_round(variable.to)))
            throw Error(ExitCode::bad_input, location, "is a whole number", "write for example {from: 6, to: 14}");
        values.push_back(first->values.number(variable.key));
    }
    // A prior belongs to any run whose design has the variable.
    for (Condition& condition : goal.conditions)
        if (condition.is_data && condition.measure.kind == Measure::Kind::keys)
            for (std::size_t run = designs.size(); run-- > 0;)
                if (designs[run].values.has(condition.measure.terms.front().key)) condition.measure.run = run;
    return values;
}

}  // namespace soft::optimize
