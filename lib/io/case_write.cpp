#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "io/case_check.hpp"
#include "io/case_file.hpp"
#include "io/columns.hpp"
#include "io/image.hpp"
#include "io/names.hpp"
#include "io/provenance_io.hpp"
#include "io/solve_parts.hpp"

namespace soft::io {
namespace {

void write_design(hid_t root, const std::string& name, const DesignText& design) {
    const GroupHandle group = create_group(root, "design", "the design from which this case was generated");
    write_text(group.get(), {"name", "1", "name of the case"}, name);
    write_text(group.get(), {"family", "1", "actuator family"}, design.family);
    write_text(group.get(), {"effective_yaml", "1", "the design with defaults and overrides applied"},
               design.effective_yaml);
    write_text(group.get(), {"sha256", "1", "SHA-256 of effective_yaml, hexadecimal"},
               core::sha256_hex(design.effective_yaml));
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

std::string element_types(const mesh::Mesh& mesh) {
    std::vector<mesh::CellType> types = mesh.cell_types;
    std::sort(types.begin(), types.end());
    types.erase(std::unique(types.begin(), types.end()), types.end());
    std::string text;
    for (const mesh::CellType type : types) text.append(text.empty() ? "" : " ").append(mesh::topology(type).name);
    return text;
}

void write_mesh(hid_t root, const model::Case& model) {
    const mesh::Mesh& mesh = model.mesh;
    const GroupHandle group = create_group(root, "mesh", "mesh data that VTKHDF does not define");
    write_text(group.get(), {"kinematics", "1", "axisymmetric | plane_strain | solid"},
               name_of(kinematics_names, model.kinematics));
    write_text(group.get(), {"formulation", "1", "displacement | mixed (displacement and pressure) | f_bar"},
               name_of(formulation_names, model.formulation));
    write_text(group.get(), {"element_types", "1", "cell types in the mesh; for information, not read"},
               element_types(mesh));
    write_count(group.get(), {"dimension", "1", "dimension of the cells: 2 (section) or 3"}, mesh.dimension);
    write_number(group.get(), {"model_fraction", "1", "fraction of the actuator in the mesh"}, model.model_fraction);
    write_list(group.get(),
               {"symmetry_planes", "1", "1 where the mesh is cut at the symmetry plane x = 0, y = 0, z = 0"},
               std::vector<std::uint8_t>(model.symmetry_planes.begin(), model.symmetry_planes.end()));
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
    const GroupHandle group = create_group(root, "supports", "zero displacement on named faces, one row per support");
    write_texts(group.get(), {"face", "1", "named face"}, column(supports, [](const auto& s) { return s.face; }));
    write_list(group.get(), {"fixed", "1", "1 where x, y, z (axisymmetric: x, r, unused) is fixed"},
               rows_of_three<std::uint8_t>(supports, [](const auto& s) { return s.fixed; }), {supports.size(), 3});
}

void write_cavity(hid_t cavities, const model::Cavity& cavity, std::int64_t order) {
    const GroupHandle group = create_group(cavities, cavity.name, "faces that enclose the cavity");
    write_count(group.get(), {"order", "1", "index in the list of cavities"}, order);
    write_text(group.get(), {"wall", "1", "named face, always loaded"}, cavity.wall);
    write_texts(group.get(), {"inner_faces", "1", "closed inner faces, loaded only when sealed"}, cavity.inner_faces);
    const auto& openings = cavity.openings;
    const GroupHandle holes = create_group(group.get(), "openings", "holes closed by a plug when sealed, one row each");
    write_texts(holes.get(), {"face", "1", "face that carries the plug's thrust"},
                column(openings, [](const auto& o) { return o.face; }));
    write_list(holes.get(), {"area", "m2", "undeformed area of the hole, whole actuator"},
               column(openings, [](const auto& o) { return o.area_m2; }));
    write_list(holes.get(), {"direction", "1", "unit vector out of the cavity, undeformed"},
               rows_of_three<double>(openings, [](const auto& o) { return o.direction; }), {openings.size(), 3});
}

void write_cavities(hid_t root, const std::vector<model::Cavity>& cavities) {
    const GroupHandle group = create_group(root, "loads/cavities", "cavities of the geometry");
    std::int64_t order = 0;
    for (const model::Cavity& cavity : cavities) write_cavity(group.get(), cavity, order++);
}

void write_outputs(hid_t root, const std::vector<model::Output>& outputs) {
    const GroupHandle group = create_group(root, "outputs", "measured outputs, one row per output");
    write_texts(group.get(), {"name", "1", "name of the output"},
                column(outputs, [](const auto& o) { return o.name; }));
    write_texts(group.get(), {"face", "1", "measured face"}, column(outputs, [](const auto& o) { return o.face; }));
    write_list(group.get(),
               {"direction", "1",
                "unit vector of the measured component, or axis of the angle, distance, curvature or moment"},
               rows_of_three<double>(outputs, [](const auto& o) { return o.direction; }), {outputs.size(), 3});
    write_texts(group.get(),
                {"measure", "1", "displacement | bend | twist | radial | rotation | curvature | force | moment"},
                column(outputs, [](const auto& o) { return std::string{name_of(measure_names, o.measure)}; }));
    write_texts(group.get(), {"reference", "1", "reference face of a bend; else empty"},
                column(outputs, [](const auto& o) { return o.reference; }));
    write_list(group.get(), {"is_point", "1", "1: the displacement of a point is measured, and face is empty"},
               column(outputs, [](const auto& o) { return static_cast<std::uint8_t>(o.point_m.has_value()); }));
    write_list(group.get(), {"point", "m", "undeformed position of the point; x, r, 0 in a section"},
               rows_of_three<double>(outputs, [](const auto& o) { return o.point_m.value_or(mesh::Point{}); }),
               {outputs.size(), 3});
}

}  // namespace

std::vector<std::byte> write_case(const model::Case& model, const DesignText& design, const Provenance& provenance) {
    check_case(model, "<case>", ExitCode::internal);
    const QuietErrors quiet;
    const FileHandle file = create_memory_file();
    {
        const GroupHandle root{H5Gopen2(file.get(), "/", H5P_DEFAULT)};
        write_attribute(root.get(), "format", "soft-actuator");
        write_attribute(root.get(), "format_version", std::int64_t{1});
        write_design(root.get(), model.name, design);
        write_vtkhdf(root.get(), model.mesh);
        write_mesh(root.get(), model);
        write_supports(root.get(), model.supports);
        write_solve_parts(root.get(), model);
        write_cavities(root.get(), model.cavities);
        write_outputs(root.get(), model.outputs);
        const GroupHandle records = create_group(root.get(), "provenance", "one record per program");
        write_provenance(records.get(), provenance);
    }
    std::vector<std::byte> image = memory_image(file.get());
    seal(image);
    return image;
}

}  // namespace soft::io
