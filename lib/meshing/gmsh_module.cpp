/// The gmsh module: the only code that is linked with gmsh. The program loads it with dlopen (gmsh_session.cpp).
#include <gmsh.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "meshing/gmsh_session.hpp"

namespace soft::meshing {
namespace {

namespace geo = gmsh::model::geo;

/// Runs calls of gmsh; its exceptions are of types that depend on its version, and its log has the reason.
template <class Work>
void guarded(Work&& work) {
    try {
        work();
    } catch (...) {
        std::string message;
        gmsh::logger::getLastError(message);
        throw Error(ExitCode::internal, "mesh", "gmsh failed: " + (message.empty() ? "unknown reason" : message));
    }
}

using Options = std::initializer_list<std::pair<const char*, double>>;
void set(Options options) {
    for (const auto& [name, value] : options) gmsh::option::setNumber(name, value);
}

/// AbortOnError is off because an exception in one of gmsh's threads would abort the program; the caller checks the mesh.
constexpr std::pair no_abort{"General.AbortOnError", 0.0}, no_sizes_at_points{"Mesh.MeshSizeFromPoints", 0.0};
constexpr double frontal_delaunay = 6;

/// On planes, cylinders and cones, triangles between the points of the edges are as accurate as the chords of the edges, whatever
/// their length.
void leave_ruled_faces_coarse() {
    constexpr int edge_points_only = 3;
    const auto type_of = [](const std::pair<int, int>& entity) {
        std::string type;
        gmsh::model::getType(entity.first, entity.second, type);
        return type;
    };
    gmsh::vectorpair faces, curves;
    gmsh::model::getEntities(faces, 2);
    gmsh::model::getEntities(curves, 1);
    std::set<int> ruled;
    for (const auto& face : faces)
        if (const std::string type = type_of(face); type == "Plane" || type == "Cylinder" || type == "Cone") {
            ruled.insert(face.second);
            gmsh::model::mesh::setAlgorithm(2, face.second, edge_points_only);
        }
    for (const auto& curve : curves) {
        if (type_of(curve) != "Line") continue;
        std::vector<int> beside, ends;
        gmsh::model::getAdjacencies(1, curve.second, beside, ends);
        if (std::ranges::all_of(beside, [&](int face) { return ruled.contains(face); }))
            gmsh::model::mesh::setTransfiniteCurve(curve.second, 2);
    }
}

/// The contracts are in gmsh_session.hpp.
class Session final : public GmshSession {
public:
    Session() {
        guarded([] {
            gmsh::initialize(0, nullptr, false);
            set({{"General.Terminal", 0}});
        });
    }
    ~Session() override {
        try {
            gmsh::finalize();
        } catch (...) {  // a destructor cannot report errors
        }
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void add_point(int tag, std::array<double, 2> position) override {
        guarded([&] { geo::addPoint(position[0], position[1], 0, 0, tag); });
    }
    void add_line(int tag, Line line) override {
        guarded([&] { geo::addLine(line.start, line.end, tag); });
    }
    void add_arc(int tag, Arc arc) override {
        guarded([&] { geo::addCircleArc(arc.start, arc.centre, arc.end, tag); });
    }
    void add_spline(int tag, std::vector<int> points) override {
        guarded([&] { geo::addSpline(points, tag); });
    }
    void divide_curve(int tag, Division division) override {
        guarded([&] { geo::mesh::setTransfiniteCurve(tag, division.points, "Progression", division.ratio); });
    }
    void add_grid(int tag, Surface surface) override {
        guarded([&] {
            geo::addCurveLoop(surface.loop, tag);
            geo::addPlaneSurface({tag}, tag);
            geo::mesh::setTransfiniteSurface(tag, "Left", surface.corners);
            geo::mesh::setRecombine(2, tag);
        });
    }
    void add_loop(int tag, std::vector<int> curves) override {
        guarded([&] { geo::addCurveLoop(curves, tag); });
    }
    void add_plane(int tag, std::vector<int> loops) override {
        guarded([&] { geo::addPlaneSurface(loops, tag); });
    }
    void mesh() override { generate(2); }

    void mesh_freely(Free cells, const Size& size) override {
        constexpr double blossom = 1;  // algorithm 8, designed for quadrilaterals, crashes in gmsh 4.8
        guarded([&] {
            // Integrate cell lengths along an edge to 1e-6: with gmsh's default 1e-9 it evaluates most sizes ten times as often.
            set({no_abort,
                 no_sizes_at_points,
                 {"Mesh.MeshSizeExtendFromBoundary", 0},
                 {"Mesh.Algorithm", frontal_delaunay},
                 {"Mesh.LcIntegrationPrecision", 1e-6}});
            if (cells == Free::quadrilaterals)
                set({{"Mesh.RecombineAll", 1}, {"Mesh.RecombinationAlgorithm", blossom}});
            gmsh::model::mesh::setSizeCallback([&size](int, int, double x, double y, double) { return size({x, y}); });
        });
        generate(2);
    }

    void add_triangles(int tag, Nodes nodes, std::vector<std::size_t> triangles) override {
        constexpr int dimension = 2, triangle = 2;
        guarded([&] {
            gmsh::model::addDiscreteEntity(dimension, tag);
            gmsh::model::mesh::addNodes(dimension, tag, nodes.tags, nodes.xyz);
            gmsh::model::mesh::addElementsByType(tag, triangle, {}, triangles);
        });
    }

    void fill(int volume, std::vector<int> surfaces, Filling filling) override {
        constexpr double delaunay = 1, hxt = 10;
        guarded([&] {
            for (const int surface : surfaces) geo::addSurfaceLoop({surface}, surface);
            geo::addVolume(surfaces, volume);
            set({no_abort,
                 no_sizes_at_points,
                 {"Mesh.MeshSizeExtendFromBoundary", 1},
                 {"Mesh.OptimizeThreshold", 0.4},
                 {"Mesh.Renumber", 0},
                 {"Mesh.Algorithm3D", filling == Filling::hxt ? hxt : delaunay}});
        });
        generate(3);
    }

    [[nodiscard]] int import_cad(const std::string& path) override {
        gmsh::vectorpair shapes;
        guarded([&] {
            gmsh::model::occ::importShapes(path, shapes, true, "step");
            gmsh::model::occ::synchronize();
        });
        return static_cast<int>(std::ranges::count(shapes, 3, &std::pair<int, int>::first));
    }

    void triangulate(const Chords& chords) override {
        guarded([&] {
            leave_ruled_faces_coarse();
            std::array<double, 6> box{};
            gmsh::model::getBoundingBox(-1, -1, box[0], box[1], box[2], box[3], box[4], box[5]);
            const double extent = std::max({box[3] - box[0], box[4] - box[1], box[5] - box[2]});
            set({no_abort,
                 {"Mesh.MeshSizeFromCurvature", chords.per_turn},
                 {"Mesh.MeshSizeMax", chords.longest * extent},
                 {"Mesh.MeshSizeMin", chords.shortest * extent},
                 {"Mesh.Algorithm", frontal_delaunay}});
            gmsh::model::mesh::generate(2);
        });
    }

    [[nodiscard]] std::vector<double> triangle_corners() const override {
        constexpr int triangle = 2;
        std::vector<double> jacobians, determinants, corners;
        guarded([&] {
            gmsh::model::mesh::getJacobians(triangle, {0, 0, 0, 1, 0, 0, 0, 1, 0}, jacobians, determinants, corners);
        });
        return corners;
    }

    [[nodiscard]] Nodes nodes() const override {
        Nodes nodes;
        std::vector<double> unused;
        guarded([&] { gmsh::model::mesh::getNodes(nodes.tags, nodes.xyz, unused, -1, -1, false, false); });
        return nodes;
    }

    [[nodiscard]] std::map<std::size_t, double> parameters(int curve) const override {
        std::vector<std::size_t> tags;
        std::vector<double> unused, values;
        guarded([&] { gmsh::model::mesh::getNodes(tags, unused, values, 1, curve); });
        std::map<std::size_t, double> found;
        for (std::size_t n = 0; n < tags.size(); ++n) found[tags[n]] = values.at(n);
        return found;
    }

    [[nodiscard]] std::vector<std::size_t> cells(int dimension, int tag) const override {
        std::vector<CellsOfType> all = cells_by_type(dimension, tag);
        return all.size() == 1 ? std::move(all.front().nodes) : std::vector<std::size_t>{};
    }

    [[nodiscard]] std::vector<std::vector<std::size_t>> polygons(int surface) const override {
        std::vector<std::vector<std::size_t>> result;
        for (const auto& [count, nodes] : cells_by_type(2, surface)) {
            const auto corners = static_cast<std::ptrdiff_t>(nodes.size() / count);
            for (auto first = nodes.begin(); first != nodes.end(); first += corners)
                result.emplace_back(first, first + corners);
        }
        return result;
    }

private:
    static void generate(int dimension) {
        guarded([&] {
            geo::synchronize();
            gmsh::model::mesh::generate(dimension);
        });
    }

    struct CellsOfType {
        std::size_t count;
        std::vector<std::size_t> nodes;
    };
    [[nodiscard]] static std::vector<CellsOfType> cells_by_type(int dimension, int tag) {
        std::vector<int> types;
        std::vector<std::vector<std::size_t>> elements, nodes;
        guarded([&] { gmsh::model::mesh::getElements(types, elements, nodes, dimension, tag); });
        std::vector<CellsOfType> result;
        for (std::size_t t = 0; t < types.size(); ++t) result.push_back({elements[t].size(), std::move(nodes[t])});
        return result;
    }
};

}  // namespace

}  // namespace soft::meshing

extern "C" soft::meshing::GmshSession* soft_open_gmsh() { return new soft::meshing::Session; }
