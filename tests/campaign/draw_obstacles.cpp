/// Rigid obstacles next to a part: walls, sleeves, posts, balls and blocks, some with friction.
#include <algorithm>
#include <cmath>

#include "draw_parts.hpp"

namespace soft::campaign {
namespace {

constexpr double mm_per_m = 1e3;
/// Distance to the part, over its diagonal.
constexpr double nearest = 0.003, farthest = 0.3;

struct Box {
    mesh::Point low_mm{1e9, 1e9, 1e9}, high_mm{-1e9, -1e9, -1e9};
    [[nodiscard]] double diagonal() const {
        return std::hypot(high_mm[0] - low_mm[0], high_mm[1] - low_mm[1], high_mm[2] - low_mm[2]);
    }
    [[nodiscard]] double middle(std::size_t d) const { return 0.5 * (low_mm[d] + high_mm[d]); }
};

std::string point(const mesh::Point& p) { return "[" + mm(p[0]) + ", " + mm(p[1]) + ", " + mm(p[2]) + "]"; }

/// A wall normal to an axis, on either side of the part.
std::string wall(Dice& dice, const Box& box, std::size_t axis, double gap) {
    const bool above = dice.chance(0.5);
    mesh::Point at{}, normal{};
    at[axis] = above ? box.high_mm[axis] + gap : box.low_mm[axis] - gap;
    normal[axis] = above ? -1 : 1;
    return "plane: {point: " + point(at) + ", normal: [" + number(normal[0]) + ", " + number(normal[1]) + ", " +
           number(normal[2]) + "]}";
}

std::string obstacle(Dice& dice, const Box& box, const std::string& model) {
    const double size = box.diagonal(), gap = size * dice.between_logs(nearest, farthest),
                 radius = size * dice.between_logs(0.1, 2);
    const bool beyond = dice.chance(0.5);
    const double x = beyond ? box.high_mm[0] + gap : box.low_mm[0] - gap, outward = beyond ? 1 : -1;
    if (model == "axisymmetric") {
        if (dice.chance(0.4)) return wall(dice, box, 0, gap);
        if (dice.chance(0.3))
            return "sphere: {center: " + point({x + outward * radius, 0, 0}) + ", radius: " + mm(radius) + "}";
        return "cylinder: {point: [0 mm, 0 mm, 0 mm], axis: [1, 0, 0], radius: " + mm(box.high_mm[1] + gap) +
               ", inside: true}";
    }
    if (dice.chance(0.4)) return wall(dice, box, dice.chance(0.5) ? 0 : 1, gap);
    const double y = box.high_mm[1] + gap, at_x = dice.between(box.low_mm[0], box.high_mm[0]);
    if (model == "plane-strain" || dice.chance(0.4))
        return "cylinder: {point: " + point({at_x, y + radius, 0}) + ", axis: [0, 0, 1], radius: " + mm(radius) + "}";
    if (dice.chance(0.5))
        return "sphere: {center: " + point({at_x, y + radius, box.middle(2)}) + ", radius: " + mm(radius) + "}";
    return "box: {from: " + point({at_x - radius, y, box.middle(2) - radius}) +
           ", to: " + point({at_x + radius, y + 2 * radius, box.middle(2) + radius}) + "}";
}

}  // namespace

std::string draw_obstacles(Dice& dice, const mesh::Mesh& mesh, const std::string& model) {
    Box box;
    for (const mesh::Point& p : mesh.points)
        for (std::size_t d = 0; d < 3; ++d) {
            box.low_mm[d] = std::min(box.low_mm[d], mm_per_m * p[d]);
            box.high_mm[d] = std::max(box.high_mm[d], mm_per_m * p[d]);
        }
    std::string all;
    for (int k = dice.whole(1, 2); k > 0; --k) {
        const std::string friction = dice.chance(0.3) ? ", friction: " + number(dice.between(0.05, 1)) : "";
        all += (all.empty() ? "" : ", ") + std::string("o") + std::to_string(k) + ": {" + obstacle(dice, box, model) +
               friction + "}";
    }
    return "{" + all + "}";
}

}  // namespace soft::campaign
