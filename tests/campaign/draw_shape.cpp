/// Shapes: dimensions typical of soft robots, thin and thick, on meshes with one or two cells through the wall.
#include <algorithm>
#include <array>
#include <numbers>

#include "draw_parts.hpp"

namespace soft::campaign {
namespace {

constexpr double pi = std::numbers::pi;

/// Cell size between half and the full wall thickness, larger if the length would need more than `max_cells`.
std::string cell_size(Dice& dice, double wall_mm, double length_mm, double max_cells) {
    return mm(std::max(wall_mm * dice.between(0.5, 1.1), length_mm / max_cells));
}

void through_wall(Dice& dice, Shape& shape) {
    shape.settings.emplace_back("mesh.through_wall", dice.chance(0.5) ? "1" : "2");
}

Shape tube(Dice& dice) {
    const double radius = dice.between(4, 15), wall = radius * dice.between_logs(0.05, 0.6),
                 length = dice.between(20, 80);
    Shape shape{"tube", dice.chance(0.93) ? "axisymmetric" : "quarter", {}, {"cavity"}, {"outer"}, {"inlet"}};
    shape.settings = {{"geometry.length", mm(length)},
                      {"geometry.outer_radius", mm(radius)},
                      {"geometry.inner_radius", mm(radius - wall)},
                      {"geometry.cap", mm(dice.between(1, 6))}};
    const bool solid = shape.model != "axisymmetric";
    shape.settings.emplace_back("mesh.size", cell_size(dice, solid ? 2 * wall : wall, length, solid ? 8 : 40));
    if (solid) shape.settings.insert(shape.settings.end(), {{"mesh.through_wall", "1"}, {"mesh.sectors", "2"}});
    shape.gas_mL = pi * (radius - wall) * (radius - wall) * length * 1e-3;
    shape.slenderness = radius / wall;
    return shape;
}

Shape fiber_tube(Dice& dice) {
    Shape shape = tube(dice);
    shape.family = "fiber-tube";
    const int families = shape.model == "axisymmetric" ? 2 : dice.whole(1, 2);
    if (families == 1) shape.model = "solid";
    const double inner = dice.chance(0.5) ? 0 : dice.between(0, 0.5);
    shape.settings.insert(shape.settings.end(), {{"geometry.fibers.angle", number(dice.between(5, 88)) + " deg"},
                                                 {"geometry.fibers.families", std::to_string(families)},
                                                 {"geometry.fibers.k1", kPa(dice.between_logs(20, 5000))},
                                                 {"geometry.fibers.k2", number(dice.between_logs(0.1, 5))},
                                                 {"geometry.fibers.layer", "[" + number(inner) + ", 1]"}});
    return shape;
}

Shape bellows(Dice& dice) {
    const double wall = dice.between(0.8, 3.5), fillet = dice.between(0.2, 1.5), bore = dice.between(1.5, 5);
    const double pitch = 2 * wall + 4 * fillet + dice.between(0.2, 4), crest = bore + wall + dice.between(5, 16);
    const int convolutions = dice.whole(1, 6);
    Shape shape{"bellows", "axisymmetric", {}, {"cavity"}, {"outer"}, {"inlet"}};
    shape.settings = {{"geometry.convolutions", std::to_string(convolutions)},
                      {"geometry.pitch", mm(pitch)},
                      {"geometry.crest_radius", mm(crest)},
                      {"geometry.bore_radius", mm(bore)},
                      {"geometry.wall", mm(wall)},
                      {"geometry.fillet", mm(fillet)},
                      {"geometry.end_disc.length", mm(wall + dice.between(2, 4))},
                      {"geometry.end_disc.radius", mm(crest * dice.between(0.6, 0.9))},
                      {"geometry.neck.radius", mm(bore + wall + dice.between(0.3, 2.5))},
                      {"geometry.neck.length", mm(dice.between(0.5, 1.5))},
                      {"mesh.size", mm(std::max(wall * dice.between(0.6, 1.1), convolutions * crest / 50))}};
    if (dice.chance(0.2)) shape.settings.emplace_back("geometry.last_crest_radius", mm(crest * dice.between(0.8, 1)));
    shape.gas_mL = pi * crest * crest * pitch * convolutions * 0.4e-3;
    shape.slenderness = crest / wall;
    return shape;
}

Shape sphere(Dice& dice) {
    const double radius = dice.between(5, 30), wall = radius * dice.between_logs(0.02, 1);
    Shape shape{"sphere", dice.chance(0.95) ? "axisymmetric" : "quarter", {}, {"cavity"}, {"outer"}, {}};
    const bool solid = shape.model != "axisymmetric";
    shape.settings = {{"geometry.inner_radius", mm(radius)},
                      {"geometry.outer_radius", mm(radius + wall)},
                      {"mesh.size", cell_size(dice, wall, 2 * radius, solid ? 6 : 40)}};
    if (solid) shape.settings.insert(shape.settings.end(), {{"mesh.through_wall", "1"}, {"mesh.sectors", "3"}});
    shape.gas_mL = 4.0 / 3 * pi * radius * radius * radius * 1e-3;
    shape.slenderness = 0.5 * radius / wall;
    return shape;
}

Shape two_spheres(Dice& dice) {
    const double radius = dice.between(5, 20), wall = radius * dice.between_logs(0.04, 0.4);
    Shape shape{"two-spheres", "axisymmetric", {}, {"left", "right"}, {"outer_left"}, {}};
    shape.settings = {{"geometry.inner_radius", mm(radius)},
                      {"geometry.outer_radius", mm(radius + wall)},
                      {"geometry.gap", mm(dice.between(2, 20))},
                      {"geometry.right_scale", dice.chance(0.4) ? "1" : number(dice.between(0.8, 1.6))},
                      {"mesh.size", cell_size(dice, wall, radius, 16)}};
    shape.gas_mL = 4.0 / 3 * pi * radius * radius * radius * 1e-3;
    shape.slenderness = 0.5 * radius / wall;
    return shape;
}

Shape ring(Dice& dice) {
    const double radius = dice.between(5, 30), wall = radius * dice.between_logs(0.05, 1);
    Shape shape{"ring", dice.chance(0.9) ? "plane-strain" : "solid", {}, {"cavity"}, {"outer"}, {}};
    shape.settings = {{"geometry.inner_radius", mm(radius)},
                      {"geometry.outer_radius", mm(radius + wall)},
                      {"geometry.length", mm(wall)},
                      {"mesh.size", cell_size(dice, wall, 1.6 * radius, shape.model == "solid" ? 6 : 30)}};
    shape.gas_mL = pi * radius * radius;  // 1 m deep
    shape.slenderness = radius / wall;
    return shape;
}

Shape rod(Dice& dice) {
    const double length = dice.between(10, 100), width = dice.between(4, 20), height = dice.between(4, 20);
    Shape shape{"rod", dice.one_of(std::vector<std::string>{"solid", "half", "quarter"}), {}, {}, {}, {"end"}};
    shape.pressure_faces = {"end"};
    if (shape.model == "solid") shape.pressure_faces.emplace_back("top");
    shape.settings = {{"geometry.length", mm(length)},
                      {"geometry.width", mm(width)},
                      {"geometry.height", mm(height)},
                      {"mesh.size", mm(std::max({length / 6, width / 2, height / 2}))}};
    if (shape.model == "solid" && dice.chance(0.4))
        shape.settings.emplace_back("supports", "{x: fixed, y: left, z: bottom}");
    shape.slenderness = 1;
    return shape;
}

Shape panel(Dice& dice) {
    const double length = dice.between(20, 80), height = length * dice.between_logs(0.04, 1);
    Shape shape{"panel", "plane-strain", {}, {}, {"top", "bottom"}, {"end"}};
    shape.settings = {{"geometry.length", mm(length)},
                      {"geometry.height", mm(height)},
                      {"geometry.end_height", mm(height * dice.between(0.4, 1))},
                      {"geometry.rise", dice.chance(0.5) ? "0 mm" : mm(height * dice.between(-0.5, 1))},
                      {"mesh.size", mm(std::max(height / 4, length / 40))}};
    if (dice.chance(0.3)) shape.settings.emplace_back("supports", "{fixed: [fixed, end]}"), shape.load_faces.clear();
    shape.slenderness = length * length / (height * height);
    return shape;
}

Shape plate(Dice& dice) {
    const bool round = dice.chance(0.75);
    const double radius = dice.between(10, 60), thickness = radius * dice.between_logs(0.02, 0.3);
    Shape shape{"plate", round ? "axisymmetric" : "quarter", {}, {}, {"bottom", "top"}, {}};
    shape.settings = {{"geometry.thickness", mm(thickness)}};
    if (round)
        shape.settings.insert(shape.settings.end(),
                              {{"geometry.radius", mm(radius)}, {"mesh.size", cell_size(dice, thickness, radius, 40)}});
    else
        shape.settings.insert(shape.settings.end(), {{"geometry.length", mm(2 * radius)},
                                                     {"geometry.width", mm(2 * radius * dice.between(0.5, 1))},
                                                     {"mesh.size", mm(std::max(thickness, radius / 4))}});
    shape.slenderness = radius / thickness;
    return shape;
}

Shape dome(Dice& dice) {
    const double radius = dice.between(10, 60), thickness = radius * dice.between_logs(0.02, 0.2);
    const double angle = dice.between(10, 140);
    Shape shape{"dome", "axisymmetric", {}, {}, {"outer", "inner"}, {}};
    shape.settings = {{"geometry.radius", mm(radius)},
                      {"geometry.thickness", mm(thickness)},
                      {"geometry.angle", number(angle) + " deg"},
                      {"mesh.size", cell_size(dice, thickness, angle / 180 * pi * radius, 50)}};
    shape.slenderness = radius / thickness;
    return shape;
}

Shape pneunet(Dice& dice) {
    const double height = dice.between(8, 20), width = dice.between(8, 20);
    const int chambers = dice.whole(1, 2);
    Shape shape{"pneunet", "half", {}, {"cavity"}, {}, {"tip"}};
    const double base = dice.between(1.5, 4);
    shape.settings = {{"geometry.chambers", std::to_string(chambers)},
                      {"geometry.height", mm(height)},
                      {"geometry.width", mm(width)},
                      {"geometry.chamber_length", mm(dice.between(6, 9))},
                      {"geometry.gap", mm(dice.between(0.8, 3))},
                      {"geometry.wall", mm(dice.between(1, 2.2))},
                      {"geometry.side", mm(dice.between(1.2, 2.5))},
                      {"geometry.roof", mm(dice.between(1.2, 2.5))},
                      {"geometry.base", mm(base)},
                      {"geometry.root", mm(4)},
                      {"mesh.size", mm(8)}};
    if (dice.chance(0.4)) shape.settings.emplace_back("geometry.layer.thickness", mm(0.3 * base));
    shape.gas_mL = 0.5e-3 * height * width * 8 * chambers;
    return shape;
}

Shape segment(Dice& dice) {
    const int chambers = dice.whole(2, 3);
    Shape shape{"segment", dice.chance(0.5) || chambers == 3 ? "solid" : "half", {}, {}, {}, {"end"}};
    for (int k = 1; k <= chambers; ++k) shape.cavities.push_back("chamber_" + std::to_string(k));
    const double length = dice.between(15, 30);
    shape.settings = {{"geometry.chambers", std::to_string(chambers)},
                      {"geometry.length", mm(length)},
                      {"geometry.web", number(dice.between(25, 60)) + " deg"},
                      {"geometry.wall", mm(dice.between(1, 3))},
                      {"mesh.size", mm(length / 2.5)}};
    shape.model = "solid";
    shape.gas_mL = 1;
    return shape;
}

std::string row(double x, double y, const std::string& tag, const std::string& curve, const std::string& loop = {}) {
    return number(x) + "," + number(y) + "," + tag + "," + curve + (loop.empty() ? "" : "," + loop) + "\n";
}

/// A closed body of revolution with varying radius and wall; the solid lies to the left of its outline.
Shape revolved(Dice& dice) {
    Shape shape{"revolved", "axisymmetric", {}, {"cavity"}, {"outer"}, {}};
    const int stations = dice.whole(3, 7);
    const double length = dice.between(20, 60), bore = dice.between(3, 10), wall = dice.between(0.8, 3),
                 ripple = dice.between(0, 0.4), cap = dice.between(1, 4);
    const std::string curve = dice.chance(0.5) ? "spline" : "line";
    std::vector<std::array<double, 3>> station;  // x, inner, outer radius
    for (int k = 0; k < stations; ++k) {
        const double inner = bore * (1 + ripple * dice.between(-1, 1));
        station.push_back({length * k / (stations - 1), inner, inner + wall * dice.between(0.8, 1.3)});
    }
    std::string text = "x_mm,r_mm,tag,curve\n";
    for (int k = 0; k + 1 < stations; ++k) text += row(station[k][0], station[k][1], "cavity", curve);
    text += row(length, station.back()[1], "cavity", "line") + row(length, 0, "axis", "line") +
            row(length + cap, 0, "tip", "line");
    text += row(length + cap, station.back()[2], "outer", "line");
    for (int k = stations - 2; k > 0; --k) text += row(station[k][0], station[k][2], "outer", "line");
    text += row(0, station.front()[2], "fixed", "line");
    shape.table_text = text;
    shape.load_faces = {"tip"};
    shape.settings = {{"supports", "{fixed: fixed}"}, {"mesh.size", mm(std::max(wall, length / 25))}};
    through_wall(dice, shape);
    shape.gas_mL = pi * bore * bore * length * 1e-3;
    shape.slenderness = bore / wall;
    return shape;
}

/// A long pad with a polygonal slot below its top.
Shape extruded(Dice& dice) {
    Shape shape{"extruded", "plane-strain", {}, {"cavity"}, {"side"}, {"top"}};
    const double width = dice.between(15, 40), height = dice.between(8, 20), roof = height * dice.between(0.08, 0.3);
    const double a = width * dice.between(0.2, 0.42), b = 0.5 * (height - 2 * roof);
    std::string text = "x_mm,y_mm,tag,curve,loop\n";
    text += row(-width / 2, 0, "base", "line", "block") + row(width / 2, 0, "side", "line", "block") +
            row(width / 2, height, "top", "line", "block") + row(-width / 2, height, "side", "line", "block");
    const int corners = dice.whole(4, 9);
    for (int k = 0; k < corners; ++k) {
        const double angle = -2 * pi * (k + 0.5) / corners, share = dice.between(0.75, 1);
        text += row(a * share * std::cos(angle), height / 2 + b * share * std::sin(angle), "cavity", "line", "slot");
    }
    shape.table_text = text;
    shape.settings = {{"supports", "{fixed: base}"}, {"mesh.size", mm(std::max(roof, height / 6))}};
    shape.settings.emplace_back("mesh.grading", number(dice.between(1, 3)));
    through_wall(dice, shape);
    shape.gas_mL = 4 * a * b;
    shape.slenderness = a / roof;
    return shape;
}

struct Family {
    Shape (*draw)(Dice&);
    double weight;  ///< solids are more expensive, so fewer are drawn
};
constexpr std::array families{Family{tube, 13},       Family{fiber_tube, 11}, Family{bellows, 13}, Family{sphere, 9},
                              Family{two_spheres, 7}, Family{ring, 8},        Family{rod, 6},      Family{panel, 8},
                              Family{plate, 8},       Family{dome, 9},        Family{revolved, 7}, Family{extruded, 6},
                              Family{pneunet, 2},     Family{segment, 2}};

}  // namespace

Shape draw_shape(Dice& dice) {
    double all = 0;
    for (const Family& family : families) all += family.weight;
    double left = dice.between(0, all);
    for (const Family& family : families)
        if ((left -= family.weight) < 0) return family.draw(dice);
    return families.back().draw(dice);
}

}  // namespace soft::campaign
