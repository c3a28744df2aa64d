/// A closed surface from a file (meshing/part_file.hpp).
#include "core/text.hpp"
#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"
#include "geometry/part.hpp"
#include "meshing/part_file.hpp"

namespace soft::geometry {
namespace {

ObstacleSurface build(const ObstacleInput& input) {
    const std::string path = input.path + ".surface", &file = input.values.text(path),
                      &unit = input.values.text(input.path + ".unit");
    if (input.kinematics != model::Kinematics::solid)
        throw input.values.refuse(path, "a section has no obstacles from a surface file",
                                  "use profile, or model: solid");
    const bool lines = file.find('\n') != std::string::npos;
    if (!lines && !meshing::is_part_file(file))
        throw input.values.refuse(path, core::quoted(file) + " is not a surface file", "use .stl, .obj or .step");
    if (!lines && meshing::is_cad_file(file) && unit != "mm")
        throw input.values.refuse(input.path + ".unit", "a STEP file defines its own unit", "remove this key");
    const std::string& location = input.values.location(path);
    try {
        meshing::BodySurface surface =
            lines ? meshing::read_obj(file, unit, file_unit_m(unit)).surface
                  : meshing::read_part(design::file_from(location, file), unit, file_unit_m(unit)).surface;
        return model::FacetedSurface{std::move(surface.points), std::move(surface.triangles)};
    } catch (const Error& error) {  // add the location in the design that names the file
        throw Error(error.code(), location + ": " + path, error.what());
    }
}

}  // namespace

ObstacleShape surface_obstacle() {
    design::Key key =
        value_key("surface", design::Kind::text, {},
                  "closed surface of a body (.stl, .obj, .step), relative to the design file; or (surface: |) "
                  "the lines of an OBJ file; solids only");
    key.max_count = several_lines;
    return {{"surface", {std::move(key), file_unit_key("unit")}}, ObstacleStorage::faceted, build};
}

}  // namespace soft::geometry
