#include "geometry/part.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <map>
#include <numbers>
#include <span>

#include "core/apart.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "geometry/body_mesher.hpp"
#include "geometry/gmsh_session.hpp"
#include "geometry/keys.hpp"
#include "geometry/section.hpp"

namespace soft::geometry {
namespace {

constexpr std::size_t most_facets = 2000000;  // some gigabytes and minutes
constexpr const char* rules_group = "geometry.faces";
constexpr const char* symmetry_key = "geometry.symmetry";
constexpr std::array<const char*, 3> symmetry_faces{symmetry_x_face, symmetry_y_face, symmetry_z_face};

core::Bytes bytes_of(const std::vector<double>& numbers) {
    const auto bytes = std::as_bytes(std::span{numbers});
    return {bytes.begin(), bytes.end()};
}

std::vector<double> numbers_of(const core::Bytes& bytes) {
    std::vector<double> numbers(bytes.size() / sizeof(double));
    std::ranges::copy(bytes, std::as_writable_bytes(std::span{numbers}).begin());
    return numbers;
}

/// What gmsh makes of the file, as numbers: of solids; of points, their coordinates; the points of each triangle.
std::vector<double> cad_numbers(const std::string& file) {
    GmshSession gmsh;
    const int solids = gmsh.import_cad(file);
    std::vector<double> result{static_cast<double>(solids)};
    if (solids != 1) return result;
    gmsh.triangulate(GmshSession::Chords{.per_turn = 64, .longest = 1.0 / 20, .shortest = 1.0 / 500});
    const auto [tags, xyz] = gmsh.nodes();
    std::map<std::size_t, std::size_t> numbers;
    for (std::size_t n = 0; n < tags.size(); ++n) numbers[tags[n]] = n;
    result.push_back(static_cast<double>(tags.size()));
    result.insert(result.end(), xyz.begin(), xyz.end());
    for (const std::size_t tag : gmsh.cells(2, -1)) result.push_back(static_cast<double>(numbers.at(tag)));
    return result;
}

surface::FacetSoup triangles_of_cad(const std::filesystem::path& path) {
    constexpr core::ApartLimits limits{.wall = std::chrono::minutes{5}};  // parts take seconds
    constexpr std::size_t head = 2;
    static_cast<void>(core::read_regular_file(path, surface::largest_file));  // says why it cannot be opened
    const core::ApartEnd end = core::done_apart([&] { return bytes_of(cad_numbers(path.string())); }, limits);
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
        throw Error(ExitCode::bad_input, path.string(), problem, remedy);
    };
    if (!end.result || end.result->empty())
        refuse("it cannot be read as STEP (gmsh fails, or takes more than 5 minutes)",
               "export the body again as STEP, or as STL");
    const std::vector<double> numbers = numbers_of(*end.result);
    const double solids = numbers.front();
    if (solids == 0) refuse("it holds no solid", "export a solid, not its faces");
    if (solids != 1)
        refuse(core::rounded_text(solids, 6) + " solids in one file", "unite them, or put each into a file of its own");
    const auto points = static_cast<std::size_t>(numbers.at(1));
    surface::FacetSoup soup;
    for (std::size_t n = head; n < head + 3 * points; n += 3)
        soup.points.push_back({numbers.at(n), numbers.at(n + 1), numbers.at(n + 2)});
    const auto corner = [&](std::size_t n) { return static_cast<std::size_t>(numbers[n]); };
    for (std::size_t n = head + 3 * points; n + 2 < numbers.size(); n += 3)
        soup.facets.push_back({corner(n), corner(n + 1), corner(n + 2)});
    if (soup.facets.empty()) refuse("gmsh finds no triangles on its faces", "export the body again as STEP, or as STL");
    return soup;
}

mesh::Point point_of(const design::Values& values, const std::string& path) {
    const std::vector<double>& numbers = values.numbers(path);
    if (numbers.size() != 3) throw values.refuse(path, "three values are needed", "[x, y, z]");
    return {numbers[0], numbers[1], numbers[2]};
}

surface::FaceRule rule_of(const design::Values& values, const std::string& name) {
    constexpr double usual_within_rad = 10 * std::numbers::pi / 180;
    const std::string own = std::string{rules_group} + "." + name + ".";
    surface::FaceRule rule{name, {}, {}, {}, {}};
    const std::array<const char*, 3> planes{"plane.x", "plane.y", "plane.z"};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!values.has(own + planes[c])) continue;
        if (rule.plane) throw values.refuse(own + planes[c], "a facet lies in one plane", "x, y or z alone");
        rule.plane = surface::FaceRule::Plane{c, values.number(own + planes[c])};
    }
    if (values.has(own + "box.from") != values.has(own + "box.to"))
        throw values.refuse(own + (values.has(own + "box.from") ? "box.from" : "box.to"), "a box has two corners",
                            "box: {from: [x, y, z], to: [x, y, z]}");
    if (values.has(own + "box.from"))
        rule.box = surface::FaceRule::Box{point_of(values, own + "box.from"), point_of(values, own + "box.to")};
    if (values.has(own + "within") && !values.has(own + "normal"))
        throw values.refuse(own + "within", "there is no normal", "normal: [x, y, z] beside it");
    if (values.has(own + "normal")) {
        rule.direction =
            surface::FaceRule::Direction{point_of(values, own + "normal"),
                                         values.has(own + "within") ? values.number(own + "within") : usual_within_rad};
        if (rule.direction->normal == mesh::Point{})
            throw values.refuse(own + "normal", "it has no direction", "e.g. [1, 0, 0]");
    }
    if (values.has(own + "up_to") && !values.has(own + "point"))
        throw values.refuse(own + "up_to", "there is no point", "point: [x, y, z] beside it");
    if (values.has(own + "point"))
        rule.flood = surface::FaceRule::Flood{point_of(values, own + "point"), values.has(own + "up_to")
                                                                                   ? listed(values.text(own + "up_to"))
                                                                                   : std::vector<std::string>{}};
    return rule;
}

/// A part that is cut lies on one side of the cut.
void refuse_crossing(const surface::BodySurface& surface, const std::array<bool, 3>& cut,
                     const design::Values& values) {
    constexpr double rounding = 1e-6;
    for (std::size_t c = 0; c < 3; ++c) {
        if (!cut[c]) continue;
        const auto [low, high] = std::ranges::minmax(surface.points, {}, [c](const mesh::Point& p) { return p[c]; });
        if (std::min(-low[c], high[c]) > rounding * surface.extent_m())
            throw values.refuse(symmetry_key,
                                std::string{"the part goes from "} + "xyz"[c] + " = " + length_text(low[c]) + " to " +
                                    length_text(high[c]) + " and is not cut at 0",
                                "cut it where it was drawn, or leave this plane out");
    }
}

/// The cuts are faces, and no flood goes across them.
std::vector<surface::FaceRule> with_cuts(std::vector<surface::FaceRule> rules, const std::array<bool, 3>& cut) {
    std::vector<surface::FaceRule> all;
    for (std::size_t c = 0; c < 3; ++c)
        if (cut[c]) all.push_back({symmetry_faces[c], surface::FaceRule::Plane{c, 0}, {}, {}, {}});
    for (surface::FaceRule& rule : rules)
        if (rule.flood && !rule.flood->up_to.empty())
            for (std::size_t c = 0; c < 3; ++c)
                if (cut[c]) rule.flood->up_to.push_back(symmetry_faces[c]);
    all.insert(all.end(), rules.begin(), rules.end());
    return all;
}

void put_on_planes(mesh::Mesh& mesh, const std::array<bool, 3>& cut) {
    for (std::size_t c = 0; c < 3; ++c) {
        const auto face = mesh.facet_sets.find(symmetry_faces[c]);
        if (!cut[c] || face == mesh.facet_sets.end()) continue;
        for (const mesh::Facet& facet : face->second)
            for (const mesh::Index node : facet_nodes(mesh, facet)) mesh.points[static_cast<std::size_t>(node)][c] = 0;
    }
}

/// The wanted length of cells where the design leaves it open: about 20 along the part.
double usual_size_m(const surface::BodySurface& surface) { return surface.extent_m() / 20; }

}  // namespace

bool is_cad_file(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".step" || ending == ".stp";
}

bool is_part_file(const std::filesystem::path& path) { return is_cad_file(path) || surface::is_surface_file(path); }

Part read_part(const std::filesystem::path& path, const std::string& unit, double unit_m) {
    const bool cad = is_cad_file(path);
    const surface::SoupOrigin origin =
        cad ? surface::SoupOrigin{path.string()} : surface::SoupOrigin{path.string(), unit, unit_m};
    surface::FacetSoup soup = cad ? triangles_of_cad(path) : surface::read_soup(path);
    if (soup.facets.size() > most_facets)
        throw Error(ExitCode::bad_input, origin.name,
                    std::to_string(soup.facets.size()) + " facets are more than " + std::to_string(most_facets),
                    "export the body with a coarser tolerance");
    return {origin, surface::body_surface(std::move(soup), origin)};
}

std::vector<surface::FaceRule> face_rules(const design::Values& values) {
    std::vector<surface::FaceRule> rules, floods;  // the latter name faces among the former
    for (const std::string& name : values.names_below(rules_group)) {
        surface::FaceRule rule = rule_of(values, name);
        (rule.flood && !rule.flood->up_to.empty() ? floods : rules).push_back(std::move(rule));
    }
    for (const surface::FaceRule& rule : floods)
        for (const std::string& border : rule.flood->up_to)
            if (std::ranges::find(rules, border, &surface::FaceRule::name) == rules.end())
                throw values.refuse(std::string{rules_group} + "." + rule.name + ".up_to",
                                    core::quoted(border) + " is no face of geometry.faces without up_to",
                                    "faces by plane, box, normal or point");
    rules.insert(rules.end(), floods.begin(), floods.end());
    return rules;
}

std::array<bool, 3> cuts(const design::Values& values) {
    const std::string& planes = values.text(symmetry_key);
    std::array<bool, 3> cut{};
    if (planes == "none") return cut;
    for (std::size_t c = 0; c < 3; ++c) cut[c] = planes.find("xyz"[c]) != std::string::npos;
    return cut;
}

MeshedPart mesh_part(const Part& part, const design::Values& values) {
    MeshedPart result;
    const std::array<bool, 3> cut = cuts(values);
    refuse_crossing(part.surface, cut, values);
    const std::vector<surface::Wall> walls = surface::walls(part.surface.points, part.surface.triangles);
    result.figures = {part.origin.name, part.surface.triangles.size(), part.surface.volume_m3(),
                      walls.empty() ? surface::WallFigures{} : surface::figures(walls), part.surface.repairs};
    for (std::size_t s = 1; s < part.surface.shells.size(); ++s) result.cavities.push_back(part.surface.shells[s].name);
    const std::vector<surface::NamedFace> faces = named_faces(part.surface, with_cuts(face_rules(values), cut));
    for (const surface::NamedFace& face : faces)
        if (std::ranges::find(face.facets, true) == face.facets.end()) {
            std::string first =
                face.name.starts_with("symmetry_") ? symmetry_key : "";  // key of the rule, for the place
            for (const char* key : {"plane.x", "plane.y", "plane.z", "box.from", "normal", "point"})
                if (const std::string path = std::string{rules_group} + "." + face.name + "." + key;
                    first.empty() && values.has(path))
                    first = path;
            throw values.refuse(first, "no facet of the surface is there",
                                "look at the coordinates in the program the part was drawn with");
        }
    const double given_m = values.number("mesh.size"), most_m = given_m > 0 ? given_m : usual_size_m(part.surface);
    const surface::WallSizes sizes(walls, bends(part.surface),
                                   {most_m / values.number("mesh.grading"), most_m, values.count("mesh.through_wall")});
    result.mesh = mesh_inside({part.surface, faces, part.origin}, sizes);
    put_on_planes(result.mesh, cut);
    return result;
}

}  // namespace soft::geometry
