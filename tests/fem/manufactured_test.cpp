/// Observed orders of convergence against k + 1 for the displacement and k for its gradient in L2, and 2 for the pressure
/// of the mixed pairs (P2/P1, Q2/P-1), Brenner and Scott, The Mathematical Theory of Finite Element Methods (2008), 12.
#include "manufactured.hpp"

#include <gtest/gtest.h>

namespace soft::manufactured {
namespace {

using mesh::CellType;
using model::Formulation;
using model::Kinematics;

struct Study {
    CellType type;
    Kinematics kinematics;
    Formulation formulation;
    int coarse, fine;  ///< cells along an edge
    double shake = 0;
};

struct Result {
    Errors error;
    double cell_size;
};

Result run(const Study& s, int n) {
    auto input = block_case(s.type, s.kinematics, s.formulation, {n, s.shake});
    input.supports = {{"boundary", {true, true, true}}};
    // Displacements alone: compressible enough not to lock. Mixed and F-bar: close to incompressible.
    const bool displacement = s.formulation == Formulation::displacement;
    const Flow flow = displacement ? Flow::general : Flow::isochoric;
    input.materials[0].bulk_modulus_Pa = (displacement ? 5.0 : 1000.0) * sample_mu_Pa;
    const auto rubber = fem::make_rubber(input.materials[0], input.formulation);
    fem::System system(input, PETSC_COMM_WORLD);
    const auto x = solve(system, rubber, flow);
    return {errors(system, rubber, flow, x), 1.0 / n};
}

std::string label(const Study& s) {
    static constexpr std::array<const char*, 3> kinematics{"_axisymmetric", "_plane", "_solid"};
    static constexpr std::array<const char*, 3> formulation{"_displacement", "_mixed", "_f_bar"};
    return std::string(mesh::topology(s.type).name) + kinematics[static_cast<std::size_t>(s.kinematics)] +
           formulation[static_cast<std::size_t>(s.formulation)] + (s.shake > 0 ? "_distorted" : "");
}

class Manufactured : public ::testing::TestWithParam<Study> {};

TEST_P(Manufactured, ErrorsDecreaseWithTheTheoreticalOrder) {
    const Study s = GetParam();
    const Result coarse = run(s, s.coarse), fine = run(s, s.fine);
    const double ratio = std::log(coarse.cell_size / fine.cell_size);
    const double displacement = std::log(coarse.error.displacement / fine.error.displacement) / ratio;
    const double gradient = std::log(coarse.error.gradient / fine.error.gradient) / ratio;
    const int k = mesh::topology(s.type).order;
    RecordProperty("displacement_order", std::to_string(displacement));
    RecordProperty("gradient_order", std::to_string(gradient));
    EXPECT_NEAR(displacement, k + 1.0, 0.15);
    EXPECT_NEAR(gradient, k, 0.15);
    if (s.formulation != Formulation::mixed) return;
    const double pressure = std::log(coarse.error.pressure / fine.error.pressure) / ratio;
    RecordProperty("pressure_order", std::to_string(pressure));
    EXPECT_NEAR(pressure, 2.0, 0.15);
}

std::vector<Study> studies() {
    std::vector<Study> list;
    for (const auto kinematics : {Kinematics::plane_strain, Kinematics::axisymmetric})
        for (const double shake : {0.0, 0.15}) {
            for (const auto type : {CellType::triangle3, CellType::quad4})
                list.push_back({type, kinematics, Formulation::displacement, 24, 48, shake});
            list.push_back({CellType::quad4, kinematics, Formulation::f_bar, 24, 48, shake});
            for (const auto type : {CellType::triangle6, CellType::quad9})
                for (const auto formulation : {Formulation::displacement, Formulation::mixed})
                    list.push_back({type, kinematics, formulation, 20, 40, shake});
        }
    for (const auto type : {CellType::tet4, CellType::hex8, CellType::wedge6})
        list.push_back({type, Kinematics::solid, Formulation::displacement, 12, 18});
    list.push_back({CellType::hex8, Kinematics::solid, Formulation::f_bar, 12, 16});
    for (const auto formulation : {Formulation::displacement, Formulation::mixed}) {
        list.push_back({CellType::hex27, Kinematics::solid, formulation, 5, 7, 0.15});
        list.push_back({CellType::tet10, Kinematics::solid, formulation, 6, 9, 0.15});
        list.push_back({CellType::wedge18, Kinematics::solid, formulation, 6, 9, 0.15});
    }
    return list;
}

INSTANTIATE_TEST_SUITE_P(Cells, Manufactured, ::testing::ValuesIn(studies()),
                         [](const auto& test) { return label(test.param); });

}  // namespace
}  // namespace soft::manufactured
