#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/load_names.hpp"
#include "design/read_parts.hpp"

namespace soft::design {
namespace {

/// Sections that solve may change; mesh and shape do not depend on them.
constexpr std::array<std::string_view, 7> changeable = {"material", "materials", "loads", "contact",
                                                        "path",     "dynamics",  "solver"};
constexpr std::string_view changeable_remedy =
    "solve can change material, materials, loads, contact, path, dynamics, solver";

void check_changeable(const Override& change) {
    const std::string section = change.path.substr(0, change.path.find('.'));
    if (std::find(changeable.begin(), changeable.end(), section) != changeable.end()) return;
    const auto& known = section_notes();
    const bool exists =
        std::any_of(known.begin(), known.end(), [&](const SectionNote& s) { return s.name == section; });
    const std::string location = "--set " + change.path;
    if (exists)
        throw Error(ExitCode::usage, location,
                    core::quoted(section) + " is built into the case and solve cannot change it",
                    "give the same --set to mesh-gen; " + std::string{changeable_remedy});
    throw Error(ExitCode::bad_input, location, "unknown key", changeable_remedy);
}

}  // namespace

Design read_built_design(std::string_view effective_yaml, std::string_view source, std::span<const FamilyKeys> families,
                         std::span<const Override> overrides, const FileFaces& built) {
    for (const Override& change : overrides) check_changeable(change);
    Node root = overridden_design(effective_yaml, source, families, overrides);
    const FamilyKeys& family = family_of(root, source, families);
    return design_of(check_design(std::move(root), source, family, &built), family);
}

Override parse_override(std::string_view argument) {
    const auto equals = argument.find('=');
    const std::string location = "--set " + core::one_line(argument);
    const std::string remedy = "write --set key.path=value, for example --set geometry.wall=2.5mm";
    if (equals == std::string_view::npos) throw Error(ExitCode::usage, location, "no '=' in it", remedy);
    Override change{std::string{core::trimmed(argument.substr(0, equals))},
                    std::string{core::trimmed(argument.substr(equals + 1))}};
    const bool hole =
        change.path.starts_with('.') || change.path.ends_with('.') || change.path.find("..") != std::string::npos;
    if (change.path.empty() || hole) throw Error(ExitCode::usage, location, "no key path before '='", remedy);
    if (change.value.empty()) throw Error(ExitCode::usage, location, "no value after '='", remedy);
    if (change.path.starts_with("load.")) change.path.replace(0, 4, "loads." + std::string{cavity_name});
    return change;
}

}  // namespace soft::design
