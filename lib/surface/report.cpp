#include "surface/report.hpp"

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "model/location.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/triangles.hpp"
#include "surface/volume.hpp"
#include "surface/wall.hpp"

namespace soft::surface {
namespace {

/// Centre of the intersection of the bounding boxes of two triangles, in model coordinates.
mesh::Point intersection_location(const Triangles& surface, const std::array<int, 2>& pair) {
    mesh::Point location{};
    for (std::size_t d = 0; d < 3; ++d) {
        double from = -std::numeric_limits<double>::infinity(), to = -from;
        for (const int triangle : pair) {
            const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
            const auto at = [&](int corner) { return surface.model_points[static_cast<std::size_t>(corner)][d]; };
            from = std::max(from, std::min({at(a), at(b), at(c)}));
            to = std::min(to, std::max({at(a), at(b), at(c)}));
        }
        location[d] = (from + to) / 2;
    }
    return location;
}

CavityReport inspect(const model::Case& model, const model::Cavity& cavity) {
    const Triangles surface = cavity_surface(model, cavity);
    const SurfaceChecks checks = check_surface(surface);
    CavityReport report;
    report.name = cavity.name;
    report.triangles = surface.triangles.size();
    report.closed = checks.closed;
    report.oriented = checks.outward;
    report.open_location = checks.open_location;
    if (checks.intersecting) report.self_intersection = intersection_location(surface, *checks.intersecting);
    report.faceted_volume_m3 = checks.volume_m3;
    report.volume_m3 = enclosed_volume_m3(model, cavity_facets(model, cavity), model.mesh.points);
    if (const auto wall = min_wall(model, cavity)) {
        report.min_wall_m = wall->thickness_m;
        report.min_wall_location = wall->location;
    }
    return report;
}

void refuse_defective(const model::Case& model, const CavityReport& report) {
    const auto refuse = [&](const std::string& problem, const char* remedy) {
        throw Error(ExitCode::bad_input, report.name, problem, remedy);
    };
    if (report.self_intersection)
        refuse("the cavity surface intersects itself near " +
                   model::location_text(model.kinematics, *report.self_intersection),
               "parts of the geometry overlap: check its lengths and radii");
    if (!report.closed)
        refuse("the cavity surface is open near " +
                   model::location_text(model.kinematics, report.open_location.value_or(mesh::Point{})),
               "its faces must enclose the cavity up to its declared openings");
    if (!report.oriented || !(report.volume_m3 > 0))
        refuse("the cavity surface has the wrong orientation (it encloses rubber)", "name the inner faces of the part");
}

}  // namespace

std::vector<CavityReport> inspect_cavities(const model::Case& model) {
    std::vector<CavityReport> reports;
    if (model.kinematics == model::Kinematics::plane_strain) return reports;
    for (const model::Cavity& cavity : model.cavities) reports.push_back(inspect(model, cavity));
    return reports;
}

std::vector<CavityReport> check_cavities(const model::Case& model) {
    std::vector<CavityReport> reports = inspect_cavities(model);
    for (const CavityReport& report : reports) refuse_defective(model, report);
    return reports;
}

}  // namespace soft::surface
