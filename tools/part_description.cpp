#include "part_description.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "core/text.hpp"
#include "core/units.hpp"
#include "surface/facet_map.hpp"

namespace soft::cli {
namespace {

using mesh::Point;
using meshing::PartFace;

constexpr double mm = 1e3;
constexpr const char* components = "xyz";

std::string number(double value, int digits = 9) {
    constexpr double rounding = 1e-9;
    return core::rounded_text(std::abs(value) < rounding ? 0 : value, digits);
}

std::string lengths(const Point& p) {
    return "[" + number(mm * p[0]) + " mm, " + number(mm * p[1]) + " mm, " + number(mm * p[2]) + " mm]";
}

std::string area_text(double area_m2) { return number(mm * mm * area_m2, 4) + " mm^2"; }

/// "x", "-y" or "[0.6, 0.8, 0]".
std::string direction_text(const Point& direction) {
    constexpr double along = 1 - 1e-6;
    for (std::size_t d = 0; d < 3; ++d)
        if (std::abs(direction[d]) > along) return std::string{direction[d] < 0 ? "-" : ""} + components[d];
    return "[" + number(direction[0], 4) + ", " + number(direction[1], 4) + ", " + number(direction[2], 4) + "]";
}

std::string rule_text(const meshing::FaceRule& rule) {
    std::vector<std::string> parts;
    if (rule.plane)
        parts.push_back(std::string{"plane: {"} + components[rule.plane->component] + ": " +
                        number(mm * rule.plane->at_m) + " mm}");
    if (rule.box) parts.push_back("box: {from: " + lengths(rule.box->from) + ", to: " + lengths(rule.box->to) + "}");
    if (rule.direction) {
        const Point& n = rule.direction->normal;
        parts.push_back("normal: [" + number(n[0]) + ", " + number(n[1]) + ", " + number(n[2]) +
                        "], within: " + number(rule.direction->within_rad * 180 / std::numbers::pi, 4) + " deg");
    }
    if (rule.flood) parts.push_back("point: " + lengths(rule.flood->point));
    return "{" + core::join(parts) + "}";
}

std::string shape_text(const PartFace& face) {
    switch (face.shape) {
        case PartFace::Shape::plane: return "plane, normal " + direction_text(face.direction);
        case PartFace::Shape::cylinder:
            return std::string{face.is_bore ? "bore" : "cylinder"} + " of radius " + number(mm * face.radius_m, 4) +
                   " mm along " + direction_text(face.direction) + " through " + lengths(face.centre);
        case PartFace::Shape::curved: break;
    }
    return "curved";
}

std::array<Point, 2> box_of(const meshing::BodySurface& surface) {
    std::array<Point, 2> box;
    for (std::size_t d = 0; d < 3; ++d) {
        const auto [low, high] = std::ranges::minmax(surface.points, {}, [d](const Point& p) { return p[d]; });
        box[0][d] = low[d];
        box[1][d] = high[d];
    }
    return box;
}

/// Axes of a parallel projection: right, up, and towards the viewer.
struct View {
    Vector3 right, up, eye;
};

View view_from(const Vector3& eye) {
    const double flat = std::hypot(eye[0], eye[1]), size = norm(eye);
    const Vector3 right{-eye[1] / flat, eye[0] / flat, 0}, towards{eye[0] / size, eye[1] / size, eye[2] / size};
    return {right, cross(towards, right), towards};
}

struct Patch {
    std::array<Point, 3> corners;
    std::size_t face;
};

/// Bisects a triangle until its sides are short enough for drawing in order of depth (painter's algorithm).
void divide(const Patch& patch, double longest_m, std::vector<Patch>& all) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = patch.corners[k], &b = patch.corners[(k + 1) % 3], &c = patch.corners[(k + 2) % 3];
        const double side = norm(along(b, -1, a));
        if (side <= longest_m || side < norm(along(c, -1, b)) || side < norm(along(a, -1, c))) continue;
        const Point middle = along(a, 0.5, along(b, -1, a));
        divide({{a, middle, c}, patch.face}, longest_m, all);
        divide({{middle, b, c}, patch.face}, longest_m, all);
        return;
    }
    all.push_back(patch);
}

std::vector<Patch> patches(const PartDescription& part) {
    constexpr double share_of_extent = 1.0 / 12;
    std::vector<Patch> all;
    for (std::size_t f = 0; f < part.faces.size(); ++f)
        for (const std::size_t t : part.faces[f].facets) {
            Patch patch{{}, f};
            for (std::size_t k = 0; k < 3; ++k)
                patch.corners[k] = part.surface.points[static_cast<std::size_t>(part.surface.triangles[t][k])];
            divide(patch, share_of_extent * part.surface.extent_m(), all);
        }
    return all;
}

std::string colour(std::size_t face, double light) {
    constexpr double golden_deg = 137.508;  // consecutive numbers get clearly different hues
    return "hsl(" + number(std::fmod(golden_deg * static_cast<double>(face), 360), 4) + ",55%," +
           number(45 + 35 * light, 4) + "%)";
}

constexpr double circle_px = 9;

/// The position nearest to the mean of `positions`, so that it lies on the face even if the face surrounds a hole. Positions whose circle
/// would overlap one of `labels` are used only if there are no others.
std::array<double, 2> middle_of(const std::vector<std::array<double, 2>>& positions,
                                const std::vector<std::array<double, 2>>& labels) {
    const auto distance = [](const auto& a, const auto& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); };
    std::array<double, 2> mean{};
    for (const auto& at : positions)
        for (std::size_t d = 0; d < 2; ++d) mean[d] += at[d] / static_cast<double>(positions.size());
    return *std::ranges::min_element(positions, {}, [&](const auto& at) {
        const bool overlaps =
            std::ranges::any_of(labels, [&](const auto& other) { return distance(at, other) < 2.2 * circle_px; });
        return std::pair{overlaps, distance(at, mean)};
    });
}

/// The circle is dashed if another face hides this one.
std::string label(std::size_t face, const std::array<double, 2>& at, bool is_behind) {
    const std::string x = number(at[0], 6), dashes = is_behind ? " stroke-dasharray='2'" : "";
    return "<circle cx='" + x + "' cy='" + number(at[1], 6) + "' r='" + number(circle_px) +
           "' fill='white' stroke='black'" + dashes + "/><text x='" + x + "' y='" + number(at[1] + 4, 6) + "'>" +
           std::to_string(face) + "</text>\n";
}

/// A projected triangle and its face.
struct ProjectedTriangle {
    std::array<std::array<double, 2>, 3> corners;
    std::size_t face;
};

bool contains_point(const std::array<std::array<double, 2>, 3>& corners, const std::array<double, 2>& at) {
    bool left = true, right = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto &a = corners[k], &b = corners[(k + 1) % 3];
        const double side = (b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0]);
        left = left && side >= 0;
        right = right && side <= 0;
    }
    return left || right;
}

/// SVG of one view centred at `middle` [px], at most 360 px wide.
std::string drawn(const PartDescription& part, const View& view, std::array<double, 2> middle) {
    constexpr double width_px = 360;
    const auto [low, high] = box_of(part.surface);
    const Point centre = along(low, 0.5, along(high, -1, low));
    const double scale = width_px / norm(along(high, -1, low));
    const auto project = [&](const Point& p) {
        const Vector3 from = along(p, -1, centre);
        return std::array{middle[0] + scale * dot(from, view.right), middle[1] - scale * dot(from, view.up),
                          dot(from, view.eye)};
    };
    struct Drawn {
        double depth, light;
        const Patch* patch;
    };
    const std::vector<Patch> all = patches(part);
    std::vector<Drawn> order;
    for (const Patch& patch : all) {
        const auto& [a, b, c] = patch.corners;
        const Vector3 normal = cross(along(b, -1, a), along(c, -1, a));
        const double facing = dot(normal, view.eye) / norm(normal);
        if (facing > 0) order.push_back({project(a)[2] + project(b)[2] + project(c)[2], facing, &patch});
    }
    std::ranges::stable_sort(order, {}, &Drawn::depth);
    std::string svg;
    std::vector<ProjectedTriangle> shown;
    std::vector<std::vector<std::array<double, 2>>> seen(part.faces.size());  // centres of the visible patches per face
    for (const Drawn& one : order) {
        std::string points;
        std::array<double, 2> mean{};
        std::array<std::array<double, 2>, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = project(one.patch->corners[k]);
            triangle[k] = {at[0], at[1]};
            points += number(at[0], 5) + "," + number(at[1], 5) + " ";
            for (std::size_t d = 0; d < 2; ++d) mean[d] += at[d] / 3;
        }
        const std::string fill = colour(one.patch->face, one.light);
        svg += "<polygon points='" + points + "' fill='" + fill + "' stroke='" + fill + "'/>\n";
        seen[one.patch->face].push_back(mean);
        shown.push_back({triangle, one.patch->face});
    }
    const auto front_face_at = [&](const std::array<double, 2>& at) {
        const auto found = std::ranges::find_if(shown.rbegin(), shown.rend(), [&](const ProjectedTriangle& one) {
            return contains_point(one.corners, at);
        });
        return found == shown.rend() ? part.faces.size() : found->face;
    };
    std::vector<std::array<double, 2>> labels;
    for (std::size_t f = 0; f < seen.size(); ++f)
        if (!seen[f].empty()) {
            labels.push_back(middle_of(seen[f], labels));
            svg += label(f + 1, labels.back(), front_face_at(labels.back()) != f);
        }
    return svg;
}

}  // namespace

std::string description_yaml(const PartDescription& part) {
    const auto [low, high] = box_of(part.surface);
    std::string text = "# " + core::one_line(part.file) + ": ";
    for (std::size_t d = 0; d < 3; ++d)
        text += std::string{d > 0 ? ", " : ""} + components[d] + " from " + number(mm * low[d], 6) + " to " +
                number(mm * high[d], 6) + " mm";
    text += "; volume " + core::quantity_text(part.surface.volume_m3(), core::Dimension::volume) + ", surface " +
            area_text(part.surface.area_m2()) + "\n";
    for (std::size_t s = 1; s < part.surface.shells.size(); ++s)
        text += "# closed cavity `" + part.surface.shells[s].name +
                "`: " + core::quantity_text(part.surface.shells[s].volume_m3, core::Dimension::volume) + " about " +
                lengths(part.surface.shells[s].inside) + "\n";
    if (part.surface.shells.size() == 1)
        text +=
            "# no closed cavity; for an open one use cavity: {point: [x, y, z] on its wall, up_to: face around its "
            "opening}\n";
    for (const std::string& repair : part.surface.repairs) text += "# repaired: " + repair + "\n";
    text += "family: imported\ngeometry:\n  file: " + core::single_quoted(part.file) + "\n";
    if (!part.unit.empty()) text += "  unit: " + part.unit + "\n";
    if (std::ranges::any_of(part.faces, [](const PartFace& face) { return face.rule.has_value(); }))
        text += "  faces:\n";
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
        const PartFace& face = part.faces[f];
        const std::string name = "face_" + std::to_string(f + 1),
                          what = shape_text(face) + ", " + area_text(face.area_m2);
        text += face.rule ? "    " + name + ": " + rule_text(*face.rule) + "   # " + what + "\n"
                          : "    # " + name + " cannot be selected by a single rule: " + what + ", near " +
                                lengths(face.on_face) + "\n";
    }
    return text;
}

std::string numbered_faces_svg(const PartDescription& part) {
    return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 420' width='1600' height='840' text-anchor='middle' "
           "font-family='sans-serif' font-size='11' stroke-width='0.6'>\n<rect width='800' height='420' fill='white'/>\n" +
           drawn(part, view_from({1, -1.6, 0.9}), {200, 200}) + drawn(part, view_from({-1, 1.6, -0.9}), {600, 200}) +
           "<text x='200' y='410'>from +x, -y, +z</text><text x='600' y='410'>from -x, +y, -z</text>\n</svg>\n";
}

std::string unit_warning(const PartDescription& part) {
    constexpr double min_m = 2e-3, inch_over_mm = 25.4;
    const double extent_m = part.surface.extent_m();
    if (part.unit.empty() || part.unit == "in" || extent_m >= min_m) return {};
    return part.file + ": the part is " + core::quantity_text(extent_m, core::Dimension::length) +
           " long; if its lengths are in inches, use `unit: in`, which gives " +
           core::quantity_text(inch_over_mm * extent_m, core::Dimension::length);
}

}  // namespace soft::cli
