#pragma once
/// gmsh, loaded only when a mesh is generated: it depends on ninety libraries (CAD, GUI, images), and resolving their symbols takes
/// longer than the rest of the program start. Private to the module.
/// Tested by meshing/section_mesher_test.
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace soft::meshing {

/// A gmsh session for the lifetime of the object: quiet, without configuration files and arguments. The caller assigns tags, from 1.
/// Throws Error(internal) with gmsh's message if gmsh fails, Error(cannot_open) if it cannot be loaded. gmsh has one state per
/// process.
class GmshSession {
public:
    GmshSession();
    ~GmshSession();
    GmshSession(const GmshSession&) = delete;
    GmshSession& operator=(const GmshSession&) = delete;

    struct Line {
        int start, end;
    };
    struct Arc {
        int start, centre, end;
    };
    /// Number of points that divide a curve, including its ends, and the ratio of neighbouring intervals.
    struct Division {
        int points;
        double ratio;
    };
    struct Surface {
        std::vector<int> loop, corners;  ///< curve tags, negative if reversed; the four corner points
    };
    void add_point(int tag, std::array<double, 2> position);
    void add_line(int tag, Line line);
    void add_arc(int tag, Arc arc);
    void divide_curve(int tag, Division division);
    void add_grid(int tag, Surface surface);  ///< plane structured grid of quadrilaterals
    void mesh();                              ///< meshes everything that was added

    void add_spline(int tag, std::vector<int> points);  ///< uniform Catmull-Rom
    void add_loop(int tag, std::vector<int> curves);
    void add_plane(int tag, std::vector<int> loops);  ///< the first loop is the outer one, the others surround holes
    /// Meshes everything that was added with linear cells of the given length: triangles, or quadrilaterals and the triangles that
    /// cannot be paired. Does not report failures: the caller checks whether the cells cover the section.
    enum class Free { triangles, quadrilaterals };
    using Size = std::function<double(std::array<double, 2>)>;
    void mesh_freely(Free cells, const Size& size);

    struct Nodes {
        std::vector<std::size_t> tags;
        std::vector<double> xyz;
    };
    [[nodiscard]] Nodes nodes() const;
    /// Node tags of the triangles and quadrilaterals of a surface.
    [[nodiscard]] std::vector<std::vector<std::size_t>> polygons(int surface) const;
    /// The inner nodes of a curve, each with its parameter: 0 at the start of the curve, 1 at its end.
    [[nodiscard]] std::map<std::size_t, double> parameters(int curve) const;
    /// Node tags of the linear cells of a curve (dimension 1), surface (2) or volume (3), cell by cell; empty if the types are mixed.
    [[nodiscard]] std::vector<std::size_t> cells(int dimension, int tag) const;

    /// Adds existing triangles as surface `tag`; `triangles` has three node tags per triangle.
    void add_triangles(int tag, Nodes nodes, std::vector<std::size_t> triangles);
    /// Fills the space between such surfaces with linear tetrahedra, which get longer away from the surfaces; the first surface
    /// encloses the others. Does not report failures.
    enum class Filling { delaunay, hxt };
    void fill(int volume, std::vector<int> surfaces, Filling filling);

    /// Imports a CAD file, converted to mm from any unit; returns the number of solids. The CAD library writes to stdout and may crash
    /// at program exit: call it in a subprocess (core/subprocess.hpp).
    [[nodiscard]] int import_cad(const std::string& path);
    /// Number of chords per full turn, and bounds of their length relative to the longest side of the bounding box.
    struct Chords {
        double per_turn, longest, shortest;
    };
    /// Meshes the imported faces with linear triangles; on planes, cylinders and cones these are as long as the faces. Does not report
    /// failures.
    void triangulate(const Chords& chords);
    /// Coordinates of the corners of all triangles, nine per triangle. Node tags cannot be used, because gmsh 4.8 does not list all nodes
    /// on the seam of a closed cylinder.
    [[nodiscard]] std::vector<double> triangle_corners() const;

private:
    [[nodiscard]] std::vector<int> tags(int dimension) const;
    [[nodiscard]] std::string type_of(int dimension, int tag) const;
    void leave_ruled_faces_coarse();

    struct CellsOfType {
        std::size_t count;
        std::vector<std::size_t> nodes;
    };
    [[nodiscard]] std::vector<CellsOfType> cells_by_type(int dimension, int tag) const;

    struct Functions;
    std::unique_ptr<const Functions> gmsh_;
};

}  // namespace soft::meshing
