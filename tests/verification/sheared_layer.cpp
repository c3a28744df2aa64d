// Simple shear of a long layer between two plates. The plates fix both faces, so the exact state is homogeneous except near the free
// ends, whose influence decays as exp(-pi x / height). Two layers that differ only in length have the same end effects: the difference
// of their energies is that of simple shear, W(I1 = I2 = 3 + g^2), in the additional length.
// A pressure gradient along the layer does not decay. By symmetry (rotation by 180 degrees) it vanishes, but triangles break the
// symmetry and produce a gradient of the size of their error at the corners. It changes the displacement in the middle by 0.2 % and the
// energy, which is stationary in the displacements, by the square of that.
#include "core/text.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Homogeneous states";
constexpr double height_m = 5e-3, depth_m = 1;

std::string mm_text(double metres) { return core::number_text(1e3 * metres) + " mm"; }

struct Layer {
    const char* name;
    std::vector<std::string> sets;
    double (*energy_Pa)(const std::map<std::string, std::vector<double>>& constants, double shear);
};

Run sheared(const Layer& layer, double length_m, double shear) {
    auto sets = layer.sets;
    sets.push_back("geometry.length=" + mm_text(length_m));
    sets.push_back("loads.top.displacement=" + mm_text(shear * height_m));
    return run_design("verification/sheared-layer.yaml", sets, Energy::recorded);
}

Outcome solve_layer(const Layer& layer) {
    constexpr double short_m = 40e-3, long_m = 60e-3;
    Outcome outcome;
    for (const double shear : {0.5, 1.0}) {
        const auto small = sheared(layer, short_m, shear), large = sheared(layer, long_m, shear);
        const std::string at = " at g = " + core::number_text(shear);
        const auto row = [&](const std::string& quantity, double reference, double ours) {
            return Row{.quantity = quantity,
                       .reference = reference,
                       .source = "simple shear, closed form",
                       .ours = ours,
                       .mesh = large.mesh,
                       .seconds = small.seconds + large.seconds,
                       .tolerance = homogeneous_tolerance};
        };
        const double more_m3 = (long_m - short_m) * height_m * depth_m;
        outcome.rows.push_back(row("energy per volume" + at + " [kJ/m3]",
                                   1e-3 * layer.energy_Pa(large.model.materials.front().constants, shear),
                                   1e-3 * (large.energy_J.back() - small.energy_J.back()) / more_m3));
        if (large.model.mesh.cell_types.front() != mesh::CellType::quad9) continue;  // triangles, see the file comment
        const auto node = nearest_node(large, {0.5 * long_m, 0.25 * height_m, 0});
        outcome.rows.push_back(row("displacement in the middle, near a quarter of the height" + at + " [mm]",
                                   1e3 * large.model.mesh.points[node][1] * shear,
                                   1e3 * large.displacement_m[3 * node]));
    }
    return outcome;
}

}  // namespace

std::vector<Problem> sheared_layer_problems() {
    using Constants = std::map<std::string, std::vector<double>>;
    const std::string mooney = "material={law: mooney-rivlin, c10: 0.06 MPa, c01: 0.02 MPa, kappa: incompressible}";
    const std::string yeoh = "material={law: yeoh, c1: 84.6 kPa, c2: 2.71 kPa, kappa: incompressible}";
    std::vector<Problem> problems;
    for (const Layer& layer :
         {Layer{"sheared layer, neo-Hookean",
                {},
                [](const Constants&c, double g) { return 0.5 * c.at("mu").front() * g * g; }},
          Layer{"sheared layer, triangles, neo-Hookean",
                {"mesh.cells=simplices"},
                [](const Constants&c, double g) { return 0.5 * c.at("mu").front() * g * g; }},
          Layer{"sheared layer, Mooney-Rivlin",
                {mooney},
                [](const Constants&c, double g) { return (c.at("c10").front() + c.at("c01").front()) * g * g; }},
          Layer{"sheared layer, Yeoh", {yeoh}, [](const Constants&c, double g) {
                    return g * g * (c.at("c1").front() + c.at("c2").front() * g * g);
                }}})
        problems.push_back({group, layer.name, [layer] { return solve_layer(layer); }});
    return problems;
}

}  // namespace soft::verification
