#pragma once
/// gmsh, loaded only when a mesh is generated: it depends on ninety libraries (CAD, GUI, images), and resolving their symbols takes
/// longer than the rest of the program start. Only the shared object soft_gmsh.so (gmsh_module.cpp) is linked with gmsh. Private to the
/// module.
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
/// Throws Error(internal) with gmsh's message if gmsh fails. gmsh has one state per process.
class GmshSession {
public:
    GmshSession() = default;
    virtual ~GmshSession() = default;
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
    virtual void add_point(int tag, std::array<double, 2> position) = 0;
    virtual void add_line(int tag, Line line) = 0;
    virtual void add_arc(int tag, Arc arc) = 0;
    virtual void divide_curve(int tag, Division division) = 0;
    virtual void add_grid(int tag, Surface surface) = 0;  ///< plane structured grid of quadrilaterals
    virtual void mesh() = 0;                              ///< meshes everything that was added

    virtual void add_spline(int tag, std::vector<int> points) = 0;  ///< uniform Catmull-Rom
    virtual void add_loop(int tag, std::vector<int> curves) = 0;
    /// The first loop is the outer one, the others surround holes.
    virtual void add_plane(int tag, std::vector<int> loops) = 0;
    /// Meshes everything that was added with linear cells of the given length: triangles, or quadrilaterals and the triangles that
    /// cannot be paired. Does not report failures: the caller checks whether the cells cover the section.
    enum class Free { triangles, quadrilaterals };
    using Size = std::function<double(std::array<double, 2>)>;
    virtual void mesh_freely(Free cells, const Size& size) = 0;

    struct Nodes {
        std::vector<std::size_t> tags;
        std::vector<double> xyz;
    };
    [[nodiscard]] virtual Nodes nodes() const = 0;
    /// Node tags of the triangles and quadrilaterals of a surface.
    [[nodiscard]] virtual std::vector<std::vector<std::size_t>> polygons(int surface) const = 0;
    /// The inner nodes of a curve, each with its parameter: 0 at the start of the curve, 1 at its end.
    [[nodiscard]] virtual std::map<std::size_t, double> parameters(int curve) const = 0;
    /// Node tags of the linear cells of a curve (dimension 1), surface (2) or volume (3), cell by cell; empty if the types are mixed.
    [[nodiscard]] virtual std::vector<std::size_t> cells(int dimension, int tag) const = 0;

    /// Adds existing triangles as surface `tag`; `triangles` has three node tags per triangle.
    virtual void add_triangles(int tag, Nodes nodes, std::vector<std::size_t> triangles) = 0;
    /// Fills the space between such surfaces with linear tetrahedra, which get longer away from the surfaces; the first surface
    /// encloses the others. Does not report failures.
    enum class Filling { delaunay, hxt };
    virtual void fill(int volume, std::vector<int> surfaces, Filling filling) = 0;

    /// Imports a CAD file, converted to mm from any unit; returns the number of solids. The CAD library writes to stdout and may crash
    /// at program exit: call it in a subprocess (core/subprocess.hpp).
    [[nodiscard]] virtual int import_cad(const std::string& path) = 0;
    /// Number of chords per full turn, and bounds of their length relative to the longest side of the bounding box.
    struct Chords {
        double per_turn, longest, shortest;
    };
    /// Meshes the imported faces with linear triangles; on planes, cylinders and cones these are as long as the faces. Does not report
    /// failures.
    virtual void triangulate(const Chords& chords) = 0;
    /// Coordinates of the corners of all triangles, nine per triangle. Node tags cannot be used, because gmsh 4.8 does not list all nodes
    /// on the seam of a closed cylinder.
    [[nodiscard]] virtual std::vector<double> triangle_corners() const = 0;
};

/// Loads soft_gmsh.so from ../lib/soft-actuator beside the folder of the program, or from where the loader finds it. Throws
/// Error(cannot_open) if it cannot be loaded, the out-of-memory error if there is too little address space.
[[nodiscard]] std::unique_ptr<GmshSession> open_gmsh();

}  // namespace soft::meshing
