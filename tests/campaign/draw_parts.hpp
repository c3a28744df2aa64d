#pragma once
/// What a drawn design is made of: keys and their values, as `--set` would give them. Internal to draw.
#include <string>
#include <utility>
#include <vector>

#include "../geometry/dice.hpp"

namespace soft::campaign {

using Settings = std::vector<std::pair<std::string, std::string>>;  ///< "geometry.wall", "2.5 mm"

struct Shape {
    std::string family, model;
    Settings settings;                  ///< geometry, mesh, supports
    std::vector<std::string> cavities;  ///< that loads may name
    std::vector<std::string> pressed;   ///< other faces that a pressure may push on
    std::vector<std::string> pulled;    ///< faces that tractions, forces and motions may act on
    double gas_mL = 1;                  ///< about the volume of its cavities
    double slenderness = 5;             ///< radius over wall: pressures go with modulus over this
    std::string table_text = {};        ///< of a section from a file
};
[[nodiscard]] Shape draw_shape(Dice& dice);

struct Stuff {
    std::string law;
    double mu_kPa = 100;
    Settings settings;  ///< material, formulation
};
[[nodiscard]] Stuff draw_material(Dice& dice, const Shape& shape);

struct Load {
    std::string kind;
    Settings settings;  ///< loads, path
};
[[nodiscard]] Load draw_load(Dice& dice, const Shape& shape, const Stuff& stuff);

/// A face moved out or in by up to a few millimetres, of a block on one to four cells across; or loads so small that the response is
/// linear. May change the shape's settings.
[[nodiscard]] Load draw_motion_or_tiny_load(Dice& dice, Shape& shape, const Stuff& stuff);

[[nodiscard]] std::string mm(double value);
[[nodiscard]] std::string kPa(double value);
[[nodiscard]] std::string number(double value);

}  // namespace soft::campaign
