#include "geometry/profile_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::geometry {
namespace {

using meshing::cross, meshing::dot, meshing::length, meshing::minus, meshing::spline_at;

constexpr double small_turn_rad = 15 * std::numbers::pi / 180;

/// The edges of a closed loop of rows: from each row to the next.
class Edges {
public:
    explicit Edges(const std::vector<ProfileRow>& rows) : rows_(rows) {}

    /// Whether edge `e` and the previous one may belong to one smooth curve: same tag, small turn, similar length.
    [[nodiscard]] bool continues(std::size_t e, double max_turn_rad = small_turn_rad) const {
        constexpr double max_ratio = 4;
        const std::size_t before = (e + rows_.size() - 1) % rows_.size();
        if (!rows_[e].may_curve || !rows_[before].may_curve || rows_[e].tag != rows_[before].tag) return false;
        const double ratio = length(along(e)) / length(along(before));
        return turn_rad(e) <= max_turn_rad && ratio <= max_ratio && ratio * max_ratio >= 1;
    }
    [[nodiscard]] double turn_rad(std::size_t e) const {
        const meshing::PlanePoint in = along((e + rows_.size() - 1) % rows_.size()), out = along(e);
        return std::abs(std::atan2(cross(in, out), dot(in, out)));
    }
    [[nodiscard]] meshing::PlanePoint along(std::size_t e) const {
        return minus(rows_[(e + 1) % rows_.size()].point, rows_[e].point);
    }

private:
    const std::vector<ProfileRow>& rows_;
};

/// Converts rows [first, end) of a loop to a spline; true if it stays close to the straight edges. Edges on the axis or a symmetry
/// plane stay straight.
bool convert_to_spline(std::vector<ProfileRow>& rows, std::size_t first, std::size_t end, FoundCurves& found) {
    constexpr double tolerance = 1e-2;  // of the length of the curve
    const std::string& tag = rows[first].tag;
    if (tag == meshing::axis_face || tag == meshing::symmetry_x_face || tag == meshing::symmetry_y_face) return false;
    const Edges edges{rows};
    double length_m = 0;
    for (std::size_t e = first; e < end; ++e) length_m += length(edges.along(e));
    std::vector<meshing::PlanePoint> points;
    for (std::size_t e = first; e <= end; ++e) points.push_back(rows[e % rows.size()].point);
    double deviation_m = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const meshing::PlanePoint chord = minus(points[k + 1], points[k]);
        for (const double share : {0.25, 0.5, 0.75})
            deviation_m =
                std::max(deviation_m,
                         std::abs(cross(chord, minus(spline_at(points, static_cast<double>(k) + share), points[k]))) /
                             length(chord));
    }
    if (deviation_m > tolerance * length_m) return false;
    for (std::size_t e = first; e < end; ++e) rows[e].shape = meshing::OutlineEdge::Shape::spline;
    rows[first].begins_edge = true;
    found.edges += end - first;
    ++found.curves;
    if (found.first_line == 0) found.first_line = rows[first].line;
    found.deviation_m = std::max(found.deviation_m, deviation_m);
    return true;
}

std::string spline_note(const FoundCurves& found, std::string_view source) {
    std::string text{source};
    return text.append(": ")
        .append(std::to_string(found.edges))
        .append(" straight edges (the first in line ")
        .append(std::to_string(found.first_line))
        .append(") approximate ")
        .append(core::counted(found.curves, "smooth curve"))
        .append(" and become splines, which deviate from them by at most ")
        .append(core::quantity_text(found.deviation_m, core::Dimension::length))
        .append("; write line in the column curve to keep an edge straight");
}

/// Counts edges with larger turns: they may be intended, or approximate a curve by few points.
void count_coarse_curves(const std::vector<ProfileRow>& rows, FoundCurves& found) {
    constexpr double large_turn_rad = 40 * std::numbers::pi / 180;
    constexpr std::size_t min_edges = 12;
    const Edges edges{rows};
    for (std::size_t first = 0; first < rows.size();) {
        bool bent = false;
        std::size_t end = first + 1;
        while (end < rows.size() && rows[end].shape == meshing::OutlineEdge::Shape::line &&
               edges.continues(end, large_turn_rad)) {
            bent = bent || edges.turn_rad(end) > small_turn_rad;
            ++end;
        }
        if (bent && end - first >= min_edges) {
            found.coarse_edges += end - first;
            if (found.coarse_line == 0) found.coarse_line = rows[first].line;
        }
        first = end;
    }
}

}  // namespace

void recognise_curves(std::vector<ProfileRow>& rows, FoundCurves& found) {
    constexpr std::size_t min_edges = 6;  // of a curve: fewer are probably intended to be straight
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].point == rows[(i + 1) % rows.size()].point) return;  // reported later, with its row
    const std::vector<ProfileRow> as_given = rows;
    const std::size_t found_before = found.edges;
    std::size_t corner = 0;
    while (corner < rows.size() && Edges{rows}.continues(corner)) ++corner;
    const bool closed = corner == rows.size();
    if (!closed) std::ranges::rotate(rows, rows.begin() + static_cast<std::ptrdiff_t>(corner));
    for (std::size_t first = 0; first < rows.size();) {
        std::size_t end = first + 1;
        while (end < rows.size() && Edges{rows}.continues(end)) ++end;
        if (end - first >= min_edges) {
            // A closed spline is smooth at its start: a loop with one corner needs two splines.
            const bool round = !closed && end - first == rows.size();
            const std::size_t middle = round ? first + (end - first) / 2 : end;
            (void)convert_to_spline(rows, first, middle, found);
            if (round) (void)convert_to_spline(rows, middle, end, found);
        }
        first = end;
    }
    if (found.edges == found_before) rows = as_given;
    count_coarse_curves(as_given, found);
}

std::vector<std::string> notes_of(const FoundCurves& found, std::string_view source) {
    std::vector<std::string> notes;
    if (found.edges > 0) notes.push_back(spline_note(found, source));
    if (found.coarse_edges > 0)
        notes.push_back(
            std::string{source} + ": " + std::to_string(found.coarse_edges) + " straight edges (the first in line " +
            std::to_string(found.coarse_line) +
            ") turn by up to 40 degrees from one to the next and each needs its own cells; if they approximate a "
            "curve, write spline in the column curve");
    return notes;
}

}  // namespace soft::geometry
