#include "sweep/plan.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "sweep/derivatives.hpp"
#include "sweep/sampling.hpp"

namespace soft::sweep {
namespace {

// More than any tolerance, fewer than the digits in which logarithms agree on all machines.
constexpr int significant_digits = 9;
constexpr std::size_t id_length = 16;
constexpr std::size_t max_file = std::size_t{4} << 30;  // bytes, the limit of a mesh file
constexpr std::string_view sensitivity_line = "# sensitivity: ";

std::string with_unit(const Range& range, double value) {
    return core::rounded_text(value, significant_digits) + (range.unit.empty() ? "" : " " + range.unit);
}

double between(const Range& range, double share) {
    if (range.scale != Scale::log) return range.low + share * (range.high - range.low);
    return std::exp(std::log(range.low) + share * (std::log(range.high) - std::log(range.low)));
}

std::string location_of(const Factor& factor, const std::string& value) {
    if (const auto* range = std::get_if<Range>(&factor.values))
        return value == range->to.text ? range->to.location : range->from.location;
    const auto& choices = std::get<Choices>(factor.values);
    const auto choice = std::ranges::find(choices, value, &SourceText::text);
    return choice == choices.end() ? factor.location : choice->location;
}

std::vector<design::Override> settings_of(const Sweep& sweep, const std::vector<std::string>& values) {
    std::vector<design::Override> settings = sweep.fixed;
    for (std::size_t f = 0; f < values.size(); ++f)
        settings.push_back({sweep.factors[f].path, values[f], location_of(sweep.factors[f], values[f])});
    return settings;
}

std::string design_id(std::string_view content, const PlanInput& input) {
    return core::sha256_hex(std::string{input.programs} + "\n" + std::string{content}).substr(0, id_length);
}

PlannedDesign planned(const Sweep& sweep, const PlanInput& input, std::vector<std::string> values) {
    std::vector<design::Override> settings = settings_of(sweep, values);
    PlannedDesign row;
    row.values = std::move(values);
    std::optional<std::string> refusal;
    try {
        design::Design design = design::read_design(input.design_text, input.design_source, input.families, settings);
        const std::string keys = sensitivity_keys(sweep, design.parameters),
                          head = keys.empty() ? "" : std::string{sensitivity_line} + keys + "\n";
        std::string content = head + design.effective_yaml;
        for (const std::string& file_key : design.values.file_keys()) {  // an absolute path, and the file's content
            const std::filesystem::path file =
                design::file_from(design.values.location(file_key), design.values.text(file_key));
            content += core::sha256_hex(core::read_regular_file(file, max_file));
            settings.push_back({file_key, std::filesystem::absolute(file).lexically_normal().string()});
            design = design::read_design(input.design_text, input.design_source, input.families, settings);
        }
        row.id = design_id(content, input);
        row.design_yaml = head + design.effective_yaml;
        row.geometry_refused = true;
        if (input.check_geometry) input.check_geometry(design);
        row.geometry_refused = false;
    } catch (const Error& error) {
        if (error.code() != ExitCode::bad_input) throw;
        refusal = error.what();
    }
    if (refusal) {
        row.design_yaml.clear();
        row.refusal = *refusal;
        std::string content{input.design_text};
        for (const design::Override& setting : settings)
            content.append("\n").append(setting.path).append("=").append(setting.value);
        row.id = design_id(content, input);
    }
    return row;
}

bool is_caused_by(const PlannedDesign& row, const SourceText& value) {
    return !row.geometry_refused && row.refusal.starts_with(value.location + ":");
}

/// Throws if all designs with a listed value are refused because of it: the error is in the sweep file, not in a design.
void check_choices(const Sweep& sweep, const Plan& plan) {
    for (std::size_t f = 0; f < sweep.factors.size(); ++f) {
        const auto* choices = std::get_if<Choices>(&sweep.factors[f].values);
        if (choices == nullptr) continue;
        for (const SourceText& choice : *choices) {
            const PlannedDesign* refused = nullptr;
            bool possible = false;
            for (const PlannedDesign& row : plan.designs) {
                if (row.values[f] != choice.text) continue;
                if (!is_caused_by(row, choice)) possible = true;
                if (refused == nullptr) refused = &row;
            }
            if (refused != nullptr && !possible) throw Error(ExitCode::bad_input, "", refused->refusal);
        }
    }
}

void check_range_ends(const Sweep& sweep, const PlanInput& input, const PlannedDesign& accepted) {
    for (std::size_t f = 0; f < sweep.factors.size(); ++f) {
        const auto* range = std::get_if<Range>(&sweep.factors[f].values);
        if (range == nullptr) continue;
        for (const SourceText& end : {range->from, range->to}) {
            std::vector<std::string> values = accepted.values;
            values[f] = end.text;
            const PlannedDesign row = planned(sweep, input, std::move(values));
            if (is_caused_by(row, end)) throw Error(ExitCode::bad_input, "", row.refusal);
        }
    }
}

/// Throws if no design has a number of `sensitivity`.
void check_sensitivity(const Sweep& sweep, const PlanInput& input, const Plan& plan, const PlannedDesign& accepted) {
    for (const SourceText& key : sweep.sensitivity) {
        const auto has_key = [&](const PlannedDesign& design) {
            const std::string line = design.design_yaml.substr(0, design.design_yaml.find('\n'));
            if (!line.starts_with(sensitivity_line)) return false;
            const std::vector<std::string> keys = core::split(line.substr(sensitivity_line.size()), ',');
            return std::ranges::find(keys, key.text) != keys.end();
        };
        if (std::ranges::any_of(plan.designs, has_key)) continue;
        std::vector<std::string> known{"all"};
        for (const auto& parameter :
             design::read_design(accepted.design_yaml, accepted.id, input.families, {}).parameters)
            known.push_back(parameter.key);
        throw Error(ExitCode::bad_input, key.location + ": sensitivity",
                    core::quoted(key.text) + " is not a number of the design that differs from 0",
                    core::did_you_mean(key.text, known));
    }
}

std::vector<std::vector<std::string>> grid_values(const Sweep& sweep) {
    std::vector<std::vector<std::string>> rows{{}};
    for (const Factor& factor : sweep.factors) {
        std::vector<std::vector<std::string>> extended;
        for (const auto& row : rows)
            for (int k = 0; k < level_count(factor); ++k) {
                extended.push_back(row);
                extended.back().push_back(level(factor, k));
            }
        rows = std::move(extended);
    }
    return rows;
}

}  // namespace

bool is_design_id(std::string_view id) noexcept {
    return id.size() == id_length && id.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string value_at(const Factor& factor, double u) {
    if (const auto* choices = std::get_if<Choices>(&factor.values))
        return (*choices)[static_cast<std::size_t>(u * static_cast<double>(choices->size()))].text;
    const Range& range = std::get<Range>(factor.values);
    if (range.scale == Scale::whole) return with_unit(range, range.low + std::floor(u * (range.high - range.low + 1)));
    return with_unit(range, between(range, u));
}

int level_count(const Factor& factor) {
    if (const auto* choices = std::get_if<Choices>(&factor.values)) return static_cast<int>(choices->size());
    return std::get<Range>(factor.values).steps;
}

std::string level(const Factor& factor, int k) {
    if (const auto* choices = std::get_if<Choices>(&factor.values)) return (*choices)[static_cast<std::size_t>(k)].text;
    const Range& range = std::get<Range>(factor.values);
    if (k == 0) return range.from.text;
    if (k == range.steps - 1) return range.to.text;
    const double value = between(range, static_cast<double>(k) / (range.steps - 1));
    return with_unit(range, range.scale == Scale::whole ? std::round(value) : value);
}

std::vector<std::vector<std::string>> sampled_values(const Sweep& sweep) {
    if (sweep.method == Method::grid) return grid_values(sweep);
    const SampleSize size{sweep.samples, static_cast<int>(sweep.factors.size())};
    const Points points =
        sweep.method == Method::random ? random_points(size, sweep.seed) : latin_hypercube(size, sweep.seed);
    std::vector<std::vector<std::string>> rows;
    for (const auto& point : points) {
        std::vector<std::string>& row = rows.emplace_back();
        for (std::size_t f = 0; f < point.size(); ++f) row.push_back(value_at(sweep.factors[f], point[f]));
    }
    return rows;
}

Plan make_plan(const Sweep& sweep, const PlanInput& input) {
    Plan plan;
    for (auto& values : sampled_values(sweep)) plan.designs.push_back(planned(sweep, input, std::move(values)));
    const auto accepted =
        std::ranges::find_if(plan.designs, [](const PlannedDesign& row) { return row.refusal.empty(); });
    if (accepted == plan.designs.end()) throw Error(ExitCode::bad_input, "", plan.designs.front().refusal);
    check_sensitivity(sweep, input, plan, *accepted);
    check_choices(sweep, plan);
    check_range_ends(sweep, input, *accepted);
    return plan;
}

std::string settings_text(const Sweep& sweep, const PlannedDesign& design) {
    std::string text;
    for (const design::Override& setting : settings_of(sweep, design.values))
        text.append(text.empty() ? "--set " : " --set ").append(core::shell_quoted(setting.path + "=" + setting.value));
    return text;
}

}  // namespace soft::sweep
