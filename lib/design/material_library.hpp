#pragma once
/// The material library: silicones by name from designs/materials/*.yaml, compiled into the program.
///   material: dragon-skin-20                                      Yeoh's law over the whole test
///   material: {name: dragon-skin-20, range: 110 %, law: yeoh}     the narrowest range that covers this engineering strain
/// A set of constants is a fit over a range of strain. A name alone selects the Yeoh set over the whole test, for any load. That set
/// has the rising term (material/yeoh.hpp) and constants whose signs make it stable at every stretch; fit.max_error is its largest
/// error. `range` selects another set; the default range of neo-hookean is 300 %. solve and postprocess warn if the stretch exceeds
/// the data (fit_range_advice). Other keys of the material (kappa, density, a constant) may be given next to `name` and override
/// those of the set.
/// Private to the module except for design/fitted.hpp. Tested by design/material_library_test.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "design/tree.hpp"

namespace soft::design {

struct MaterialFile {
    std::string_view name;  ///< dragon-skin-20
    std::string_view yaml;
};

/// All files, sorted by name.
[[nodiscard]] std::span<const MaterialFile> material_files();

/// One set of constants of the library.
struct MaterialSet {
    std::string law;
    double strain = 0;        ///< engineering strain at the end of its range
    std::string strain_text;  ///< "110 %"
    Node block;               ///< the content of `material:` in a design
};

/// The sets of a file in file order: the ranges of each law are sorted from narrow to wide.
[[nodiscard]] std::vector<MaterialSet> material_sets(const MaterialFile& file);

/// The file of a material; nullptr for an unknown name.
[[nodiscard]] const MaterialFile* find_material(std::string_view name);

/// Replaces `material: dragon-skin-20` by `material: {name: dragon-skin-20}`, so that --set material.range=110% can be applied.
/// Also for the entries below `materials`.
void expand_material_names(Node& root);

/// Replaces material names by the constants of the library. Throws Error (bad_input) at the location of a name, law or range that is
/// not in the library. A material without `name` is not changed.
void resolve_material_names(Node& root);

}  // namespace soft::design
