#include "fit_elastic.hpp"

#include <filesystem>

#include "cli.hpp"
#include "design/design.hpp"
#include "design/tree.hpp"
#include "fit/given_law.hpp"

namespace soft::cli {

fit::Fit elastic_law(const std::string& material) {
    // A design needs a family, a mesh and loads. These have no geometry, so that only the material matters.
    design::FamilyKeys specimen;
    specimen.name = "specimen";
    specimen.models = {"solid"};
    specimen.faces = {"end"};
    specimen.defaults = "supports: {fixed: end}\n";
    const bool is_file = material.find('/') != std::string::npos || std::filesystem::exists(material);
    std::string text = "material: " + material;
    const std::string source = is_file ? material : "--elastic";
    if (is_file) {
        const Input input = read_input(material, max_table_bytes);
        design::Node root = design::parse_yaml(input.text(), input.source);
        std::erase_if(root.members, [](const design::Member& member) { return member.key != "material"; });
        if (root.members.empty())
            throw Error(ExitCode::bad_input, input.source, "has no group 'material'",
                        "give a design, a material of fit-material, or a silicone of the library");
        text = design::write_yaml(root);
    }
    const std::vector<design::Override> others{{"family", specimen.name, "--elastic"},
                                               {"mesh.size", "1 mm", "--elastic"},
                                               {"loads", "{end: {traction: 1 Pa, along: x}}", "--elastic"}};
    const design::Design design = design::read_design(text, source, {&specimen, 1}, others);
    const auto& inelastic = design.material.inelastic;
    if (inelastic && inelastic->instantaneous)
        throw Error(ExitCode::bad_input, source, "its constants are instantaneous, those of the law are long-term",
                    "omit `constants`, and divide them by 1 plus the sum of the moduli");
    if (design.material.strain == model::Strain::small)
        throw Error(ExitCode::bad_input, source, "a law of small strains is not fitted", "omit `strain`");
    const auto& constants = design.material.constants;
    return fit::given_law(design.material.law, {constants.begin(), constants.end()});
}

}  // namespace soft::cli
