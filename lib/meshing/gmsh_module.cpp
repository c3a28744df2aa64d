/// The gmsh module: the only code that is linked with gmsh. The program loads it with dlopen (gmsh_session.cpp).
#include "meshing/gmsh_session.hpp"

extern "C" {  // which the header of gmsh 4.8 does not say
#include <gmshc.h>
}

#include <algorithm>
#include <set>
#include <span>
#include <string>

#include "core/error.hpp"

namespace soft::meshing {
namespace {

/// Calls a gmsh function with its last argument `int* failed`; throws if it fails.
template <class Function, class... Arguments>
void call(Function* called, Arguments... arguments) {
    int failed = 0;
    static_cast<void>(called(arguments..., &failed));
    if (failed == 0) return;
    char* words = nullptr;
    gmshLoggerGetLastError(&words, &failed);
    const std::string message = words != nullptr ? words : "unknown reason";
    gmshFree(words);
    throw Error(ExitCode::internal, "mesh", "gmsh failed: " + message);
}

/// Copies an array allocated by gmsh and frees the original.
template <class T>
std::vector<T> taken(T* values, std::size_t count) {
    std::vector<T> copy(values, values + count);
    gmshFree(values);
    return copy;
}

class Session final : public GmshSession {
public:
    Session() {
        call(gmshInitialize, 0, nullptr, 0);
        call(gmshOptionSetNumber, "General.Terminal", 0.0);
    }
    ~Session() override {
        int ignored = 0;  // a destructor cannot report errors
        gmshFinalize(&ignored);
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void add_point(int tag, std::array<double, 2> position) override;
    void add_line(int tag, Line line) override;
    void add_arc(int tag, Arc arc) override;
    void divide_curve(int tag, Division division) override;
    void add_grid(int tag, Surface surface) override;
    void mesh() override;
    void add_spline(int tag, std::vector<int> points) override;
    void add_loop(int tag, std::vector<int> curves) override;
    void add_plane(int tag, std::vector<int> loops) override;
    void mesh_freely(Free cells, const Size& size) override;
    [[nodiscard]] Nodes nodes() const override;
    [[nodiscard]] std::vector<std::vector<std::size_t>> polygons(int surface) const override;
    [[nodiscard]] std::map<std::size_t, double> parameters(int curve) const override;
    [[nodiscard]] std::vector<std::size_t> cells(int dimension, int tag) const override;
    void add_triangles(int tag, Nodes nodes, std::vector<std::size_t> triangles) override;
    void fill(int volume, std::vector<int> surfaces, Filling filling) override;
    [[nodiscard]] int import_cad(const std::string& path) override;
    void triangulate(const Chords& chords) override;
    [[nodiscard]] std::vector<double> triangle_corners() const override;

private:
    [[nodiscard]] std::vector<int> tags(int dimension) const;
    [[nodiscard]] std::string type_of(int dimension, int tag) const;
    void leave_ruled_faces_coarse();

    struct CellsOfType {
        std::size_t count;
        std::vector<std::size_t> nodes;
    };
    [[nodiscard]] std::vector<CellsOfType> cells_by_type(int dimension, int tag) const;
};

void Session::add_point(int tag, std::array<double, 2> position) {
    call(gmshModelGeoAddPoint, position[0], position[1], 0.0, 0.0, tag);
}

void Session::add_line(int tag, Line line) { call(gmshModelGeoAddLine, line.start, line.end, tag); }

void Session::add_arc(int tag, Arc arc) {
    call(gmshModelGeoAddCircleArc, arc.start, arc.centre, arc.end, tag, 0.0, 0.0, 0.0);
}

void Session::divide_curve(int tag, Division division) {
    call(gmshModelGeoMeshSetTransfiniteCurve, tag, division.points, "Progression", division.ratio);
}

void Session::add_grid(int tag, Surface surface) {
    constexpr double max_angle = 45;  // gmsh's default
    call(gmshModelGeoAddCurveLoop, surface.loop.data(), surface.loop.size(), tag, 0);
    call(gmshModelGeoAddPlaneSurface, &tag, std::size_t{1}, tag);
    call(gmshModelGeoMeshSetTransfiniteSurface, tag, "Left", surface.corners.data(), surface.corners.size());
    call(gmshModelGeoMeshSetRecombine, 2, tag, max_angle);
}

void Session::mesh() {
    call(gmshModelGeoSynchronize);
    call(gmshModelMeshGenerate, 2);
}

void Session::add_spline(int tag, std::vector<int> points) {
    call(gmshModelGeoAddSpline, points.data(), points.size(), tag);
}

void Session::add_loop(int tag, std::vector<int> curves) {
    call(gmshModelGeoAddCurveLoop, curves.data(), curves.size(), tag, 0);
}

void Session::add_plane(int tag, std::vector<int> loops) {
    call(gmshModelGeoAddPlaneSurface, loops.data(), loops.size(), tag);
}

void Session::mesh_freely(Free cells, const Size& size) {
    call(gmshModelGeoSynchronize);
    struct Option {
        const char* name;
        double value;
    };
    constexpr double frontal_delaunay = 6,
                     blossom = 1;  // algorithm 8, designed for quadrilaterals, crashes in gmsh 4.8
    // Integrate cell lengths along an edge to 1e-6: with gmsh's default 1e-9 it evaluates most sizes ten times as often.
    // AbortOnError is off because an exception in one of gmsh's threads would abort the program; the caller checks the mesh.
    for (const Option& option : {Option{"General.AbortOnError", 0}, Option{"Mesh.MeshSizeExtendFromBoundary", 0},
                                 Option{"Mesh.MeshSizeFromPoints", 0}, Option{"Mesh.Algorithm", frontal_delaunay},
                                 Option{"Mesh.LcIntegrationPrecision", 1e-6}})
        call(gmshOptionSetNumber, option.name, option.value);
    if (cells == Free::quadrilaterals)
        for (const Option& option : {Option{"Mesh.RecombineAll", 1}, Option{"Mesh.RecombinationAlgorithm", blossom}})
            call(gmshOptionSetNumber, option.name, option.value);
    const auto evaluate = [](int, int, double x, double y, double, void* size_function) {
        return (*static_cast<const Size*>(size_function))({x, y});
    };
    call(gmshModelMeshSetSizeCallback, static_cast<double (*)(int, int, double, double, double, void*)>(evaluate),
         const_cast<void*>(static_cast<const void*>(&size)));  // NOLINT(*-const-cast): `evaluate` only reads it
    call(gmshModelMeshGenerate, 2);
}

void Session::add_triangles(int tag, Nodes nodes, std::vector<std::size_t> triangles) {
    constexpr int dimension = 2, triangle = 2;
    call(gmshModelAddDiscreteEntity, dimension, tag, static_cast<int*>(nullptr), std::size_t{0});
    call(gmshModelMeshAddNodes, dimension, tag, nodes.tags.data(), nodes.tags.size(), nodes.xyz.data(),
         nodes.xyz.size(), static_cast<double*>(nullptr), std::size_t{0});
    call(gmshModelMeshAddElementsByType, tag, triangle, static_cast<std::size_t*>(nullptr), std::size_t{0},
         triangles.data(), triangles.size());
}

void Session::fill(int volume, std::vector<int> surfaces, Filling filling) {
    constexpr double delaunay = 1, hxt = 10;
    for (int& surface : surfaces) {
        call(gmshModelGeoAddSurfaceLoop, &surface, std::size_t{1}, surface);
    }
    call(gmshModelGeoAddVolume, surfaces.data(), surfaces.size(), volume);
    call(gmshModelGeoSynchronize);
    for (const auto& [name, value] :
         {std::pair{"General.AbortOnError", 0.0}, std::pair{"Mesh.MeshSizeExtendFromBoundary", 1.0},
          std::pair{"Mesh.MeshSizeFromPoints", 0.0}, std::pair{"Mesh.OptimizeThreshold", 0.4},
          std::pair{"Mesh.Renumber", 0.0}, std::pair{"Mesh.Algorithm3D", filling == Filling::hxt ? hxt : delaunay}})
        call(gmshOptionSetNumber, name, value);
    call(gmshModelMeshGenerate, 3);
}

int Session::import_cad(const std::string& path) {
    int* shapes = nullptr;  // dimension, tag, dimension, tag, ...
    std::size_t count = 0;
    constexpr int only_of_highest_dimension = 1;
    call(gmshModelOccImportShapes, path.c_str(), &shapes, &count, only_of_highest_dimension, "step");
    int solids = 0;
    for (std::size_t s = 0; s < count; s += 2) solids += shapes[s] == 3 ? 1 : 0;
    gmshFree(shapes);
    call(gmshModelOccSynchronize);
    return solids;
}

std::string Session::type_of(int dimension, int tag) const {
    char* words = nullptr;
    call(gmshModelGetType, dimension, tag, &words);
    std::string type = words != nullptr ? words : "";
    gmshFree(words);
    return type;
}

std::vector<int> Session::tags(int dimension) const {
    int* pairs = nullptr;  // dimension, tag, dimension, tag, ...
    std::size_t count = 0;
    call(gmshModelGetEntities, &pairs, &count, dimension);
    std::vector<int> found;
    for (std::size_t n = 1; n < count; n += 2) found.push_back(pairs[n]);
    gmshFree(pairs);
    return found;
}

/// On planes, cylinders and cones, triangles between the points of the edges are as accurate as the chords of the edges, whatever
/// their length.
void Session::leave_ruled_faces_coarse() {
    constexpr int edge_points_only = 3;
    std::set<int> ruled;
    for (const int face : tags(2))
        if (const std::string type = type_of(2, face); type == "Plane" || type == "Cylinder" || type == "Cone") {
            ruled.insert(face);
            call(gmshModelMeshSetAlgorithm, 2, face, edge_points_only);
        }
    for (const int curve : tags(1)) {
        if (type_of(1, curve) != "Line") continue;
        int *faces = nullptr, *ends = nullptr;
        std::size_t face_count = 0, end_count = 0;
        call(gmshModelGetAdjacencies, 1, curve, &faces, &face_count, &ends, &end_count);
        const auto beside = taken(faces, face_count);
        gmshFree(ends);
        if (std::ranges::all_of(beside, [&](int face) { return ruled.contains(face); }))
            call(gmshModelMeshSetTransfiniteCurve, curve, 2, "Progression", 1.0);
    }
}

void Session::triangulate(const Chords& chords) {
    leave_ruled_faces_coarse();
    std::array<double, 6> box{};
    call(gmshModelGetBoundingBox, -1, -1, &box[0], &box[1], &box[2], &box[3], &box[4], &box[5]);
    const double extent = std::max({box[3] - box[0], box[4] - box[1], box[5] - box[2]});
    constexpr double frontal_delaunay = 6;
    for (const auto& [name, value] :
         {std::pair{"General.AbortOnError", 0.0}, std::pair{"Mesh.MeshSizeFromCurvature", chords.per_turn},
          std::pair{"Mesh.MeshSizeMax", chords.longest * extent},
          std::pair{"Mesh.MeshSizeMin", chords.shortest * extent}, std::pair{"Mesh.Algorithm", frontal_delaunay}})
        call(gmshOptionSetNumber, name, value);
    call(gmshModelMeshGenerate, 2);
}

std::vector<double> Session::triangle_corners() const {
    constexpr int triangle = 2;
    std::array<double, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
    double *jacobians = nullptr, *determinants = nullptr, *coordinates = nullptr;
    std::size_t jacobian_count = 0, determinant_count = 0, coordinate_count = 0;
    call(gmshModelMeshGetJacobians, triangle, corners.data(), corners.size(), &jacobians, &jacobian_count,
         &determinants, &determinant_count, &coordinates, &coordinate_count, -1, std::size_t{0}, std::size_t{1});
    gmshFree(jacobians);
    gmshFree(determinants);
    return taken(coordinates, coordinate_count);
}

GmshSession::Nodes Session::nodes() const {
    std::size_t *tags = nullptr, tag_count = 0, coordinate_count = 0, parameter_count = 0;
    double *coordinates = nullptr, *parameters = nullptr;
    call(gmshModelMeshGetNodes, &tags, &tag_count, &coordinates, &coordinate_count, &parameters, &parameter_count, -1,
         -1, 0, 0);
    gmshFree(parameters);
    return {taken(tags, tag_count), taken(coordinates, coordinate_count)};
}

std::map<std::size_t, double> Session::parameters(int curve) const {
    std::size_t *tags = nullptr, tag_count = 0, coordinate_count = 0, parameter_count = 0;
    double *coordinates = nullptr, *parameters = nullptr;
    call(gmshModelMeshGetNodes, &tags, &tag_count, &coordinates, &coordinate_count, &parameters, &parameter_count, 1,
         curve, 0, 1);
    gmshFree(coordinates);
    const auto inside = taken(tags, tag_count);
    const auto values = taken(parameters, parameter_count);
    std::map<std::size_t, double> found;
    for (std::size_t n = 0; n < inside.size(); ++n) found[inside[n]] = values.at(n);
    return found;
}

std::vector<Session::CellsOfType> Session::cells_by_type(int dimension, int tag) const {
    int* types = nullptr;
    std::size_t type_count = 0, **elements = nullptr, *element_counts = nullptr, element_lists = 0;
    std::size_t **nodes = nullptr, *node_counts = nullptr, node_lists = 0;
    call(gmshModelMeshGetElements, &types, &type_count, &elements, &element_counts, &element_lists, &nodes,
         &node_counts, &node_lists, dimension, tag);
    std::vector<CellsOfType> result;
    for (std::size_t t = 0; t < type_count; ++t)
        result.push_back({element_counts[t], {nodes[t], nodes[t] + node_counts[t]}});
    for (std::size_t* list : std::span(elements, element_lists)) gmshFree(list);
    for (std::size_t* list : std::span(nodes, node_lists)) gmshFree(list);
    for (void* array : {static_cast<void*>(types), static_cast<void*>(elements), static_cast<void*>(element_counts),
                        static_cast<void*>(nodes), static_cast<void*>(node_counts)})
        gmshFree(array);
    return result;
}

std::vector<std::size_t> Session::cells(int dimension, int tag) const {
    std::vector<CellsOfType> all = cells_by_type(dimension, tag);
    return all.size() == 1 ? std::move(all.front().nodes) : std::vector<std::size_t>{};
}

std::vector<std::vector<std::size_t>> Session::polygons(int surface) const {
    std::vector<std::vector<std::size_t>> result;
    for (const auto& [count, nodes] : cells_by_type(2, surface)) {
        const std::size_t corners = nodes.size() / count;
        for (auto first = nodes.begin(); first != nodes.end(); first += static_cast<std::ptrdiff_t>(corners))
            result.emplace_back(first, first + static_cast<std::ptrdiff_t>(corners));
    }
    return result;
}

}  // namespace

}  // namespace soft::meshing

extern "C" soft::meshing::GmshSession* soft_open_gmsh() { return new soft::meshing::Session; }
