/// Measures the assembly kernels relative to the measured peak of a core: cells by type, formulation and law, the scatter into the matrix,
/// and a whole evaluation. Rates and times use CPU time.   kernels [--benchmark_format=csv] [--benchmark_filter=hex27]
#include <benchmark/benchmark.h>

#include <iostream>
#include <string>

#include "../fem/matrix.hpp"
#include "../fem/sample_cases.hpp"
#include "cell_flops.hpp"
#include "fem/system.hpp"
#include "linalg/session.hpp"
#include "peak.hpp"

namespace soft::benchmarks {
namespace {

using fem::Form;
using material::Wanted;
using mesh::CellType;
using model::Kinematics;

struct CellCase {
    fem::Combination combination;
    const char* law;
    [[nodiscard]] std::string name() const { return fem::label(combination) + " " + law; }
};

std::vector<CellCase> cell_cases() {
    return {{{CellType::hex27, Kinematics::solid, Form::mixed}, "neo-hookean"},
            {{CellType::hex27, Kinematics::solid, Form::mixed}, "ogden"},
            {{CellType::tet10, Kinematics::solid, Form::mixed}, "neo-hookean"},
            {{CellType::quad9, Kinematics::axisymmetric, Form::mixed}, "neo-hookean"}};
}

void set_rates(benchmark::State& state, double flops, const Peak& peak) {
    using benchmark::Counter;
    state.counters["flops"] = flops;
    state.counters["GFlop/s"] = Counter(1e-9 * flops, Counter::kIsIterationInvariantRate);
    state.counters["% of peak"] = Counter(100 * flops / peak.flops_per_s, Counter::kIsIterationInvariantRate);
}

/// Integrates the residual, and the stiffness if requested, of one distorted cell repeatedly.
void time_cell(benchmark::State& state, const CellCase& which, Wanted wanted, const Peak& peak) {
    const fem::Sample sample(which.combination, fem::rubber_of(*material::find_law(which.law)));
    const auto input = sample.input(sample.unknowns);
    fem::CellOutput out(sample.cell);
    std::visit(
        [&](const auto& rubber) {
            for (auto _ : state) {
                fem::integrate_cell(sample.cell, which.combination.kinematics, rubber, input, wanted, out);
                benchmark::DoNotOptimize(out.residual.data());
                benchmark::ClobberMemory();
            }
        },
        sample.rubber);
    if (!(out.min_jacobian > 0.0)) state.SkipWithError("the sample cell is inverted: nothing was computed");
    const CellFlops flops = cell_flops(sample.cell, which.combination.kinematics);
    set_rates(state, wanted == Wanted::stress ? flops.residual : flops.total(), peak);
}

constexpr int box_side = 6;  // 216 hexahedra, 2 197 nodes: a matrix beyond the second-level cache, as in real meshes

model::Case box() {
    model::Case input = box_case(box_side, false);
    input.formulation = model::Formulation::mixed;
    return input;
}

/// Adds the block of one cell after another to the matrix of a mesh with linalg::BlockAdder.
void time_scatter(benchmark::State& state) {
    const model::Case input = box();
    fem::System system(input, PETSC_COMM_SELF);
    const auto cell = fem::make_reference_cell(CellType::hex27, Form::mixed);
    const linalg::Matrix K = system.make_matrix();
    std::vector<std::vector<PetscInt>> dofs(static_cast<std::size_t>(input.mesh.cell_count()));
    for (std::size_t c = 0; c < dofs.size(); ++c)
        system.dofs().cell_dofs(input.mesh, static_cast<mesh::Index>(c), cell, dofs[c]);
    const linalg::BlockIndices indices(K, std::vector<std::span<const PetscInt>>(dofs.begin(), dofs.end()));
    const std::vector<double> values(static_cast<std::size_t>(cell.dofs()) * cell.dofs(), 1.0);
    linalg::BlockAdder adder(K);
    std::size_t next = 0;
    for (auto _ : state) {
        adder.add(indices, next, values);
        next = next + 1 == dofs.size() ? 0 : next + 1;
    }
}

/// System::evaluate of a mesh. All benchmarks have the same counters, because the CSV writer fails otherwise.
void time_evaluation(benchmark::State& state, Wanted wanted, const Peak& peak) {
    const model::Case input = box();
    fem::System system(input, PETSC_COMM_SELF);
    const linalg::Vector x = system.make_vector(), R = system.make_vector();
    SOFT_PETSC(VecSetRandom(x, nullptr));
    SOFT_PETSC(VecScale(x, 1e-6));  // small compared with 10 mm: distorted cells, none inverted
    const linalg::Matrix K = system.make_matrix();
    const auto levels = fem::no_loads(input);
    const auto cells = static_cast<double>(input.mesh.cell_count());
    static_cast<void>(
        system.evaluate(x, levels, R, K));  // the first evaluation looks up the indices of the matrix entries
    for (auto _ : state)
        if (!system.evaluate(x, levels, R, wanted == Wanted::stress ? nullptr : K.get()).admissible())
            state.SkipWithError("the sample mesh is inverted");
    const auto cell = fem::make_reference_cell(CellType::hex27, Form::mixed);
    const CellFlops flops = cell_flops(cell, Kinematics::solid);
    set_rates(state, cells * (wanted == Wanted::stress ? flops.residual : flops.total()), peak);
}

void register_all(const Peak& peak) {
    const auto add = [](const std::string& name, auto&& function) {
        benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMicrosecond);
    };
    add("peak", [peak](benchmark::State& state) {
        constexpr long rounds = 100'000;
        const auto widest = detail::widest_vector();
        for (auto _ : state) benchmark::DoNotOptimize(widest.run(rounds));
        set_rates(state, 2.0 * widest.width * detail::chain_count * rounds, peak);
    });
    for (const CellCase& which : cell_cases()) {
        add(which.name() + ": residual",
            [=](benchmark::State& state) { time_cell(state, which, Wanted::stress, peak); });
        add(which.name() + ": residual and stiffness",
            [=](benchmark::State& state) { time_cell(state, which, Wanted::stress_and_tangent, peak); });
    }
    add("hex27 mixed: scatter", time_scatter);
    add("hex27 mixed 216 cells: residual",
        [peak](benchmark::State& state) { time_evaluation(state, Wanted::stress, peak); });
    add("hex27 mixed 216 cells: residual and stiffness",
        [peak](benchmark::State& state) { time_evaluation(state, Wanted::stress_and_tangent, peak); });
}

}  // namespace
}  // namespace soft::benchmarks

int main(int argc, char** argv) {
    soft::linalg::choose_blas_kernel(argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 64;
    const soft::linalg::Session session({});
    const auto peak = soft::benchmarks::measure_peak();
    benchmark::AddCustomContext("BLAS", soft::linalg::blas_name());
    benchmark::AddCustomContext("peak_GFlop_per_s", std::to_string(1e-9 * peak.flops_per_s));
    benchmark::AddCustomContext("vector_bits", std::to_string(64 * peak.vector_width));
    soft::benchmarks::register_all(peak);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
