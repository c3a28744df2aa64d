#include "meshing/shells.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/text.hpp"
#include "surface/facet_map.hpp"

namespace soft::meshing {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Edge = std::pair<std::size_t, std::size_t>;

std::string location_text(const mesh::Point& p, const SoupOrigin& origin) {
    const auto number = [&](std::size_t d) {
        return core::rounded_text(p[d], 4) + (origin.unit.empty() ? "" : " ") + origin.unit;
    };
    return "x = " + number(0) + ", y = " + number(1) + ", z = " + number(2);
}

[[noreturn]] void refuse(const SoupOrigin& origin, const std::string& problem, const std::string& remedy) {
    throw Error(ExitCode::bad_input, origin.name, problem, remedy);
}

mesh::Point middle(const mesh::Point& a, const mesh::Point& b) {
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// Edges by their ends, with the number of facets that share each edge.
std::map<Edge, int> edges_of(const FacetSoup& soup) {
    std::map<Edge, int> edges;
    for (const auto& t : soup.facets)
        for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    return edges;
}

/// Rims of holes: connected chains of edges that belong to one facet only.
std::vector<std::vector<Edge>> rims_of(const std::map<Edge, int>& edges) {
    std::multimap<std::size_t, Edge> open;
    for (const auto& [edge, uses] : edges)
        if (uses == 1) {
            open.emplace(edge.first, edge);
            open.emplace(edge.second, edge);
        }
    std::vector<std::vector<Edge>> rims;
    std::set<Edge> done;
    for (const auto& [start, first] : open) {
        if (done.contains(first)) continue;
        std::vector<Edge>& rim = rims.emplace_back();
        std::vector<std::size_t> pending{start};
        while (!pending.empty()) {
            const auto [from, to] = open.equal_range(pending.back());
            pending.pop_back();
            for (auto next = from; next != to; ++next)
                if (done.insert(next->second).second) {
                    rim.push_back(next->second);
                    pending.insert(pending.end(), {next->second.first, next->second.second});
                }
        }
    }
    return rims;
}

void refuse_open(const FacetSoup& soup, const SoupOrigin& origin) {
    const std::map<Edge, int> edges = edges_of(soup);
    const auto crowded = std::ranges::count_if(edges, [](const auto& edge) { return edge.second > 2; });
    for (const auto& [edge, uses] : edges)
        if (uses > 2)
            refuse(origin,
                   counted(static_cast<std::size_t>(crowded), "edge is", "edges are") +
                       " shared by more than two facets, the first by " + std::to_string(uses) + " near " +
                       location_text(middle(soup.points[edge.first], soup.points[edge.second]), origin),
                   "unite the parts into one body or separate them");
    const auto rims = rims_of(edges);
    if (rims.empty()) return;
    double length = 0;
    mesh::Point centre{};
    for (const auto& [a, b] : rims.front()) {
        const mesh::Point &p = soup.points[a], &q = soup.points[b];
        length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        for (std::size_t d = 0; d < 3; ++d) centre[d] += (p[d] + q[d]) / 2 / static_cast<double>(rims.front().size());
    }
    refuse(origin,
           counted(rims.size(), "hole", "holes") + " in the surface, " + (rims.size() > 1 ? "the first " : "") +
               "near " + location_text(centre, origin) + " with a rim of length " + core::rounded_text(length, 4) +
               (origin.unit.empty() ? "" : " ") + origin.unit,
           "close the surface in the CAD program: a part is a solid, and an opening is a channel through its wall");
}

/// CGAL mesh in which every facet has an orientation consistent with its neighbours.
SurfaceMesh oriented(const FacetSoup& soup, const SoupOrigin& origin) {
    std::vector<Kernel::Point_3> points;
    for (const mesh::Point& p : soup.points) points.emplace_back(p[0], p[1], p[2]);
    std::vector<std::vector<std::size_t>> facets = soup.facets;
    const std::size_t before = points.size();
    if (!PMP::orient_polygon_soup(points, facets) && points.size() != before) {
        const Kernel::Point_3& p = points[before];  // CGAL duplicates non-manifold points and appends the copies
        refuse(origin,
               "the surface is not manifold (connected at a single point, or not orientable) near " +
                   location_text({p.x(), p.y(), p.z()}, origin),
               "unite the parts into one body or separate them");
    }
    SurfaceMesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, facets, mesh);
    return mesh;
}

void refuse_crossings(const SurfaceMesh& mesh, const SoupOrigin& origin) {
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
    PMP::self_intersections(mesh, std::back_inserter(pairs));
    if (pairs.empty()) return;
    for (auto& [a, b] : pairs)
        if (b < a) std::swap(a, b);
    const auto [first, second] = *std::ranges::min_element(pairs);
    mesh::Point location{};  // centre of the intersection of their bounding boxes
    for (int d = 0; d < 3; ++d) {
        double from = -std::numeric_limits<double>::infinity(), to = -from;
        for (const auto face : {first, second}) {
            const CGAL::Bbox_3 box = PMP::face_bbox(face, mesh);
            from = std::max(from, box.min(d));
            to = std::min(to, box.max(d));
        }
        location[static_cast<std::size_t>(d)] = (from + to) / 2;
    }
    refuse(origin,
           counted(pairs.size(), "pair of facets intersects", "pairs of facets intersect") + ", the first near " +
               location_text(location, origin),
           "unite the overlapping parts in the CAD program");
}

/// Number of facets whose orientation differs from that in the file.
std::size_t count_reoriented(const FacetSoup& soup, const SurfaceMesh& mesh) {
    std::size_t turned = 0;
    std::map<std::array<std::size_t, 3>, std::array<std::size_t, 3>> written;
    for (const auto& t : soup.facets) {
        std::array<std::size_t, 3> key{t[0], t[1], t[2]};
        const std::array<std::size_t, 3> own = key;
        std::ranges::sort(key);
        written[key] = own;
    }
    for (const auto face : mesh.faces()) {
        std::array<std::size_t, 3> now{};
        std::size_t k = 0;
        for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) now[k++] = vertex.idx();
        std::array<std::size_t, 3> key = now;
        std::ranges::sort(key);
        const auto found = written.find(key);
        if (found == written.end()) continue;
        const auto& was = found->second;
        const auto at = static_cast<std::size_t>(std::ranges::find(was, now[0]) - was.begin());
        turned += was[(at + 1) % 3] != now[1] ? 1U : 0U;
    }
    return turned;
}

[[noreturn]] void refuse_empty(const SoupOrigin& origin) {
    refuse(origin, "the surface is flat and encloses no volume", "export a solid part");
}

/// A connected component of the surface: its facets, the enclosed volume (negative: a cavity) and its bounding box.
struct Sheet {
    std::vector<SurfaceMesh::Face_index> faces;
    double volume = 0;
    CGAL::Bbox_3 box;
};

std::vector<Sheet> sheets_of(const SurfaceMesh& mesh, const SoupOrigin& origin) {
    std::map<SurfaceMesh::Face_index, std::size_t> number_of;
    boost::associative_property_map numbers(number_of);
    std::vector<Sheet> sheets(PMP::connected_components(mesh, numbers));
    for (const auto face : mesh.faces()) {
        Sheet& sheet = sheets[number_of.at(face)];
        sheet.faces.push_back(face);
        sheet.box = sheet.faces.size() == 1 ? PMP::face_bbox(face, mesh) : sheet.box + PMP::face_bbox(face, mesh);
    }
    for (Sheet& sheet : sheets)  // tetrahedra with the origin: each sheet is closed
        for (const auto face : sheet.faces) {
            const auto h = mesh.halfedge(face);
            const Kernel::Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                                  &c = mesh.point(mesh.target(mesh.next(h)));
            sheet.volume += CGAL::to_double(CGAL::volume(CGAL::ORIGIN + Kernel::Vector_3(0, 0, 0), a, b, c));
        }
    std::ranges::sort(sheets, [](const Sheet& a, const Sheet& b) {  // the outside first, then cavities by location
        if ((a.volume > 0) != (b.volume > 0)) return a.volume > 0;
        return std::array{a.box.xmin(), a.box.ymin(), a.box.zmin()} <
               std::array{b.box.xmin(), b.box.ymin(), b.box.zmin()};
    });
    const auto bodies = std::ranges::count_if(sheets, [](const Sheet& sheet) { return sheet.volume > 0; });
    if (bodies == 0) refuse_empty(origin);
    if (bodies != 1) {
        const CGAL::Bbox_3& box = sheets[1].box;
        refuse(origin,
               std::to_string(bodies) + " bodies in one file, the second around " +
                   location_text(
                       {(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2},
                       origin),
               "unite them or put each into its own file");
    }
    return sheets;
}

BodySurface plain(const SurfaceMesh& mesh, const std::vector<Sheet>& sheets, double unit_m) {
    BodySurface surface;
    for (const auto vertex : mesh.vertices()) {
        const Kernel::Point_3& p = mesh.point(vertex);
        surface.points.push_back({p.x() * unit_m, p.y() * unit_m, p.z() * unit_m});
    }
    const std::size_t cavities = sheets.size() - 1;
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const CGAL::Bbox_3& box = sheets[s].box;
        surface.shells.push_back({s == 0          ? "outer"
                                  : cavities == 1 ? "cavity"
                                                  : "cavity_" + std::to_string(s),
                                  std::abs(sheets[s].volume) * std::pow(unit_m, 3),
                                  {(box.xmin() + box.xmax()) / 2 * unit_m, (box.ymin() + box.ymax()) / 2 * unit_m,
                                   (box.zmin() + box.zmax()) / 2 * unit_m}});
        for (const auto face : sheets[s].faces) {
            std::array<int, 3> t{};
            std::size_t k = 0;
            for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
                t[k++] = static_cast<int>(vertex.idx());
            surface.triangles.push_back(t);
            surface.shell_of.push_back(static_cast<int>(s));
        }
    }
    return surface;
}

}  // namespace

BodySurface closed_shells(const FacetSoup& soup, const SoupOrigin& origin) {
    refuse_open(soup, origin);
    SurfaceMesh mesh = oriented(soup, origin);
    std::vector<SurfaceMesh::Face_index> flat;
    PMP::degenerate_faces(mesh, std::back_inserter(flat));
    const bool mended = flat.empty() || PMP::remove_degenerate_faces(mesh);
    PMP::remove_isolated_vertices(mesh);
    mesh.collect_garbage();
    if (!mended)
        refuse(origin, counted(flat.size(), "zero-area facet", "zero-area facets") + " that cannot be removed",
               "export the part again with larger facets");
    if (mesh.number_of_faces() == 0) refuse_empty(origin);
    refuse_crossings(mesh, origin);
    PMP::orient_to_bound_a_volume(mesh);
    const std::size_t turned = flat.empty() ? count_reoriented(soup, mesh) : 0;  // removing facets renumbers the points
    BodySurface surface = plain(mesh, sheets_of(mesh, origin), origin.unit_m);
    if (!flat.empty())
        surface.repairs.push_back(counted(flat.size(), "zero-area facet", "zero-area facets") + " removed");
    if (turned > 0) surface.repairs.push_back(counted(turned, "facet", "facets") + " reoriented");
    return surface;
}

}  // namespace soft::meshing
