#include "draw.hpp"

#include <fstream>
#include <initializer_list>
#include <stdexcept>

#include "draw_parts.hpp"
#include "geometry/build.hpp"

namespace soft::campaign {
namespace {

constexpr int max_attempts = 100;
/// Nodes: a path then takes a second or two.
constexpr std::size_t most_of_a_section = 2500, most_of_a_solid = 1500;

std::string table_name(const Number& number) {
    return "section-" + std::to_string(number.seed) + "-" + std::to_string(number.index) + ".csv";
}

Drawn attempt(Dice& dice, const Number& number, const std::filesystem::path& folder) {
    Shape shape = draw_shape(dice);
    const Stuff stuff = draw_material(dice, shape);
    const Load load =
        number.index % 4 == 3 ? draw_motion_or_tiny_load(dice, shape, stuff) : draw_load(dice, shape, stuff);
    Drawn drawn{shape.family, stuff.law, load.kind, {}, {}, shape.table_text, 0};
    const std::string place = (folder / "drawn.yaml").string() + ":1:1";
    std::vector<design::Override> overrides{{"model", shape.model, place}};
    if (!shape.table_text.empty()) {
        drawn.table = table_name(number);
        std::ofstream{folder / drawn.table} << shape.table_text;
        overrides.push_back({"geometry.profile", drawn.table, place});
    }
    for (const Settings* settings :
         std::initializer_list<const Settings*>{&shape.settings, &stuff.settings, &load.settings})
        for (const auto& [key, value] : *settings) overrides.push_back({key, value, place});
    const design::Design design =
        design::read_design("family: " + shape.family + "\n", place, geometry::catalogue_keys(), overrides);
    const mesh::Mesh mesh = geometry::build_case(design).mesh;
    if (mesh.points.size() > (mesh.dimension == 2 ? most_of_a_section : most_of_a_solid))
        throw Error(ExitCode::bad_input, "mesh", "has too many cells for a campaign");
    drawn.design_yaml = design.effective_yaml;
    return drawn;
}

}  // namespace

Drawn draw(const Number& number, const std::filesystem::path& folder) {
    Dice dice{number.seed * 1'000'003U + static_cast<std::uint32_t>(number.index)};
    std::string last;
    for (int refused = 0; refused < max_attempts; ++refused) {
        try {
            Drawn drawn = attempt(dice, number, folder);
            drawn.refused = refused;
            return drawn;
        } catch (const Error& error) {
            if (error.code() != ExitCode::bad_input) throw;
            last = error.what();
        }
    }
    throw std::runtime_error("a hundred designs refused, at last: " + last);
}

}  // namespace soft::campaign
