#include "io/case_read.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "io/case_check.hpp"
#include "io/columns.hpp"
#include "io/image.hpp"
#include "io/names.hpp"
#include "io/provenance_io.hpp"
#include "io/subprocess_read.hpp"
#include "math/vector.hpp"

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

void read_mesh(const GroupReader& group, mesh::Mesh& mesh) {
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

/// Row of the list of cavities, of an entry that belongs to a cavity.
model::Cavity& cavity_at(std::vector<model::Cavity>& cavities, std::int64_t row, const GroupReader& group,
                         std::size_t i) {
    if (row < 0 || row >= extent(cavities.size()))
        throw group.refuse("cavity[" + std::to_string(i) + "]", "there is no cavity " + std::to_string(row));
    return cavities[static_cast<std::size_t>(row)];
}

std::vector<model::Cavity> read_cavities(const GroupReader& group) {
    std::vector<model::Cavity> cavities;
    for (const std::string& name : group.texts("name")) cavities.push_back({name, {}, {}, {}});
    const auto walls = group.texts("wall", extent(cavities.size()));
    for (std::size_t i = 0; i < cavities.size(); ++i) cavities[i].wall = walls[i];
    const GroupReader inner = group.group("inner_faces"), openings = group.group("openings");
    const auto inner_faces = inner.texts("face");
    const auto inner_rows = inner.array<std::int64_t>("cavity", {extent(inner_faces.size())});
    for (std::size_t i = 0; i < inner_faces.size(); ++i)
        cavity_at(cavities, inner_rows[i], inner, i).inner_faces.push_back(inner_faces[i]);
    const auto faces = openings.texts("face");
    const auto rows = openings.array<std::int64_t>("cavity", {extent(faces.size())});
    const auto areas = openings.array<double>("area", {extent(faces.size())});
    const auto directions = openings.array<double>("direction", {extent(faces.size()), 3});
    for (std::size_t i = 0; i < faces.size(); ++i)
        cavity_at(cavities, rows[i], openings, i)
            .openings.push_back({faces[i], areas[i], triple<double>(directions, i)});
    return cavities;
}

std::map<std::string, model::Shape::Winding> read_fibers(const GroupReader& group) {
    const auto regions = group.texts("region");
    const Shape rows{extent(regions.size())};
    const auto angles = group.array<double>("angle", rows), k1 = group.array<double>("k1", rows),
               k2 = group.array<double>("k2", rows);
    const auto families = group.array<std::int64_t>("families", rows);
    const auto frames = read_words(group, "frame", fiber_frame_names, rows[0]);
    std::map<std::string, model::Shape::Winding> windings;
    for (std::size_t i = 0; i < regions.size(); ++i)
        windings[regions[i]] = {{angles[i], k1[i], k2[i], group.to_int("families", families[i], 1)}, frames[i]};
    return windings;
}

/// A case without obstacles may lack the group: older files do.
std::map<std::string, model::FacetedSurface> read_obstacles(const GroupReader& shape) {
    std::map<std::string, model::FacetedSurface> obstacles;
    if (!shape.has("obstacles")) return obstacles;
    const GroupReader group = shape.group("obstacles");
    for (const std::string& name : group.names()) {
        const GroupReader one = group.group(name);
        model::FacetedSurface& surface = obstacles[name];
        const auto points = one.array<double>("points", {any, 3});
        for (std::size_t i = 0; 3 * i < points.size(); ++i) surface.points.push_back(triple<double>(points, i));
        const auto facets = one.array<std::int64_t>("facets", {any, 3});
        for (std::size_t i = 0; 3 * i < facets.size(); ++i) {
            auto& facet = surface.facets.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) facet[k] = one.to_int("facets", facets[3 * i + k], -1);
        }
    }
    return obstacles;
}

model::Shape read_shape(const GroupReader& group) {
    model::Shape shape;
    shape.kinematics = group.word("kinematics", kinematics_names);
    shape.model_fraction = group.number("model_fraction");
    shape.symmetry_planes = triple<bool>(group.flags("symmetry_planes", {3}), 0);
    shape.axis = triple<double>(group.array<double>("axis", {3}), 0);
    shape.supports = read_supports(group.group("supports"));
    shape.cavities = read_cavities(group.group("cavities"));
    const GroupReader materials = group.group("materials");
    const auto regions = materials.texts("region");
    const auto names = materials.texts("material", extent(regions.size()));
    for (std::size_t i = 0; i < regions.size(); ++i) shape.region_materials[regions[i]] = names[i];
    shape.region_fibers = read_fibers(group.group("fibers"));
    shape.obstacles = read_obstacles(group);
    return shape;
}

model::Variation::Side read_side(const GroupReader& group, const mesh::Mesh& mesh) {
    model::Variation::Side side{{}, read_shape(group.group("shape")), group.text("effective_yaml")};
    const auto moves = group.array<double>("moves", {extent(mesh.points.size()), 3});
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        side.points.push_back(along(mesh.points[i], 1, triple<double>(moves, i)));
    mesh::Mesh moved = mesh;
    moved.points = side.points;
    check_case(moved, side.shape, group.origin().source, ExitCode::bad_input);
    return side;
}

/// Absent unless mesh-gen was asked for sensitivities.
std::vector<model::Variation> read_variations(const GroupReader& root, const mesh::Mesh& mesh) {
    std::vector<model::Variation> variations;
    if (!root.has("variations")) return variations;
    const GroupReader group = root.group("variations");
    for (std::size_t i = 0; i < group.names().size(); ++i) {
        const GroupReader one = group.group(std::to_string(i));
        const model::DesignParameter parameter{one.text("key"),           one.text("unit"),
                                               one.number("SI_per_unit"), one.number("value"),
                                               one.number("lower_value"), one.number("higher_value")};
        if (!is_name(parameter.key)) throw one.refuse("key", core::quoted(parameter.key) + " is not a key");
        if (!(parameter.SI_per_unit > 0)) throw one.refuse("SI_per_unit", "is not positive");
        if (!(parameter.lower < parameter.higher && parameter.lower <= parameter.value &&
              parameter.value <= parameter.higher))
            throw one.refuse("value", "is not between lower_value and higher_value");
        variations.push_back({parameter, read_side(one.group("lower"), mesh), read_side(one.group("higher"), mesh)});
    }
    return variations;
}

StoredCase read_bare_case(std::span<const std::byte> hdf5, const Origin& origin) {
    const FileHandle file = open_image(hdf5, origin);
    return read_stored_case(GroupReader{file.get(), origin});
}

}  // namespace

DesignText read_design_text(const GroupReader& group) {
    return {group.text("effective_yaml"), group.texts("overrides")};
}

std::string design_location(const Origin& origin, std::string_view group) {
    return origin.source + ":/" + std::string{group} + "/effective_yaml";
}

StoredCase read_stored_case(const GroupReader& root) {
    StoredCase stored;
    stored.design = read_design_text(root.group("design"));
    stored.shape = read_shape(root.group("shape"));
    stored.mesh.dimension = model::dimension_of(stored.shape.kinematics);
    read_vtkhdf(root.group("VTKHDF"), stored.mesh);
    read_mesh(root.group("mesh"), stored.mesh);
    stored.provenance = read_provenance(root);
    check_case(stored.mesh, stored.shape, root.origin().source, ExitCode::bad_input);
    stored.variations = read_variations(root, stored.mesh);
    return stored;
}

std::vector<model::DesignParameter> parameters_of(std::span<const model::Variation> variations) {
    std::vector<model::DesignParameter> parameters;
    for (const model::Variation& variation : variations) parameters.push_back(variation.parameter);
    return parameters;
}

CaseFile read_case_file(std::span<const std::byte> image, std::string_view source, const model::CaseBuilder& build) {
    const ImageParts parts = split_image(image, source);
    const QuietErrors quiet;
    const Origin origin{std::string{source}, parts.hdf5.size()};
    if (!parts.sealed)
        read_in_subprocess(origin, [&](const Origin& noted) { static_cast<void>(read_bare_case(parts.hdf5, noted)); });
    StoredCase stored = read_bare_case(parts.hdf5, origin);
    CaseFile file;
    for (std::size_t i = 0; i < stored.variations.size(); ++i) {
        const auto build_side = [&](const model::Variation::Side& side, const char* name) {
            mesh::Mesh moved = stored.mesh;
            moved.points = side.points;
            return build(std::move(moved), side.shape, side.effective_yaml,
                         design_location(origin, "variations/" + std::to_string(i) + "/" + name));
        };
        file.variations.push_back(
            {build_side(stored.variations[i].lower, "lower"), build_side(stored.variations[i].higher, "higher")});
    }
    file.model =
        build(std::move(stored.mesh), stored.shape, stored.design.effective_yaml, design_location(origin, "design"));
    file.model.parameters = parameters_of(stored.variations);
    file.design = std::move(stored.design);
    file.provenance = std::move(stored.provenance);
    return file;
}

}  // namespace soft::io
