#pragma once
/// What mesh-gen was asked for.
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"
#include "design/law_list.hpp"

namespace soft::cli {

[[nodiscard]] const About& mesh_gen_about() noexcept;

enum class Task { build, check, explain, list, list_materials, print_template, surface, describe };

struct MeshGenOptions {
    CommonOptions common;
    Task task = Task::build;
    std::vector<std::string> inputs;  ///< one; several only with `folder`
    std::string folder;               ///< a case for each input goes here; empty: to common.output
    std::string family;
    std::string picture;  ///< file for the numbered faces of a part that is described; empty: none
    std::string surface;  ///< file for the body's surface, in place of the case
    design::LawListStyle law_style = design::LawListStyle::plain;
    std::vector<std::string> sets;
};

/// nullopt when help and the like was printed. Error(usage).
[[nodiscard]] std::optional<MeshGenOptions> parse_mesh_gen_options(int argc, char** argv);

/// One for each input, as `mesh-gen DESIGN -o FOLDER/NAME.h5` would have it, in the provenance too.
/// Error(usage) where two would write the same file.
[[nodiscard]] std::vector<MeshGenOptions> one_by_one(const MeshGenOptions& options);

}  // namespace soft::cli
