/// Settings that change the assembled system or only its assembly: threads, scaling, the loaded shape, small strain.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "fem/system.hpp"
#include "sample_cases.hpp"
#include "sample_states.hpp"

namespace soft::fem {
namespace {

/// Largest difference of two matrices' entries, over the largest entry.
double difference(Mat a, Mat b) {
    double largest = 0, apart = 0;
    SOFT_PETSC(MatNorm(a, NORM_INFINITY, &largest));
    linalg::Matrix copy;
    SOFT_PETSC(MatDuplicate(a, MAT_COPY_VALUES, copy.out()));
    SOFT_PETSC(MatAXPY(copy, -1.0, b, SAME_NONZERO_PATTERN));
    SOFT_PETSC(MatNorm(copy, NORM_INFINITY, &apart));
    return apart / largest;
}

struct Assembled {
    linalg::Vector R;
    linalg::Matrix K;
    double force_scale;
};

Assembled assemble(const model::Case& input, double pressure_Pa) {
    System system(input, PETSC_COMM_WORLD);
    Assembled result{system.make_vector(), system.make_matrix(), 0.0};
    LoadLevels levels = no_loads(input);
    levels.pressures_Pa.assign(input.loads.size(), pressure_Pa);
    result.force_scale = system.evaluate(wavy(system, 2e-5, 0.3), levels, result.R, result.K).force_scale;
    return result;
}

TEST(Threads, DoNotChangeAnyBitOfResidualAndTangent) {
    auto input = box_case(3, true);
    const auto one = assemble(input, -1e4);
    for (const int threads : {2, 3}) {
        input.solver.threads = threads;
        const auto many = assemble(input, -1e4);
        auto apart = linalg::duplicate(one.R);
        linalg::copy(one.R, apart);
        linalg::add(apart, -1.0, many.R);
        EXPECT_EQ(linalg::norm(apart), 0.0);
        EXPECT_EQ(difference(one.K, many.K), 0.0);
        EXPECT_EQ(one.force_scale, many.force_scale);
    }
}

TEST(Threads, FindTheSameWorstCell) {
    auto input = box_case(3, true);
    mesh::Index worst[2];
    for (const int threads : {1, 3}) {
        input.solver.threads = threads;
        System system(input, PETSC_COMM_WORLD);
        auto R = system.make_vector();
        worst[threads / 3] = system.evaluate(wavy(system, 1e-4, 0.3), no_loads(input), R, nullptr).worst_cell;
    }
    EXPECT_EQ(worst[0], worst[1]);
}

TEST(Scaling, OffGivesPressuresInPascal) {
    auto input = box_case(1, true);
    System scaled(input, PETSC_COMM_WORLD);
    EXPECT_NEAR(scaled.dofs().pressure_scale_Pa, sample_mu_Pa / 0.01, 1e-6 * sample_mu_Pa / 0.01);
    input.solver.scaling = false;
    System plain(input, PETSC_COMM_WORLD);
    EXPECT_EQ(plain.dofs().pressure_scale_Pa, 1.0);
}

TEST(UndeformedShape, ForceActsOnTheUndeformedAreaInEveryState) {
    auto input = box_case(2, false);
    input.formulation = model::Formulation::displacement;
    input.loads[0].shape = model::LoadShape::undeformed;
    System system(input, PETSC_COMM_WORLD);
    auto without = system.make_vector(), with = system.make_vector();
    const auto x = wavy(system, 2e-5, 0.3);
    LoadLevels levels = no_loads(input);
    system.evaluate(x, levels, without, nullptr);
    levels.pressures_Pa = {-sample_mu_Pa};
    system.evaluate(x, levels, with, nullptr);
    linalg::add(with, -1.0, without);  // -(force of the load)
    // Only along x; the total is the pressure times the undeformed area.
    const auto mean = system.outputs().value(0, with, nullptr);  // weights of the face's mean
    EXPECT_LT(mean, 0.0);
    double total = 0;
    SOFT_PETSC(VecSum(with, &total));
    EXPECT_NEAR(total, -sample_mu_Pa * 0.01 * 0.01, 1e-12 * sample_mu_Pa);
}

TEST(UndeformedShape, AddsNothingToTheTangent) {
    auto input = box_case(2, false);
    input.formulation = model::Formulation::displacement;
    input.loads[0].shape = model::LoadShape::undeformed;
    const auto loaded = assemble(input, -sample_mu_Pa), free = assemble(input, 0.0);
    EXPECT_EQ(difference(loaded.K, free.K), 0.0);
    input.loads[0].shape = model::LoadShape::deformed;
    const auto follower = assemble(input, -sample_mu_Pa);
    EXPECT_GT(difference(follower.K, free.K), 1e-4);
}

TEST(SmallStrain, GivesEveryLawTheResidualOfHooke) {
    auto input = box_case(2, false);
    input.formulation = model::Formulation::displacement;
    input.materials[0].constants["mu"] = {sample_mu_Pa};
    input.materials[0].strain = model::Strain::small;
    const auto small = assemble(input, 0.0);
    input.materials[0].law = "linear-elastic";
    input.materials[0].strain = model::Strain::finite;
    const auto hooke = assemble(input, 0.0);
    EXPECT_LT(difference(small.K, hooke.K), 1e-14);
    auto apart = linalg::duplicate(small.R);
    linalg::copy(small.R, apart);
    linalg::add(apart, -1.0, hooke.R);
    EXPECT_LT(linalg::norm(apart), 1e-14 * linalg::norm(small.R));
}

TEST(SmallStrain, IsTheTangentOfTheFiniteLawWithoutDeformation) {
    auto input = box_case(2, false);
    input.formulation = model::Formulation::displacement;
    const auto tangent = [&](model::Strain strain) {
        input.materials[0].strain = strain;
        System system(input, PETSC_COMM_WORLD);
        auto R = system.make_vector();
        auto K = system.make_matrix();
        system.evaluate(system.make_vector(), no_loads(input), R, K);
        return K;
    };
    EXPECT_LT(difference(tangent(model::Strain::finite), tangent(model::Strain::small)), 1e-12);
    input.materials[0].bulk_modulus_Pa = 1.5 * sample_mu_Pa;  // differs from that of its volumetric term alone
    input.materials[0].law = "neo-hookean-compressible";
    EXPECT_LT(difference(tangent(model::Strain::finite), tangent(model::Strain::small)), 1e-12);
}

TEST(SmallStrain, RejectsALawWithoutLinearCounterpart) {
    auto input = box_case(1, false);
    input.formulation = model::Formulation::displacement;
    input.materials[0].law = "kraken";
    input.materials[0].strain = model::Strain::small;
    EXPECT_THROW(System(input, PETSC_COMM_WORLD), Error);
}

}  // namespace
}  // namespace soft::fem
