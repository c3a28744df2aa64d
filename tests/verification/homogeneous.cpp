// Homogeneous states: every law in three modes, and the rod of the paper's Table 1.
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
constexpr const char* small_strain = "linear-elastic";

struct Law {
    std::string name, design;
    [[nodiscard]] model::Case read(const std::vector<std::string>& sets = {}) const {
        return read_case("verification/" + design + ".yaml", sets);
    }
    /// Tensile stress of the design.
    [[nodiscard]] double stress_Pa() const { return -read().path.stages.front().supplies.front().value; }
};

/// Every law has a design law-NAME.yaml. The name of a law with several terms states those of its design.
std::vector<Law> laws() {
    std::vector<Law> all;
    for (const material::LawInfo& info : material::laws()) {
        const std::string name{info.name}, design = "law-" + name;
        if (name == "mooney-rivlin") {
            all.push_back({name + ", 2 terms", design});
            all.push_back({name + ", 5 terms", design + "-5"});
        } else {
            all.push_back({name == "ogden" ? name + ", 3 terms" : name, design});
        }
    }
    return all;
}

std::string MPa_text(double stress_Pa) { return core::number_text(1e-6 * stress_Pa) + " MPa"; }

/// Tension along x with the second axis free, under the same tension, or fixed.
enum class Mode { uniaxial, equibiaxial, planar };

Row stretch_row(const Law& law, Mode mode, const std::string& cells) {
    std::vector<std::string> sets{"mesh.cells=" + cells};
    const double stress_Pa = law.stress_Pa();
    const Prescribed pull{stress_Pa, false};
    Prescribed other{0, false};
    std::string word = "uniaxial";
    if (mode == Mode::equibiaxial) {
        sets.push_back("loads.right.pressure=-" + MPa_text(stress_Pa));
        other = pull;
        word = "equibiaxial";
    } else if (mode == Mode::planar) {
        sets.push_back("supports.y=[left, right]");
        other.fixed = true;
        word = "planar";
    }
    const auto run = run_design("verification/" + law.design + ".yaml", sets);
    const double length_m = 20e-3;
    return {.quantity = "stretch at " + core::number_text(1e-3 * stress_Pa) + " kPa, " + word + " [-]",
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
                    const std::string& name = law.name;
                    if (name == small_strain || name == "holzapfel-gasser-ogden") continue;
                    const auto material = law.read().materials.front();
                    const auto state =
                        material::homogeneous_state(model::make_rubber(material), material::Mode::simple_shear, shear);
                    outcome.rows.push_back(
                        {.quantity = "Cauchy shear stress at g = 1.5, " + name + " [kPa]",
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
