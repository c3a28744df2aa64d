#include "meshing/outline_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

#include "core/error.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "meshing/gmsh_session.hpp"
#include "meshing/outline_sizes.hpp"
#include "meshing/polygons.hpp"

namespace soft::meshing {
namespace {

using mesh::Index;

/// To unit size, and there to the digits that no change of scale touches: what gmsh decides by the last digits, such as which of
/// two equal triangles is joined to a third, must be the same for a part in millimetres and in metres.
double unit_scale(const Outline& outline) { return 1 / extent_m(outline); }
double without_rounding(double unit_coordinate) { return std::ldexp(std::round(std::ldexp(unit_coordinate, 40)), -40); }

/// The outline told to gmsh, and which of its curves belong to which edge.
class Description {
public:
    Description(GmshSession& gmsh, const Outline& outline, double scale) : gmsh_(gmsh), scale_(scale) {
        std::vector<int> loops;
        for (const Loop& loop : outline.loops) {
            std::vector<int> starts, curves;
            for (const OutlineEdge& edge : loop) starts.push_back(point(edge.points.front()));
            for (std::size_t e = 0; e < loop.size(); ++e) {
                const auto first = static_cast<std::ptrdiff_t>(curves_.size());
                add(loop[e], {starts[e], starts[(e + 1) % loop.size()]});
                for (auto c = first; c < static_cast<std::ptrdiff_t>(curves_.size()); ++c)
                    curves.push_back(static_cast<int>(c) + 1);
            }
            loops.push_back(static_cast<int>(loops.size()) + 1);
            gmsh_.add_loop(loops.back(), std::move(curves));
        }
        // The loop round the solid comes first for gmsh, the holes behind it.
        const auto outer = std::ranges::max_element(
            loops, {}, [&](int loop) { return area_m2(outline.loops[static_cast<std::size_t>(loop) - 1]); });
        std::iter_swap(loops.begin(), outer);
        gmsh_.add_plane(surface, std::move(loops));
    }

    static constexpr int surface = 1;
    /// Of an edge, between two of its shares.
    struct Part {
        const OutlineEdge* edge;
        double from, to;
    };
    [[nodiscard]] const std::vector<Part>& curves() const { return curves_; }  ///< of curve 1, 2, ...

private:
    int point(PlanePoint place) {
        gmsh_.add_point(++points_, {without_rounding(place[0] * scale_), without_rounding(place[1] * scale_)});
        return points_;
    }
    int next(const Part& part) {
        curves_.push_back(part);
        return static_cast<int>(curves_.size());
    }

    void add(const OutlineEdge& edge, Ends ends) {
        switch (edge.shape) {
            case OutlineEdge::Shape::line: gmsh_.add_line(next({&edge, 0, 1}), {ends.start, ends.end}); break;
            case OutlineEdge::Shape::arc: add_arc(edge, ends); break;
            case OutlineEdge::Shape::spline: {
                std::vector<int> through{ends.start};
                for (std::size_t i = 1; i + 1 < edge.points.size(); ++i) through.push_back(point(edge.points[i]));
                through.push_back(ends.end);
                gmsh_.add_spline(next({&edge, 0, 1}), std::move(through));
                break;
            }
        }
    }

    /// gmsh's arcs turn by less than half a turn.
    void add_arc(const OutlineEdge& edge, Ends ends) {
        const OutlineArc arc = arc_of(edge);
        const int centre = point(arc.centre);
        const int parts = static_cast<int>(std::ceil(std::abs(arc.turn_rad) / (0.5 * std::numbers::pi + 1e-9)));
        for (int k = 1; k <= parts; ++k) {
            const double from = static_cast<double>(k - 1) / parts, to = static_cast<double>(k) / parts;
            const int stop = k == parts ? ends.end : point(arc.at(to));
            gmsh_.add_arc(next({&edge, from, to}), {ends.start, centre, stop});
            ends.start = stop;
        }
    }

    GmshSession& gmsh_;
    double scale_;
    int points_ = 0;
    std::vector<Part> curves_;
};

/// What gmsh made, in our numbers: points in the order in which the cells use them.
class Fetched {
public:
    Fetched(const GmshSession& gmsh, const Outline& outline, double scale) : gmsh_(gmsh) {
        const double snap_m = 1e-13 * extent_m(outline);  // rounding; a node on the axis must have r = 0
        const auto [tags, xyz] = gmsh.nodes();
        for (std::size_t i = 0; i < tags.size(); ++i) {
            const auto snapped = [&](double value) { return std::abs(value) < snap_m ? 0.0 : value; };
            places_[tags[i]] = {snapped(xyz[3 * i] / scale), snapped(xyz[3 * i + 1] / scale)};
        }
        for (const auto& polygon : gmsh.polygons(Description::surface)) {
            std::vector<int>& cell = result_.cells.emplace_back();
            for (const std::size_t tag : polygon) cell.push_back(number(tag));
        }
    }

    /// The sides along a curve, which runs through a part of its edge.
    void add_sides(int curve, const Description::Part& part) {
        constexpr std::size_t per_line = 2;
        const std::map<std::size_t, double> inside = gmsh_.parameters(curve);
        const auto share = [&](std::size_t tag, double at_end) {
            const auto found = inside.find(tag);
            return part.from + (found == inside.end() ? at_end : found->second) * (part.to - part.from);
        };
        const auto lines = gmsh_.cells(1, curve);
        for (std::size_t n = 0; n + 1 < lines.size(); n += per_line)
            result_.boundary[{number(lines[n]), number(lines[n + 1])}] = {part.edge, share(lines[n], 0),
                                                                          share(lines[n + 1], 1)};
    }

    Polygons take() { return std::move(result_); }

private:
    int number(std::size_t tag) {
        const auto [entry, fresh] = numbers_.try_emplace(tag, static_cast<int>(result_.points.size()));
        if (fresh) result_.points.push_back(places_.at(tag));
        return entry->second;
    }

    const GmshSession& gmsh_;
    std::unordered_map<std::size_t, PlanePoint> places_;
    std::unordered_map<std::size_t, int> numbers_;
    Polygons result_;
};

using Size = std::function<double(PlanePoint)>;

mesh::Mesh mesh_once(const Outline& outline, const Size& size_m, FreeCells cells) {
    const double scale = unit_scale(outline);
    GmshSession gmsh;
    const Description description{gmsh, outline, scale};
    const bool quads = cells == FreeCells::quadrilaterals;
    const double factor = (quads ? 2 : 1) * scale;
    gmsh.mesh_freely(
        quads ? GmshSession::Free::quadrilaterals : GmshSession::Free::triangles, [&](std::array<double, 2> place) {
            return static_cast<double>(static_cast<float>(factor * size_m({place[0] / scale, place[1] / scale})));
        });
    Fetched fetched{gmsh, outline, scale};
    for (std::size_t c = 0; c < description.curves().size(); ++c)
        fetched.add_sides(static_cast<int>(c) + 1, description.curves()[c]);
    Polygons polygons = fetched.take();
    divide_flat_corners(polygons);
    if (quads) polygons = into_quadrilaterals(polygons);
    smooth(polygons);
    mesh::Mesh mesh = second_order(polygons);
    double outline_m2 = 0;
    for (const Loop& loop : outline.loops) outline_m2 += area_m2(loop);
    constexpr double uncovered = 0.05;  // quadratic sides miss the outline by far less
    if (!(std::abs(mesh::measure(mesh, mesh::Measure::plain) / outline_m2 - 1) < uncovered))
        throw Error(ExitCode::internal, "section mesh", "gmsh's cells do not cover the section");
    return mesh;
}

/// A curved side may come so near to the opposite corner that its cell is flat there or inside out.
struct Spoilt {
    double least = 1;                ///< least over largest determinant of any cell; below 0 inside out
    std::vector<PlanePoint> places;  ///< of the cells that are hardly sound
};

Spoilt spoilt_cells(const mesh::Mesh& mesh) {
    constexpr double hardly = 0.1;
    Spoilt spoilt;
    std::vector<std::vector<mesh::ShapeValue>> shapes;
    for (const auto& node : mesh::topology(mesh.cell_types.front()).nodes)
        shapes.push_back(mesh::shape_values(mesh.cell_types.front(), node));
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        double least = INFINITY, most = -INFINITY;
        for (const auto& at_node : shapes) {
            const double determinant = map_cell(mesh, cell, at_node).determinant;
            least = std::min(least, determinant);
            most = std::max(most, determinant);
        }
        const double quality = most > 0 ? least / most : -1.0;
        const mesh::Point& corner = mesh.point(mesh.cell_nodes(cell).front());
        if (quality < hardly) spoilt.places.push_back({corner[0], corner[1]});
        spoilt.least = std::min(spoilt.least, quality);
    }
    return spoilt;
}

/// Half as long at those places, and growing from there as elsewhere.
Size shorter_at(const Size& size_m, const std::vector<PlanePoint>& places) {
    std::vector<double> sizes_m;
    for (const PlanePoint& place : places) sizes_m.push_back(0.5 * size_m(place));
    return [=](PlanePoint p) {
        double shortest_m = size_m(p);
        for (std::size_t i = 0; i < places.size(); ++i)
            shortest_m =
                std::min(shortest_m, sizes_m[i] + size_growth * std::hypot(p[0] - places[i][0], p[1] - places[i][1]));
        return shortest_m;
    };
}

}  // namespace

mesh::Mesh mesh_outline(const Outline& outline, FreeCells cells) {
    constexpr int attempts = 5;  // what a sixteenth of the length does not cure is a corner too sharp for any cell
    Size size_m = outline.size_m;
    mesh::Mesh best;
    double best_quality = -INFINITY;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        mesh::Mesh mesh;
        try {
            mesh = mesh_once(outline, size_m, cells);
        } catch (const Error& error) {  // gmsh has stumbled; over other lengths it may not
            if (error.code() != ExitCode::internal) throw;
            size_m = [=](PlanePoint place) { return 0.7 * size_m(place); };
            continue;
        }
        const Spoilt spoilt = spoilt_cells(mesh);
        if (spoilt.least > best_quality) {
            best_quality = spoilt.least;
            best = std::move(mesh);
        }
        if (spoilt.places.empty()) break;
        size_m = shorter_at(size_m, spoilt.places);
    }
    if (best.cell_types.empty())
        throw Error(ExitCode::bad_input, "section mesh", "gmsh finds no mesh in the outline",
                    "leave out very sharp corners and very thin walls");
    static_cast<void>(mesh::quality(best));  // throws with the place if no attempt has given sound cells
    return best;
}

}  // namespace soft::meshing
