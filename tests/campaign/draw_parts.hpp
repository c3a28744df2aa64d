#pragma once
/// Parts of a random design as keys and values, as for `--set`. Internal to draw.
#include <string>
#include <utility>
#include <vector>

#include "../geometry/dice.hpp"
#include "mesh/mesh.hpp"

namespace soft::campaign {

using Settings = std::vector<std::pair<std::string, std::string>>;  ///< "geometry.wall", "2.5 mm"

struct Shape {
    std::string family, model;
    Settings settings;                        ///< geometry, mesh, supports
    std::vector<std::string> cavities;        ///< cavities that loads may use
    std::vector<std::string> pressure_faces;  ///< other faces for pressures
    std::vector<std::string> load_faces;      ///< faces for tractions, forces and motions
    double gas_mL = 1;                        ///< approximate volume of the cavities
    double slenderness = 5;       ///< radius over wall thickness: pressures scale with the modulus over this
    std::string table_text = {};  ///< table of a section, if read from a file
};
[[nodiscard]] Shape draw_shape(Dice& dice);

struct DrawnMaterial {
    std::string law;
    double mu_kPa = 100;
    Settings settings;  ///< material, formulation
};
[[nodiscard]] DrawnMaterial draw_material(Dice& dice, const Shape& shape);

struct Load {
    std::string kind;
    Settings settings;  ///< loads, path
};
[[nodiscard]] Load draw_load(Dice& dice, const Shape& shape, const DrawnMaterial& material);

/// A prescribed face displacement of up to a few millimetres, outwards or inwards (a rod gets one to four cells along it), or loads so
/// small that the response is linear. May change the settings of the shape.
[[nodiscard]] Load draw_motion_or_tiny_load(Dice& dice, Shape& shape, const DrawnMaterial& material);

/// One or two obstacles that do not overlap with the undeformed mesh by its bounding box, as a value of `obstacles`.
[[nodiscard]] std::string draw_obstacles(Dice& dice, const mesh::Mesh& mesh, const std::string& model);

[[nodiscard]] std::string mm(double value);
[[nodiscard]] std::string kPa(double value);
[[nodiscard]] std::string number(double value);

}  // namespace soft::campaign
