/// Any section (x, y), given as a table (profile.hpp): a long body in plane strain, or a solid extruded along z.
#include <algorithm>

#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "geometry/profile.hpp"

namespace soft::geometry {
namespace {

constexpr Across across = Across::y;
constexpr const char *low_end = "end_z0", *high_end = "end_z1";

/// Area of a hole through the body that opens in both end faces, or 0 if the wall is open at a side. A wall that ends on a symmetry
/// plane is closed by its mirror image; the plane contains the origin and adds nothing to the sum over x dy - y dx.
double hole_m2(const Body& body, const std::string& wall) {
    double area = 0;
    for (const meshing::Loop& loop : body.outline.loops) {
        meshing::Loop own;
        for (std::size_t e = 0; e < loop.size(); ++e) {
            const meshing::OutlineEdge &edge = loop[e], &next = loop[(e + 1) % loop.size()];
            const auto is_wall = [&](const meshing::OutlineEdge& one) {
                return std::ranges::find(one.faces, wall) != one.faces.end();
            };
            if (is_wall(edge)) own.push_back(edge);
            if (is_wall(edge) == is_wall(next)) continue;
            const std::string& beside = (is_wall(edge) ? next : edge).faces.front();
            if (beside != meshing::symmetry_x_face && beside != meshing::symmetry_y_face) return 0;
        }
        area -= area_m2(own);
    }
    return area / body.fraction;
}

design::FileFaces faces_of_file(const std::string& file, std::string_view location) {
    const meshing::Outline outline = outline_of_file(file, location, across);
    std::vector<std::string> faces = tags_of(outline);
    for (const char* end : {low_end, high_end}) {
        if (std::ranges::find(faces, end) != faces.end())
            throw Error(ExitCode::bad_input, std::string{location} + ": " + profile_key,
                        std::string{"an edge is tagged '"} + end + "', which is the name of an end face",
                        "use another tag");
        faces.emplace_back(end);
    }
    return {faces};
}

Body build(const design::Values& values) {
    Body body = body_of_profile(values, across);
    const double thickness_m = values.number("geometry.thickness");
    body.sweep = meshing::Extrusion{thickness_m,
                                    profile_cells(body.outline, values).along(thickness_m),
                                    {low_end},
                                    {high_end},
                                    meshing::Extrusion::Along::z};
    if (model_of(values) != Model::solid) return body;
    for (model::Cavity& cavity : body.cavities)
        if (const double area = hole_m2(body, cavity.wall); area > 0)
            cavity.openings = {{low_end, area, {0, 0, -1}}, {high_end, area, {0, 0, 1}}};
    return body;
}

}  // namespace

constexpr const char* extruded_table = R"(x_mm,y_mm,tag,loop,curve,via_x_mm,via_y_mm
-12,0,base,block,,,
12,0,side,block,,,
12,12,top,block,,,
-12,12,side,block,,,
-6,6,cavity,slot,arc,-8,8
-6,10,cavity,slot,,,
6,10,cavity,slot,arc,8,8
6,6,cavity,slot,,,
)";

Family extruded() {
    design::FamilyKeys keys;
    keys.name = "extruded";
    keys.summary = "any section in a table (CSV) of lines, arcs and splines, in plane strain or extruded";
    keys.geometry = {file_key(across),
                     length_key("thickness", "10 mm", "thickness of the solid along z; in plane strain it is 1 m")};
    keys.models = {"plane-strain", "solid"};
    keys.faces = {"base", "cavity", "side", "top", low_end, high_end};  // of the template's table
    keys.defaults = std::string{"geometry:\n"} + block("profile", extruded_table) +
                    "supports: {fixed: base}\n"
                    "loads:\n"
                    "  cavity: {pressure: 20 kPa}\n"
                    "outputs:\n"
                    "  rise: {face: top, along: y}\n";
    keys.mesh = profile_mesh_keys();
    keys.faces_of_file = faces_of_file;
    return {std::move(keys), build};
}

}  // namespace soft::geometry
