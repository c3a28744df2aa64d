#include "optimize/goal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/text.hpp"
#include "design/tree.hpp"

namespace soft::optimize {
namespace {

using design::Member;
using design::Node;
using design::refuse;

constexpr double usual_tolerance = 5e-3;

const Node& member(const Node& map, const std::string& key, const std::string& path) {
    const Node* found = design::find(map, key);
    if (found == nullptr) refuse(map.location, path, "the key " + core::quoted(key) + " is missing");
    return *found;
}

void require_map(const Node& node, const std::string& path, const std::string& example) {
    if (node.kind != Node::Kind::map || node.members.empty())
        refuse(node.location, path, "a group of keys is needed here", "write for example " + example);
}

/// The member of a group that has one: {pressure: 20 kPa}.
const Member& single_member(const Node& map, const std::string& path, const std::string& example) {
    require_map(map, path, example);
    if (map.members.size() > 1)
        refuse(map.members[1].location, path, core::quoted(map.members[1].key) + " is a second quantity",
               "write for example " + example);
    return map.members.front();
}

/// A quantity as written.
struct Written {
    double SI = 0;
    std::string text, unit;
    double SI_per_unit = 1;
};
std::optional<core::Dimension> dimension_of(const std::string& unit) {
    return unit.empty() || unit == "%" ? core::Dimension::ratio : core::dimension_of(unit);
}
/// The dimension follows from the unit, unless it is given.
Written quantity_of(const Node& node, const std::string& path, std::optional<core::Dimension> wanted = {}) {
    if (node.kind != Node::Kind::scalar)
        refuse(node.location, path, "a value is needed here", "write for example 20 kPa");
    const core::QuantityParts parts = core::quantity_parts(node.text);
    const auto dimension = wanted ? wanted : dimension_of(parts.unit);
    if (!dimension)
        refuse(node.location, path, core::quoted(parts.unit) + " is not a unit", "write for example 20 kPa");
    const auto value = core::parse_quantity(node.text, *dimension);
    if (const auto* refusal = std::get_if<core::Refusal>(&value))
        refuse(node.location, path, refusal->problem, refusal->remedy);
    const auto unit = core::parse_quantity("1 " + parts.unit, *dimension);
    const double* SI = std::get_if<double>(&unit);
    return {std::get<double>(value), core::tidy_quantity(node.text), parts.unit, SI == nullptr ? 1 : *SI};
}

Variable variable_of(const Member& member_of_vary) {
    const std::string path = "vary." + member_of_vary.key;
    const Node& range = member_of_vary.value;
    require_map(range, path, "{from: 1.5 mm, to: 4 mm}");
    design::require_known_keys(range, {"from", "to", "prior", "sd"}, path);
    const Node &from = member(range, "from", path), &to = member(range, "to", path);
    const Written low = quantity_of(from, path + ".from"), high = quantity_of(to, path + ".to", dimension_of(low.unit));
    if (!(low.SI < high.SI)) refuse(to.location, path + ".to", "is not larger than `from`");
    return {member_of_vary.key, low.SI, high.SI, false, low.unit, low.SI_per_unit};
}

/// "geometry.bore_radius + 2 * geometry.wall"
std::vector<Measure::Term> terms_of(const std::string& text, const std::string& location) {
    std::vector<Measure::Term> terms;
    std::string sum = text;  // a - b is a + -1 * b
    for (std::size_t minus = 0; (minus = sum.find(" - ", minus)) != std::string::npos;)
        sum.replace(minus, 3, " + -1 * ");
    for (const std::string& part : core::split(sum, '+')) {
        const std::vector<std::string> factors = core::split(part, '*');
        Measure::Term term{1, factors.back()};
        bool valid = !term.key.empty();
        for (const std::string& text_of_factor : std::span(factors).first(factors.size() - 1)) {
            double factor = 1;
            const char* const end_of_text = text_of_factor.data() + text_of_factor.size();
            const auto [end, error] = std::from_chars(text_of_factor.data(), end_of_text, factor);
            valid = valid && error == std::errc{} && end == end_of_text;
            term.factor *= factor;
        }
        if (!valid)
            refuse(location, text, core::quoted(part) + " is not a number of the design",
                   "write for example geometry.bore_radius + 2 * geometry.wall");
        terms.push_back(std::move(term));
    }
    return terms;
}

void read_at(const Node& entry, const std::string& path, Measure& measure) {
    const Member& at = single_member(member(entry, "at", path), path + ".at", "at: {pressure: 20 kPa}");
    const Written value = quantity_of(at.value, path + ".at");
    measure.at = at.key;
    measure.at_SI = value.SI;
    measure.at_text = value.text;
    measure.text = measure.quantity + " at " + measure.at + " " + value.text;
}

void set_value(Condition& condition, const Written& value) {
    condition.value_SI = value.SI;
    condition.scale_SI = value.SI == 0 ? value.SI_per_unit : std::abs(value.SI);
    condition.value_text = value.text;
    condition.unit = value.unit;
    condition.SI_per_unit = value.SI_per_unit;
}

/// The load of {limit: {pressure: 45 kPa}}, and its measure.
const Member& limit_load(const Node& entry, const Node& limit, const std::string& path, const std::string& example) {
    if (const Node* at = design::find(entry, "at"))
        refuse(at->location, path + ".at", "a limit point has its own place", "omit it");
    return single_member(limit, path, example);
}
Measure limit_of(const Member& load) {
    return {.kind = Measure::Kind::limit, .quantity = load.key, .text = "limit " + load.key};
}
/// The measure that a word names without further keys.
std::optional<Measure> volume_named(const std::string& name) {
    if (name != "rubber_volume" && name != "cavity_volume") return std::nullopt;
    const auto kind = name == "rubber_volume" ? Measure::Kind::rubber_volume : Measure::Kind::cavity_volume;
    return Measure{.kind = kind, .quantity = name, .text = name};
}

/// Bounds on a measure: {below: 2}, {above: 2}, or both.
std::vector<Condition> bounds_on(const Measure& measure, const Node& bounds, const std::string& path) {
    require_map(bounds, path, "{below: 2}");
    design::require_known_keys(bounds, {"below", "above"}, path);
    std::vector<Condition> conditions;
    for (const Member& bound : bounds.members) {
        Condition condition{.measure = measure};
        condition.relation = bound.key == "below" ? Condition::Relation::below : Condition::Relation::above;
        set_value(condition, quantity_of(bound.value, path));
        conditions.push_back(std::move(condition));
    }
    const auto value_of = [&](const char* key) { return quantity_of(member(bounds, key, path), path).SI; };
    if (conditions.size() == 2 && !(value_of("above") < value_of("below")))
        refuse(bounds.location, path, "`above` is not less than `below`");
    return conditions;
}

/// The prior of a variable as a condition.
std::optional<Condition> prior_of(const Member& variable) {
    const std::string path = "vary." + variable.key;
    const Node *prior = design::find(variable.value, "prior"), *deviation = design::find(variable.value, "sd");
    if (prior == nullptr && deviation == nullptr) return std::nullopt;
    if (prior == nullptr || deviation == nullptr)
        refuse(variable.location, path, "`prior` and `sd` belong together",
               "write for example prior: 84 kPa, sd: 5 kPa");
    Condition condition;
    condition.measure = {.kind = Measure::Kind::keys, .terms = {{1, variable.key}}, .text = "prior of " + variable.key};
    const Written from = quantity_of(member(variable.value, "from", path), path + ".from");
    set_value(condition, quantity_of(*prior, path + ".prior", dimension_of(from.unit)));
    const bool is_share = core::quantity_parts(deviation->text).unit == "%";
    const double sd = is_share ? quantity_of(*deviation, path + ".sd").SI * condition.scale_SI
                               : quantity_of(*deviation, path + ".sd", dimension_of(from.unit)).SI;
    if (!(sd > 0)) refuse(deviation->location, path + ".sd", "must be more than 0");
    condition.within = sd / condition.scale_SI;
    condition.is_data = true;
    return condition;
}

/// The changes under the key `set`.
std::vector<design::Override> changes_of(const Node& map) {
    std::vector<design::Override> changes;
    const Node* set = design::find(map, "set");
    if (set == nullptr) return changes;
    for (const Member& one : set->members) {
        if (one.value.kind != Node::Kind::scalar)
            refuse(one.location, "set." + one.key, "a single value is needed here",
                   "write for example mesh.size: 2 mm");
        changes.push_back({one.key, one.value.text, one.location});
    }
    return changes;
}

/// The index of the run of an entry, which may have its own `design` and `set`.
std::size_t run_of(const Node& entry, std::vector<Run>& runs) {
    const Node* design_file = design::find(entry, "design");
    Run run = runs.front();
    if (design_file != nullptr) {
        if (design_file->kind != Node::Kind::scalar || design_file->text.empty())
            refuse(design_file->location, "design", "the name of a file is needed here");
        run = {design_file->text, design_file->location, {}};
    }
    const std::vector<design::Override> changes = changes_of(entry);
    run.set.insert(run.set.end(), changes.begin(), changes.end());
    const auto same = [&](const Run& other) {
        return other.design_file == run.design_file &&
               std::ranges::equal(other.set, run.set,
                                  [](const auto& a, const auto& b) { return a.path == b.path && a.value == b.value; });
    };
    const auto known = std::ranges::find_if(runs, same);
    const auto index = static_cast<std::size_t>(known - runs.begin());
    if (known == runs.end()) runs.push_back(std::move(run));
    return index;
}

double tolerance_of(const Node& entry, const std::string& path) {
    const Node* within = design::find(entry, "within");
    const double value =
        within == nullptr ? usual_tolerance : quantity_of(*within, path + ".within", core::Dimension::ratio).SI;
    if (!(value > 0)) refuse(entry.location, path + ".within", "must be more than 0");
    return value;
}

MeasuredCurve curve_of(const Node& entry, const std::string& path, std::vector<Run>& runs) {
    design::require_known_keys(entry, {"curve", "at", "columns", "from", "to", "within", "weight", "design", "set"},
                               path);
    const auto text = [&](const std::string& key) {
        const Node* node = design::find(entry, key);
        if (node != nullptr && node->kind != Node::Kind::scalar)
            refuse(node->location, path + "." + key, "a single value is needed here",
                   "write for example {curve: measured.csv, at: elongation, from: 10 mm}");
        return node == nullptr ? std::string{} : node->text;
    };
    MeasuredCurve curve{.run = run_of(entry, runs),
                        .file = text("curve"),
                        .location = design::find(entry, "curve")->location,
                        .columns = text("columns"),
                        .at = text("at"),
                        .from = text("from"),
                        .to = text("to"),
                        .within = tolerance_of(entry, path)};
    if (const Node* weight = design::find(entry, "weight")) {
        const double value = quantity_of(*weight, path + ".weight", core::Dimension::ratio).SI;
        if (!(value > 0)) refuse(weight->location, path + ".weight", "must be more than 0");
        curve.within /= std::sqrt(value);
    }
    return curve;
}

/// The member of an entry that is the quantity.
const Member& subject_of(const Node& entry, const std::string& path) {
    require_map(entry, path, "{elongation: 60 mm, at: {pressure: 20 kPa}}");
    const Member* subject = nullptr;
    for (const Member& one : entry.members) {
        if (one.key == "at" || one.key == "within" || one.key == "design" || one.key == "set") continue;
        if (subject != nullptr)
            refuse(one.location, path, core::quoted(one.key) + " is a second quantity", "write one entry for each");
        subject = &one;
    }
    if (subject == nullptr)
        refuse(entry.location, path, "no quantity", "write {elongation: 60 mm, at: {pressure: 20 kPa}}");
    return *subject;
}

Condition target_of(const Node& entry, const std::string& path) {
    const Member& subject = subject_of(entry, path);
    Condition condition;
    condition.within = tolerance_of(entry, path);
    const Node* value = &subject.value;
    condition.measure.quantity = subject.key;
    if (subject.key == "limit") {
        const Member& load = limit_load(entry, *value, path, "{limit: {pressure: 45 kPa}}");
        condition.measure = limit_of(load);
        value = &load.value;
    } else {
        read_at(entry, path, condition.measure);
    }
    const Written wanted = quantity_of(*value, path);
    if (wanted.SI == 0) refuse(value->location, path, "a target of 0 has no relative difference");
    set_value(condition, wanted);
    return condition;
}

std::vector<Condition> constraints_of(const Node& entry, const std::string& path) {
    const Member& subject = subject_of(entry, path);
    if (const Node* within = design::find(entry, "within"))
        refuse(within->location, path + ".within", "a bound has no tolerance", "omit it");
    if (subject.key == "limit") {
        const Member& load = limit_load(entry, subject.value, path, "{limit: {pressure: {above: 40 kPa}}}");
        return bounds_on(limit_of(load), load.value, path);
    }
    Measure measure{.quantity = subject.key, .text = subject.key};
    if (design::find(entry, "at") != nullptr) {
        read_at(entry, path, measure);
    } else if (auto volume = volume_named(subject.key)) {
        measure = std::move(*volume);
    } else {
        measure.kind = Measure::Kind::keys;
        measure.terms = terms_of(subject.key, subject.location);
    }
    return bounds_on(measure, subject.value, path);
}

/// Whether an entry is {stable: true}.
bool asks_for_stability(const Node& entry, const std::string& path) {
    const Node* stable = design::find(entry, "stable");
    if (stable == nullptr) return false;
    if (entry.members.size() > 1 || stable->text != "true")
        refuse(entry.location, path + ".stable", "has the value true and no further keys",
               "all states up to the last value of a target or constraint are checked");
    return true;
}

std::optional<Measure> objective_of(const Node& node) {
    const std::string path = "minimize";
    if (node.kind == Node::Kind::scalar) {
        if (node.text == "nothing") return std::nullopt;
        if (auto volume = volume_named(node.text)) return volume;
        refuse(node.location, path, core::quoted(node.text) + " is not an objective",
               "write rubber_volume, cavity_volume, nothing, or {stretch_p99: {at: {pressure: 20 kPa}}}");
    }
    const std::string example = "{stretch_p99: {at: {pressure: 20 kPa}}}";
    const Member& subject = single_member(node, path, example);
    require_map(subject.value, path, example);
    design::require_known_keys(subject.value, {"at"}, path);
    Measure measure{.quantity = subject.key};
    read_at(subject.value, path, measure);
    return measure;
}

const std::vector<Node>& list_of(const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::list)
        refuse(node.location, path, "a list is needed here", "write one line '- {...}' for each");
    return node.items;
}

}  // namespace

std::string Variable::text_of(double value_SI) const {
    constexpr int digits = 7;  // below the accuracy of any mould
    const std::string number = core::rounded_text(is_whole ? std::round(value_SI) : value_SI / SI_per_unit, digits);
    return unit.empty() ? number : number + " " + unit;
}

Goal read_goal(std::string_view text, std::string_view source) {
    const Node root = design::parse_yaml(text, source, {"goal", "see docs/tutorials/inverse.md for a goal"});
    require_map(root, "", "design: bellows.yaml");
    design::require_known_keys(root, {"design", "set", "vary", "targets", "minimize", "constraints"}, "");
    Goal goal;
    const Node& design_file = member(root, "design", "design");
    if (design_file.kind != Node::Kind::scalar || design_file.text.empty())
        refuse(design_file.location, "design", "the name of a file is needed here");
    goal.runs.push_back({design_file.text, design_file.location, changes_of(root)});
    const Node& vary = member(root, "vary", "vary");
    require_map(vary, "vary", "{geometry.wall: {from: 1.5 mm, to: 4 mm}}");
    for (const Member& one : vary.members) goal.variables.push_back(variable_of(one));
    const auto add = [&goal](const Node& entry, Condition condition) {
        condition.measure.run = run_of(entry, goal.runs);
        goal.conditions.push_back(std::move(condition));
    };
    if (const Node* targets = design::find(root, "targets"))
        for (const Node& entry : list_of(*targets, "targets")) {
            if (design::find(entry, "curve") != nullptr)
                goal.curves.push_back(curve_of(entry, "targets", goal.runs));
            else
                add(entry, target_of(entry, "targets"));
        }
    if (const Node* constraints = design::find(root, "constraints"))
        for (const Node& entry : list_of(*constraints, "constraints")) {
            if (asks_for_stability(entry, "constraints"))
                goal.stable = true;
            else
                for (Condition& bound : constraints_of(entry, "constraints")) add(entry, std::move(bound));
        }
    if (const Node* minimize = design::find(root, "minimize")) goal.minimize = objective_of(*minimize);
    if (goal.conditions.empty() && goal.curves.empty() && !goal.minimize)
        refuse(root.location, "targets", "the goal has no targets and minimizes nothing",
               "add targets: [{elongation: 60 mm, at: {pressure: 20 kPa}}]");
    for (const Member& one : vary.members)
        if (auto prior = prior_of(one)) goal.conditions.push_back(std::move(*prior));
    for (const Run& run : goal.runs)
        for (const design::Override& change : run.set)
            if (std::ranges::find(goal.variables, change.path, &Variable::key) != goal.variables.end())
                refuse(change.location, "set." + change.path, "is varied too", "omit it here or under `vary`");
    if (goal.has_data() && goal.minimize)
        refuse(design::find(root, "minimize")->location, "minimize",
               "a goal with measured curves or priors minimizes the differences from them", "omit it");
    return goal;
}

}  // namespace soft::optimize
