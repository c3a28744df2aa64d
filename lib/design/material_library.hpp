#pragma once
/// Silicones by name: designs/materials/*.yaml, built into the program so that a design finds them from anywhere.
///   material: dragon-skin-20                                      Yeoh's law over the whole test
///   material: {name: dragon-skin-20, range: 110 %, law: yeoh}     the narrowest range that covers this engineering strain
/// A set of constants is a fit over a range of strain. A name alone is one law, whatever the loads: the Yeoh set over the whole
/// test, with the rising term (material/yeoh.hpp) and signs that keep it stable at every stretch; fit.max_error says how
/// close it is. `range` chooses another set; neo-hookean without a range is that of 300 %. solve and postprocess warn where the
/// stretch leaves the data (fit_advice). Other keys of the material (kappa, density, a constant) stand beside `name` and win
/// over the set's.
/// Private to the module but for design/fitted.hpp. Tested by design/material_library_test.
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

/// In the order of their names.
[[nodiscard]] std::span<const MaterialFile> material_files();

/// One fit of the library.
struct MaterialSet {
    std::string law;
    double strain = 0;        ///< engineering, where its range ends
    std::string strain_text;  ///< "110 %"
    Node block;               ///< what stands below `material:` of a design
};

/// In the order of the file: a law's ranges from the narrowest on.
[[nodiscard]] std::vector<MaterialSet> material_sets(const MaterialFile& file);

/// nullptr for an unknown name.
[[nodiscard]] const MaterialFile* find_material(std::string_view name);

/// `material: dragon-skin-20` becomes `material: {name: dragon-skin-20}`, so that --set material.range=110% has a place;
/// those below `materials` too.
void names_to_keys(Node& root);

/// Puts the constants in the place of the names. Throws Error (bad_input) at its place for a name, law or range that the
/// library does not have. A material that states its law itself is left alone.
void names_to_materials(Node& root);

}  // namespace soft::design
