/// mesh-gen: a parametric design (YAML) -> a case (HDF5): mesh, materials, supports, loads.
///     mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "cli.hpp"
#include "core/text.hpp"
#include "design/design.hpp"
#include "design/law_list.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "io/case_file.hpp"
#include "library_versions.hpp"
#include "mesh_summary.hpp"

namespace {

using namespace soft;

std::vector<cli::Library> libraries() {
    using namespace cli::built_with;
    return {{"gmsh", gmsh}, {"CGAL", cgal}, {"HDF5", hdf5}, {"yaml-cpp", yaml_cpp}};
}

const cli::About about{
    .tool = "mesh-gen",
    .summary = "a parametric soft actuator (YAML) to a case (HDF5): mesh, materials, supports and loads",
    .examples = {{"mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv",
                  "the whole way from design to curve"},
                 {"mesh-gen --template tube | mesh-gen - --set geometry.cap=6mm -o tube.h5",
                  "a design to start from, changed and meshed"}},
    .libraries = libraries};

enum class Task { build, check, explain, list, list_materials, print_template };

struct MeshGenOptions {
    cli::CommonOptions common;
    Task task = Task::build;
    std::string input;
    std::string family;
    design::LawListStyle law_style = design::LawListStyle::plain;
    std::vector<std::string> sets;
};

std::vector<std::string> family_names() {
    std::vector<std::string> names;
    for (const design::FamilyKeys& family : geometry::catalogue_keys()) names.push_back(family.name);
    return names;
}

std::optional<MeshGenOptions> parse_mesh_gen_options(int argc, char** argv) {
    MeshGenOptions options;
    CLI::App app;
    const auto task = [&options](Task chosen) { return [&options, chosen] { options.task = chosen; }; };
    cli::add_input(app, options.input, "DESIGN", "The design (YAML)");
    app.add_flag_callback("--check", task(Task::check), "Validate the design and write nothing");
    app.add_flag_callback("--explain", task(Task::explain),
                          "Print the effective design: what is given, what is a default, what it means");
    app.add_flag_callback("--list", task(Task::list), "Print the actuator families");
    auto* materials = app.add_flag_callback("--list-materials", task(Task::list_materials),
                                            "Print the material laws: energy, parameters, ranges, sources");
    app.add_flag_callback("--markdown", [&options] { options.law_style = design::LawListStyle::markdown; },
                          "Print the laws as the tables of the README")
        ->needs(materials);
    app.add_option("--template", options.family, "Print a commented, runnable design of the family")
        ->type_name("FAMILY")
        ->check(CLI::IsMember(family_names()));
    cli::add_set_option(app, options.sets);
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    cli::at_most_one_of(app, std::vector<std::string>{"--check", "--explain", "--list", "--list-materials", "--template"});
    if (!options.family.empty()) options.task = Task::print_template;
    cli::check_distinct({{"DESIGN", options.input}}, {{"--output", options.common.output}, {"--json", options.common.json}});
    return options;
}

std::string family_list() {
    constexpr std::size_t column = 12;
    std::string text;
    for (const design::FamilyKeys& family : geometry::catalogue_keys()) {
        const std::size_t gap = family.name.size() < column ? column - family.name.size() : 1;
        text += family.name + std::string(gap, ' ') + family.summary + "\n";
    }
    return text;
}

const design::FamilyKeys& family_named(const std::string& name) {
    const auto families = geometry::catalogue_keys();
    return *std::find_if(families.begin(), families.end(),
                         [&](const design::FamilyKeys& family) { return family.name == name; });
}

ExitCode build(const MeshGenOptions& options, const cli::Input& input, const std::vector<design::Override>& overrides) {
    cli::Console console{about.tool, options.common.verbosity};
    const design::Design design =
        design::read_design(input.text(), input.source, geometry::catalogue_keys(), overrides);
    const model::Case model = geometry::build_case(design);
    const std::vector<std::string> warnings = geometry::warnings_of(design, model);
    for (const std::string& warning : warnings) console.warn(warning);
    const cli::MeshSummary summary = cli::inspect(model);
    if (options.task == Task::build) {
        const io::Provenance provenance{std::string{about.tool}, std::string{cli::version()},
                                        std::string{cli::revision()}, cli::library_lines(about),
                                        options.common.command_line};
        const auto image = io::write_case(model, {design.family, design.effective_yaml, options.sets}, provenance);
        cli::write_output(options.common.output, image, cli::Content::binary);
    }
    for (const std::string& line : cli::summary_lines(summary)) console.say(line);
    if (options.task == Task::check) console.say(input.source + ": nothing wrong");
    if (!options.common.json.empty()) cli::write_json(options.common.json, cli::summary_json(summary, warnings));
    return ExitCode::ok;
}

ExitCode mesh_gen(const MeshGenOptions& options) {
    constexpr std::size_t longest_design = (std::size_t{1} << 20) + 1;  // one more than the reader takes: it says so
    const std::string& output = options.common.output;
    switch (options.task) {
        case Task::list: cli::write_output(output, family_list()); return ExitCode::ok;
        case Task::list_materials: cli::write_output(output, design::law_list(options.law_style)); return ExitCode::ok;
        case Task::print_template:
            cli::write_output(output, design::template_yaml(family_named(options.family)));
            return ExitCode::ok;
        case Task::explain:
        case Task::check: break;
        case Task::build: cli::check_output(output, cli::Content::binary); break;
    }
    const cli::Input input = cli::read_input(options.input, longest_design);
    std::vector<design::Override> overrides;
    for (const std::string& set : options.sets) overrides.push_back(design::parse_override(set));
    if (options.task != Task::explain) return build(options, input, overrides);
    cli::write_output(output,
                      design::explain_design(input.text(), input.source, geometry::catalogue_keys(), overrides));
    return ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) { return soft::cli::run_guarded(argc, argv, parse_mesh_gen_options, mesh_gen); }
