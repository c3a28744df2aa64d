#pragma once
/// gmsh, loaded when a mesh is made and no earlier: with it come ninety libraries (CAD, windows, images), and looking up their
/// symbols costs more than everything else a program does to start. Private to the module.
/// Tested by meshing/section_mesher_test.
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace soft::meshing {

/// gmsh speaks only while this lives: quiet, no configuration files, no arguments. Tags are the caller's, from 1.
/// What gmsh cannot do is an Error(internal) with its words, a gmsh that cannot be loaded Error(cannot_open). gmsh keeps one
/// state per process.
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
    /// Points that divide a curve, ends included; the ratio of neighbouring intervals.
    struct Division {
        int points;
        double ratio;
    };
    struct Surface {
        std::vector<int> loop, corners;  ///< curves, minus those run backwards; the four points
    };
    void add_point(int tag, std::array<double, 2> place);
    void add_line(int tag, Line line);
    void add_arc(int tag, Arc arc);
    void divide_curve(int tag, Division division);
    void add_grid(int tag, Surface surface);  ///< plane, of quadrilaterals
    void mesh();                              ///< all that was added

    void add_spline(int tag, std::vector<int> points);  ///< uniform Catmull-Rom
    void add_loop(int tag, std::vector<int> curves);
    void add_plane(int tag, std::vector<int> loops);  ///< the first round it, the others round its holes
    /// What was added, in linear cells of the given length: triangles, or quadrilaterals and the triangles that find no partner. Reports
    /// no failure: the caller checks whether the cells cover the section.
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
    /// The nodes inside a curve, each with its parameter: 0 at the start of the curve, 1 at its end.
    [[nodiscard]] std::map<std::size_t, double> parameters(int curve) const;
    /// Node tags of the linear cells of a curve (dimension 1), surface (2) or volume (3), cell by cell; none where the types are mixed.
    [[nodiscard]] std::vector<std::size_t> cells(int dimension, int tag) const;

    /// Triangles that are there already, as surface `tag` (nodes by tags of their own; three a triangle).
    void add_triangles(int tag, Nodes nodes, std::vector<std::size_t> triangles);
    /// Linear tetrahedra between such surfaces, the first around the others; they get longer away from them. Says nothing where
    /// it fails.
    enum class Filling { delaunay, hxt };
    void fill(int volume, std::vector<int> surfaces, Filling filling);

    /// The number of solids in a CAD file, in mm whatever its unit. The CAD library talks on stdout, and may crash at the program's exit: for a
    /// process of its own (core/subprocess.hpp).
    [[nodiscard]] int import_cad(const std::string& path);
    /// Chords to a full turn, and their bounds as shares of the longest side of the box around all.
    struct Chords {
        double per_turn, longest, shortest;
    };
    /// The faces of what was imported, as linear triangles; those of planes, cylinders and cones as long as the faces are. Reports no failure.
    void triangulate(const Chords& chords);
    /// Coordinates of the corners of all triangles, nine a triangle. By node tags they cannot be had: gmsh 4.8 does not list all nodes on
    /// the seam of a closed cylinder.
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
