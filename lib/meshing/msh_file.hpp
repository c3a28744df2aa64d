#pragma once
/// Raw contents of a Gmsh .msh file, version 2.2 or 4.1, ASCII or binary. The parser does not use gmsh, so that errors name the line
/// and a corrupted file cannot abort the program.
/// Source: Gmsh reference manual, 'MSH file format'. Tested by meshing/import_test, with files written by gmsh.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::meshing {

/// Elements of one type, geometric entity and set of physical groups.
struct MshBlock {
    int type;                        ///< Gmsh's number, one of msh_type's
    int entity;                      ///< tag of the curve, surface or volume; 0 if the file does not define it
    std::vector<int> groups;         ///< tags of the physical groups of its dimension
    std::vector<std::size_t> tags;   ///< one per element
    std::vector<std::size_t> nodes;  ///< tags, msh_type(type)->nodes per element
};

struct MshFile {
    std::vector<std::size_t> node_tags;
    std::vector<mesh::Point> positions;  ///< in the unit of the file
    std::vector<MshBlock> blocks;
    std::map<std::pair<int, int>, std::string> group_names;  ///< (dimension, tag) -> name as written
};

struct MshType {
    int number;
    int dimension;
    int nodes;
    std::optional<mesh::CellType> cell;  ///< none for a point; for serendipity types the completed cell
};

/// nullptr for types that are not read (pyramids, third order and up).
[[nodiscard]] const MshType* msh_type(int number) noexcept;

/// Throws Error(cannot_open) if the file cannot be read, Error(bad_input) "file:line: problem; remedy" (binary: the byte) if it is
/// not such a file or is truncated.
[[nodiscard]] MshFile read_msh(const std::filesystem::path& path);
/// The same for the content of a file called `name`.
[[nodiscard]] MshFile read_msh(std::string_view content, const std::string& name);

}  // namespace soft::meshing
