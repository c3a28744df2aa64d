#include "meshing/msh_file.hpp"

#include <array>
#include <cstdlib>
#include <limits>
#include <tuple>

#include "core/files.hpp"
#include "meshing/msh_scanner.hpp"

namespace soft::meshing {
namespace {

using mesh::CellType;

constexpr std::array<MshType, 16> types{{{1, 1, 2, CellType::line2},
                                         {2, 2, 3, CellType::triangle3},
                                         {3, 2, 4, CellType::quad4},
                                         {4, 3, 4, CellType::tet4},
                                         {5, 3, 8, CellType::hex8},
                                         {6, 3, 6, CellType::wedge6},
                                         {8, 1, 3, CellType::line3},
                                         {9, 2, 6, CellType::triangle6},
                                         {10, 2, 9, CellType::quad9},
                                         {11, 3, 10, CellType::tet10},
                                         {12, 3, 27, CellType::hex27},
                                         {13, 3, 18, CellType::wedge18},
                                         {15, 0, 1, std::nullopt},
                                         {16, 2, 8, CellType::quad9},
                                         {17, 3, 20, CellType::hex27},
                                         {18, 3, 15, CellType::wedge18}}};

class Reader {
public:
    Reader(std::string_view bytes, const std::string& name) : in_(bytes, name) {}

    MshFile read() {
        while (in_.skip_blanks()) read_section();
        if (version_ == 0) in_.fail("the file is empty", "export the mesh as Gmsh .msh, version 4.1 or 2.2");
        if (!has_nodes_ || !has_elements_)
            in_.fail("there is no $Nodes or no $Elements section", "export the mesh again");
        return std::move(file_);
    }

private:
    void read_section() {
        const std::size_t start = in_.position();
        const std::string name{core::trimmed(in_.line())};
        if (!name.starts_with('$') || (version_ == 0 && name != "$MeshFormat" && name != "$Comments")) {
            in_.return_to(start);
            in_.fail(version_ == 0 ? "not a Gmsh mesh: the file does not begin with $MeshFormat"
                                   : "expected a section, found " + core::quoted(name.substr(0, 20)),
                     "export the mesh as Gmsh .msh, version 4.1 or 2.2");
        }
        const std::string end = "$End" + name.substr(1);
        if (name == "$MeshFormat")
            read_format();
        else if (name == "$PhysicalNames")
            read_names();
        else if (name == "$Entities" && version_ == 4)
            read_entities();
        else if (name == "$Nodes")
            version_ == 4 ? read_nodes_4() : read_nodes_2();
        else if (name == "$Elements")
            version_ == 4 ? read_elements_4() : read_elements_2();
        else if (name == "$PartitionedEntities")
            in_.fail("the mesh is partitioned", "export it without partitions (Gmsh: Mesh.SaveAll = 0)");
        else
            return in_.skip_to(end);
        in_.expect(end);
    }

    void read_format() {
        const auto version = in_.text_number<double>();
        const int binary = in_.text_number<int>(), size = in_.text_number<int>();
        if (version != 2.2 && version != 4.1)
            in_.fail("format version " + core::number_text(version) + " is not supported",
                     "export version 4.1 or 2.2 (Gmsh: Mesh.MshFileVersion)");
        version_ = version == 4.1 ? 4 : 2;
        if (size != 8)
            in_.fail("numbers of " + std::to_string(size) + " bytes are not supported", "export with 8 bytes");
        if (binary == 0) return;
        in_.line();
        in_.set_encoding(MshEncoding::binary);
        if (in_.number<int>() != 1) in_.fail("the file has the byte order of another machine", "export it as ASCII");
    }

    void read_names() {
        const auto count = in_.checked_count(in_.text_number<std::size_t>(), 4);
        for (std::size_t i = 0; i < count; ++i) {
            const int dimension = in_.text_number<int>(), tag = in_.text_number<int>();
            const std::string_view text = core::trimmed(in_.line());
            if (text.size() < 2 || text.front() != '"' || text.back() != '"')
                in_.fail("the name of a physical group has no quotes", "export the mesh again");
            file_.group_names[{dimension, tag}] = std::string{text.substr(1, text.size() - 2)};
        }
    }

    void read_entities() {
        std::array<std::size_t, 4> counts{};
        for (std::size_t& count : counts) count = in_.count(1);
        for (int dimension = 0; dimension < 4; ++dimension)
            for (std::size_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
                const int tag = in_.number<int>();
                for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) static_cast<void>(in_.number<double>());
                std::vector<int>& groups = entity_groups_[{dimension, tag}];
                groups.resize(in_.count(1));
                for (int& group : groups) group = group_tag();
                if (dimension == 0) continue;
                for (std::size_t k = in_.count(1); k > 0; --k) static_cast<void>(in_.number<int>());
            }
    }

    /// Tag of a physical group or an entity; its sign is an orientation.
    int group_tag() {
        const int tag = in_.number<int>();
        if (tag == std::numeric_limits<int>::min()) in_.fail("a tag is out of range", "export the mesh again");
        return std::abs(tag);
    }

    mesh::Point position() {
        mesh::Point p{};
        for (double& component : p) component = in_.number<double>();
        return p;
    }

    void read_nodes_2() {
        has_nodes_ = true;
        const auto count = in_.checked_count(in_.text_number<std::size_t>(), 8);
        if (in_.binary()) in_.line();
        for (std::size_t i = 0; i < count; ++i) {
            file_.node_tags.push_back(static_cast<std::size_t>(in_.number<int>()));
            file_.positions.push_back(position());
        }
    }

    void read_nodes_4() {
        has_nodes_ = true;
        const std::size_t blocks = in_.count(1);
        for (int skipped = 0; skipped < 3; ++skipped) static_cast<void>(in_.number<std::size_t>());
        for (std::size_t b = 0; b < blocks; ++b) {
            const int dimension = in_.number<int>();
            static_cast<void>(in_.number<int>());
            const int parameters = in_.number<int>() != 0 ? dimension : 0;
            const std::size_t count = in_.count(8);
            for (std::size_t i = 0; i < count; ++i) file_.node_tags.push_back(in_.number<std::size_t>());
            for (std::size_t i = 0; i < count; ++i) {
                file_.positions.push_back(position());
                for (int k = 0; k < parameters; ++k) static_cast<void>(in_.number<double>());
            }
        }
    }

    const MshType& type_of(int number) const {
        const MshType* type = msh_type(number);
        if (type != nullptr) return *type;
        const bool pyramid = number == 7 || number == 14 || number == 19;
        in_.fail(pyramid ? "pyramids are not supported"
                         : "elements of Gmsh's type " + std::to_string(number) + " are not supported",
                 "mesh with triangles, quadrilaterals, tetrahedra, hexahedra or prisms of first or second order");
    }

    void add_element(MshBlock& block, const MshType& type, std::size_t tag) {
        block.tags.push_back(tag);
        for (int k = 0; k < type.nodes; ++k)
            block.nodes.push_back(version_ == 4 ? in_.number<std::size_t>()
                                                : static_cast<std::size_t>(in_.number<int>()));
    }

    void read_elements_2() {
        has_elements_ = true;
        std::map<std::tuple<int, int, int>, std::size_t> known;  // (type, entity, group) -> block
        const auto count = in_.checked_count(in_.text_number<std::size_t>(), 4);
        if (in_.binary()) in_.line();
        for (std::size_t done = 0; done < count;) {
            int tag = in_.binary() ? 0 : in_.number<int>();
            const MshType& type = type_of(in_.number<int>());
            const int run = in_.binary() ? in_.number<int>() : 1, tag_count = in_.number<int>();
            if (run < 1 || static_cast<std::size_t>(run) > count - done || tag_count < 0)
                in_.fail("the header of a block of elements is invalid", "export the mesh again");
            for (int i = 0; i < run; ++i, ++done) {
                if (in_.binary()) tag = in_.number<int>();
                std::array<int, 2> kept{};  // physical group and entity; partitions follow
                for (int k = 0; k < tag_count; ++k) {
                    const int value = group_tag();
                    if (k < 2) kept[static_cast<std::size_t>(k)] = value;
                }
                const auto [entry, fresh] = known.try_emplace({type.number, kept[1], kept[0]}, file_.blocks.size());
                if (fresh) file_.blocks.push_back({type.number, kept[1], {}, {}, {}});
                MshBlock& block = file_.blocks[entry->second];
                if (fresh && kept[0] != 0) block.groups = {kept[0]};
                add_element(block, type, static_cast<std::size_t>(tag));
            }
        }
    }

    void read_elements_4() {
        has_elements_ = true;
        const std::size_t blocks = in_.count(1);
        for (int skipped = 0; skipped < 3; ++skipped) static_cast<void>(in_.number<std::size_t>());
        for (std::size_t b = 0; b < blocks; ++b) {
            const int dimension = in_.number<int>(), entity = in_.number<int>();
            const MshType& type = type_of(in_.number<int>());
            if (type.dimension != dimension)
                in_.fail("elements of dimension " + std::to_string(type.dimension) + " in an entity of dimension " +
                             std::to_string(dimension),
                         "export the mesh again");
            const std::size_t count = in_.count(4);
            MshBlock& block = file_.blocks.emplace_back(MshBlock{type.number, entity, {}, {}, {}});
            if (const auto groups = entity_groups_.find({dimension, entity}); groups != entity_groups_.end())
                block.groups = groups->second;
            for (std::size_t i = 0; i < count; ++i) add_element(block, type, in_.number<std::size_t>());
        }
    }

    MshScanner in_;
    MshFile file_;
    std::map<std::pair<int, int>, std::vector<int>> entity_groups_;
    int version_ = 0;  ///< 2 or 4 once known
    bool has_nodes_ = false, has_elements_ = false;
};

}  // namespace

const MshType* msh_type(int number) noexcept {
    for (const MshType& type : types)
        if (type.number == number) return &type;
    return nullptr;
}

MshFile read_msh(const std::filesystem::path& path) {
    constexpr std::size_t max_bytes = std::size_t{1} << 32U;  // more than any mesh that can be solved
    const core::Bytes bytes = core::read_regular_file(path, max_bytes);
    return read_msh({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string());
}

MshFile read_msh(std::string_view content, const std::string& name) { return Reader{content, name}.read(); }

}  // namespace soft::meshing
