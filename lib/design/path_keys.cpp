/// The keys of `path`.
#include <algorithm>

#include "core/units.hpp"
#include "design/common_keys.hpp"
#include "design/path.hpp"

namespace soft::design {
namespace {

constexpr const char *as_path = "path", *no_end = "none", *stages_path = "path.stages";

std::vector<std::string> controls() { return {"auto", "pressure", "volume", "displacement", "arc-length"}; }

Key control_key(const std::string& path) {
    const bool of_stage = path != "path";
    std::vector<std::string> choices = controls();
    if (of_stage) choices.insert(choices.begin(), as_path);
    return {
        .path = path + ".control",
        .kind = Kind::choice,
        .fallback = of_stage ? as_path : "auto",
        .meaning =
            of_stage
                ? "as path.control, or the quantity prescribed in this stage"
                : "quantity prescribed along the path; auto takes the load while the body is stiff, then the volume "
                  "or the arc length, and passes limit points",
        .choices = std::move(choices)};
}

Key controlled_key(const std::string& path, std::vector<std::string> choices) {
    const bool of_stage = path != "path";
    choices.insert(choices.begin(), of_stage ? as_path : "first");
    return {.path = path + ".controlled",
            .kind = Kind::choice,
            .fallback = choices.front(),
            .meaning = of_stage ? "as path.controlled, or another output or cavity"
                                : "output (control: displacement) or cavity (control: volume) that is prescribed",
            .choices = std::move(choices)};
}

std::vector<Key> branch_keys() {
    const model::PathSettings defaults;
    return {
        {.path = "path.branch",
         .kind = Kind::choice,
         .fallback = "stay",
         .meaning =
             "at a bifurcation: stay on the primary branch, or follow the other branch from the first bifurcation on",
         .choices = {"stay", "follow"}},
        {.path = "path.imperfection",
         .kind = Kind::length,
         .fallback = "0.1 mm",
         .meaning = "amplitude of the perturbation onto a followed branch, as its largest displacement",
         .min = 0,
         .min_open = true},
        {.path = "path.contact",
         .kind = Kind::choice,
         .fallback = "stop",
         .meaning = "at self-contact of the walls: stop the path, or ignore it and let the walls penetrate",
         .choices = {"stop", "ignore"}},
        {.path = "path.stretch_limit",
         .kind = Kind::ratio,
         .fallback = core::quantity_text(defaults.stretch_limit, core::Dimension::ratio),
         .meaning = "stretch, exceeded in 1 % of the rubber, at which a load that cannot be reached is abandoned",
         .min = 1,
         .min_open = true},
        {.path = "path.frequencies",
         .kind = Kind::count,
         .fallback = std::to_string(defaults.frequencies),
         .meaning =
             "number of natural frequencies of small vibrations about each state, loads held; needs material.density",
         .min = 0,
         .max = model::max_frequencies}};
}

Kind kind_of(const Node* measure) {
    const auto known = std::ranges::find_if(model::all_measures, [&](model::Measure m) {
        return measure != nullptr && measure->text == model::name_of(m);
    });
    switch (known == model::all_measures.end() ? core::Dimension::length : model::unit_of(*known).dimension) {
        case core::Dimension::angle: return Kind::angle;
        case core::Dimension::curvature: return Kind::curvature;
        case core::Dimension::force: return Kind::force;
        case core::Dimension::moment: return Kind::moment;
        default: return Kind::length;
    }
}

/// An output of the tree and the kind of its values.
struct NamedOutput {
    std::string name;
    Kind kind;
};
std::vector<NamedOutput> named_outputs(const Node& root) {
    std::vector<NamedOutput> outputs;
    for (const Member& output : members_of(root, "outputs")) {
        outputs.push_back({output.key, kind_of(find(output.value, "measure"))});
    }
    return outputs;
}

void add_until_keys(Schema& schema, const Node& root, const std::string& section,
                    std::span<const NamedOutput> outputs) {
    std::vector<std::string> ends = until_quantities();
    for (const NamedOutput& output : outputs) ends.push_back(output.name);
    for (const Member& until : members_of(root, section)) {
        const auto output = std::ranges::find(outputs, until.key, &NamedOutput::name);
        if (output != outputs.end())
            schema.keys.push_back({.path = section + "." + until.key,
                                   .kind = output->kind,
                                   .meaning = "the path or stage ends when the output reaches this value"});
        else if (std::ranges::find(ends, until.key) != ends.end())
            schema.keys.push_back(until_key(section, until.key));
    }
    schema.names[section] = std::move(ends);
}

void check_stage_name(const Member& stage) {
    if (!is_valid_name(stage.key))
        refuse(stage.location, std::string{stages_path} + "." + stage.key, "not a name of a stage", valid_name_rule);
}

StageEntry add_stage_keys(Schema& schema, const Node& root, const Member& stage, std::span<const LoadEntry> loads) {
    check_stage_name(stage);
    StageEntry entry{stage.key, std::string{stages_path} + "." + stage.key, {}};
    entry.loads = add_stage_load_keys(schema, root, entry.path, loads);
    const Key controlled = *std::ranges::find(schema.keys, "path.controlled", &Key::path);
    schema.keys.push_back(control_key(entry.path));
    schema.keys.push_back(controlled_key(entry.path, {controlled.choices.begin() + 1, controlled.choices.end()}));
    const std::string until = entry.path + ".until";
    const Node* own = find_path(root, until);
    if (own != nullptr && own->kind == Node::Kind::map)
        add_until_keys(schema, root, until, named_outputs(root));
    else
        schema.keys.push_back({.path = until,
                               .kind = Kind::choice,
                               .fallback = as_path,
                               .meaning = "as path.until, none, or a separate group {quantity: value}",
                               .choices = {as_path, no_end}});
    return entry;
}

}  // namespace

void fill_empty_until(Node& root) {
    for (const Member& stage : members_of(root, stages_path)) {
        Node* until = find_path(root, std::string{stages_path} + "." + stage.key + ".until");
        if (until == nullptr || until->kind == Node::Kind::scalar || until->kind == Node::Kind::list) continue;
        if (until->members.empty()) *until = scalar_node(no_end, until->location);
    }
}

std::vector<StageEntry> add_path_keys(Schema& schema, const Node& root, std::span<const LoadEntry> loads) {
    const std::vector<NamedOutput> outputs = named_outputs(root);
    std::vector<std::string> controlled;
    for (const NamedOutput& output : outputs) controlled.push_back(output.name);
    for (const LoadEntry& load : loads)
        if (load.kind == LoadKind::gas) controlled.push_back(load.name);
    schema.keys.push_back(control_key("path"));
    schema.keys.push_back(controlled_key("path", std::move(controlled)));
    add_until_keys(schema, root, "path.until", outputs);
    for (Key& key : branch_keys()) schema.keys.push_back(std::move(key));
    std::vector<StageEntry> stages;
    for (const Member& stage : members_of(root, stages_path))
        stages.push_back(add_stage_keys(schema, root, stage, loads));
    schema.names[stages_path];
    if (!stages.empty()) return stages;
    StageEntry whole{"", "path", {}};
    for (std::size_t i = 0; i < loads.size(); ++i)
        if (loads[i].kind != LoadKind::shared_gas) whole.loads.push_back({i, loads[i].what, loads[i].value});
    return {whole};
}

}  // namespace soft::design
