#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "io/case_check.hpp"
#include "io/case_file.hpp"
#include "io/columns.hpp"
#include "io/image.hpp"
#include "io/names.hpp"
#include "io/provenance_io.hpp"
#include "math/vector.hpp"

namespace soft::io {
namespace {

void write_design(hid_t root, const DesignText& design) {
    const GroupHandle group = create_group(root, "design", "the design from which this case was generated");
    write_text(group.get(), {"effective_yaml", "1", "the design with defaults and overrides applied"},
               design.effective_yaml);
    write_texts(group.get(), {"overrides", "1", "key.path=value, as given to --set"}, design.overrides);
}

void write_vtkhdf(hid_t root, const mesh::Mesh& mesh) {
    const GroupHandle group = create_group(root, "VTKHDF", "the mesh in the reference configuration, for ParaView");
    const std::vector<std::int64_t> version{1, 0};
    write_attribute(group.get(), "Version", version);
    write_attribute(group.get(), "Type", "UnstructuredGrid");
    const auto count = [&](const char* name, std::size_t value, std::string_view description) {
        write_list(group.get(), {name, "1", description}, std::vector{static_cast<std::int64_t>(value)});
    };
    count("NumberOfPoints", mesh.points.size(), "one partition");
    count("NumberOfCells", mesh.cell_types.size(), "one partition");
    count("NumberOfConnectivityIds", mesh.connectivity.size(), "one partition");
    write_list(group.get(), {"Points", "m", "reference position x, y, z; x, r, 0 in a section"},
               rows_of_three<double>(mesh.points, [](const mesh::Point& point) { return point; }),
               {mesh.points.size(), 3});
    write_list(group.get(), {"Connectivity", "1", "points of the cells, one cell after the other, in VTK order"},
               mesh.connectivity);
    write_list(group.get(), {"Offsets", "1", "cell c has Connectivity[Offsets[c]] to Connectivity[Offsets[c + 1] - 1]"},
               mesh.offsets);
    write_list(group.get(), {"Types", "1", "VTK cell type"},
               column(mesh.cell_types, [](mesh::CellType type) { return static_cast<std::uint8_t>(type); }));
}

void write_mesh(hid_t root, const mesh::Mesh& mesh) {
    const GroupHandle group = create_group(root, "mesh", "mesh data that VTKHDF does not define");
    write_texts(group.get(), {"region_names", "1", "names of the cell regions"}, mesh.region_names);
    write_list(group.get(), {"cell_regions", "1", "row of region_names, one per cell"}, mesh.cell_regions);
    const GroupHandle facets = create_group(group.get(), "facets", "named faces: cell, local facet in VTK order");
    for (const auto& [name, list] : mesh.facet_sets) {
        std::vector<std::int64_t> pairs;
        for (const mesh::Facet& facet : list) pairs.insert(pairs.end(), {facet.cell, facet.local});
        write_list(facets.get(), {name, "1", "cell, local facet"}, pairs, {list.size(), 2});
    }
    const GroupHandle points = create_group(group.get(), "points", "named point sets");
    for (const auto& [name, list] : mesh.point_sets) write_list(points.get(), {name, "1", "point numbers"}, list);
}

void write_supports(hid_t root, const std::vector<model::Support>& supports) {
    const GroupHandle group =
        create_group(root, "supports", "zero displacement that the shape prescribes on named faces");
    write_texts(group.get(), {"face", "1", "named face"}, column(supports, [](const auto& s) { return s.face; }));
    write_list(group.get(), {"fixed", "1", "1 where x, y, z (axisymmetric: x, r, unused) is fixed"},
               rows_of_three<std::uint8_t>(supports, [](const auto& s) { return s.fixed; }), {supports.size(), 3});
}

/// An entry of a list of a cavity, and the row of the cavity.
template <class Entry>
struct Owned {
    std::int64_t cavity;
    const Entry& entry;
};
template <class Entry>
std::vector<Owned<Entry>> owned(const std::vector<model::Cavity>& cavities, std::vector<Entry> model::Cavity::*list) {
    std::vector<Owned<Entry>> all;
    for (std::size_t i = 0; i < cavities.size(); ++i)
        for (const Entry& entry : cavities[i].*list) all.push_back({static_cast<std::int64_t>(i), entry});
    return all;
}

void write_cavities(hid_t shape, const std::vector<model::Cavity>& cavities) {
    const GroupHandle group = create_group(shape, "cavities", "the cavities, one row each");
    write_texts(group.get(), {"name", "1", "name of the cavity"},
                column(cavities, [](const auto& c) { return c.name; }));
    write_texts(group.get(), {"wall", "1", "named face, always loaded"},
                column(cavities, [](const auto& c) { return c.wall; }));
    const GroupHandle inner = create_group(group.get(), "inner_faces", "closed inner faces, loaded only when sealed");
    const auto faces = owned(cavities, &model::Cavity::inner_faces);
    write_list(inner.get(), {"cavity", "1", "row of cavities/name"},
               column(faces, [](const auto& f) { return f.cavity; }));
    write_texts(inner.get(), {"face", "1", "named face"}, column(faces, [](const auto& f) { return f.entry; }));
    const GroupHandle holes = create_group(group.get(), "openings", "holes closed by a plug when sealed, one row each");
    const auto openings = owned(cavities, &model::Cavity::openings);
    write_list(holes.get(), {"cavity", "1", "row of cavities/name"},
               column(openings, [](const auto& o) { return o.cavity; }));
    write_texts(holes.get(), {"face", "1", "face that carries the plug's thrust"},
                column(openings, [](const auto& o) { return o.entry.face; }));
    write_list(holes.get(), {"area", "m2", "undeformed area of the hole, whole actuator"},
               column(openings, [](const auto& o) { return o.entry.area_m2; }));
    write_list(holes.get(), {"direction", "1", "unit vector out of the cavity, undeformed"},
               rows_of_three<double>(openings, [](const auto& o) { return o.entry.direction; }), {openings.size(), 3});
}

void write_regions(hid_t root, const model::Shape& shape) {
    const GroupHandle materials =
        create_group(root, "materials", "regions whose material does not follow from their name");
    write_texts(materials.get(), {"region", "1", "row of /mesh/region_names"},
                column(shape.region_materials, [](const auto& entry) { return entry.first; }));
    write_texts(materials.get(),
                {"material", "1", "name below `materials` of the design; any other: the main material"},
                column(shape.region_materials, [](const auto& entry) { return entry.second; }));
    const GroupHandle group = create_group(root, "fibers", "fibres of regions in addition to those of their law");
    const auto& windings = shape.region_fibers;
    write_texts(group.get(), {"region", "1", "row of /mesh/region_names"},
                column(windings, [](const auto& entry) { return entry.first; }));
    const auto number = [&](const Label& label, double material::Fibers::*member) {
        write_list(group.get(), label,
                   column(windings, [&](const auto& entry) { return entry.second.fibers.*member; }));
    };
    number({"angle", "rad", "angle of the fibres from the axis x"}, &material::Fibers::angle_rad);
    number({"k1", "Pa", "stiffness of the fibres"}, &material::Fibers::k1_Pa);
    number({"k2", "1", "exponent of the fibres"}, &material::Fibers::k2);
    write_list(
        group.get(), {"families", "1", "number of families of fibres: 1 or 2"},
        column(windings, [](const auto& entry) { return static_cast<std::int64_t>(entry.second.fibers.families); }));
    write_texts(group.get(), {"frame", "1", "cartesian | cylindrical"}, column(windings, [](const auto& entry) {
                    return std::string{name_of(fiber_frame_names, entry.second.frame)};
                }));
}

/// Faceted obstacles, one group each.
void write_obstacles(hid_t shape, const std::map<std::string, model::FacetedSurface>& obstacles) {
    const GroupHandle group = create_group(shape, "obstacles", "obstacles with a faceted surface, by name");
    for (const auto& [name, surface] : obstacles) {
        const GroupHandle one = create_group(group.get(), name.c_str(), "a faceted surface, normals to the actuator");
        write_list(one.get(), {"points", "m", "position x, y, z; x, r, 0 in a section"},
                   rows_of_three<double>(surface.points, [](const mesh::Point& point) { return point; }),
                   {surface.points.size(), 3});
        write_list(one.get(), {"facets", "1", "rows of points: triangle, or segment of a section and -1"},
                   rows_of_three<std::int64_t>(surface.facets, [](const auto& facet) { return facet; }),
                   {surface.facets.size(), 3});
    }
}

void write_shape(hid_t root, const model::Shape& shape) {
    const GroupHandle group = create_group(root, "shape", "what the shape adds to the mesh");
    write_text(group.get(), {"kinematics", "1", "axisymmetric | plane_strain | solid"},
               name_of(kinematics_names, shape.kinematics));
    write_number(group.get(), {"model_fraction", "1", "fraction of the actuator in the mesh"}, shape.model_fraction);
    write_list(group.get(),
               {"symmetry_planes", "1", "1 where the mesh is cut at the symmetry plane x = 0, y = 0, z = 0"},
               std::vector<std::uint8_t>(shape.symmetry_planes.begin(), shape.symmetry_planes.end()));
    write_list(group.get(), {"axis", "1", "unit vector from the fixed to the moving face"},
               std::vector<double>(shape.axis.begin(), shape.axis.end()));
    write_supports(group.get(), shape.supports);
    write_cavities(group.get(), shape.cavities);
    write_regions(group.get(), shape);
    write_obstacles(group.get(), shape.obstacles);
}

/// Moves of the points instead of their positions: most are 0 or alike, and compress well.
void write_side(hid_t parent, const char* name, const mesh::Mesh& mesh, const model::Variation::Side& side) {
    const GroupHandle group = create_group(parent, name, "what differs from the case");
    write_text(group.get(), {"effective_yaml", "1", "the design with this value"}, side.effective_yaml);
    std::vector<mesh::Point> moves(side.points.size());
    std::ranges::transform(side.points, mesh.points, moves.begin(), difference);
    write_list(group.get(),
               {"moves", "m", "of the points, from their positions in the case: x, y, z; x, r, 0 in a section"},
               rows_of_three<double>(moves, [](const mesh::Point& move) { return move; }), {moves.size(), 3});
    write_shape(group.get(), side.shape);
}

/// One group per number of the design, "0", "1", ...
void write_variations(hid_t root, const mesh::Mesh& mesh, std::span<const model::Variation> variations) {
    if (variations.empty()) return;
    const GroupHandle group =
        create_group(root, "variations", "the case with a smaller and a larger value of a number of the design");
    for (std::size_t i = 0; i < variations.size(); ++i) {
        const auto& [parameter, lower, higher] = variations[i];
        const GroupHandle one = create_group(group.get(), std::to_string(i), "the number, and both cases");
        write_text(one.get(), {"key", "1", "key path in the design"}, parameter.key);
        write_text(one.get(), {"unit", "1", "as written in the design; empty for a pure number"}, parameter.unit);
        write_number(one.get(), {"SI_per_unit", "1", "SI value of the unit"}, parameter.SI_per_unit);
        write_number(one.get(), {"value", "1", "in the case, SI"}, parameter.value);
        write_number(one.get(), {"lower_value", "1", "SI"}, parameter.lower);
        write_number(one.get(), {"higher_value", "1", "SI"}, parameter.higher);
        write_side(one.get(), "lower", mesh, lower);
        write_side(one.get(), "higher", mesh, higher);
    }
}

}  // namespace

std::vector<std::byte> write_case(const mesh::Mesh& mesh, const model::Shape& shape, const DesignText& design,
                                  const Provenance& provenance, std::span<const model::Variation> variations) {
    check_case(mesh, shape, "<case>", ExitCode::internal);
    const QuietErrors quiet;
    const FileHandle file = create_memory_file();
    {
        const GroupHandle root{H5Gopen2(file.get(), "/", H5P_DEFAULT)};
        write_attribute(root.get(), "format", "soft-actuator");
        write_attribute(root.get(), "format_version", format_version);
        write_design(root.get(), design);
        write_vtkhdf(root.get(), mesh);
        write_mesh(root.get(), mesh);
        write_shape(root.get(), shape);
        write_variations(root.get(), mesh, variations);
        const GroupHandle records = create_group(root.get(), "provenance", "one record per program");
        write_provenance(records.get(), provenance);
    }
    std::vector<std::byte> image = memory_image(file.get());
    seal(image);
    return image;
}

}  // namespace soft::io
