#include "draw.hpp"

#include <fstream>
#include <initializer_list>
#include <stdexcept>

#include "draw_parts.hpp"
#include "geometry/build.hpp"

namespace soft::campaign {
namespace {

constexpr int max_attempts = 100;
/// Maximum number of nodes, so that a path takes a second or two.
constexpr std::size_t max_section_nodes = 2500, max_solid_nodes = 1500;

std::string table_name(const DesignIndex& number) {
    return "section-" + std::to_string(number.seed) + "-" + std::to_string(number.index) + ".csv";
}

Drawn attempt(Dice& dice, const DesignIndex& number, const std::filesystem::path& folder) {
    Shape shape = draw_shape(dice);
    const DrawnMaterial material = draw_material(dice, shape);
    const Load load =
        number.index % 4 == 3 ? draw_motion_or_tiny_load(dice, shape, material) : draw_load(dice, shape, material);
    Drawn drawn{shape.family, material.law, load.kind, {}, {}, shape.table_text, 0};
    const std::string location = (folder / "drawn.yaml").string() + ":1:1";
    std::vector<design::Override> overrides{{"model", shape.model, location}};
    if (!shape.table_text.empty()) {
        drawn.table = table_name(number);
        std::ofstream{folder / drawn.table} << shape.table_text;
        overrides.push_back({"geometry.profile", drawn.table, location});
    }
    for (const Settings* settings :
         std::initializer_list<const Settings*>{&shape.settings, &material.settings, &load.settings})
        for (const auto& [key, value] : *settings) overrides.push_back({key, value, location});
    const auto read = [&] {
        return design::read_design("family: " + shape.family + "\n", location, geometry::catalogue_keys(), overrides);
    };
    design::Design design = read();
    const mesh::Mesh mesh = geometry::build_case(design).mesh;
    if (mesh.points.size() > (mesh.dimension == 2 ? max_section_nodes : max_solid_nodes))
        throw Error(ExitCode::bad_input, "mesh", "too large for a campaign");
    if (number.index % 4 != 3 && dice.chance(1.0 / 3)) {
        overrides.push_back({"obstacles", draw_obstacles(dice, mesh, shape.model), location});
        drawn.load += " (obstacles)";
        design = read();
        static_cast<void>(geometry::build_case(design));  // refuses an overlap
    }
    drawn.design_yaml = design.effective_yaml;
    return drawn;
}

}  // namespace

Drawn draw(const DesignIndex& number, const std::filesystem::path& folder) {
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
    throw std::runtime_error("a hundred designs were rejected, the last with: " + last);
}

}  // namespace soft::campaign
