#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/tree.hpp"
#include "sweep/sweep.hpp"

namespace soft::sweep {
namespace {

using design::Member;
using design::Node;
using design::refuse;

const std::vector<std::string>& top_keys() {
    static const std::vector<std::string> keys{"design", "method", "samples", "seed",       "vary",
                                               "set",    "at",     "outputs", "sensitivity"};
    return keys;
}
const std::vector<std::string>& range_keys() {
    static const std::vector<std::string> keys{"from", "to", "steps", "scale"};
    return keys;
}

SourceText single_value(const Node& node, const std::string& path, const std::string& example) {
    if (node.kind != Node::Kind::scalar || core::trimmed(node.text).empty())
        refuse(node.location, path, "a single value is needed here", "write for example " + example);
    if (core::trimmed(node.text).find('\n') != std::string_view::npos)
        refuse(node.location, path, "several lines where one value is needed", "write for example " + example);
    return {std::string{core::trimmed(node.text)}, node.location};
}

/// Reads one value or a list of values.
std::vector<SourceText> one_or_more(const Node& node, const std::string& path, const std::string& example) {
    if (node.kind != Node::Kind::list) return {single_value(node, path, example)};
    if (node.items.empty()) refuse(node.location, path, "the list is empty", "write for example [" + example + "]");
    std::vector<SourceText> values;
    for (const Node& item : node.items) values.push_back(single_value(item, path, example));
    return values;
}

template <class Choice>
Choice choice_of(const Node& node, const std::string& path,
                 const std::vector<std::pair<std::string, Choice>>& choices) {
    std::vector<std::string> words;
    for (const auto& [word, choice] : choices) words.push_back(word);
    const std::string text = single_value(node, path, words.front()).text;
    for (const auto& [word, choice] : choices)
        if (word == text) return choice;
    refuse(node.location, path, core::quoted(text) + " is not a valid value", core::did_you_mean(text, words));
}

struct Limits {
    long min, max;
};
long whole_number(const Node& node, const std::string& path, Limits limits) {
    const SourceText written = single_value(node, path, std::to_string(limits.min));
    const auto parsed = core::parse_count(written.text);
    if (const auto* refusal = std::get_if<core::Refusal>(&parsed))
        refuse(node.location, path, refusal->problem, refusal->remedy);
    const long value = std::get<long>(parsed);
    if (value < limits.min || value > limits.max)
        refuse(node.location, path, written.text + " is out of range",
               "it must be at least " + std::to_string(limits.min) + ", at most " + std::to_string(limits.max));
    return value;
}

struct Quantity {
    double number;
    std::string unit;
};
std::optional<Quantity> number_in(const std::string& text) {
    const core::QuantityParts parts = core::quantity_parts(text);
    const char* const last = parts.number.data() + parts.number.size();
    Quantity quantity{0, parts.unit};
    const auto end =
        std::from_chars(parts.number.data() + (parts.number.starts_with('+') ? 1 : 0), last, quantity.number);
    if (end.ec != std::errc{} || end.ptr != last || !std::isfinite(quantity.number)) return std::nullopt;
    return quantity;
}

Quantity quantity_of(const SourceText& written, const std::string& path) {
    if (auto quantity = number_in(written.text)) return *quantity;
    refuse(written.location, path, core::quoted(written.text) + " is not a number",
           "write words as a list: [one, two]");
}

[[noreturn]] void refuse_unit(const SourceText& value, const SourceText& other, const std::string& path) {
    refuse(value.location, path, core::quoted(value.text) + " has another unit than " + core::quoted(other.text),
           "write all in the same unit");
}

/// Words, or numbers that share a unit: their column has one.
Choices choices_of(const Node& node, const std::string& path) {
    Choices choices = one_or_more(node, path, "2 mm, 3 mm");
    const SourceText* first = nullptr;
    std::string unit;
    for (const SourceText& choice : choices) {
        const auto quantity = number_in(choice.text);
        if (!quantity || quantity->unit.empty()) continue;
        if (first == nullptr) {
            first = &choice;
            unit = quantity->unit;
        }
        // A unit of another dimension is refused with the design.
        if (quantity->unit != unit && core::dimension_of(quantity->unit) == core::dimension_of(unit))
            refuse_unit(choice, *first, path);
    }
    return choices;
}

const Node& required_value(const Node& map, std::string_view key, const SourceText& at, const std::string& example) {
    if (const Node* node = design::find(map, key)) return *node;
    refuse(at.location, at.text, "missing", "add " + std::string{key} + ": " + example);
}

Range range_of(const Node& node, const std::string& path, Method method) {
    design::require_known_keys(node, range_keys(), path);
    Range range;
    range.from =
        single_value(required_value(node, "from", {path + ".from", node.location}, "2 mm"), path + ".from", "2 mm");
    range.to = single_value(required_value(node, "to", {path + ".to", node.location}, "4 mm"), path + ".to", "4 mm");
    const Quantity from = quantity_of(range.from, path), to = quantity_of(range.to, path);
    if (from.unit != to.unit) refuse_unit(range.to, range.from, path);
    if (!(from.number < to.number))
        refuse(range.to.location, path, range.to.text + " is not more than " + range.from.text,
               "write the smaller one first");
    range.low = from.number, range.high = to.number, range.unit = from.unit;
    if (const Node* scale = design::find(node, "scale"))
        range.scale = choice_of<Scale>(*scale, path + ".scale",
                                       {{"linear", Scale::linear}, {"log", Scale::log}, {"whole", Scale::whole}});
    if (range.scale == Scale::log && range.low <= 0)
        refuse(range.from.location, path, range.from.text + " has no logarithm", "a log scale starts above 0");
    if (range.scale == Scale::whole && (std::floor(range.low) != range.low || std::floor(range.high) != range.high))
        refuse(range.from.location, path, "the ends are not whole numbers",
               "write for example {from: 5, to: 12, scale: whole}");
    const Node* steps = design::find(node, "steps");
    if (method == Method::grid)
        range.steps = static_cast<int>(whole_number(
            required_value(node, "steps", {path + ".steps", node.location}, "5"), path + ".steps", {2, max_designs}));
    else if (steps != nullptr)
        refuse(steps->location, path + ".steps", "only a grid has steps",
               "leave it out; samples is the number of designs");
    return range;
}

std::vector<Factor> factors_of(const Node& vary, Method method) {
    if (vary.kind != Node::Kind::map || vary.members.empty())
        refuse(vary.location, "vary", "a group of keys is needed here", "write geometry.wall: {from: 2 mm, to: 4 mm}");
    std::vector<Factor> factors;
    for (const Member& member : vary.members) {
        const Node& node = member.value;
        Factor factor{member.key, member.location, Choices{}};
        if (node.kind == Node::Kind::map)
            factor.values = range_of(node, member.key, method);
        else if (node.kind == Node::Kind::list)
            factor.values = choices_of(node, member.key);
        else
            refuse(node.location, member.key, "a range or a list is needed here",
                   "write {from: 2 mm, to: 4 mm} or [2 mm, 3 mm]; put keys that do not vary under set");
        factors.push_back(std::move(factor));
    }
    return factors;
}

std::vector<design::Override> overrides_of(const Node& set) {
    if (set.kind != Node::Kind::map)
        refuse(set.location, "set", "a group of keys is needed here", "write {mesh.size: 2 mm}");
    std::vector<design::Override> overrides;
    for (const Member& member : set.members) {
        if (member.value.kind == Node::Kind::map)
            refuse(member.value.location, member.key, "a single value or a list is needed here",
                   "write the whole key path: " + member.key + ".key: value");
        std::vector<std::string> texts;
        for (const SourceText& value : one_or_more(member.value, member.key, "2 mm")) texts.push_back(value.text);
        const bool list = member.value.kind == Node::Kind::list;
        overrides.push_back({member.key, list ? std::string{"["}.append(core::join(texts)).append("]") : texts.front(),
                             member.value.location});
    }
    return overrides;
}

/// Splits "elongation=5mm,10mm" into two points. A value without '=' uses the quantity of the entry before it, also in a YAML list.
std::vector<SourceText> points_of(const Node& at) {
    std::vector<SourceText> points;
    std::string quantity;
    for (const SourceText& entry : one_or_more(at, "at", "elongation=20mm"))
        for (std::string& word : core::split(entry.text, ',')) {
            const std::size_t equals = word.find('=');
            if (equals != std::string::npos)
                quantity = word.substr(0, equals);
            else if (word == "end" || word == "limit")
                quantity.clear();
            else if (quantity.empty() || word.empty())
                refuse(entry.location, "at", core::quoted(word) + " is not a point of the path",
                       "write elongation=20mm, limit or end");
            else
                word.insert(0, quantity + "=");
            points.push_back({std::move(word), entry.location});
        }
    return points;
}

void check_size(const Sweep& sweep, const std::string& location) {
    if (sweep.method != Method::grid) return;
    double designs = 1;
    for (const Factor& factor : sweep.factors) designs *= level_count(factor);
    if (designs > max_designs)
        refuse(location, "vary", "the grid has " + core::rounded_text(designs, 3) + " designs",
               "use at most " + std::to_string(max_designs) + ": fewer steps, or method: latin-hypercube");
}

}  // namespace

Sweep read_sweep(std::string_view text, std::string_view source) {
    const Node root = design::parse_yaml(text, source, {"sweep", "see docs/guides/sweeps.md"});
    const std::string top = std::string{source} + ":1:1";
    if (root.kind != Node::Kind::map) refuse(top, "", "a sweep is a group of keys", "write design: ..., vary: {...}");
    design::require_known_keys(root, top_keys(), "");
    Sweep sweep;
    sweep.source = source;
    sweep.design = single_value(required_value(root, "design", {"design", top}, "designs/tube.yaml"), "design",
                                "designs/tube.yaml");
    if (const Node* method = design::find(root, "method"))
        sweep.method = choice_of<Method>(
            *method, "method",
            {{"grid", Method::grid}, {"random", Method::random}, {"latin-hypercube", Method::latin_hypercube}});
    for (const char* key : {"samples", "seed"})
        if (const Member* member = design::find_member(root, key); member != nullptr && sweep.method == Method::grid)
            refuse(member->location, key, "unused with method: grid",
                   "write method: random or method: latin-hypercube, or leave it out");
    if (sweep.method != Method::grid)
        sweep.samples = static_cast<int>(
            whole_number(required_value(root, "samples", {"samples", top}, "100"), "samples", {1, max_designs}));
    if (const Node* seed = design::find(root, "seed"))
        sweep.seed = static_cast<std::uint64_t>(whole_number(*seed, "seed", {0, std::numeric_limits<long>::max()}));
    const Node& vary = required_value(root, "vary", {"vary", top}, "{geometry.wall: [2 mm, 3 mm]}");
    sweep.factors = factors_of(vary, sweep.method);
    if (const Node* set = design::find(root, "set")) sweep.fixed = overrides_of(*set);
    for (const design::Override& fixed : sweep.fixed)
        if (std::ranges::find(sweep.factors, fixed.path, &Factor::path) != sweep.factors.end())
            refuse(fixed.location, fixed.path, "a key that varies cannot be set", "write it under vary or under set");
    sweep.at = {{"end", "default"}};
    if (const Node* at = design::find(root, "at")) sweep.at = points_of(*at);
    if (const Node* outputs = design::find(root, "outputs"))
        sweep.outputs = one_or_more(*outputs, "outputs", "pressure_kPa");
    if (const Node* sensitivity = design::find(root, "sensitivity"))
        sweep.sensitivity = one_or_more(*sensitivity, "sensitivity", "geometry.wall");
    check_size(sweep, vary.location);
    return sweep;
}

}  // namespace soft::sweep
