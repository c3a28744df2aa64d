/// The keys of `path`.
#include <algorithm>

#include "design/common_keys.hpp"
#include "design/path.hpp"

namespace soft::design {
namespace {

using model::Control;

constexpr int max_cycles = 1000;
constexpr const char *as_path = "path", *no_end = "none", *stages_path = "path.stages";

/// Keys of a stage repeat those of the path, with the word `path` to take over its value.
Key key_for(const std::string& path, Key key, const char* meaning_of_stage) {
    if (path != "path") {
        key.choices.insert(key.choices.begin(), as_path);
        key.fallback = as_path;
        key.meaning = meaning_of_stage;
    }
    key.path.insert(0, path + ".");
    return key;
}

Key control_key(const std::string& path) {
    return key_for(path, control_setting().key, "as path.control, or the quantity prescribed in this stage");
}

/// `choices`: outputs and cavities.
Key controlled_key(const std::string& path, std::vector<std::string> choices) {
    if (path == "path") choices.insert(choices.begin(), "first");
    return key_for(path,
                   choice_key("controlled", "first", std::move(choices),
                              "output (control: displacement) or cavity (control: volume) that is prescribed"),
                   "as path.controlled, or another output or cavity");
}

Kind kind_of_output(const Node* measure) {
    const auto known = std::ranges::find(model::measures, measure == nullptr ? "displacement" : measure->text,
                                         &model::MeasureInfo::name);
    return known == model::measures.end() ? Kind::length : kind_of(known->unit.dimension);
}

/// An output of the tree and the kind of its values.
struct NamedOutput {
    std::string name;
    Kind kind;
};
std::vector<NamedOutput> named_outputs(const Node& root) {
    std::vector<NamedOutput> outputs;
    for (const Member& output : members_of(root, "outputs")) {
        outputs.push_back({output.key, kind_of_output(find(output.value, "measure"))});
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
            schema.keys.push_back(value_key(section + "." + until.key, output->kind, {},
                                            "the path or stage ends when the output reaches this value"));
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
    schema.keys.push_back(
        or_word("none", value_key(entry.path + ".time", Kind::time, above(0),
                                  "duration, in which the loads change linearly; none: without time")));
    const std::string until = entry.path + ".until";
    const Node* own = find_path(root, until);
    if (own != nullptr && own->kind == Node::Kind::map)
        add_until_keys(schema, root, until, named_outputs(root));
    else
        schema.keys.push_back(choice_key(until, as_path, {as_path, no_end},
                                         "as path.until, none, or a separate group {quantity: value}"));
    return entry;
}

}  // namespace

const Setting<model::Stage>& control_setting() {
    static const Setting<model::Stage> setting = choice(
        "control", &model::Stage::control,
        {{"auto", Control::automatic},
         {"pressure", Control::pressure},
         {"volume", Control::volume},
         {"displacement", Control::displacement},
         {"arc-length", Control::arc_length}},
        "quantity prescribed along the path; auto takes the load while the body is stiff, then the volume or the arc "
        "length, and passes limit points");
    return setting;
}

const Settings<model::PathSettings>& path_settings() {
    using model::Branch, model::Contact;
    using Path = model::PathSettings;
    static const Settings<Path> settings{
        choice(
            "branch", &Path::branch, {{"stay", Branch::stay}, {"follow", Branch::follow}},
            "at a bifurcation: stay on the primary branch, or follow the other branch from the first bifurcation on"),
        in_unit("mm", quantity("imperfection", &Path::imperfection_m, Kind::length, above(0),
                               "amplitude of the perturbation onto a followed branch, as its largest displacement")),
        choice("contact", &Path::contact,
               {{"solve", Contact::solve}, {"stop", Contact::stop}, {"ignore", Contact::ignore}},
               "where walls of the actuator touch each other: solve for the contact forces, stop the path, or ignore "
               "the contact and let the walls penetrate; obstacles are respected in any case"),
        choice(
            "modulus", &Path::modulus,
            {{"long-term", model::Modulus::long_term}, {"instantaneous", model::Modulus::instantaneous}},
            "response of viscoelastic rubber where the stages have no time: as under very slow or very fast loading"),
        number("time_accuracy", &Path::time_accuracy, share,
               "relative error of the viscous stress that the steps of stages with a time may have"),
        count("repeat", &Path::cycles, {1, max_cycles}, "number of times that the stages are passed"),
        number(
            "stretch_limit", &Path::stretch_limit, above(1),
            "stretch, exceeded in 1 % of the rubber, at which a load that cannot be reached is abandoned; past a maximum also "
            "at a point with ten times this stretch"),
        count("frequencies", &Path::frequencies, {0, model::max_frequencies},
              "number of natural frequencies of small vibrations about each state, loads held; needs "
              "material.density")};
    return settings;
}

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
        if (load.form->kind == LoadKind::gas) controlled.push_back(load.name);
    schema.keys.push_back(control_key("path"));
    schema.keys.push_back(controlled_key("path", std::move(controlled)));
    add_until_keys(schema, root, "path.until", outputs);
    for (Key& key : keys_of(path_settings(), "path")) schema.keys.push_back(std::move(key));
    std::vector<StageEntry> stages;
    for (const Member& stage : members_of(root, stages_path))
        stages.push_back(add_stage_keys(schema, root, stage, loads));
    schema.names[stages_path];
    if (!stages.empty()) return stages;
    StageEntry whole{"", "path", {}};
    for (std::size_t i = 0; i < loads.size(); ++i)
        if (loads[i].form->kind != LoadKind::shared_gas)
            whole.loads.push_back({i, loads[i].form->what, loads[i].value});
    return {whole};
}

}  // namespace soft::design
