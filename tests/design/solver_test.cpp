/// The keys of `solver`, and the strain and load configuration keys.
#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;
using namespace soft::model;

model::SolverSettings solver(const std::string& keys) { return read(base + "solver: {" + keys + "}\n").solver; }

TEST(Solver, HasTheDefaultsOfTheModel) {
    const SolverSettings set = read(base).solver, usual;
    EXPECT_EQ(set.newton, usual.newton);
    EXPECT_EQ(set.line_search, usual.line_search);
    EXPECT_EQ(set.tangent, usual.tangent);
    EXPECT_EQ(set.newton_limit, usual.newton_limit);
    EXPECT_EQ(set.linear.method, usual.linear.method);
    EXPECT_EQ(set.linear.preconditioner, usual.linear.preconditioner);
    EXPECT_EQ(set.linear.tolerance, usual.linear.tolerance);
    EXPECT_EQ(set.linear.iteration_limit, usual.linear.iteration_limit);
    EXPECT_EQ(set.scaling, usual.scaling);
    EXPECT_EQ(set.threads, usual.threads);
    EXPECT_EQ(set.steps, usual.steps);
    EXPECT_EQ(set.predictor, usual.predictor);
    EXPECT_EQ(set.wanted_iterations, usual.wanted_iterations);
    EXPECT_EQ(read(base).material.strain, Strain::finite);
    EXPECT_EQ(read(base).loads.at(0).shape, LoadShape::deformed);
    EXPECT_FALSE(read(base).dynamics.has_value());
}

TEST(Solver, ReadsEveryChoice) {
    EXPECT_EQ(solver("newton: full").newton, NewtonMethod::full);
    EXPECT_EQ(solver("newton: modified").newton, NewtonMethod::modified);
    EXPECT_EQ(solver("newton: bfgs").newton, NewtonMethod::bfgs);
    EXPECT_EQ(solver("line_search: secant").line_search, LineSearch::secant);
    EXPECT_EQ(solver("line_search: none").line_search, LineSearch::none);
    EXPECT_EQ(solver("tangent: finite-difference").tangent, TangentSource::finite_difference);
    EXPECT_EQ(solver("steps: iteration-adaptive").steps, StepRule::iteration_adaptive);
    EXPECT_EQ(solver("steps: constant").steps, StepRule::constant);
    EXPECT_EQ(solver("predictor: tangent").predictor, Predictor::tangent);
    EXPECT_EQ(solver("predictor: none").predictor, Predictor::none);
    EXPECT_EQ(solver("linear: mumps-ldlt").linear.method, LinearMethod::mumps_ldlt);
    EXPECT_EQ(solver("linear: mumps-lu").linear.method, LinearMethod::mumps_lu);
    EXPECT_EQ(solver("linear: superlu-dist").linear.method, LinearMethod::superlu_dist);
    EXPECT_EQ(solver("linear: cholmod").linear.method, LinearMethod::cholmod);
    EXPECT_EQ(solver("linear: jacobian-free").linear.method, LinearMethod::jacobian_free);
    const std::vector<std::pair<std::string, Preconditioner>> words{{"lu", Preconditioner::lu},
                                                                    {"asm-lu", Preconditioner::asm_lu},
                                                                    {"asm-ilu", Preconditioner::asm_ilu},
                                                                    {"asm-boomeramg", Preconditioner::asm_boomeramg},
                                                                    {"gamg", Preconditioner::gamg},
                                                                    {"boomeramg", Preconditioner::boomeramg},
                                                                    {"multigrid", Preconditioner::multigrid},
                                                                    {"jacobi", Preconditioner::jacobi},
                                                                    {"none", Preconditioner::none}};
    for (const auto& [word, meant] : words)
        EXPECT_EQ(solver("linear: krylov, preconditioner: " + word).linear.preconditioner, meant) << word;
}

TEST(Solver, ReadsNumbers) {
    const SolverSettings set = solver(
        "newton_limit: 1, scaling: false, threads: 4, wanted_iterations: 9, linear_tolerance: 1e-3, "
        "linear_limit: 500");
    EXPECT_EQ(set.newton_limit, 1);
    EXPECT_FALSE(set.scaling);
    EXPECT_EQ(set.threads, 4);
    EXPECT_EQ(set.wanted_iterations, 9);
    EXPECT_EQ(set.linear.tolerance, 1e-3);
    EXPECT_EQ(set.linear.iteration_limit, 500);
}

TEST(Solver, RejectsValuesOutOfRangeAndUnknownChoices) {
    const std::vector<std::pair<std::string, std::string>> bad{{"newton_limit: 0", "at least 1"},
                                                               {"threads: 257", "at most 256"},
                                                               {"threads: -1", "at least 0"},
                                                               {"linear_tolerance: 0.6", "at most 0.5"},
                                                               {"linear_limit: 200000", "at most"},
                                                               {"wanted_iterations: 101", "at most 100"},
                                                               {"linear: pardiso", "is not a valid value"},
                                                               {"newton: fast", "is not a valid value"},
                                                               {"scaling: maybe", "true or false"}};
    for (const auto& [keys, part] : bad)
        EXPECT_TRUE(contains(refusal(base + "solver: {" + keys + "}\n"), part)) << keys;
}

TEST(Solver, PreconditionerWithoutAKrylovMethodIsRejected) {
    const std::string line = refusal(base + "solver: {preconditioner: gamg}\n");
    EXPECT_EQ(line.find("p.yaml:4:26: solver.preconditioner: linear: auto takes no preconditioner; linear: krylov"), 0u)
        << line;
    EXPECT_EQ(solver("linear: jacobian-free, preconditioner: gamg").linear.preconditioner, Preconditioner::gamg);
}

TEST(Solver, SettingsAreReproducedByTheEffectiveDesignAndPassedToSolve) {
    const std::string text = base + "solver: {linear: krylov, preconditioner: asm-ilu, newton: bfgs, threads: 2}\n";
    const std::string effective = read(text).effective_yaml;
    EXPECT_EQ(read(effective).effective_yaml, effective);
    const std::vector<Override> changes = {{"solver.newton", "modified"},
                                           {"solver.linear_limit", "7"},
                                           {"material.strain", "small"},
                                           {"loads.cavity.acts_on", "undeformed"}};
    const Design part = read_built(effective, changes);
    EXPECT_EQ(part.solver.newton, NewtonMethod::modified);
    EXPECT_EQ(part.solver.linear.iteration_limit, 7);
    EXPECT_EQ(part.solver.linear.preconditioner, Preconditioner::asm_ilu);
    EXPECT_EQ(part.solver.threads, 2);
    EXPECT_EQ(part.material.strain, Strain::small);
    EXPECT_EQ(part.loads.at(0).shape, LoadShape::undeformed);
    EXPECT_EQ(part.effective_yaml, read(effective, changes).effective_yaml);
}

TEST(Strain, CanBeSmallForLawsWithALinearCounterpart) {
    EXPECT_EQ(read("family: pipe\nmaterial: {law: yeoh, c1: 50 kPa, c2: 1 kPa, c3: 0 Pa, strain: small}\n"
                   "loads: {cavity: {pressure: 3 kPa}}\n")
                  .material.strain,
              Strain::small);
    const std::string kraken = refusal(
        "family: pipe\nmaterial: {law: kraken, mu: 50 kPa, kappa: 5 MPa, strain: small}\n"
        "mesh: {formulation: displacement}\nloads: {cavity: {pressure: 3 kPa}}\n");
    EXPECT_TRUE(contains(kraken, "material.strain: ")) << kraken;
    EXPECT_TRUE(contains(kraken, "linear form")) << kraken;
}

TEST(LoadShape, AppliesToAnyPressure) {
    EXPECT_EQ(read(base + "model: solid\n", {{"loads.cavity.acts_on", "undeformed"}}).loads.at(0).shape,
              LoadShape::undeformed);
    const Design bar = read(
        "family: bar\nmaterial: {law: neo-hookean, mu: 1 MPa}\nloads: {end: {pressure: 1 kPa, acts_on: undeformed}}\n");
    EXPECT_EQ(bar.loads.at(0).shape, LoadShape::undeformed);
    const std::string traction = refusal(
        "family: bar\nmaterial: {law: neo-hookean, mu: 1 MPa}\n"
        "loads: {end: {traction: 1 kPa, along: x, acts_on: undeformed}}\n");
    EXPECT_TRUE(contains(traction, "loads.end.acts_on: unknown key")) << traction;
}

}  // namespace
