#include "io/case_read.hpp"

#include <algorithm>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "io/case_check.hpp"
#include "io/columns.hpp"
#include "io/image.hpp"
#include "io/names.hpp"
#include "io/provenance_io.hpp"
#include "io/solve_parts.hpp"
#include "io/subprocess_read.hpp"

namespace soft::io {
namespace {

constexpr std::int64_t max_entities = std::int64_t{1} << 31;  // points or cells: far beyond any mesh that can be solved

void read_vtkhdf(const GroupReader& group, mesh::Mesh& mesh) {
    if (group.integer_attribute("Version", 2) != std::vector<std::int64_t>{1, 0})
        throw group.refuse("Version", "is not 1.0");
    if (group.text_attribute("Type") != "UnstructuredGrid") throw group.refuse("Type", "is not UnstructuredGrid");
    const auto size = [&](const std::string& name) {
        const std::int64_t value = group.array<std::int64_t>(name, {1})[0];
        if (value < 1 || value > 64 * max_entities)
            throw group.refuse(name, std::to_string(value) + " is out of range");
        return value;
    };
    const std::int64_t points = size("NumberOfPoints");
    const std::int64_t cells = size("NumberOfCells");
    const auto coordinates = group.array<double>("Points", {points, 3});
    mesh.points.resize(static_cast<std::size_t>(points));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i] = triple<double>(coordinates, i);
    mesh.connectivity = group.array<std::int64_t>("Connectivity", {size("NumberOfConnectivityIds")});
    mesh.offsets = group.array<std::int64_t>("Offsets", {cells + 1});
    const auto types = group.array<std::uint8_t>("Types", {cells});
    mesh.cell_types.reserve(types.size());
    for (std::size_t c = 0; c < types.size(); ++c) {
        const auto type = mesh::cell_type_from_vtk(types[c]);
        if (!type)
            throw group.refuse("Types[" + std::to_string(c) + "]",
                               "cell type " + std::to_string(types[c]) + " is not supported");
        mesh.cell_types.push_back(*type);
    }
}

std::vector<mesh::Facet> read_facets(const GroupReader& group, const std::string& name) {
    const auto pairs = group.array<std::int64_t>(name, {any, 2});
    std::vector<mesh::Facet> facets(pairs.size() / 2);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        constexpr std::int64_t max_facets = 6;  // of any cell type; check_case checks the number of facets of the cell
        const std::int64_t local = pairs[2 * i + 1];
        if (local < 0 || local >= max_facets)
            throw group.refuse(name + "[" + std::to_string(i) + "]", "no cell has a facet " + std::to_string(local));
        facets[i] = {pairs[2 * i], static_cast<int>(local)};
    }
    return facets;
}

void read_mesh(const GroupReader& group, model::Case& model) {
    model.kinematics = group.word("kinematics", kinematics_names);
    model.formulation = group.word("formulation", formulation_names);
    model.model_fraction = group.number("model_fraction");
    model.symmetry_planes = triple<bool>(group.flags("symmetry_planes", {3}), 0);
    mesh::Mesh& mesh = model.mesh;
    mesh.dimension = group.int_count("dimension", 2);
    mesh.region_names = group.texts("region_names");
    mesh.cell_regions = group.array<std::int32_t>("cell_regions", {mesh.cell_count()});
    const GroupReader facets = group.group("facets");
    for (const std::string& name : facets.names()) mesh.facet_sets[name] = read_facets(facets, name);
    const GroupReader points = group.group("points");
    for (const std::string& name : points.names()) mesh.point_sets[name] = points.array<std::int64_t>(name, {any});
}

std::vector<model::Support> read_supports(const GroupReader& group) {
    const auto faces = group.texts("face");
    const auto fixed = group.flags("fixed", {extent(faces.size()), 3});
    std::vector<model::Support> supports;
    for (std::size_t i = 0; i < faces.size(); ++i) supports.push_back({faces[i], triple<bool>(fixed, i)});
    return supports;
}

std::vector<model::Cavity> read_cavities(const GroupReader& group) {
    std::vector<model::Cavity> cavities;
    for (const std::string& name : ordered_names(group)) {
        const GroupReader one = group.group(name);
        model::Cavity& cavity = cavities.emplace_back();
        cavity.name = name;
        cavity.wall = one.text("wall");
        cavity.inner_faces = one.texts("inner_faces");
        const GroupReader openings = one.group("openings");
        const auto faces = openings.texts("face");
        const auto areas = openings.array<double>("area", {extent(faces.size())});
        const auto directions = openings.array<double>("direction", {extent(faces.size()), 3});
        for (std::size_t i = 0; i < faces.size(); ++i)
            cavity.openings.push_back({faces[i], areas[i], triple<double>(directions, i)});
    }
    return cavities;
}

std::vector<model::Output> read_outputs(const GroupReader& group) {
    const auto names = group.texts("name");
    const auto faces = group.texts("face", extent(names.size()));
    const auto directions = group.array<double>("direction", {extent(names.size()), 3});
    const auto measures = read_words(group, "measure", measure_names, extent(names.size()));
    const auto references = group.texts("reference", extent(names.size()));
    const auto is_point = group.flags("is_point", {extent(names.size())});
    const auto points = group.array<double>("point", {extent(names.size()), 3});
    std::vector<model::Output> outputs;
    for (std::size_t i = 0; i < names.size(); ++i)
        outputs.push_back({names[i], faces[i], triple<double>(directions, i), measures[i], references[i],
                           is_point[i] == 1 ? std::optional{triple<double>(points, i)} : std::nullopt});
    return outputs;
}

}  // namespace

std::vector<std::string> ordered_names(const GroupReader& group) {
    const std::vector<std::string> names = group.names();
    std::vector<std::string> ordered(names.size());
    for (const std::string& name : names) {
        const std::int64_t order = group.group(name).count("order", 0, extent(names.size()) - 1);
        auto& slot = ordered[static_cast<std::size_t>(order)];
        if (!slot.empty()) throw group.refuse(name + "/order", "is the same as the order of " + core::quoted(slot));
        slot = name;
    }
    return ordered;
}

DesignText read_design_text(const GroupReader& group) {
    DesignText design{group.has("family") ? group.text("family") : std::string{}, group.text("effective_yaml"),
                      group.texts("overrides")};
    if (core::sha256_hex(design.effective_yaml) != group.text("sha256"))
        throw group.refuse("effective_yaml", "does not match its SHA-256");
    return design;
}

CaseFile read_case_groups(const GroupReader& root) {
    CaseFile file;
    const GroupReader design = root.group("design");
    file.design = read_design_text(design);
    model::Case& model = file.model;
    model.name = design.text("name");
    read_vtkhdf(root.group("VTKHDF"), model.mesh);
    read_mesh(root.group("mesh"), model);
    model.supports = read_supports(root.group("supports"));
    model.cavities = read_cavities(root.group("loads").group("cavities"));
    read_solve_parts(root, model);
    model.outputs = read_outputs(root.group("outputs"));
    file.provenance = read_provenance(root);
    check_case(model, root.origin().source, ExitCode::bad_input);
    return file;
}

CaseFile read_bare_case(std::span<const std::byte> hdf5, const Origin& origin) {
    const FileHandle file = open_image(hdf5, origin);
    return read_case_groups(GroupReader{file.get(), origin});
}

CaseFile read_case_file(std::span<const std::byte> image, std::string_view source) {
    const ImageParts parts = split_image(image, source);
    const QuietErrors quiet;
    const Origin origin{std::string{source}, parts.hdf5.size()};
    if (!parts.sealed)
        read_in_subprocess(origin, [&](const Origin& noted) { static_cast<void>(read_bare_case(parts.hdf5, noted)); });
    return read_bare_case(parts.hdf5, origin);
}

model::Case read_case(std::span<const std::byte> image, std::string_view source) {
    return read_case_file(image, source).model;
}

}  // namespace soft::io
