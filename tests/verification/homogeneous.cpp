// Homogeneous states: every law in three modes, and the rod of the paper's Table 1.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "inflation_formula.hpp"
#include "material/catalogue.hpp"
#include "material/homogeneous.hpp"
#include "model/rubber.hpp"
#include "principal_law.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Homogeneous states";
constexpr const char* design = "verification/homogeneous.yaml";

struct Law {
    std::string name;      ///< in the table
    std::string material;  ///< the section of the design
    double stress_Pa = 0.4e6;
    std::string formulation = "mixed";

    [[nodiscard]] std::vector<std::string> sets() const {
        return {"material={law: " + material + "}", "mesh.formulation=" + formulation};
    }
};

/// A law of the catalogue with the constants that are its example.
Law example(const material::LawInfo& info) {
    std::string material{info.name};
    for (const auto& parameter : info.parameters)
        material.append(", ").append(parameter.name).append(": ").append(parameter.example);
    material += info.bulk == material::Bulk::finite ? ", kappa: 0.4 MPa" : ", kappa: incompressible";
    return {.name = std::string{info.name}, .material = material, .formulation = info.mixed ? "mixed" : "displacement"};
}

/// Every law: these with constants of their own, the others with their examples.
const std::vector<Law>& laws() {
    static const std::vector<Law> all = [] {
        std::vector<Law> laws{
            {"neo-hookean", "neo-hookean, mu: 0.1644 MPa"},
            {"neo-hookean-compressible", "neo-hookean-compressible, mu: 0.1644 MPa, kappa: 0.4 MPa, volumetric: log"},
            {"mooney-rivlin, 2 terms", "mooney-rivlin, c10: 0.07 MPa, c01: 0.0122 MPa"},
            {"mooney-rivlin, 5 terms",
             "mooney-rivlin, c10: 0.07 MPa, c01: 0.0122 MPa, c20: 0.002 MPa, c11: 0.001 MPa, c02: 0.0005 MPa"},
            {"yeoh", "yeoh, c1: 0.0822 MPa, c2: -0.001 MPa, c3: 0.0002 MPa"},
            // Treloar's rubber: Ogden, Proc. R. Soc. A 326 (1972) 565
            {"ogden, 3 terms", "ogden, mu: [0.63 MPa, 0.0012 MPa, -0.01 MPa], alpha: [1.3, 5, -2]", 0.8e6},
            {"gent", "gent, mu: 0.1644 MPa, jm: 30"},
            {"arruda-boyce", "arruda-boyce, mu: 0.1644 MPa, locking_stretch: 3"},
            // Fibres in the plane of x and y
            {"holzapfel-gasser-ogden", "holzapfel-gasser-ogden, mu: 0.1644 MPa, k1: 0.05 MPa, k2: 0.5, angle: 35 deg"},
            {"saint-venant-kirchhoff", "saint-venant-kirchhoff, mu: 0.1644 MPa, kappa: 0.4 MPa"},
            {"linear-elastic", "linear-elastic, mu: 0.1644 MPa, kappa: 0.4 MPa", 0.2e6},
            {"kraken", "kraken, mu: 0.2069 MPa, kappa: 20.69 MPa", 7.5e6, "displacement"},
        };
        for (const auto& info : material::laws())
            if (std::ranges::none_of(
                    laws, [&](const Law& law) { return law.material.starts_with(std::string{info.name} + ","); }))
                laws.push_back(example(info));
        return laws;
    }();
    return all;
}

std::string MPa_text(double stress_Pa) { return core::number_text(1e-6 * stress_Pa) + " MPa"; }

/// Tension along x with the second axis free, under the same tension, or fixed.
enum class Mode { uniaxial, equibiaxial, planar };

Row stretch_row(const Law& law, Mode mode, const std::string& cells) {
    std::vector<std::string> sets = law.sets();
    sets.push_back("mesh.cells=" + cells);
    sets.push_back("loads.end.pressure=-" + MPa_text(law.stress_Pa));
    const Prescribed pull{law.stress_Pa, false};
    Prescribed other{0, false};
    std::string word = "uniaxial";
    if (mode == Mode::equibiaxial) {
        sets.push_back("loads.right.pressure=-" + MPa_text(law.stress_Pa));
        other = pull;
        word = "equibiaxial";
    } else if (mode == Mode::planar) {
        sets.push_back("supports.y=[left, right]");
        other.fixed = true;
        word = "planar";
    }
    const auto run = run_design(design, sets);
    const double length_m = 20e-3;
    return {.quantity = "stretch at " + core::number_text(1e-3 * law.stress_Pa) + " kPa, " + word + " [-]",
            .reference = stretches_at(run.model.materials.front(), pull, other)[0],
            .source = "equilibrium of the closed form",
            .ours = 1.0 + run.steps.back().outputs.at(0) / length_m,
            .mesh = run.mesh,
            .seconds = run.seconds,
            .tolerance = homogeneous_tolerance};
}

Problem states_of(const Law& law, const std::string& cells) {
    return {group, law.name + (cells == "auto" ? ", hexahedra" : ", tetrahedra"), [law, cells] {
                Outcome outcome;
                for (const Mode mode : {Mode::uniaxial, Mode::equibiaxial, Mode::planar})
                    outcome.rows.push_back(stretch_row(law, mode, cells));
                return outcome;
            }};
}

/// Cauchy shear stress at the amount of shear g: principal stretches l and 1/l with l - 1/l = g, the first at the angle
/// theta to the plane of shear with sin theta cos theta = 1/(l + 1/l).
double shear_stress_Pa(const model::Material& material, double g) {
    const double l = 0.5 * g + std::sqrt(1.0 + 0.25 * g * g);
    const auto stress = material.bulk_modulus_Pa ? cauchy_of(material) : extra_stress_of(material);
    const Triple s = stress({l, 1.0 / l, 1.0});
    return (s[0] - s[1]) / (l + 1.0 / l);
}

Problem simple_shear() {
    return {group, "simple shear, one material point", [] {
                constexpr double shear = 1.5;
                Outcome outcome;
                for (const Law& law : laws()) {
                    if (law.name == "linear-elastic" || law.name == "holzapfel-gasser-ogden") continue;
                    const auto material = read_case(design, law.sets()).materials.front();
                    const auto state =
                        material::homogeneous_state(model::make_rubber(material), material::Mode::simple_shear, shear);
                    outcome.rows.push_back(
                        {.quantity = "Cauchy shear stress at g = 1.5, " + law.name + " [kPa]",
                         .reference = 1e-3 * shear_stress_Pa(material, shear),
                         .source = "closed form",
                         .ours = 1e-3 * material::cauchy_stress_Pa(state.value(), material::Mode::simple_shear),
                         .mesh = "none: a material point",
                         .seconds = 0,
                         .tolerance = homogeneous_tolerance});
                }
                return outcome;
            }};
}

struct RodLaw {
    const char* name;
    std::vector<std::string> sets;
};

/// The rod of Table 1: Cauchy stress 0.25 t MPa, with t from the table.
Problem table_rod(const RodLaw& law) {
    return {group, std::string("rod of Table 1, ") + law.name, [law] {
                const auto run = run_design("verification/rod-table1.yaml", law.sets);
                Outcome outcome;
                for (const int t : {5, 10, 20, 30}) {
                    const double stress_Pa = 0.25e6 * t;
                    const auto point = run.at("pressure", -stress_Pa);
                    outcome.rows.push_back(
                        {.quantity = "strain at " + core::number_text(0.25 * t) + " MPa [%]",
                         .reference = 100 * (stretches_at(run.model.materials.front(), {stress_Pa}, {})[0] - 1),
                         .source = "closed form",
                         .ours = 1e3 * point.outputs.at(0),  // 100 mm long
                         .mesh = run.mesh,
                         .seconds = run.seconds,
                         .tolerance = homogeneous_tolerance});
                }
                return outcome;
            }};
}

/// The kraken law is not stress-free in the undeformed state: in the first row, at load factor 0, the rod has shrunk.
Problem kraken_shrink() {
    return {group, "kraken law without load", [] {
                const auto run = run_design("verification/rod-table1.yaml",
                                            {"material.law=kraken", "mesh.formulation=displacement"});
                const double mu = run.model.materials.front().constants.at("mu").front();
                const double per_kappa = mu / *run.model.materials.front().bulk_modulus_Pa;
                // sigma = mu (l^2 - 1/(l + mu/kappa)) = 0
                const double l = root_of([&](double x) { return x * x - 1.0 / (x + per_kappa); }, 0.5, 1.5);
                return Outcome{{{.quantity = "strain [%]",
                                 .reference = 100 * (l - 1),
                                 .source = "closed form",
                                 .ours = 1e3 * run.steps.front().outputs.at(0),
                                 .mesh = run.mesh,
                                 .seconds = run.seconds}},
                               {}};
            }};
}

}  // namespace

std::vector<Problem> homogeneous_problems() {
    std::vector<Problem> problems;
    for (const Law& law : laws())
        for (const char* cells : {"auto", "simplices"}) problems.push_back(states_of(law, cells));
    problems.push_back(simple_shear());
    const std::vector<std::string> kraken{"material.law=kraken", "mesh.formulation=displacement"};
    auto first_order = kraken;
    first_order.push_back("mesh.order=1");
    for (const RodLaw& law :
         {RodLaw{"split law, kappa/mu = 100", {}}, RodLaw{"incompressible", {"material.kappa=incompressible"}},
          RodLaw{"kraken law, second order", kraken}, RodLaw{"kraken law, first order", first_order}})
        problems.push_back(table_rod(law));
    problems.push_back(kraken_shrink());
    return problems;
}

}  // namespace soft::verification
