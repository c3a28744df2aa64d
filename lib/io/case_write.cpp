#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "io/case_check.hpp"
#include "io/case_file.hpp"
#include "io/hdf5_write.hpp"
#include "io/image.hpp"
#include "io/names.hpp"
#include "io/provenance_io.hpp"

namespace soft::io {
namespace {

/// One column of a list of structs.
template <class List, class Pick>
auto column(const List& list, Pick pick) {
    std::vector<std::decay_t<decltype(pick(list.front()))>> values;
    values.reserve(list.size());
    for (const auto& entry : list) values.push_back(pick(entry));
    return values;
}

/// The same of a member that is an array of three, row after row.
template <class T, class List, class Pick>
std::vector<T> rows_of_three(const List& list, Pick pick) {
    std::vector<T> values;
    values.reserve(list.size() * 3);
    for (const auto& entry : list)
        for (const auto value : pick(entry)) values.push_back(static_cast<T>(value));
    return values;
}

template <class T>
void write_list(hid_t group, const Label& label, const std::vector<T>& values, std::vector<hsize_t> shape = {}) {
    write_array<T>(group, label, values, std::move(shape));
}

void write_design(hid_t root, const std::string& name, const DesignText& design) {
    const GroupHandle group = create_group(root, "design", "the design this case was made from");
    write_text(group.get(), {"name", "1", "name of the case"}, name);
    write_text(group.get(), {"family", "1", "actuator family"}, design.family);
    write_text(group.get(), {"effective_yaml", "1", "the design with defaults and overrides in place"},
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
    write_list(group.get(), {"Points", "m", "reference position x, y, z; a section holds x, r, 0"},
               rows_of_three<double>(mesh.points, [](const mesh::Point& point) { return point; }),
               {mesh.points.size(), 3});
    write_list(group.get(), {"Connectivity", "1", "points of the cells, one cell after the other, in VTK order"},
               mesh.connectivity);
    write_list(group.get(), {"Offsets", "1", "cell c has Connectivity[Offsets[c]] up to Connectivity[Offsets[c + 1]]"},
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
    const GroupHandle group = create_group(root, "mesh", "what VTKHDF has no place for");
    write_text(group.get(), {"kinematics", "1", "axisymmetric | plane_strain | solid"},
               name_of(kinematics_names, model.kinematics));
    write_text(group.get(), {"formulation", "1", "displacement | mixed (displacement and pressure)"},
               name_of(formulation_names, model.formulation));
    write_text(group.get(), {"element_types", "1", "cell types that occur; for people, not read"}, element_types(mesh));
    write_count(group.get(), {"dimension", "1", "of the cells: 2 (section) or 3"}, mesh.dimension);
    write_number(group.get(), {"model_fraction", "1", "part of the actuator in the mesh"}, model.model_fraction);
    write_list(group.get(), {"symmetry_planes", "1", "1 where the mesh is cut at x = 0, y = 0, z = 0"},
               std::vector<std::uint8_t>(model.symmetry_planes.begin(), model.symmetry_planes.end()));
    write_texts(group.get(), {"region_names", "1", "names of the cell regions"}, mesh.region_names);
    write_list(group.get(), {"cell_regions", "1", "row of region_names, one a cell"}, mesh.cell_regions);
    const GroupHandle facets = create_group(group.get(), "facets", "named faces: cell, local facet in VTK order");
    for (const auto& [name, list] : mesh.facet_sets) {
        std::vector<std::int64_t> pairs;
        for (const mesh::Facet& facet : list) pairs.insert(pairs.end(), {facet.cell, facet.local});
        write_list(facets.get(), {name, "1", "cell, local facet"}, pairs, {list.size(), 2});
    }
    const GroupHandle points = create_group(group.get(), "points", "named point sets");
    for (const auto& [name, list] : mesh.point_sets) write_list(points.get(), {name, "1", "point numbers"}, list);
}

void write_materials(hid_t root, const std::vector<model::Material>& materials) {
    const GroupHandle group = create_group(root, "materials", "one group a cell region, by its name");
    std::int64_t order = 0;
    for (const model::Material& material : materials) {
        const GroupHandle one = create_group(group.get(), material.name, "hyperelastic law and constants");
        write_count(one.get(), {"order", "1", "place in the list of materials"}, order++);
        write_text(one.get(), {"law", "1", "name of the law"}, material.law);
        write_text(one.get(), {"volumetric", "1", "volumetric energy: quadratic | log | mixed"},
                   name_of(volumetric_names, material.volumetric));
        write_text(one.get(), {"fiber_frame", "1", "directions of fibres: cartesian x, y | cylindrical x, hoop"},
                   name_of(fiber_frame_names, material.fiber_frame));
        if (material.bulk_modulus_Pa)
            write_number(one.get(), {"bulk_modulus", "Pa", "kappa; absent: incompressible"}, *material.bulk_modulus_Pa);
        const GroupHandle constants = create_group(one.get(), "constants", "by the law's own keys");
        for (const auto& [key, values] : material.constants)
            write_list(constants.get(), {key, "SI", "constant of the law, one value or a list"}, values);
    }
}

void write_supports(hid_t root, const std::vector<model::Support>& supports) {
    const GroupHandle group = create_group(root, "supports", "zero displacement on named faces, one row a support");
    write_texts(group.get(), {"face", "1", "named face"}, column(supports, [](const auto& s) { return s.face; }));
    write_list(group.get(), {"fixed", "1", "1 where x, y, z (axisymmetric: x, r, unused) is held"},
               rows_of_three<std::uint8_t>(supports, [](const auto& s) { return s.fixed; }), {supports.size(), 3});
}

void write_cavity(hid_t cavities, const model::Cavity& cavity, std::int64_t order) {
    const GroupHandle group = create_group(cavities, cavity.name, "faces that enclose the cavity");
    write_count(group.get(), {"order", "1", "place in the list of cavities"}, order);
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

void write_loads(hid_t root, const model::Case& model) {
    const auto& loads = model.loads;
    const GroupHandle group = create_group(root, "loads", "follower pressures at load factor 1, one row a load");
    write_texts(group.get(), {"target", "1", "cavity or named face"},
                column(loads, [](const auto& l) { return l.target; }));
    write_list(group.get(), {"pressure", "Pa", "above ambient; positive inflates, traction -p n on the deformed area"},
               column(loads, [](const auto& l) { return l.pressure_Pa; }));
    write_list(group.get(), {"sealed", "1", "1: plugs and inner faces are loaded too"},
               column(loads, [](const auto& l) { return static_cast<std::uint8_t>(l.sealed); }));
    const auto& tractions = model.tractions;
    const GroupHandle dead = create_group(group.get(), "tractions", "dead tractions at load factor 1, one row a load");
    write_texts(dead.get(), {"face", "1", "named face"}, column(tractions, [](const auto& t) { return t.face; }));
    write_list(dead.get(), {"traction", "Pa", "force per undeformed area: x, y, z (axisymmetric: x, r, unused)"},
               rows_of_three<double>(tractions, [](const auto& t) { return t.traction_Pa; }), {tractions.size(), 3});
    const GroupHandle cavities = create_group(group.get(), "cavities", "cavities of the geometry");
    std::int64_t order = 0;
    for (const model::Cavity& cavity : model.cavities) write_cavity(cavities.get(), cavity, order++);
}

void write_outputs(hid_t root, const std::vector<model::Output>& outputs) {
    const GroupHandle group = create_group(root, "outputs", "measured displacements, one row an output");
    write_texts(group.get(), {"name", "1", "name of the output"},
                column(outputs, [](const auto& o) { return o.name; }));
    write_texts(group.get(), {"face", "1", "face over whose undeformed area the mean is taken"},
                column(outputs, [](const auto& o) { return o.face; }));
    write_list(group.get(), {"direction", "1", "unit vector of the measured component"},
               rows_of_three<double>(outputs, [](const auto& o) { return o.direction; }), {outputs.size(), 3});
}

void write_control(hid_t root, const model::PathSettings& path, const model::SolverSettings& solver) {
    const GroupHandle group = create_group(root, "control", "how the path is followed");
    write_text(group.get(), {"control", "1", "pressure | volume | displacement | arc_length"},
               name_of(control_names, path.control));
    const GroupHandle until = create_group(group.get(), "until", "the path ends at the first that is reached");
    write_texts(until.get(), {"quantity", "1", "pressure | volume_ratio | steps | name of an output"},
                column(path.until, [](const auto& u) { return u.quantity; }));
    write_list(until.get(), {"value", "SI", "in the unit of the quantity: Pa, 1, 1, m"},
               column(path.until, [](const auto& u) { return u.value; }));
    const GroupHandle settings = create_group(group.get(), "solver", "tolerances and limits");
    const hid_t id = settings.get();
    write_number(id, {"residual_tolerance", "1", "relative to the nodal forces"}, solver.residual_tolerance);
    write_count(id, {"newton_limit", "1", "iterations a step"}, solver.newton_limit);
    write_number(id, {"first_step", "1", "fraction of the full load in the linear response"}, solver.first_step);
    write_number(id, {"largest_step", "1", "fraction of the path; 0: chosen by the solver"}, solver.largest_step);
    write_number(id, {"smallest_step", "1", "fraction of the first step"}, solver.smallest_step);
    write_count(id, {"step_limit", "1", "most steps of a path"}, solver.step_limit);
    write_number(id, {"step_accuracy", "1", "wanted relative error of the predictor"}, solver.step_accuracy);
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
        write_materials(root.get(), model.materials);
        write_supports(root.get(), model.supports);
        write_loads(root.get(), model);
        write_outputs(root.get(), model.outputs);
        write_control(root.get(), model.path, model.solver);
        const GroupHandle records = create_group(root.get(), "provenance", "one record a stage");
        write_provenance(records.get(), provenance);
    }
    std::vector<std::byte> image = memory_image(file.get());
    seal(image);
    return image;
}

}  // namespace soft::io
