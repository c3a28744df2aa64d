#include "sweep/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "sweep/sampling.hpp"

namespace soft::sweep {
namespace {

constexpr int digits = 9;  // more than any dimension is known to, fewer than logarithms agree on everywhere
constexpr std::size_t id_length = 16;
constexpr std::size_t max_file = std::size_t{4} << 30;  // bytes, that of a mesh
constexpr std::array file_keys{"geometry.file", "geometry.profile"};

std::string number_of(const Range& range, double value) {
    return core::rounded_text(value, digits) + (range.unit.empty() ? "" : " " + range.unit);
}

double between(const Range& range, double share) {
    if (range.scale != Scale::log) return range.low + share * (range.high - range.low);
    return std::exp(std::log(range.low) + share * (std::log(range.high) - std::log(range.low)));
}

std::string location_of(const Factor& factor, const std::string& value) {
    if (const auto* range = std::get_if<Range>(&factor.values))
        return value == range->to.text ? range->to.place : range->from.place;
    const auto& choices = std::get<Choices>(factor.values);
    const auto choice = std::ranges::find(choices, value, &Written::text);
    return choice == choices.end() ? factor.place : choice->place;
}

std::vector<design::Override> settings_of(const Sweep& sweep, const std::vector<std::string>& values) {
    std::vector<design::Override> settings = sweep.fixed;
    for (std::size_t f = 0; f < values.size(); ++f)
        settings.push_back({sweep.factors[f].path, values[f], location_of(sweep.factors[f], values[f])});
    return settings;
}

std::string address(std::string_view content, const Basis& basis) {
    return core::sha256_hex(std::string{basis.programs} + "\n" + std::string{content}).substr(0, id_length);
}

Planned planned(const Sweep& sweep, const Basis& basis, std::vector<std::string> values) {
    std::vector<design::Override> settings = settings_of(sweep, values);
    Planned row;
    row.values = std::move(values);
    std::optional<std::string> refusal;
    try {
        design::Design design = design::read_design(basis.design_text, basis.design_source, basis.families, settings);
        std::string content = design.effective_yaml;
        for (const char* file_key : file_keys) {  // it is to be found from any folder, and to count by what is in it
            if (!design.values.has(file_key)) continue;
            if (design.values.text(file_key).find('\n') != std::string::npos) continue;  // the content itself
            const std::filesystem::path file =
                design::file_from(design.values.place(file_key), design.values.text(file_key));
            content += core::sha256_hex(core::read_regular_file(file, max_file));
            settings.push_back({file_key, std::filesystem::absolute(file).lexically_normal().string()});
            design = design::read_design(basis.design_text, basis.design_source, basis.families, settings);
        }
        row.id = address(content, basis);
        row.design_yaml = std::move(design.effective_yaml);
        row.geometry_refused = true;
        if (basis.check_geometry) basis.check_geometry(design);
        row.geometry_refused = false;
    } catch (const Error& error) {
        if (error.code() != ExitCode::bad_input) throw;
        refusal = error.what();
    }
    if (refusal) {
        row.design_yaml.clear();
        row.refusal = *refusal;
        std::string content{basis.design_text};
        for (const design::Override& setting : settings)
            content.append("\n").append(setting.path).append("=").append(setting.value);
        row.id = address(content, basis);
    }
    return row;
}

bool is_about(const Planned& row, const Written& value) {
    return !row.geometry_refused && row.refusal.starts_with(value.place + ":");
}

/// A value that no design can have is a fault of the file, not of a design.
void check_choices(const Sweep& sweep, const Plan& plan) {
    for (std::size_t f = 0; f < sweep.factors.size(); ++f) {
        const auto* choices = std::get_if<Choices>(&sweep.factors[f].values);
        if (choices == nullptr) continue;
        for (const Written& choice : *choices) {
            const Planned* refused = nullptr;
            bool possible = false;
            for (const Planned& row : plan.designs) {
                if (row.values[f] != choice.text) continue;
                if (!is_about(row, choice)) possible = true;
                if (refused == nullptr) refused = &row;
            }
            if (refused != nullptr && !possible) throw Error(ExitCode::bad_input, "", refused->refusal);
        }
    }
}

void check_ends(const Sweep& sweep, const Basis& basis, const Planned& sound) {
    for (std::size_t f = 0; f < sweep.factors.size(); ++f) {
        const auto* range = std::get_if<Range>(&sweep.factors[f].values);
        if (range == nullptr) continue;
        for (const Written& end : {range->from, range->to}) {
            std::vector<std::string> values = sound.values;
            values[f] = end.text;
            const Planned row = planned(sweep, basis, std::move(values));
            if (is_about(row, end)) throw Error(ExitCode::bad_input, "", row.refusal);
        }
    }
}

std::vector<std::vector<std::string>> grid_values(const Sweep& sweep) {
    std::vector<std::vector<std::string>> rows{{}};
    for (const Factor& factor : sweep.factors) {
        std::vector<std::vector<std::string>> longer;
        for (const auto& row : rows)
            for (int k = 0; k < level_count(factor); ++k) {
                longer.push_back(row);
                longer.back().push_back(level(factor, k));
            }
        rows = std::move(longer);
    }
    return rows;
}

/// For a shell.
std::string quoted_word(const std::string& word) {
    const bool plain = word.find_first_of(" \t\"'\\$`*?[]{}()<>|&;#~!") == std::string::npos;
    if (plain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return text + "'";
}

}  // namespace

bool is_address(std::string_view id) noexcept {
    return id.size() == id_length && id.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string value_at(const Factor& factor, double u) {
    if (const auto* choices = std::get_if<Choices>(&factor.values))
        return (*choices)[static_cast<std::size_t>(u * static_cast<double>(choices->size()))].text;
    const Range& range = std::get<Range>(factor.values);
    if (range.scale == Scale::whole) return number_of(range, range.low + std::floor(u * (range.high - range.low + 1)));
    return number_of(range, between(range, u));
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
    return number_of(range, range.scale == Scale::whole ? std::round(value) : value);
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

Plan make_plan(const Sweep& sweep, const Basis& basis) {
    Plan plan;
    for (auto& values : sampled_values(sweep)) plan.designs.push_back(planned(sweep, basis, std::move(values)));
    const auto sound = std::ranges::find_if(plan.designs, [](const Planned& row) { return row.refusal.empty(); });
    if (sound == plan.designs.end()) throw Error(ExitCode::bad_input, "", plan.designs.front().refusal);
    check_choices(sweep, plan);
    check_ends(sweep, basis, *sound);
    return plan;
}

std::string settings_text(const Sweep& sweep, const Planned& design) {
    std::string text;
    for (const design::Override& setting : settings_of(sweep, design.values))
        text.append(text.empty() ? "--set " : " --set ").append(quoted_word(setting.path + "=" + setting.value));
    return text;
}

}  // namespace soft::sweep
