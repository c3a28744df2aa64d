#include "mesh_gen_options.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <set>

#include "core/text.hpp"
#include "geometry/family.hpp"
#include "library_versions.hpp"

namespace soft::cli {
namespace {

const About about{.tool = "mesh-gen",
                  .summary = "generates a case (HDF5: mesh and complete design) from a parametric design (YAML)",
                  .examples = {{"mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv",
                                "Complete pipeline from design to curve"},
                               {"mesh-gen --template tube | mesh-gen - --set geometry.cap=6mm -o tube.h5",
                                "Takes a template, changes it and meshes it"}},
                  .libraries = [] {
                      return std::vector<Library>{{"gmsh", built_with::gmsh},
                                                  {"CGAL", built_with::cgal},
                                                  {"HDF5", built_with::hdf5},
                                                  {"yaml-cpp", built_with::yaml_cpp}};
                  }};

std::vector<std::string> family_names() {
    std::vector<std::string> names;
    for (const design::FamilyKeys& family : geometry::catalogue_keys()) names.push_back(family.name);
    return names;
}

}  // namespace

const About& mesh_gen_about() noexcept { return about; }

std::optional<MeshGenOptions> parse_mesh_gen_options(int argc, char** argv) {
    MeshGenOptions options;
    CLI::App app;
    const auto task = [&options](Task chosen) { return [&options, chosen] { options.task = chosen; }; };
    add_inputs(app, options.inputs, "DESIGN", "The design (YAML)");
    app.add_option("--output-folder", options.folder,
                   "Write FOLDER/NAME.h5 for each NAME.yaml of several designs; a design that fails is "
                   "reported and the others continue")
        ->type_name("FOLDER");
    app.add_flag_callback("--check", task(Task::check), "Validate the design without writing a case");
    app.add_flag_callback("--explain", task(Task::explain),
                          "Print the effective design: given values, defaults and the meaning of each key");
    app.add_flag_callback("--list", task(Task::list), "Print the actuator families");
    app.add_flag_callback("--list-keys", task(Task::list_keys),
                          "Print all keys of designs as Markdown: values, ranges, defaults, meaning");
    auto* materials = app.add_flag_callback(
        "--list-materials", task(Task::list_materials),
        "Print the material laws (energy, parameters, ranges, sources) and the silicones by name");
    app.add_flag_callback(
           "--markdown", [&options] { options.law_style = design::LawListStyle::markdown; },
           "With --list-materials: print Markdown tables")
        ->needs(materials);
    app.add_option("--template", options.family, "Print a commented, runnable design of the family")
        ->type_name("FAMILY")
        ->check(CLI::IsMember(family_names()));
    app.add_option("--surface", options.surface,
                   "Write the surface of a solid model instead of a case: STL or OBJ by the extension, in mm")
        ->type_name("FILE");
    auto* describe = app.add_flag_callback(
        "--describe", task(Task::describe),
        "Read a part (.step, .stl, .obj) instead of DESIGN, and print the beginning of a design with "
        "its faces");
    app.add_option("--picture", options.picture, "With --describe: write a picture of the numbered faces (SVG)")
        ->type_name("FILE")
        ->needs(describe);
    add_set_option(app, options.sets);
    app.add_option(
           "--sensitivity", options.sensitivity,
           "Let solve compute the derivatives of the curve by these numbers of the design (geometry.wall,material.mu), or "
           "by all; see postprocess --sensitivity")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("KEY[,KEY...]");
    add_common_options(app, options.common, about);
    if (!parse(app, about, options.common, argc, argv)) return std::nullopt;
    require_at_most_one(
        app, std::vector<std::string>{"--check", "--explain", "--list", "--list-keys", "--list-materials", "--template",
                                      "--output-folder", "--surface", "--describe"});
    require_at_most_one(app, std::vector<std::string>{"--surface", "--output"});
    require_at_most_one(app, std::vector<std::string>{"--output-folder", "--output"});
    require_at_most_one(app, std::vector<std::string>{"--output-folder", "--json"});
    if (!options.family.empty()) options.task = Task::print_template;
    if (!options.surface.empty()) options.task = Task::surface;
    if (options.inputs.empty()) options.inputs.emplace_back();
    if (options.inputs.size() > 1 && options.folder.empty())
        throw Error(ExitCode::usage, "", "one argument too many: " + core::quoted(options.inputs[1]),
                    "see `mesh-gen --help` (several designs need --output-folder)");
    return options;
}

std::vector<MeshGenOptions> split_inputs(const MeshGenOptions& options) {
    namespace fs = std::filesystem;
    std::vector<MeshGenOptions> all;
    std::set<std::string> files;
    for (const std::string& input : options.inputs) {
        if (input.empty() || input == "-")
            throw Error(ExitCode::usage, "--output-folder", "a design from stdin has no name",
                        "give its file, or use -o");
        MeshGenOptions& one = all.emplace_back(options);
        one.inputs = {input};
        one.folder.clear();
        one.common.output = (fs::path{options.folder} / fs::path{input}.filename().replace_extension(".h5")).string();
        if (!files.insert(one.common.output).second)
            throw Error(ExitCode::usage, "--output-folder",
                        "two designs would write " + core::quoted(one.common.output), "rename one of them");
        std::vector<std::string> words{std::string{about.tool}, input, "-o", one.common.output};
        for (const std::string& set : options.sets) words.insert(words.end(), {"--set", set});
        if (!options.sensitivity.empty())
            words.insert(words.end(), {"--sensitivity", core::join(options.sensitivity, ",")});
        one.common.command_line = command_line_of(words);
    }
    return all;
}

}  // namespace soft::cli
