#include "meshing/part_file.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <map>
#include <span>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/subprocess.hpp"
#include "core/text.hpp"
#include "meshing/gmsh_session.hpp"

namespace soft::meshing {
namespace {

constexpr std::size_t max_facets = 2000000;  // some gigabytes and minutes

core::Bytes bytes_of(const std::vector<double>& numbers) {
    const auto bytes = std::as_bytes(std::span{numbers});
    return {bytes.begin(), bytes.end()};
}

std::vector<double> numbers_of(const core::Bytes& bytes) {
    std::vector<double> numbers(bytes.size() / sizeof(double));
    std::ranges::copy(bytes, std::as_writable_bytes(std::span{numbers}).begin());
    return numbers;
}

/// Triangulates the CAD file; returns the number of solids, then the corner coordinates of each triangle if there is one solid.
std::vector<double> cad_numbers(const std::string& file) {
    const auto gmsh = open_gmsh();
    const int solids = gmsh->import_cad(file);
    std::vector<double> result{static_cast<double>(solids)};
    if (solids != 1) return result;
    gmsh->triangulate(GmshSession::Chords{.per_turn = 64, .longest = 1.0 / 20, .shortest = 1.0 / 500});
    const std::vector<double> corners = gmsh->triangle_corners();
    result.insert(result.end(), corners.begin(), corners.end());
    return result;
}

/// Merges the corners of triangles given by nine coordinates each.
FacetSoup joined(std::span<const double> corners) {
    constexpr double same = 1e-8;  // mm: smaller differences are rounding
    FacetSoup soup;
    std::map<std::array<long long, 3>, std::size_t> numbers;
    for (std::size_t n = 0; n + 2 < corners.size(); n += 3) {
        const mesh::Point p{corners[n], corners[n + 1], corners[n + 2]};
        const auto [entry, fresh] = numbers.try_emplace(
            {std::llround(p[0] / same), std::llround(p[1] / same), std::llround(p[2] / same)}, soup.points.size());
        if (fresh) soup.points.push_back(p);
        if (n % 9 == 0) soup.facets.emplace_back();
        soup.facets.back().push_back(entry->second);
    }
    return soup;
}

FacetSoup triangles_of_cad(const std::filesystem::path& path) {
    constexpr core::SubprocessLimits limits{.wall = std::chrono::minutes{5}};  // parts take seconds
    static_cast<void>(core::read_regular_file(path, max_file));  // throws with the reason if it cannot be opened
    const core::SubprocessOutcome end =
        core::run_in_subprocess([&] { return bytes_of(cad_numbers(path.string())); }, limits);
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
        throw Error(ExitCode::bad_input, path.string(), problem, remedy);
    };
    if (!end.result || end.result->empty())
        refuse("it cannot be read as STEP (gmsh failed or took more than 5 minutes)",
               "export the part again as STEP, or as STL");
    const std::vector<double> numbers = numbers_of(*end.result);
    const double solids = numbers.front();
    if (solids == 0) refuse("it contains no solid", "export a solid, not its faces");
    if (solids != 1)
        refuse(core::rounded_text(solids, 6) + " solids in one file", "unite them, or use one file for each");
    FacetSoup soup = joined(std::span{numbers}.subspan(1));
    if (soup.facets.empty()) refuse("gmsh could not triangulate its faces", "export the part again as STEP, or as STL");
    return soup;
}

}  // namespace

bool is_cad_file(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".step" || ending == ".stp";
}

bool is_part_file(const std::filesystem::path& path) { return is_cad_file(path) || is_surface_file(path); }

Part read_part(const std::filesystem::path& path, const std::string& unit, double unit_m) {
    const bool cad = is_cad_file(path);
    const SoupOrigin origin = cad ? SoupOrigin{path.string()} : SoupOrigin{path.string(), unit, unit_m};
    FacetSoup soup = cad ? triangles_of_cad(path) : read_soup(path);
    if (soup.facets.size() > max_facets)
        throw Error(ExitCode::bad_input, origin.name,
                    std::to_string(soup.facets.size()) + " facets are more than " + std::to_string(max_facets),
                    "export the part with a coarser tolerance");
    return {origin, body_surface(std::move(soup), origin)};
}

Part read_obj(const std::string& lines, const std::string& unit, double unit_m) {
    const SoupOrigin origin{"OBJ in the design", unit, unit_m};
    return {origin, body_surface(read_soup(lines, origin.name + ".obj"), origin)};
}

}  // namespace soft::meshing
