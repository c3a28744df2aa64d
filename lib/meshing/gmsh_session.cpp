#include "meshing/gmsh_session.hpp"

#include <dlfcn.h>
#include <gmshc.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>

#include "core/error.hpp"
#include "core/memory.hpp"

namespace soft::meshing {
namespace {

constexpr const char* library_file = SOFT_GMSH_LIBRARY;
constexpr const char* needed_first = SOFT_GMSH_NEEDS;  // "libA.so.1 libB.so.2 ", lowest level first

Error not_loaded(const char* reason) {
    const std::string why = reason != nullptr ? reason : "unknown reason";
    if (why.find("failed to map segment") != std::string::npos) return core::out_of_memory();
    return {ExitCode::cannot_open, library_file, "cannot be loaded: " + why,
            "install gmsh, or rebuild with the installed version"};
}

/// The loader searches a symbol first in the program and the libraries it is linked with, then in everything loaded by the same
/// dlopen call. With RTLD_DEEPBIND the libraries are searched first (not supported by the address sanitizer). If they are loaded one
/// by one, lowest level first, each is searched only with its own dependencies. Both together halve the loading time.
#if defined(__SANITIZE_ADDRESS__) || !defined(RTLD_DEEPBIND)
constexpr int how_loaded = RTLD_LAZY | RTLD_LOCAL;
#else
constexpr int how_loaded = RTLD_LAZY | RTLD_LOCAL | RTLD_DEEPBIND;
#endif

/// With less memory the loader or one of the libraries may abort the program. Measured: 120 MB of address space for the smallest mesh.
constexpr std::size_t memory_to_load = std::size_t{112} << 20;

/// Missing or unneeded entries in the list of libraries are ignored.
void* load_gmsh() {
    core::require_memory(memory_to_load);
    const std::string names{needed_first};
    for (std::size_t begin = 0, end = 0; (end = names.find(' ', begin)) != std::string::npos; begin = end + 1)
        static_cast<void>(::dlopen(names.substr(begin, end - begin).c_str(), how_loaded));
    void* library = ::dlopen(library_file, how_loaded);
    if (library == nullptr) throw not_loaded(::dlerror());
    return library;  // never closed: some of the libraries crash when they are unloaded
}

template <class Function>
Function* function(void* library, const char* name) {
    auto* address = reinterpret_cast<Function*>(::dlsym(library, name));
    if (address == nullptr) throw not_loaded(::dlerror());
    return address;
}

/// Copies an array allocated by gmsh and frees the original.
template <class T>
std::vector<T> taken(T* values, std::size_t count, decltype(gmshFree)* free_array) {
    std::vector<T> copy(values, values + count);
    free_array(values);
    return copy;
}

}  // namespace

struct GmshSession::Functions {
    void* library = load_gmsh();
    decltype(gmshInitialize)* initialize = function<decltype(gmshInitialize)>(library, "gmshInitialize");
    decltype(gmshFinalize)* finalize = function<decltype(gmshFinalize)>(library, "gmshFinalize");
    decltype(gmshFree)* free = function<decltype(gmshFree)>(library, "gmshFree");
    decltype(gmshLoggerGetLastError)* last_error =
        function<decltype(gmshLoggerGetLastError)>(library, "gmshLoggerGetLastError");
    decltype(gmshOptionSetNumber)* set_option = function<decltype(gmshOptionSetNumber)>(library, "gmshOptionSetNumber");
    decltype(gmshModelGeoAddPoint)* add_point =
        function<decltype(gmshModelGeoAddPoint)>(library, "gmshModelGeoAddPoint");
    decltype(gmshModelGeoAddLine)* add_line = function<decltype(gmshModelGeoAddLine)>(library, "gmshModelGeoAddLine");
    decltype(gmshModelGeoAddCircleArc)* add_arc =
        function<decltype(gmshModelGeoAddCircleArc)>(library, "gmshModelGeoAddCircleArc");
    decltype(gmshModelGeoAddCurveLoop)* add_loop =
        function<decltype(gmshModelGeoAddCurveLoop)>(library, "gmshModelGeoAddCurveLoop");
    decltype(gmshModelGeoAddPlaneSurface)* add_surface =
        function<decltype(gmshModelGeoAddPlaneSurface)>(library, "gmshModelGeoAddPlaneSurface");
    decltype(gmshModelGeoAddSpline)* add_spline =
        function<decltype(gmshModelGeoAddSpline)>(library, "gmshModelGeoAddSpline");
    decltype(gmshModelMeshSetSizeCallback)* set_size =
        function<decltype(gmshModelMeshSetSizeCallback)>(library, "gmshModelMeshSetSizeCallback");
    decltype(gmshModelGeoMeshSetTransfiniteCurve)* divide =
        function<decltype(gmshModelGeoMeshSetTransfiniteCurve)>(library, "gmshModelGeoMeshSetTransfiniteCurve");
    decltype(gmshModelGeoMeshSetTransfiniteSurface)* make_grid =
        function<decltype(gmshModelGeoMeshSetTransfiniteSurface)>(library, "gmshModelGeoMeshSetTransfiniteSurface");
    decltype(gmshModelGeoMeshSetRecombine)* recombine =
        function<decltype(gmshModelGeoMeshSetRecombine)>(library, "gmshModelGeoMeshSetRecombine");
    decltype(gmshModelGeoSynchronize)* synchronize =
        function<decltype(gmshModelGeoSynchronize)>(library, "gmshModelGeoSynchronize");
    decltype(gmshModelMeshGenerate)* generate =
        function<decltype(gmshModelMeshGenerate)>(library, "gmshModelMeshGenerate");
    decltype(gmshModelMeshGetNodes)* get_nodes =
        function<decltype(gmshModelMeshGetNodes)>(library, "gmshModelMeshGetNodes");
    decltype(gmshModelMeshGetElements)* get_elements =
        function<decltype(gmshModelMeshGetElements)>(library, "gmshModelMeshGetElements");
    decltype(gmshModelAddDiscreteEntity)* add_discrete =
        function<decltype(gmshModelAddDiscreteEntity)>(library, "gmshModelAddDiscreteEntity");
    decltype(gmshModelMeshAddNodes)* add_nodes =
        function<decltype(gmshModelMeshAddNodes)>(library, "gmshModelMeshAddNodes");
    decltype(gmshModelMeshAddElementsByType)* add_elements =
        function<decltype(gmshModelMeshAddElementsByType)>(library, "gmshModelMeshAddElementsByType");
    decltype(gmshModelGeoAddSurfaceLoop)* add_shell =
        function<decltype(gmshModelGeoAddSurfaceLoop)>(library, "gmshModelGeoAddSurfaceLoop");
    decltype(gmshModelGeoAddVolume)* add_volume =
        function<decltype(gmshModelGeoAddVolume)>(library, "gmshModelGeoAddVolume");
    decltype(gmshModelOccImportShapes)* import_shapes =
        function<decltype(gmshModelOccImportShapes)>(library, "gmshModelOccImportShapes");
    decltype(gmshModelOccSynchronize)* synchronize_cad =
        function<decltype(gmshModelOccSynchronize)>(library, "gmshModelOccSynchronize");
    decltype(gmshModelMeshGetJacobians)* get_jacobians =
        function<decltype(gmshModelMeshGetJacobians)>(library, "gmshModelMeshGetJacobians");
    decltype(gmshModelGetEntities)* get_entities =
        function<decltype(gmshModelGetEntities)>(library, "gmshModelGetEntities");
    decltype(gmshModelGetType)* get_type = function<decltype(gmshModelGetType)>(library, "gmshModelGetType");
    decltype(gmshModelGetAdjacencies)* adjacencies =
        function<decltype(gmshModelGetAdjacencies)>(library, "gmshModelGetAdjacencies");
    decltype(gmshModelMeshSetAlgorithm)* set_algorithm =
        function<decltype(gmshModelMeshSetAlgorithm)>(library, "gmshModelMeshSetAlgorithm");
    decltype(gmshModelMeshSetTransfiniteCurve)* divide_cad_curve =
        function<decltype(gmshModelMeshSetTransfiniteCurve)>(library, "gmshModelMeshSetTransfiniteCurve");
    decltype(gmshModelGetBoundingBox)* bounding_box =
        function<decltype(gmshModelGetBoundingBox)>(library, "gmshModelGetBoundingBox");

    /// Calls a gmsh function with its last argument `int* failed`; throws if it fails.
    template <class Function, class... Arguments>
    void call(Function* called, Arguments... arguments) const {
        int failed = 0;
        static_cast<void>(called(arguments..., &failed));
        if (failed == 0) return;
        char* words = nullptr;
        last_error(&words, &failed);
        const std::string message = words != nullptr ? words : "unknown reason";
        free(words);
        throw Error(ExitCode::internal, "mesh", "gmsh failed: " + message);
    }
};

GmshSession::GmshSession() : gmsh_(std::make_unique<const Functions>()) {
    gmsh_->call(gmsh_->initialize, 0, nullptr, 0);
    gmsh_->call(gmsh_->set_option, "General.Terminal", 0.0);
}

GmshSession::~GmshSession() {
    int ignored = 0;  // a destructor cannot report errors
    gmsh_->finalize(&ignored);
}

void GmshSession::add_point(int tag, std::array<double, 2> position) {
    gmsh_->call(gmsh_->add_point, position[0], position[1], 0.0, 0.0, tag);
}

void GmshSession::add_line(int tag, Line line) { gmsh_->call(gmsh_->add_line, line.start, line.end, tag); }

void GmshSession::add_arc(int tag, Arc arc) {
    gmsh_->call(gmsh_->add_arc, arc.start, arc.centre, arc.end, tag, 0.0, 0.0, 0.0);
}

void GmshSession::divide_curve(int tag, Division division) {
    gmsh_->call(gmsh_->divide, tag, division.points, "Progression", division.ratio);
}

void GmshSession::add_grid(int tag, Surface surface) {
    constexpr double max_angle = 45;  // gmsh's default
    gmsh_->call(gmsh_->add_loop, surface.loop.data(), surface.loop.size(), tag, 0);
    gmsh_->call(gmsh_->add_surface, &tag, std::size_t{1}, tag);
    gmsh_->call(gmsh_->make_grid, tag, "Left", surface.corners.data(), surface.corners.size());
    gmsh_->call(gmsh_->recombine, 2, tag, max_angle);
}

void GmshSession::mesh() {
    gmsh_->call(gmsh_->synchronize);
    gmsh_->call(gmsh_->generate, 2);
}

void GmshSession::add_spline(int tag, std::vector<int> points) {
    gmsh_->call(gmsh_->add_spline, points.data(), points.size(), tag);
}

void GmshSession::add_loop(int tag, std::vector<int> curves) {
    gmsh_->call(gmsh_->add_loop, curves.data(), curves.size(), tag, 0);
}

void GmshSession::add_plane(int tag, std::vector<int> loops) {
    gmsh_->call(gmsh_->add_surface, loops.data(), loops.size(), tag);
}

void GmshSession::mesh_freely(Free cells, const Size& size) {
    gmsh_->call(gmsh_->synchronize);
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
        gmsh_->call(gmsh_->set_option, option.name, option.value);
    if (cells == Free::quadrilaterals)
        for (const Option& option : {Option{"Mesh.RecombineAll", 1}, Option{"Mesh.RecombinationAlgorithm", blossom}})
            gmsh_->call(gmsh_->set_option, option.name, option.value);
    const auto evaluate = [](int, int, double x, double y, double, void* size_function) {
        return (*static_cast<const Size*>(size_function))({x, y});
    };
    gmsh_->call(gmsh_->set_size, static_cast<double (*)(int, int, double, double, double, void*)>(evaluate),
                const_cast<void*>(static_cast<const void*>(&size)));  // NOLINT(*-const-cast): `evaluate` only reads it
    gmsh_->call(gmsh_->generate, 2);
}

void GmshSession::add_triangles(int tag, Nodes nodes, std::vector<std::size_t> triangles) {
    constexpr int dimension = 2, triangle = 2;
    gmsh_->call(gmsh_->add_discrete, dimension, tag, static_cast<int*>(nullptr), std::size_t{0});
    gmsh_->call(gmsh_->add_nodes, dimension, tag, nodes.tags.data(), nodes.tags.size(), nodes.xyz.data(),
                nodes.xyz.size(), static_cast<double*>(nullptr), std::size_t{0});
    gmsh_->call(gmsh_->add_elements, tag, triangle, static_cast<std::size_t*>(nullptr), std::size_t{0},
                triangles.data(), triangles.size());
}

void GmshSession::fill(int volume, std::vector<int> surfaces, Filling filling) {
    constexpr double delaunay = 1, hxt = 10;
    for (int& surface : surfaces) {
        gmsh_->call(gmsh_->add_shell, &surface, std::size_t{1}, surface);
    }
    gmsh_->call(gmsh_->add_volume, surfaces.data(), surfaces.size(), volume);
    gmsh_->call(gmsh_->synchronize);
    for (const auto& [name, value] :
         {std::pair{"General.AbortOnError", 0.0}, std::pair{"Mesh.MeshSizeExtendFromBoundary", 1.0},
          std::pair{"Mesh.MeshSizeFromPoints", 0.0}, std::pair{"Mesh.OptimizeThreshold", 0.4},
          std::pair{"Mesh.Renumber", 0.0}, std::pair{"Mesh.Algorithm3D", filling == Filling::hxt ? hxt : delaunay}})
        gmsh_->call(gmsh_->set_option, name, value);
    gmsh_->call(gmsh_->generate, 3);
}

int GmshSession::import_cad(const std::string& path) {
    int* shapes = nullptr;  // dimension, tag, dimension, tag, ...
    std::size_t count = 0;
    constexpr int only_of_highest_dimension = 1;
    gmsh_->call(gmsh_->import_shapes, path.c_str(), &shapes, &count, only_of_highest_dimension, "step");
    int solids = 0;
    for (std::size_t s = 0; s < count; s += 2) solids += shapes[s] == 3 ? 1 : 0;
    gmsh_->free(shapes);
    gmsh_->call(gmsh_->synchronize_cad);
    return solids;
}

std::string GmshSession::type_of(int dimension, int tag) const {
    char* words = nullptr;
    gmsh_->call(gmsh_->get_type, dimension, tag, &words);
    std::string type = words != nullptr ? words : "";
    gmsh_->free(words);
    return type;
}

std::vector<int> GmshSession::tags(int dimension) const {
    int* pairs = nullptr;  // dimension, tag, dimension, tag, ...
    std::size_t count = 0;
    gmsh_->call(gmsh_->get_entities, &pairs, &count, dimension);
    std::vector<int> found;
    for (std::size_t n = 1; n < count; n += 2) found.push_back(pairs[n]);
    gmsh_->free(pairs);
    return found;
}

/// On planes, cylinders and cones, triangles between the points of the edges are as accurate as the chords of the edges, whatever
/// their length.
void GmshSession::leave_ruled_faces_coarse() {
    constexpr int edge_points_only = 3;
    std::set<int> ruled;
    for (const int face : tags(2))
        if (const std::string type = type_of(2, face); type == "Plane" || type == "Cylinder" || type == "Cone") {
            ruled.insert(face);
            gmsh_->call(gmsh_->set_algorithm, 2, face, edge_points_only);
        }
    for (const int curve : tags(1)) {
        if (type_of(1, curve) != "Line") continue;
        int *faces = nullptr, *ends = nullptr;
        std::size_t face_count = 0, end_count = 0;
        gmsh_->call(gmsh_->adjacencies, 1, curve, &faces, &face_count, &ends, &end_count);
        const auto beside = taken(faces, face_count, gmsh_->free);
        gmsh_->free(ends);
        if (std::ranges::all_of(beside, [&](int face) { return ruled.contains(face); }))
            gmsh_->call(gmsh_->divide_cad_curve, curve, 2, "Progression", 1.0);
    }
}

void GmshSession::triangulate(const Chords& chords) {
    leave_ruled_faces_coarse();
    std::array<double, 6> box{};
    gmsh_->call(gmsh_->bounding_box, -1, -1, &box[0], &box[1], &box[2], &box[3], &box[4], &box[5]);
    const double extent = std::max({box[3] - box[0], box[4] - box[1], box[5] - box[2]});
    constexpr double frontal_delaunay = 6;
    for (const auto& [name, value] :
         {std::pair{"General.AbortOnError", 0.0}, std::pair{"Mesh.MeshSizeFromCurvature", chords.per_turn},
          std::pair{"Mesh.MeshSizeMax", chords.longest * extent},
          std::pair{"Mesh.MeshSizeMin", chords.shortest * extent}, std::pair{"Mesh.Algorithm", frontal_delaunay}})
        gmsh_->call(gmsh_->set_option, name, value);
    gmsh_->call(gmsh_->generate, 2);
}

std::vector<double> GmshSession::triangle_corners() const {
    constexpr int triangle = 2;
    std::array<double, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
    double *jacobians = nullptr, *determinants = nullptr, *coordinates = nullptr;
    std::size_t jacobian_count = 0, determinant_count = 0, coordinate_count = 0;
    gmsh_->call(gmsh_->get_jacobians, triangle, corners.data(), corners.size(), &jacobians, &jacobian_count,
                &determinants, &determinant_count, &coordinates, &coordinate_count, -1, std::size_t{0}, std::size_t{1});
    gmsh_->free(jacobians);
    gmsh_->free(determinants);
    return taken(coordinates, coordinate_count, gmsh_->free);
}

GmshSession::Nodes GmshSession::nodes() const {
    std::size_t *tags = nullptr, tag_count = 0, coordinate_count = 0, parameter_count = 0;
    double *coordinates = nullptr, *parameters = nullptr;
    gmsh_->call(gmsh_->get_nodes, &tags, &tag_count, &coordinates, &coordinate_count, &parameters, &parameter_count, -1,
                -1, 0, 0);
    gmsh_->free(parameters);
    return {taken(tags, tag_count, gmsh_->free), taken(coordinates, coordinate_count, gmsh_->free)};
}

std::map<std::size_t, double> GmshSession::parameters(int curve) const {
    std::size_t *tags = nullptr, tag_count = 0, coordinate_count = 0, parameter_count = 0;
    double *coordinates = nullptr, *parameters = nullptr;
    gmsh_->call(gmsh_->get_nodes, &tags, &tag_count, &coordinates, &coordinate_count, &parameters, &parameter_count, 1,
                curve, 0, 1);
    gmsh_->free(coordinates);
    const auto inside = taken(tags, tag_count, gmsh_->free);
    const auto values = taken(parameters, parameter_count, gmsh_->free);
    std::map<std::size_t, double> found;
    for (std::size_t n = 0; n < inside.size(); ++n) found[inside[n]] = values.at(n);
    return found;
}

std::vector<GmshSession::CellsOfType> GmshSession::cells_by_type(int dimension, int tag) const {
    int* types = nullptr;
    std::size_t type_count = 0, **elements = nullptr, *element_counts = nullptr, element_lists = 0;
    std::size_t **nodes = nullptr, *node_counts = nullptr, node_lists = 0;
    gmsh_->call(gmsh_->get_elements, &types, &type_count, &elements, &element_counts, &element_lists, &nodes,
                &node_counts, &node_lists, dimension, tag);
    std::vector<CellsOfType> result;
    for (std::size_t t = 0; t < type_count; ++t)
        result.push_back({element_counts[t], {nodes[t], nodes[t] + node_counts[t]}});
    for (std::size_t* list : std::span(elements, element_lists)) gmsh_->free(list);
    for (std::size_t* list : std::span(nodes, node_lists)) gmsh_->free(list);
    for (void* array : {static_cast<void*>(types), static_cast<void*>(elements), static_cast<void*>(element_counts),
                        static_cast<void*>(nodes), static_cast<void*>(node_counts)})
        gmsh_->free(array);
    return result;
}

std::vector<std::size_t> GmshSession::cells(int dimension, int tag) const {
    std::vector<CellsOfType> all = cells_by_type(dimension, tag);
    return all.size() == 1 ? std::move(all.front().nodes) : std::vector<std::size_t>{};
}

std::vector<std::vector<std::size_t>> GmshSession::polygons(int surface) const {
    std::vector<std::vector<std::size_t>> result;
    for (const auto& [count, nodes] : cells_by_type(2, surface)) {
        const std::size_t corners = nodes.size() / count;
        for (auto first = nodes.begin(); first != nodes.end(); first += static_cast<std::ptrdiff_t>(corners))
            result.emplace_back(first, first + static_cast<std::ptrdiff_t>(corners));
    }
    return result;
}

}  // namespace soft::meshing
