#pragma once
/// Mesh files for the tests of the import, written by gmsh: parts with known volumes, in every version, encoding,
/// order and cell type.
#include <gmsh.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace soft::meshing::sample {

struct FileKind {
    double version = 4.1;
    bool binary = false;
    int order = 1;
    bool incomplete = false;  ///< serendipity elements
};

enum class Cells { triangles, quadrilaterals, tetrahedra, hexahedra, wedges };

/// A four-sided section (1,0) (2,0) (0,2) (0,1), height 1 along z for solids: between two straight lines, or a quarter
/// ring between two arcs.
enum class Sides { straight, round };

inline std::filesystem::path temporary(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("soft-import-" + std::to_string(getpid()) + "-" + name);
}

/// A file that is removed at the end of the test.
struct TemporaryFile {
    std::filesystem::path path;
    explicit TemporaryFile(const std::string& name, const std::string& text = {}) : path(temporary(name)) {
        if (!text.empty()) std::ofstream{path, std::ios::binary} << text;
    }
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] std::string text() const {
        std::ifstream file{path, std::ios::binary};
        std::ostringstream all;
        all << file.rdbuf();
        return all.str();
    }
};

struct Gmsh {
    Gmsh() {
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
    }
    ~Gmsh() { gmsh::finalize(); }
    Gmsh(const Gmsh&) = delete;
    Gmsh& operator=(const Gmsh&) = delete;
};

inline void name_group(int dimension, const std::vector<int>& entities, const std::string& name) {
    gmsh::model::setPhysicalName(dimension, gmsh::model::addPhysicalGroup(dimension, entities), name);
}

/// Curves or walls "inner" (radius 1), "outer" (radius 2), "ends"; of solids also "bottom", "top". Region "part".
inline void draw_part(Cells cells, Sides sides, int divisions) {
    namespace geo = gmsh::model::geo;
    geo::addPoint(1, 0, 0, 0, 1);
    geo::addPoint(2, 0, 0, 0, 2);
    geo::addPoint(0, 2, 0, 0, 3);
    geo::addPoint(0, 1, 0, 0, 4);
    geo::addPoint(0, 0, 0, 0, 5);
    geo::addLine(1, 2, 1);
    geo::addLine(3, 4, 3);
    if (sides == Sides::round) {
        geo::addCircleArc(2, 5, 3, 2);
        geo::addCircleArc(4, 5, 1, 4);
    } else {
        geo::addLine(2, 3, 2);
        geo::addLine(4, 1, 4);
    }
    for (const int curve : {1, 2, 3, 4}) geo::mesh::setTransfiniteCurve(curve, divisions + 1);
    geo::addCurveLoop({1, 2, 3, 4}, 1);
    geo::addPlaneSurface({1}, 1);
    geo::mesh::setTransfiniteSurface(1);
    const bool four_sided = cells == Cells::quadrilaterals || cells == Cells::hexahedra;
    if (four_sided) geo::mesh::setRecombine(2, 1);
    if (cells == Cells::triangles || cells == Cells::quadrilaterals) {
        geo::synchronize();
        name_group(1, {4}, "inner");
        name_group(1, {2}, "outer");
        name_group(1, {1, 3}, "ends");
        name_group(2, {1}, "part");
        return;
    }
    gmsh::vectorpair made;  // top, volume, then the walls in the order of the loop
    const std::vector<int> layers = cells == Cells::tetrahedra ? std::vector<int>{} : std::vector<int>{divisions};
    geo::extrude({{2, 1}}, 0, 0, 1, made, layers, {}, cells != Cells::tetrahedra);
    geo::synchronize();
    name_group(2, {1}, "bottom");
    name_group(2, {made[0].second}, "top");
    name_group(2, {made[2].second, made[4].second}, "ends");
    name_group(2, {made[3].second}, "outer");
    name_group(2, {made[5].second}, "inner");
    name_group(3, {made[1].second}, "part");
}

/// Maps every node of the mesh: x -> factor x, y -> y + shift.
inline void move_nodes(double factor, double shift) {
    std::vector<std::size_t> tags;
    std::vector<double> xyz, parameters;
    gmsh::model::mesh::getNodes(tags, xyz, parameters);
    for (std::size_t n = 0; n < tags.size(); ++n)
        gmsh::model::mesh::setNode(tags[n], {factor * xyz[3 * n], xyz[3 * n + 1] + shift, xyz[3 * n + 2]}, {});
}

inline void write(const std::filesystem::path& path, const FileKind& kind) {
    gmsh::option::setNumber("Mesh.MshFileVersion", kind.version);
    gmsh::option::setNumber("Mesh.Binary", kind.binary ? 1 : 0);
    gmsh::write(path.string());
}

inline void write_part(const std::filesystem::path& path, Cells cells, Sides sides, const FileKind& kind,
                       int divisions = 3) {
    const Gmsh session;
    draw_part(cells, sides, divisions);
    gmsh::option::setNumber("Mesh.SecondOrderIncomplete", kind.incomplete ? 1 : 0);
    gmsh::option::setNumber("Mesh.MeshSizeMax", 0.5);
    gmsh::option::setNumber("Mesh.ElementOrder", kind.order);
    gmsh::model::mesh::generate(cells == Cells::triangles || cells == Cells::quadrilaterals ? 2 : 3);
    write(path, kind);
}

}  // namespace soft::meshing::sample
