#pragma once
/// What the keys under `loads` mean: a cavity (`cavity` where there is one, else by name under `cavities`), gravity, or a
/// face. Private to the module. Tested by design/load_test, design/cavity_test.
#include <span>
#include <string>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"

namespace soft::design {

inline constexpr std::string_view cavity_name = "cavity";  ///< the short form for the one cavity of a family
inline constexpr std::string_view cavities_group = "cavities";
inline constexpr std::string_view gravity_name = "gravity";

enum class LoadTarget { cavity, face, gravity };

struct NamedLoad {
    std::string path;  ///< "loads.cavities.left"
    std::string name;  ///< of the cavity, of the face itself, or "gravity"
    LoadTarget target;
    const Member* member;
};

/// Members of the group `section` of the tree, those of `cavities` among them; unknown names are left out. Refuses a cavity
/// where there is none, and one among several that is not named under `cavities`.
[[nodiscard]] std::vector<NamedLoad> named_loads(const Node& root, const std::string& section, const FaceNames& faces);

/// The names that may stand there, for "did you mean".
void add_load_names(Schema& schema, const std::string& section);

/// Overrides under `loads`, each at the name of its face under which the tree has a load already.
[[nodiscard]] std::vector<Override> in_names_of(const Node& root, std::span<const Override> overrides,
                                                const FaceNames& faces);

}  // namespace soft::design
