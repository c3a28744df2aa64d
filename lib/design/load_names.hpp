#pragma once
/// Resolves the keys under `loads` to a cavity (`cavity` if there is only one, otherwise by name under `cavities`), gravity, a face
/// or an obstacle. Private to the module. Tested by design/load_test, design/cavity_test.
#include <span>
#include <string>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"
#include "design/load_keys.hpp"

namespace soft::design {

inline constexpr std::string_view cavity_name = "cavity";  ///< short form for a family with a single cavity
inline constexpr std::string_view cavities_group = "cavities";
inline constexpr std::string_view gravity_name = "gravity";

struct NamedLoad {
    std::string path;  ///< "loads.cavities.left"
    std::string name;  ///< resolved name of the cavity or face, of the obstacle, or "gravity"
    LoadTarget target;
    const Member* member;
};

/// Loads in the group `section` of the tree, including those under `cavities`; unknown names are skipped. Rejects a cavity load if
/// there is no cavity, and the short form if there are several.
[[nodiscard]] std::vector<NamedLoad> named_loads(const Node& root, const std::string& section, const FaceNames& faces);

/// Adds the names that are allowed in `section`, for "did you mean".
void add_load_names(Schema& schema, const std::string& section);

/// The overrides, with each face under `loads` replaced by the alias under which the tree already has a load.
[[nodiscard]] std::vector<Override> in_names_of(const Node& root, std::span<const Override> overrides,
                                                const FaceNames& faces);

}  // namespace soft::design
