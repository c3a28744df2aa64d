/// mesh-gen: a parametric design (YAML) -> a case (HDF5): mesh and complete design.
///     mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv
#include <nlohmann/json.hpp>

#include <algorithm>

#include "cli.hpp"
#include "core/text.hpp"
#include "design/design.hpp"
#include "design/key_list.hpp"
#include "design/law_list.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "geometry/variations.hpp"
#include "io/case_file.hpp"
#include "mesh/mesh.hpp"
#include "mesh_gen_options.hpp"
#include "mesh_summary.hpp"
#include "meshing/body_surface.hpp"
#include "meshing/fine_triangles.hpp"
#include "meshing/part_file.hpp"
#include "meshing/surface_file.hpp"
#include "part_description.hpp"

namespace {

using namespace soft;

const cli::About& about = cli::mesh_gen_about();

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

/// Writes all boundary facets of the mesh; for a half or quarter model these include the symmetry planes.
std::string write_surface(const model::Case& model, const std::string& file) {
    if (model.kinematics != model::Kinematics::solid)
        throw Error(ExitCode::bad_input, file, "an axisymmetric or plane-strain section has no closed surface",
                    "use --set model=solid");
    // 0.01 mm for a bellows of 100 mm: relative error of radii and volume below 0.03 %.
    constexpr double share_of_extent = 1e-4;
    const surface::Triangles triangles = meshing::fine_triangles(model.mesh, mesh::boundary_facets(model.mesh),
                                                                 share_of_extent * mesh::extent_m(model.mesh));
    cli::write_output(file, meshing::surface_file(triangles, file), cli::Content::binary);
    std::string line = file + ": " + std::to_string(triangles.triangles.size()) + " triangles";
    if (model.model_fraction < 1)
        line += " around 1/" + core::rounded_text(1 / model.model_fraction, 3) +
                " of the actuator, closed at the symmetry planes";
    return line;
}

ExitCode build(const cli::MeshGenOptions& options, const cli::Input& input,
               const std::vector<design::Override>& overrides) {
    cli::Console console{about, options.common};
    if (input.source != options.inputs.front() && input.source != "<stdin>")
        console.say("reads the example " + input.source);
    const design::Design design =
        design::read_design(input.text(), input.source, geometry::catalogue_keys(), overrides);
    const geometry::Built built = geometry::build_with_figures(design);
    const model::Case& model = built.model;
    const cli::MeshSummary summary = cli::inspect(built);
    std::vector<std::string> warnings = geometry::warnings_of(design, built);
    if (std::string large = cli::memory_warning(summary.unknowns, model.mesh.dimension); !large.empty())
        warnings.push_back(std::move(large));
    for (const std::string& warning : warnings) console.warn(warning);
    if (options.task == cli::Task::build) {
        const io::Provenance provenance{std::string{about.tool}, std::string{cli::version()},
                                        std::string{cli::revision()}, cli::library_lines(about),
                                        options.common.command_line};
        const geometry::Variations varied =
            options.sensitivity.empty() ? geometry::Variations()
                                        : geometry::make_variations(design, built, options.sensitivity, input.source);
        for (const std::string& note : varied.notes) console.warn(note);
        const auto image = io::write_case(model.mesh, built.shape, {design.effective_yaml, options.sets}, provenance,
                                          varied.variations);
        cli::write_output(options.common.output, image, cli::Content::binary);
    }
    for (const std::string& line : cli::summary_lines(summary)) console.say(line);
    if (options.task == cli::Task::surface) console.say(write_surface(model, options.surface));
    if (options.task == cli::Task::check) {
        const std::string found = warnings.empty() ? "" : ", " + core::counted(warnings.size(), "warning");
        console.say(input.source + ": valid" + found);
    }
    if (!options.common.json.empty()) cli::write_json(options.common.json, cli::summary_json(summary, warnings));
    return ExitCode::ok;
}

/// The length unit of an STL or OBJ file, from --set geometry.unit=...; --describe accepts no other override.
std::string unit_of(const cli::MeshGenOptions& options) {
    std::string unit = "mm";
    for (const std::string& set : options.sets) {
        const design::Override one = design::parse_override(set);
        if (one.path != "geometry.unit")
            throw Error(ExitCode::usage, "--set " + one.path, "--describe reads a part, not a design",
                        "set only the unit, for example --set geometry.unit=in");
        unit = one.value;
    }
    return unit;
}

ExitCode describe(const cli::MeshGenOptions& options) {
    const std::string& file = options.inputs.front();
    if (!meshing::is_part_file(file))
        throw Error(ExitCode::usage, "--describe", core::quoted(file) + " is not a part",
                    "give a .step, .stl or .obj file");
    cli::Console console{about, options.common};
    const bool cad = meshing::is_cad_file(file);
    const std::string unit = cad ? "" : unit_of(options);
    const meshing::Part part = meshing::read_part(file, unit, cad ? 1 : geometry::file_unit_m(unit));
    const cli::PartDescription description{file, unit, part.surface, meshing::part_faces(part.surface)};
    if (const std::string warning = cli::unit_warning(description); !warning.empty()) console.warn(warning);
    if (!options.picture.empty()) cli::write_output(options.picture, cli::numbered_faces_svg(description));
    cli::write_output(options.common.output, cli::description_yaml(description));
    return ExitCode::ok;
}

/// Rejects a part or mesh file given instead of a design.
void refuse_part(const std::string& file) {
    const bool part = meshing::is_part_file(file);
    if (!part && !file.ends_with(".msh")) return;
    throw Error(ExitCode::bad_input, file, std::string{part ? "a CAD part" : "a mesh"} + ", not a design (YAML)",
                part ? "use family: imported with geometry.file; `mesh-gen --describe " + file +
                           "` prints a design to start from"
                     : "use family: imported with geometry.file");
}

ExitCode run_task(const cli::MeshGenOptions& options) {
    const std::string& output = options.common.output;
    cli::check_distinct({{"DESIGN", options.inputs.front()}}, options.common,
                        {{"--surface", options.surface}, {"--picture", options.picture}});
    switch (options.task) {
        case cli::Task::list: cli::write_output(output, family_list()); return ExitCode::ok;
        case cli::Task::list_keys:
            cli::write_output(output, design::key_list(geometry::catalogue_keys()));
            return ExitCode::ok;
        case cli::Task::list_materials:
            cli::write_output(output, design::law_list(options.law_style));
            return ExitCode::ok;
        case cli::Task::print_template:
            cli::write_output(output, design::template_yaml(family_named(options.family)));
            return ExitCode::ok;
        case cli::Task::describe: return describe(options);
        case cli::Task::explain:
        case cli::Task::check: break;
        case cli::Task::surface:
            if (!meshing::is_surface_file(options.surface))
                throw meshing::surface_format_error(options.surface);  // before meshing
            break;
        case cli::Task::build: cli::check_output(output, cli::Content::binary); break;
    }
    refuse_part(options.inputs.front());
    const cli::Input input = cli::read_design(options.inputs.front());
    std::vector<design::Override> overrides;
    for (const std::string& set : options.sets) overrides.push_back(design::parse_override(set));
    if (options.task != cli::Task::explain) return build(options, input, overrides);
    cli::write_output(output,
                      design::explain_design(input.text(), input.source, geometry::catalogue_keys(), overrides));
    return ExitCode::ok;
}

/// Reports designs that fail and continues with the others. Returns the exit code of the first failure.
ExitCode mesh_gen(const cli::MeshGenOptions& options) {
    if (options.folder.empty()) return run_task(options);
    const std::vector<cli::MeshGenOptions> all = cli::split_inputs(options);
    cli::make_folder(options.folder);
    ExitCode first = ExitCode::ok;
    for (const cli::MeshGenOptions& one : all) {
        const ExitCode code = cli::report_errors(about.tool, one.common.command_line, [&one] { return run_task(one); });
        if (first == ExitCode::ok) first = code;
    }
    return first;
}

}  // namespace

int main(int argc, char** argv) {
    return soft::cli::run_guarded(argc, argv, soft::cli::parse_mesh_gen_options, mesh_gen);
}
