/// Any body of revolution about x; its half section is given as a table (profile.hpp).
#include <algorithm>
#include <numbers>

#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "geometry/profile.hpp"

namespace soft::geometry {
namespace {

constexpr Across across = Across::r;

/// Where the wall ends away from the axis, a plug is attached to the adjacent edge. The solid lies to the left of the wall, so at the
/// end of the wall the opening faces +x, at its start -x: closed integral of n dA = 0.
std::vector<model::Opening> plugs(const meshing::Outline& outline, const std::string& wall) {
    const auto is_wall = [&](const meshing::OutlineEdge& edge) {
        return std::ranges::find(edge.faces, wall) != edge.faces.end();
    };
    std::vector<model::Opening> openings;
    for (const meshing::Loop& loop : outline.loops)
        for (std::size_t e = 0; e < loop.size(); ++e) {
            const meshing::OutlineEdge &before = loop[e], &after = loop[(e + 1) % loop.size()];
            const meshing::OutlineEdge& rim = is_wall(before) ? after : before;
            const double radius_m = after.points.front()[1];
            if (is_wall(before) == is_wall(after) || radius_m == 0 || rim.faces.front() == meshing::symmetry_x_face)
                continue;
            openings.push_back(
                {rim.faces.front(), std::numbers::pi * radius_m * radius_m, {is_wall(before) ? 1.0 : -1.0, 0, 0}});
        }
    return openings;
}

design::FileFaces faces_of_file(const std::string& file, std::string_view location) {
    return {tags_of(outline_of_file(file, location, across))};
}

Body build(const design::Values& values) {
    Body body = body_of_profile(values, across);
    for (model::Cavity& cavity : body.cavities) cavity.openings = plugs(body.outline, cavity.wall);
    body.sweep = Revolution{sectors(values)};
    return body;
}

}  // namespace

constexpr const char* revolved_table = R"(x_mm,r_mm,tag,curve,via_x_mm,via_r_mm
0,8,cavity,,,
20,8,cavity,arc,25.6568542495,5.6568542495
28,0,axis,,,
30,0,tip,arc,29.8480775301,1.7364817767
29.3969262079,3.4202014333,outer,arc,25.7357643635,8.1915204429
20,10,outer,,,
0,10,fixed,,,
)";

Family revolved() {
    design::FamilyKeys keys;
    keys.name = "revolved";
    keys.summary = "any body of revolution, its half section in a table (CSV) of lines, arcs and splines";
    keys.geometry = {file_key(across)};
    keys.models = {"axisymmetric", "solid", "half", "quarter"};
    keys.faces = {"fixed", "cavity", "outer", "tip"};  // of the template's table
    keys.defaults = std::string{"geometry:\n"} + block("profile", revolved_table) +
                    "supports: {fixed: fixed}\n"
                    "loads:\n"
                    "  cavity: {pressure: 20 kPa}\n"
                    "outputs:\n"
                    "  elongation: {face: tip, along: x}\n";
    keys.mesh = profile_mesh_keys();
    keys.mesh.push_back(sectors_key());
    keys.faces_of_file = faces_of_file;
    return {std::move(keys), build};
}

}  // namespace soft::geometry
