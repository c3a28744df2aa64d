#include "fit_elastic.hpp"

#include <filesystem>

#include "cli.hpp"
#include "design/design.hpp"
#include "fit/history_fit.hpp"

namespace soft::cli {

fit::Fit elastic_law(const std::string& material) {
    // A design needs a family, a mesh and loads. These have no geometry, so that only the material matters.
    const design::FamilyKeys specimen{
        .name = "specimen", .models = {"solid"}, .faces = {"end"}, .defaults = "supports: {fixed: end}\n"};
    const bool is_file = std::filesystem::exists(material);
    const std::string text =
        is_file ? std::string{read_input(material, max_table_bytes).text()} : "material: " + material;
    const std::vector<design::Override> others{{"family", specimen.name, "--elastic"},
                                               {"mesh.size", "1 mm", "--elastic"},
                                               {"loads", "{end: {traction: 1 Pa, along: x}}", "--elastic"}};
    const design::Design design =
        design::read_design(text, is_file ? material : "--elastic", {&specimen, 1}, others);
    const auto& constants = design.material.constants;
    return fit::given_law(design.material.law, {constants.begin(), constants.end()});
}

}  // namespace soft::cli
