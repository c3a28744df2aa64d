#include "meshing/import.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "core/error.hpp"
#include "core/text.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/mesh.hpp"
#include "meshing/msh_cells.hpp"
#include "meshing/section_mesher.hpp"

namespace soft::meshing {
namespace {

using mesh::Index;

/// Corner nodes in ascending order, the same for all cells that share a side.
using Key = std::array<Index, 4>;

Key key_of(std::span<const Index> corners) {
    Key key;
    key.fill(std::numeric_limits<Index>::max());
    std::copy(corners.begin(), corners.end(), key.begin());
    std::sort(key.begin(), key.end());
    return key;
}

/// The mesh under construction, with the element tags and entities of the file.
class Importer {
public:
    Importer(const MshFile& file, std::string name) : file_(file), name_(std::move(name)) {}

    mesh::Mesh import(double unit_m) {
        find_dimension();
        for (std::size_t n = 0; n < file_.node_tags.size(); ++n)
            if (!numbers_.try_emplace(file_.node_tags[n], static_cast<Index>(n)).second)
                refuse("node " + std::to_string(file_.node_tags[n]) + " is defined twice");
        result_.points = file_.positions;
        add_cells();
        const std::vector<Index> kept = drop_unused_points(result_);
        for (auto& [tag, number] : numbers_) number = kept[static_cast<std::size_t>(number)];
        if (result_.dimension == 2) flatten();
        reorient_mirrored();
        refuse_inverted_cells();
        find_sides();
        add_facet_sets();
        for (mesh::Point& p : result_.points)
            for (double& component : p) component *= unit_m;
        return std::move(result_);
    }

private:
    [[noreturn]] void refuse(const std::string& problem,
                             const std::string& remedy = "repair the mesh and export it again") const {
        throw Error(ExitCode::bad_input, name_, problem, remedy);
    }
    static const MshType& type_of(const MshBlock& block) { return *msh_type(block.type); }
    [[nodiscard]] std::string element(Index cell) const {
        return "element " + std::to_string(cell_tags_[static_cast<std::size_t>(cell)]);
    }

    void find_dimension() {
        int dimension = 0;
        for (const MshBlock& block : file_.blocks)
            if (!block.tags.empty()) dimension = std::max(dimension, type_of(block).dimension);
        if (dimension < 2)
            refuse("there are no cells", "mesh the surface (2D) or the volume (3D) and save all its elements");
        result_.dimension = dimension;
    }

    /// A valid name of a face or region: letters, digits, '_' and '-'.
    static std::string as_name(std::string_view text) {
        constexpr std::size_t max_length = 100;
        std::string name{text.substr(0, max_length)};
        for (char& c : name) {
            const bool allowed = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
            if (!allowed) c = '_';
        }
        return name;
    }

    [[nodiscard]] std::string group_name(int dimension, int tag, const std::string& otherwise) const {
        const auto found = file_.group_names.find({dimension, tag});
        if (found == file_.group_names.end() || found->second.empty()) return otherwise;
        std::string name = as_name(found->second);
        for (const auto& [group, other] : file_.group_names)
            if (group.first == dimension && group.second != tag && as_name(other) == name)
                refuse("two physical groups are both called " + core::quoted(name), "rename one of them");
        return name;
    }

    [[nodiscard]] Index node_of(const MshBlock& block, std::size_t element_number, std::size_t tag) const {
        const auto found = numbers_.find(tag);
        if (found == numbers_.end())
            refuse("element " + std::to_string(block.tags[element_number]) + " uses node " + std::to_string(tag) +
                   ", which the file does not define");
        return found->second;
    }

    void add_cells() {
        for (const MshBlock& block : file_.blocks) {
            const MshType& type = type_of(block);
            if (type.dimension != result_.dimension || block.tags.empty()) continue;
            if (block.groups.size() > 1)
                refuse("element " + std::to_string(block.tags.front()) + " belongs to several physical groups of cells",
                       "put each part in one group only");
            const std::int32_t own = region_number(
                result_, block.groups.empty() ? rubber_region
                                              : group_name(result_.dimension, block.groups.front(), rubber_region));
            add_cells(block, type, own);
        }
        const auto order_of = [](mesh::CellType type) { return mesh::topology(type).order; };
        for (Index c = 1; c < result_.cell_count(); ++c)
            if (order_of(result_.cell_type(c)) != order_of(result_.cell_type(0)))
                refuse(element(c) + " has another order than " + element(0), "mesh all parts with one order");
    }

    void add_cells(const MshBlock& block, const MshType& type, std::int32_t own_region) {
        const std::vector<int> gmsh_nodes = gmsh_node_numbers(type);
        const std::vector<Completion> missing_nodes = completions(type);
        const auto per_element = static_cast<std::size_t>(type.nodes);
        std::vector<Index> nodes(gmsh_nodes.size());
        for (std::size_t e = 0; e < block.tags.size(); ++e) {
            for (std::size_t n = 0; n < gmsh_nodes.size(); ++n)
                if (gmsh_nodes[n] != missing_node)
                    nodes[n] =
                        node_of(block, e, block.nodes[e * per_element + static_cast<std::size_t>(gmsh_nodes[n])]);
            for (const Completion& completion : missing_nodes)
                nodes[static_cast<std::size_t>(completion.node)] = completed(completion, nodes);
            add_cell(result_, *type.cell, nodes, own_region);
            cell_tags_.push_back(block.tags[e]);
            cell_entities_.push_back(block.entity);
        }
    }

    /// The node that a serendipity element lacks; neighbours share the added nodes of their common sides.
    Index completed(const Completion& completion, const std::vector<Index>& nodes) {
        const auto next = static_cast<Index>(result_.points.size());
        const bool on_side = completion.corners.size() == 4 && result_.dimension == 3;
        if (on_side) {
            std::vector<Index> corners;
            for (const int corner : completion.corners) corners.push_back(nodes[static_cast<std::size_t>(corner)]);
            const auto [entry, fresh] = side_nodes_.try_emplace(key_of(corners), next);
            if (!fresh) return entry->second;
        }
        mesh::Point position{};
        for (const auto& [part, weight] : completion.parts)
            for (std::size_t d = 0; d < 3; ++d)
                position[d] += weight * result_.point(nodes[static_cast<std::size_t>(part)])[d];
        result_.points.push_back(position);
        return next;
    }

    void flatten() {
        const double tolerance = mesh::plane_tolerance * mesh::extent_m(result_);
        const double z = result_.points.front()[2];
        for (mesh::Point& p : result_.points) {
            if (std::abs(p[2] - z) > tolerance)
                refuse(
                    "the mesh has no cells of dimension 3, and those of dimension 2 do not lie in one plane z = constant",
                    "mesh the volume (and name it as a physical group), or draw the section in the x-y plane");
            p[2] = 0;
        }
    }

    [[nodiscard]] double determinant_at(Index cell, const std::array<double, 3>& xi) const {
        return map_cell(result_, cell, mesh::shape_values(result_.cell_type(cell), xi)).determinant;
    }

    /// Renumbers the cells of entities in which all cells have negative orientation: surfaces drawn clockwise, mirrored parts.
    void reorient_mirrored() {
        std::map<int, bool> mirrored;
        for (Index c = 0; c < result_.cell_count(); ++c) {
            const bool negative = determinant_at(c, mesh::reference_centre(result_.cell_type(c))) < 0;
            const auto entry = mirrored.try_emplace(cell_entities_[static_cast<std::size_t>(c)], negative).first;
            entry->second = entry->second && negative;
        }
        for (Index c = 0; c < result_.cell_count(); ++c) {
            if (!mirrored.at(cell_entities_[static_cast<std::size_t>(c)])) continue;
            const auto nodes = result_.cell_nodes(c);
            const std::vector<Index> old(nodes.begin(), nodes.end());
            const std::vector<int> order = mirrored_order(result_.cell_type(c));
            const auto first = static_cast<std::size_t>(result_.offsets[static_cast<std::size_t>(c)]);
            for (std::size_t n = 0; n < old.size(); ++n)
                result_.connectivity[first + n] = old[static_cast<std::size_t>(order[n])];
        }
    }

    void refuse_inverted_cells() const {
        for (Index c = 0; c < result_.cell_count(); ++c)
            for (const auto& xi : mesh::topology(result_.cell_type(c)).nodes)
                if (!(determinant_at(c, xi) > 0))
                    refuse(
                        element(c) + " is inverted or degenerate",
                        "remesh with other sizes, or optimise the mesh (Gmsh: Tools, or Mesh.Optimize, Mesh.HighOrderOptimize)");
    }

    void find_sides() {
        for (Index c = 0; c < result_.cell_count(); ++c) {
            const auto count = static_cast<int>(mesh::topology(result_.cell_type(c)).facets.size());
            for (int local = 0; local < count; ++local) {
                std::vector<mesh::Facet>& cells = sides_[key_of(facet_corners(result_, {c, local}))];
                cells.push_back({c, local});
                if (cells.size() > 2)
                    refuse(
                        element(c) + " shares a side with " + element(cells[0].cell) + " and " + element(cells[1].cell),
                        "the mesh overlaps itself: remove duplicate cells");
                if (cells.size() == 2) refuse_duplicates(cells[0].cell, c);
            }
        }
    }

    void refuse_duplicates(Index a, Index b) const {
        const auto sorted = [&](Index cell) {
            const auto nodes = result_.cell_nodes(cell);
            std::vector<Index> copy(nodes.begin(), nodes.end());
            std::sort(copy.begin(), copy.end());
            return copy;
        };
        if (sorted(a) == sorted(b))
            refuse(element(a) + " and " + element(b) + " are the same cell",
                   "put each part in one physical group only");
    }

    void add_facet_sets() {
        for (const MshBlock& block : file_.blocks) {
            const MshType& type = type_of(block);
            if (type.dimension != result_.dimension - 1) continue;
            for (const int group : block.groups) {
                const std::string face = group_name(type.dimension, group, "face_" + std::to_string(group));
                std::vector<mesh::Facet>& facets = result_.facet_sets[face];
                for (std::size_t e = 0; e < block.tags.size(); ++e) facets.push_back(side(block, e, face));
            }
        }
        for (auto& [name, facets] : result_.facet_sets) {
            std::sort(facets.begin(), facets.end());
            facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
        }
    }

    [[nodiscard]] mesh::Facet side(const MshBlock& block, std::size_t number, const std::string& face) const {
        const MshType& type = type_of(block);
        const auto first = number * static_cast<std::size_t>(type.nodes);
        std::vector<Index> corners;
        for (int k = 0; k < mesh::topology(*type.cell).vertex_count; ++k)
            corners.push_back(node_of(block, number, block.nodes[first + static_cast<std::size_t>(k)]));
        const auto found = sides_.find(key_of(corners));
        const std::string what = "element " + std::to_string(block.tags[number]) + " of the face " + core::quoted(face);
        if (found == sides_.end())
            refuse(what + " is not a side of a cell", "mesh surface and volume together, so that they share nodes");
        if (found->second.size() > 1)
            refuse(what + " lies inside the body, between two cells", "remove inner surfaces from the physical groups");
        return found->second.front();
    }

    struct Hash {
        std::size_t operator()(const Key& key) const noexcept {
            std::uint64_t hash = 0;
            for (const Index node : key) {
                hash = (hash ^ static_cast<std::uint64_t>(node)) * 0x9E3779B97F4A7C15ULL;
                hash ^= hash >> 29U;
            }
            return static_cast<std::size_t>(hash);
        }
    };

    const MshFile& file_;
    std::string name_;
    mesh::Mesh result_;
    std::unordered_map<std::size_t, Index> numbers_;   ///< node tag -> point
    std::unordered_map<Key, Index, Hash> side_nodes_;  ///< nodes added to serendipity elements, by side
    std::unordered_map<Key, std::vector<mesh::Facet>, Hash> sides_;
    std::vector<std::size_t> cell_tags_;
    std::vector<int> cell_entities_;
};

}  // namespace

mesh::Mesh import_mesh(const std::filesystem::path& path, double unit_m) {
    return import_mesh(read_msh(path), path.string(), unit_m);
}

mesh::Mesh import_mesh(const MshFile& file, const std::string& name, double unit_m) {
    return Importer{file, name}.import(unit_m);
}

}  // namespace soft::meshing
