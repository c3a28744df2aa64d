// Profiles given as tables (family revolved) compared with results of the independent code for the same geometry, and thin round plates
// compared with membrane theory.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "membrane_formula.hpp"
#include "run_design.hpp"

namespace soft::verification {
namespace {

// The clamped rim and the inner corners are singular: the cells of the table are graded toward them.
TEST(Drawn, TubeFromATableHasTheCurveOfTheTubeFamily) {
    const auto run = run_design("verification/tube-table.yaml", {"path.until.elongation=6 mm"});
    for (const auto& [pressure_kPa, elongation_mm] :
         std::map<double, double>{{10, 0.2817}, {20, 0.9168}, {30, 2.2875}, {40, 5.8978}})
        EXPECT_NEAR(1e3 * run.at("pressure", 1e3 * pressure_kPa).outputs.at(0) / elongation_mm, 1, 1e-3)
            << pressure_kPa;
}

// The same meridian from the keys of the family and from an independent table of tangents. Elongation at 10 kPa with cells of 1.5 and
// 0.75 mm: 16.9710 and 16.9910 mm from the keys, 16.9943 and 16.9971 mm from the table, graded toward corners.
TEST(Drawn, TaperedBellowsHaveTheCurveOfTheirMeridianTable) {
    const auto keys = run_design("verification/bellows-tapered.yaml", {}),
               table = run_design("verification/bellows-tapered-table.yaml", {});
    for (const double pressure_kPa : {2.0, 5.0, 10.0})
        EXPECT_NEAR(keys.at("pressure", 1e3 * pressure_kPa).outputs.at(0) /
                        -table.at("pressure", 1e3 * pressure_kPa).outputs.at(0),
                    1, 1e-3)
            << pressure_kPa;
}

// The plate bends in a boundary layer at the rim with a width of the order of the thickness. Its contribution to the pressure is of first
// order in the thickness, so two thicknesses allow an extrapolation, up to the bending term of order (thickness / deflection)^2.
TEST(Membrane, PressureOfAThinRoundPlateConvergesToMembraneTheoryWithFirstOrder) {
    for (const auto& [deflection_mm, left] : std::map<int, double>{{8, 4e-3}, {15, 2e-3}}) {
        const auto over_membrane = [mm = deflection_mm](double thickness_mm) {
            const auto run =
                run_design("verification/membrane.yaml", {"geometry.thickness=" + std::to_string(thickness_mm) + " mm",
                                                          "path.until.deflection=" + std::to_string(mm) + " mm"});
            return 1e3 * run.pressure_kPa() /
                       membrane_deflected({50e-3, 1e-3 * thickness_mm, 164.4e3}, 1e-3 * mm).pressure_Pa -
                   1;
        };
        const double one = over_membrane(0.5), half = over_membrane(0.25);
        EXPECT_GT(half, 0) << deflection_mm;  // bending increases the pressure
        EXPECT_LT(half, 0.03) << deflection_mm;
        EXPECT_NEAR(2 * half - one, 0, left) << deflection_mm;
    }
}

}  // namespace
}  // namespace soft::verification
