#pragma once
/// Command line of mesh-gen.
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"
#include "design/law_list.hpp"

namespace soft::cli {

[[nodiscard]] const About& mesh_gen_about() noexcept;

enum class Task { build, check, explain, list, list_keys, list_materials, print_template, surface, describe };

struct MeshGenOptions {
    CommonOptions common;
    Task task = Task::build;
    std::vector<std::string> inputs;  ///< one; several only with `folder`
    std::string folder;               ///< output folder, one case per input; empty: write to common.output
    std::string family;
    std::string picture;  ///< with --describe: file for the picture of the numbered faces; empty: none
    std::string surface;  ///< file for the surface of the body, instead of the case
    design::LawListStyle law_style = design::LawListStyle::plain;
    std::vector<std::string> sets;
    std::vector<std::string> sensitivity;  ///< keys, or "all"
};

/// nullopt if help, version or the like was printed. Throws Error(usage).
[[nodiscard]] std::optional<MeshGenOptions> parse_mesh_gen_options(int argc, char** argv);

/// Options for each input, identical to those of `mesh-gen DESIGN -o FOLDER/NAME.h5`, also in the provenance.
/// Throws Error(usage) if two inputs would write the same file.
[[nodiscard]] std::vector<MeshGenOptions> split_inputs(const MeshGenOptions& options);

}  // namespace soft::cli
