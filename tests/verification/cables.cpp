// Fibres as an anisotropic layer against the same fibres as cables: helical strands of a stiff isotropic rubber, embedded in the
// layer's place in a mesh whose cells follow the helix. Nothing of the fibres' energy takes part in the second model.
#include <cmath>
#include <numbers>
#include <string>

#include "core/text.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Fibre-reinforced tubes";
constexpr double degree = std::numbers::pi / 180;
constexpr double inner_m = 2.5e-3, outer_m = 10e-3, layer_begin = 0.45, layer_end = 0.55;
constexpr double middle_m = inner_m + 0.5 * (layer_begin + layer_end) * (outer_m - inner_m);
constexpr double k1_Pa = 2e6, mu_Pa = 164.4e3;

struct Cables {
    double angle_deg;
    int sectors;  ///< of a quarter turn
    int every;    ///< sector of which one is a cable
};

model::Case layer_case(const Cables& cables) {
    return read_case(
        "verification/fiber-tube-long.yaml",
        {"geometry.length=60 mm", "geometry.fibers.angle=" + core::number_text(cables.angle_deg) + " deg",
         "geometry.fibers.families=1", "geometry.fibers.k1=" + core::number_text(k1_Pa) + " Pa",
         "geometry.fibers.k2=0.01", "geometry.inner_radius=2.5 mm", "geometry.fibers.layer=[0.45, 0.55]", "model=solid",
         "mesh.size=6 mm", "mesh.through_wall=3", "mesh.sectors=" + std::to_string(cables.sectors),
         "loads.cavity.pressure=20 kPa", "path.control=pressure",
         "outputs={twist: {face: inlet, measure: twist, along: axis}, elongation: {face: inlet, along: axis}}"});
}

/// The sector around the axis in which a cell of the unturned mesh lies.
int sector_of(const mesh::Mesh& mesh, mesh::Index cell, int sectors) {
    double y = 0, z = 0;
    for (const mesh::Index node : mesh.cell_nodes(cell)) {
        y += mesh.point(node)[1];
        z += mesh.point(node)[2];
    }
    const double turn = std::atan2(z, y) / (2 * std::numbers::pi);
    return static_cast<int>(std::floor((turn < 0 ? turn + 1 : turn) * sectors));
}

/// Strand and layer of the same stiffness along the fibre: a small strain e of fibres stores 2 k1 e^2, of a strand 3/2 mu e^2 beyond
/// the rubber whose place it takes, in the share 1 / every of the layer.
model::Case cable_case(const Cables& cables) {
    model::Case result = layer_case(cables);
    mesh::Mesh& mesh = result.mesh;
    std::int32_t layer = 0;
    while (mesh.region_names.at(static_cast<std::size_t>(layer)) != "fibers") ++layer;
    const auto strand = static_cast<std::int32_t>(mesh.region_names.size());
    mesh.region_names.emplace_back("cable");
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
        std::int32_t& region = mesh.cell_regions[static_cast<std::size_t>(cell)];
        if (region == layer && sector_of(mesh, cell, 4 * cables.sectors) % cables.every == 0) region = strand;
    }
    for (mesh::Point& p : mesh.points) {  // a turn about the axis that grows along it keeps circles, volumes and faces
        const double turn = p[0] * std::tan(cables.angle_deg * degree) / middle_m, c = std::cos(turn),
                     s = std::sin(turn);
        p = {p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]};
    }
    model::Material cable;
    for (model::Material& material : result.materials)
        if (material.name == "fibers") {
            material.fibers.reset();
            cable = material;
        }
    cable.name = "cable";
    cable.constants["mu"] = {mu_Pa + 4.0 / 3.0 * k1_Pa * cables.every};
    result.materials.push_back(cable);
    return result;
}

Problem problem(const Cables& cables) {
    const int count = 4 * cables.sectors / cables.every;
    const std::string name = std::to_string(count) + " cables at " + core::number_text(cables.angle_deg) + " degrees";
    return {
        group, name, [cables, name] {
            const Run layer = run_case(layer_case(cables), name), strands = run_case(cable_case(cables), name);
            const auto row = [&](const std::string& quantity, std::size_t output, double unit) {
                return Row{.quantity = quantity,
                           .reference = strands.steps.back().outputs.at(output) / unit,
                           .source = "strands of isotropic rubber along the helix",
                           .ours = layer.steps.back().outputs.at(output) / unit,
                           .mesh = layer.mesh,
                           .seconds = layer.seconds + strands.seconds,
                           .tolerance = 5e-2,
                           .reason = "x"};
            };
            return Outcome{{row("twist at 20 kPa [deg]", 0, degree), row("elongation at 20 kPa [mm]", 1, 1e-3)}, {}};
        }};
}

}  // namespace

std::vector<Problem> cable_problems() { return {problem({40, 6, 3})}; }

}  // namespace soft::verification
