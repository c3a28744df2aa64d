/// Fuzz target: YAML designs with the keys of all families.
#include "design/design.hpp"

#include <algorithm>
#include <array>

#include "geometry/family.hpp"
#include "target.hpp"

/// Families whose build needs gmsh, which cannot be loaded under the sanitizers.
constexpr std::array meshed{"segment", "fiber-tube", "imported"};

void soft::fuzz::read(std::span<const std::byte> bytes) {
    constexpr std::string_view source = "designs/fuzz.yaml";  // base of relative file names
    const auto read_again = [&](std::string_view text) {
        return design::read_design(text, source, geometry::catalogue_keys(), {});
    };
    const design::Design design = read_again(text_of(bytes));
    require(read_again(design.effective_yaml).effective_yaml == design.effective_yaml,
            "the effective design reads back to itself");
    static_cast<void>(design::explain_design(text_of(bytes), source, geometry::catalogue_keys(), {}));
    for (const geometry::Family& family : geometry::catalogue())
        if (family.keys.name == design.family && std::ranges::find(meshed, design.family) == meshed.end())
            static_cast<void>(family.build(design.values));
}
