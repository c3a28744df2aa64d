#include "geometry/profile.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/files.hpp"
#include "core/table.hpp"
#include "core/text.hpp"
#include "geometry/keys.hpp"
#include "geometry/profile_curves.hpp"
#include "meshing/outline_sizes.hpp"

namespace soft::geometry {
namespace {

constexpr const char* cavity_face = "cavity";

Error fault(std::string_view source, std::size_t line, std::string_view problem, std::string_view remedy = {}) {
    return {ExitCode::bad_input, std::string{source} + ":" + std::to_string(line), problem, remedy};
}

class Reader {
public:
    Reader(std::string_view text, std::string_view source, Across across)
        : table_(core::read_table(text, source)), second_(across == Across::r ? "r" : "y") {
        if (table_.headings.empty())
            throw fault(source, table_.lines.front(), "the header line is missing",
                        "begin with x_mm," + second_ + "_mm,tag");
        for (const core::Heading& heading : table_.headings) check_known(heading);
    }

    [[nodiscard]] std::vector<ProfileRow> rows() const {
        const std::vector<double> x = lengths("x", table_), y = lengths(second_, table_);
        std::vector<ProfileRow> rows;
        for (std::size_t i = 0; i < table_.rows.size(); ++i)
            rows.push_back({table_.lines[i],
                            {x[i], y[i]},
                            word("tag", i),
                            word("loop", i),
                            shape_in(i),
                            std::nullopt,
                            word("curve", i).empty()});
        if (!column("tag"))
            throw fault(table_.source, table_.header_line, "there is no column 'tag'",
                        "name the face of the edge that starts at each row");
        read_vias(rows);
        return rows;
    }

private:
    void check_known(const core::Heading& heading) const {
        const std::vector<std::string> known{"x", second_, "tag", "curve", "via_x", "via_" + second_, "loop"};
        if (std::ranges::find(known, heading.quantity) == known.end())
            throw fault(table_.source, table_.header_line, "unknown column " + core::quoted(heading.name),
                        "use " + core::join(known) + ", lengths with a unit as in x_mm");
    }

    [[nodiscard]] std::optional<std::size_t> column(std::string_view quantity) const {
        const auto found = std::ranges::find(table_.headings, quantity, &core::Heading::quantity);
        if (found == table_.headings.end()) return std::nullopt;
        return static_cast<std::size_t>(found - table_.headings.begin());
    }

    [[nodiscard]] std::vector<double> lengths(const std::string& quantity, const core::Table& table) const {
        const auto found = column(quantity);
        if (!found)
            throw fault(table_.source, table_.header_line, "there is no column " + core::quoted(quantity + "_mm"));
        const core::Heading& heading = table_.headings[*found];
        if (core::dimension_of(heading.unit) != core::Dimension::length)
            throw fault(table_.source, table_.header_line,
                        "column " + core::quoted(heading.name) + " has no unit of length", "write " + quantity + "_mm");
        return core::values_SI(table, *found, heading.unit, core::Dimension::length);
    }

    [[nodiscard]] std::string word(std::string_view quantity, std::size_t row) const {
        const auto found = column(quantity);
        return found ? std::string{core::trimmed(table_.rows[row][*found])} : std::string{};
    }

    [[nodiscard]] meshing::OutlineEdge::Shape shape_in(std::size_t row) const {
        const std::string name = word("curve", row);
        if (name.empty() || name == "line") return meshing::OutlineEdge::Shape::line;
        if (name == "arc") return meshing::OutlineEdge::Shape::arc;
        if (name == "spline") return meshing::OutlineEdge::Shape::spline;
        throw fault(table_.source, table_.lines[row], core::quoted(name) + " is not a curve",
                    "use line, arc or spline");
    }

    void read_vias(std::vector<ProfileRow>& rows) const {
        core::Table arcs = table_;  // only the rows of arcs
        arcs.rows.clear();
        arcs.lines.clear();
        std::vector<ProfileRow*> owners;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].shape != meshing::OutlineEdge::Shape::arc) continue;
            arcs.rows.push_back(table_.rows[i]);
            arcs.lines.push_back(table_.lines[i]);
            owners.push_back(&rows[i]);
        }
        if (owners.empty()) return;
        const std::vector<double> x = lengths("via_x", arcs), y = lengths("via_" + second_, arcs);
        for (std::size_t i = 0; i < owners.size(); ++i) owners[i]->via = meshing::PlanePoint{x[i], y[i]};
    }

    core::Table table_;
    std::string second_;
};

bool is_tag(const std::string& word) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto is_other = [](char c) { return (c >= '0' && c <= '9') || c == '_' || c == '-'; };
    return !word.empty() && is_letter(word.front()) &&
           std::ranges::all_of(word, [&](char c) { return is_letter(c) || is_other(c); });
}

/// Converts the rows of one loop to edges.
meshing::Loop loop_of(std::vector<ProfileRow> rows, std::string_view source, FoundCurves& found) {
    if (rows.size() > 1 && rows.back().tag.empty() && rows.back().point == rows.front().point) rows.pop_back();
    recognise_curves(rows, found);
    meshing::Loop loop;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ProfileRow& row = rows[i];
        const meshing::PlanePoint next = rows[(i + 1) % rows.size()].point;
        if (row.tag.empty())
            throw fault(source, row.line, "the tag is missing",
                        "name the face of the edge that starts here, for example free");
        if (!is_tag(row.tag))
            throw fault(source, row.line, core::quoted(row.tag) + " is not a valid face name",
                        "use letters, digits, _ and -, starting with a letter");
        const bool continues_spline = i > 0 && row.shape == meshing::OutlineEdge::Shape::spline && !row.begins_edge &&
                                      rows[i - 1].shape == row.shape && rows[i - 1].tag == row.tag;
        if (continues_spline) {
            loop.back().points.push_back(next);
            continue;
        }
        meshing::OutlineEdge edge{row.shape, {row.point, next}, {row.tag}, row.line};
        if (row.via) {
            edge.points.insert(edge.points.begin() + 1, *row.via);
            const meshing::PlanePoint a{row.via->at(0) - row.point[0], row.via->at(1) - row.point[1]},
                b{next[0] - row.point[0], next[1] - row.point[1]};
            if (std::abs(a[0] * b[1] - a[1] * b[0]) <=
                meshing::outline_tolerance * std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]))
                throw fault(source, row.line, "the three points of the arc are collinear", "use line");
        }
        loop.push_back(std::move(edge));
    }
    return loop;
}

meshing::Outline loops_of(const std::vector<ProfileRow>& rows, std::string_view source) {
    meshing::Outline outline;
    FoundCurves found;
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin < rows.size();) {
        std::size_t end = begin;
        while (end < rows.size() && rows[end].loop == rows[begin].loop) ++end;
        if (std::ranges::find(names, rows[begin].loop) != names.end())
            throw fault(source, rows[begin].line,
                        "loop " + core::quoted(rows[begin].loop) + " continues after another loop",
                        "keep its rows together");
        names.push_back(rows[begin].loop);
        outline.loops.push_back(loop_of(
            {rows.begin() + static_cast<std::ptrdiff_t>(begin), rows.begin() + static_cast<std::ptrdiff_t>(end)},
            source, found));
        begin = end;
    }
    outline.notes = notes_of(found, source);
    return outline;
}

/// Throws for an edge with the reserved tag that does not lie on the plane or axis, and, if `demanded`, for an edge on it that has
/// another tag.
void check_named_line(const meshing::Outline& outline, std::string_view source, std::size_t component,
                      const std::string& name, bool demanded) {
    const char* const zero = component == 0 ? "x = 0" : "r = 0";
    for (const meshing::Loop& loop : outline.loops)
        for (const meshing::OutlineEdge& edge : loop) {
            const bool on_line = edge.shape == meshing::OutlineEdge::Shape::line && edge.points[0][component] == 0 &&
                                 edge.points[1][component] == 0;
            const bool named = edge.faces.front() == name;
            if (named && !on_line)
                throw fault(source, edge.row, "the edge is tagged " + name + " but does not lie on " + zero,
                            "use another tag");
            if (!named && on_line && demanded)
                throw fault(source, edge.row,
                            "the edge lies on the axis r = 0 but is tagged " + core::quoted(edge.faces.front()),
                            "tag it axis");
        }
}

void check_not_below(const meshing::Outline& outline, std::string_view source, std::size_t component,
                     const char* what) {
    const double rounding_m = meshing::outline_tolerance * extent_m(outline);
    for (const meshing::OutlinePiece& piece : pieces_of(outline))
        if (piece.start[component] < -rounding_m) {
            const meshing::OutlineEdge& edge = outline.loops[piece.loop][piece.edge];
            throw fault(source, edge.row,
                        std::string{component == 0 ? "x" : "r"} + " reaches " +
                            core::rounded_text(1e3 * piece.start[component], 6) + " mm",
                        what);
        }
}

bool has_tag(const meshing::Outline& outline, std::string_view tag) {
    const auto tags = tags_of(outline);
    return std::ranges::find(tags, tag) != tags.end();
}

/// Checks the reserved face names.
void check_reserved(const meshing::Outline& outline, std::string_view source, Across across) {
    check_named_line(outline, source, 0, meshing::symmetry_x_face, false);
    if (has_tag(outline, meshing::symmetry_x_face))
        check_not_below(outline, source, 0, "draw the half x >= 0; the tag symmetry_x mirrors the body at x = 0");
    if (across == Across::r) {
        check_named_line(outline, source, 1, meshing::axis_face, true);
        check_not_below(outline, source, 1, "draw the half section at r >= 0; the axis of revolution is x");
    } else {
        check_named_line(outline, source, 1, meshing::symmetry_y_face, false);
        if (has_tag(outline, meshing::symmetry_y_face))
            check_not_below(outline, source, 1, "draw the half y >= 0; the tag symmetry_y mirrors the body at y = 0");
    }
    const std::string foreign = across == Across::r ? meshing::symmetry_y_face : meshing::axis_face;
    for (const meshing::Loop& loop : outline.loops)
        for (const meshing::OutlineEdge& edge : loop)
            for (const std::string& taken :
                 {foreign, std::string{meshing::symmetry_z_face}, std::string{"middle_y"}, std::string{"middle_z"}})
                if (edge.faces.front() == taken)
                    throw fault(source, edge.row, core::quoted(taken) + " is a reserved face name", "use another tag");
}

/// Moves points within rounding of the axis or a symmetry plane onto it.
void snap(meshing::Outline& outline) {
    const double rounding_m = meshing::outline_tolerance * extent_m(outline);
    for (meshing::Loop& loop : outline.loops)
        for (meshing::OutlineEdge& edge : loop)
            for (meshing::PlanePoint& p : edge.points)
                for (double& coordinate : p)
                    if (std::abs(coordinate) <= rounding_m) coordinate = 0;
}

/// Adds the name of the cavity to the edges of the listed tags.
void add_cavity(meshing::Outline& outline, const design::Values& values, const std::string& name) {
    const std::string key = "geometry.cavities." + name;
    const auto tags = tags_of(outline);
    for (const std::string& tag : listed(values.text(key))) {
        if (std::ranges::find(tags, tag) == tags.end())
            throw values.refuse(key, "no edge is tagged " + core::quoted(tag), core::did_you_mean(tag, tags));
        for (meshing::Loop& loop : outline.loops)
            for (meshing::OutlineEdge& edge : loop)
                if (edge.faces.front() == tag && tag != name) edge.faces.push_back(name);
    }
}

/// Pressure on an edge of two cavities would act twice.
void refuse_common_walls(const meshing::Outline& outline, const design::Values& values,
                         const std::vector<std::string>& cavities) {
    for (const meshing::Loop& loop : outline.loops)
        for (const meshing::OutlineEdge& edge : loop) {
            std::vector<std::string> owners;
            std::ranges::copy_if(cavities, std::back_inserter(owners), [&](const std::string& name) {
                return std::ranges::find(edge.faces, name) != edge.faces.end();
            });
            if (owners.size() < 2) continue;
            const std::string key =
                "geometry.cavities." + (values.has("geometry.cavities." + owners[1]) ? owners[1] : owners[0]);
            const std::string& other = key.ends_with("." + owners[1]) ? owners[0] : owners[1];
            throw values.refuse(key, "its wall shares edges with that of " + core::quoted(other),
                                "assign each edge to one cavity");
        }
}

std::vector<std::string> fixed_faces(const design::Values& values) {
    constexpr const char* key = "supports.fixed";
    return values.has(key) ? listed(values.text(key)) : std::vector<std::string>{};
}

}  // namespace

meshing::Outline outline_from(std::string_view text, std::string_view source, Across across) {
    meshing::Outline outline = loops_of(Reader{text, source, across}.rows(), source);
    snap(outline);
    if (const auto wrong = fault_of(outline)) throw fault(source, wrong->row, wrong->problem, wrong->remedy);
    check_reserved(outline, source, across);
    return outline;
}

meshing::Outline outline_of_file(const std::string& file, std::string_view location, Across across,
                                 std::string_view key) {
    try {
        if (file.find('\n') != std::string::npos) return outline_from(file, "table", across);
        const std::string path = design::file_from(location, file);
        constexpr std::size_t max_bytes = std::size_t{1} << 20;  // about ten thousand points
        const auto bytes = core::read_regular_file(path, max_bytes);
        return outline_from({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path, across);
    } catch (const Error& error) {  // add the location in the design that names the file
        throw Error(error.code(), std::string{location}.append(": ").append(key), error.what());
    }
}

std::vector<std::string> tags_of(const meshing::Outline& outline) {
    std::vector<std::string> tags;
    for (const meshing::Loop& loop : outline.loops)
        for (const meshing::OutlineEdge& edge : loop)
            if (std::ranges::find(tags, edge.faces.front()) == tags.end()) tags.push_back(edge.faces.front());
    return tags;
}

Body body_of_profile(const design::Values& values, Across across) {
    Body body;
    meshing::Outline& outline = body.outline;
    outline = outline_of_file(values.text(profile_key), values.location(profile_key), across);
    body.notes = outline.notes;
    std::vector<std::string> names = values.names_below("geometry.cavities");
    for (const std::string& name : names) add_cavity(outline, values, name);
    if (std::ranges::find(names, cavity_face) == names.end() && has_tag(outline, cavity_face))
        names.emplace_back(cavity_face);
    refuse_common_walls(outline, values, names);
    for (const std::string& name : names) body.cavities.push_back({name, name, {}, {}});
    constexpr int own_through = 3;
    const int stated = values.count("mesh.through_wall");
    outline.size_m = cell_sizes(
        outline, {profile_cells(outline, values).length_m(), stated > 0 ? stated : scaled_count(values, own_through),
                  values.number("mesh.grading"), fixed_faces(values)});
    body.symmetry_planes = {has_tag(outline, meshing::symmetry_x_face), has_tag(outline, meshing::symmetry_y_face),
                            false};
    for (const bool cut : body.symmetry_planes) body.fraction *= cut ? 0.5 : 1.0;
    return body;
}

design::Key file_key(Across across) {
    const bool turned = across == Across::r;
    return {.path = profile_key,
            .kind = design::Kind::text,
            .meaning = std::string{turned ? "the half section" : "the section"} +
                       " as a table: a file relative to the design file, or (profile: |) its lines; columns " +
                       (turned ? "x_mm, r_mm" : "x_mm, y_mm") +
                       ", tag (of the edge that starts at the row), optional curve (line, arc, spline), " +
                       (turned ? "via_x_mm, via_r_mm" : "via_x_mm, via_y_mm") +
                       " (of an arc), loop; the solid lies on the left",
            .max_count = several_lines};
}

CellSize profile_cells(const meshing::Outline& outline, const design::Values& values) {
    const meshing::PlanePoint sides_m = extents_m(outline);
    constexpr double along = 8.5;  // cells at walls and corners are shorter
    return {values, std::sqrt(sides_m[0] * sides_m[1]) / along};
}

std::vector<design::Key> profile_mesh_keys() {
    design::Key min_cells = through_wall_key();
    min_cells.meaning = "minimum number of cells through the thinnest part of a wall; auto: 3 (draft 2, fine 5)";
    min_cells.min = 1;
    min_cells.max = 100;
    return {size_key(), std::move(min_cells), grading_key("4")};
}

}  // namespace soft::geometry
