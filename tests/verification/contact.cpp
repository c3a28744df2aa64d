// Contact with rigid obstacles and with itself. The references are closed forms and those of tests/verification/peers, whose README
// explains the tolerances: a wall keeps a gap below the contact distance, 1 % of a facet, so that obstacles act this much early.
#include <algorithm>
#include <cmath>
#include <span>

#include "core/text.hpp"
#include "inflation_formula.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Contact";
constexpr const char* independent = "GetFEM, Q2/Q1, Lagrange multipliers";
constexpr double mu_Pa = 1e5;

struct Value {
    std::string quantity;
    double reference, ours;
    double tolerance = default_tolerance;
    const char* reason = "";
};

Outcome compare(const Run& run, const std::string& source, const std::vector<Value>& values) {
    Outcome outcome;
    for (const Value& value : values)
        outcome.rows.push_back({.quantity = value.quantity,
                                .reference = value.reference,
                                .source = source,
                                .ours = value.ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds,
                                .tolerance = value.tolerance,
                                .reason = value.reason});
    return outcome;
}

/// Two blocks with meshes that do not match, pressed to a stretch of 0.9: the state is homogeneous. The stretch that is reached, which
/// depends on the gap, gives the force of a homogeneous state.
Outcome patch_test() {
    const Run run = run_design("verification/contact-patch.yaml", {});
    const auto& last = run.steps.back();
    const auto force_N = [](double l) { return 0.01 * mu_Pa * (1 / (l * l) - l * l) / l; };
    const double reached = 1 + last.outputs.at(1) / 5e-3;  // of the lower block
    return compare(
        run, "closed form",
        {{"force at the stretch reached [N]", force_N(reached), last.outputs.at(0)},
         {"width at the stretch reached [mm]", 10 / reached, 10 + 1e3 * last.outputs.at(3), homogeneous_tolerance},
         {"largest stretch [-]", 1 / 0.9, last.max_stretch},
         {"force at a stretch of 0.9 [N]", force_N(0.9), last.outputs.at(0), 4e-3,
          "a gap of 3 um changes the stretch by 3e-4, the force by 0.36 %"}});
}

/// A tube in a sleeve or a shell in a sphere. Nothing moves after the first contact: the obstacle carries the rest of the pressure.
struct Mould {
    const char* design;
    double inner_mm, outer_mm, mould_mm;
    double power;  ///< of the radius in the volume: 2 in a tube, 3 in a sphere
    double touch_tolerance = default_tolerance;
    const char* touch_reason = "";
    std::vector<std::string> sets = {};
    /// The facets of a mesh without a grid have unequal contact distances, hence unequal pressures.
    bool has_equal_facets = true;
};

Outcome inflate(const Mould& mould) {
    auto sets = mould.sets;
    sets.emplace_back("mesh.size=0.5 mm");
    const Run run = run_design(mould.design, sets);
    const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
    const double ratio = mould.outer_mm / mould.inner_mm, power = mould.power;
    const auto pressure_kPa = [&](double l) {
        return 1e-3 * (power == 3 ? sphere_pressure_Pa(extra_stress, l, ratio)
                                  : cylinder_pressure_Pa(extra_stress, {1, ratio, 1}, l));
    };
    const double l = std::pow(std::pow(mould.mould_mm / mould.inner_mm, power) - std::pow(ratio, power) + 1, 1 / power);
    const double touch_kPa = pressure_kPa(l);
    std::vector<Value> values;
    if (!run.end.limit_points.empty())
        values.push_back({"limit pressure [kPa]", first_peak(pressure_kPa, 1.001, 3).value,
                          1e-3 * run.end.limit_points.front().pressure_Pa});
    values.push_back({"pressure at the first contact [kPa]", touch_kPa,
                      1e-3 * run.end.first_contacts.at(0).at.pressure_Pa, mould.touch_tolerance, mould.touch_reason});
    values.push_back({"displacement of the bore at 60 kPa [mm]", mould.inner_mm * (l - 1), run.output_mm()});
    if (mould.has_equal_facets)
        values.push_back({"contact pressure at 60 kPa [kPa]", 60 - touch_kPa, 1e-3 * run.steps.back().outputs.at(1)});
    return compare(run, "quadrature", values);
}

/// The last step of each stage.
std::vector<model::Step> stage_ends(const Run& run) {
    std::vector<model::Step> ends;
    for (std::size_t i = 0; i < run.steps.size(); ++i)
        if (i + 1 == run.steps.size() || run.steps[i + 1].stage != run.steps[i].stage) ends.push_back(run.steps[i]);
    return ends;
}

/// path.stages in which the load takes each of these values in turn.
std::string stages(const std::string& load, const std::vector<std::string>& values) {
    std::string text = "path.stages={";
    char name = 'a';
    for (const auto& value : values) {
        text += name == 'a' ? "" : ", ";
        text += name++;
        text += ": {loads: {" + load + ": {" + value + "}}}";
    }
    return text + "}";
}

constexpr const char* facet =
    "the gap, below 1 % of a facet, is up to 0.5 % of the approach; the edge of the contact is resolved to a facet";

/// The gap is 1 % of a facet, so that small approaches need small cells.
Outcome pressed_cylinder(const char* size, std::size_t first) {
    struct State {
        const char *displacement, *approach;
        double force_N, growth_mm;
    };
    const State states[] = {{"-0.55 mm", "5 %", 63.957, 0.20113},
                            {"-1.05 mm", "10 %", 159.868, 0.49263},
                            {"-1.55 mm", "15 %", 287.114, 0.85868},
                            {"-2.05 mm", "20 %", 453.473, 1.30221}};
    const auto compared = std::span(states).subspan(first);
    std::vector<std::string> displacements;
    for (const State& state : compared) displacements.push_back(std::string{"displacement: "} + state.displacement);
    const Run run = run_design("verification/contact-cylinder.yaml",
                               {std::string{"mesh.size="} + size, stages("plate", displacements)});
    const auto ends = stage_ends(run);
    std::vector<Value> values;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        const auto& [displacement, approach, force_N, growth_mm] = compared[i];
        const std::string at = std::string{" at an approach of "} + approach;
        values.push_back({"force on a half" + at + " [N]", force_N, ends.at(i).outputs.at(0), 5e-3, facet});
        values.push_back(
            {"growth of the half width" + at + " [mm]", growth_mm, 1e3 * ends.at(i).outputs.at(1), 5e-3, facet});
    }
    return compare(run, independent, values);
}

/// The ring collapses; `pressures` after its inner faces touch.
Outcome collapsed_ring() {
    const std::vector<std::string> pressures{"pressure: 133.33333 Pa", "pressure: 174.89623 Pa",
                                             "pressure: 208.23333 Pa", "pressure: 241.56667 Pa",
                                             "pressure: 274.9 Pa",     "pressure: 308.23333 Pa"};
    const Run run = run_design("verification/contact-ring-pressure.yaml", {stages("outer", pressures)});
    const std::vector<double> side_mm{7.1883, 7.5721, 7.7169, 7.8596, 7.9983, 8.1306};
    const auto ends = stage_ends(run);
    std::vector<Value> values{
        {"pressure at the first contact [Pa]", 162.621, run.end.first_contacts.at(0).at.pressure_Pa}};
    for (std::size_t i = 0; i < side_mm.size(); ++i)
        values.push_back({"outward displacement at " + pressures[i].substr(10) + " [mm]", side_mm[i],
                          1e3 * ends.at(i).outputs.at(1)});
    return compare(run, independent, values);
}

/// Both halves of the ring, whose inner faces touch each other.
Outcome collapsed_half() {
    const Run run = run_design("verification/contact-ring-half.yaml", {});
    const auto& outputs = run.steps.back().outputs;
    constexpr const char* strip = "the strip that holds the ring changes free states by 0.1 %";
    return compare(run, independent,
                   {{"outward displacement at 308.23333 Pa [mm]", 8.1306, 1e3 * outputs.at(2), 2e-3, strip},
                    {"displacement of the upper face at 308.23333 Pa [mm]", -19, 1e3 * outputs.at(0)},
                    {"displacement of the lower face at 308.23333 Pa [mm]", 19, 1e3 * outputs.at(1)}});
}

/// A ring between two plates, compared at equal forces: only the position of the plates contains the gap.
Outcome pressed_ring() {
    const Run run = run_design("verification/contact-ring-plates.yaml", {});
    struct State {
        double force_N, top_mm, side_mm;
    };
    std::vector<Value> values;
    for (const State& state :
         {State{0.33333, -1.6989, 1.4231}, State{0.66667, -3.7958, 2.8895}, State{0.83333, -4.9968, 3.6046},
          State{1.16667, -7.2658, 4.8095}, State{1.66667, -9.3678, 5.9176}}) {
        const auto outputs = run.at("press", state.force_N).outputs;
        const std::string at = " at " + core::number_text(state.force_N) + " N per half [mm]";
        values.push_back({"displacement of the top" + at, state.top_mm, 1e3 * outputs.at(1)});
        values.push_back({"displacement of the side" + at, state.side_mm, 1e3 * outputs.at(2)});
    }
    return compare(run, independent, values);
}

/// A rigid sphere or punch on a block that is large against the contact.
Outcome indentation(const std::string& design, const char* source, double force_N, const std::string& refine) {
    const Run run = run_design(design, {"mesh.refine=" + refine});
    return compare(run, source,
                   {{"force [mN]", 1e3 * force_N, 1e3 * run.steps.back().outputs.at(0), 1e-2,
                     "the block has a finite size (0.1 to 0.4 %), and the gap is about 0.5 % of the depth"}});
}

/// Coulomb's law on a ramp of slope `slope`: horizontal over vertical force is tan(a + f) while it advances, tan(a - f) while it withdraws;
/// 0 where tan a is the coefficient of friction: a block begins to slide down there.
Outcome ramp(const std::string& design, double slope, const std::vector<std::string>& sets) {
    const Run run = run_design(design, sets);
    const auto ratio = [](const model::Step& step) { return 1 + step.outputs.at(0) / -step.outputs.at(1); };
    const auto advanced = std::ranges::find_if(run.steps, [](const model::Step& step) { return step.stage == 1; });
    const double a = std::atan(slope), f = std::atan(0.3);
    return compare(
        run, "Coulomb's law",
        {{"1 + horizontal over vertical force, advancing [-]", 1 + std::tan(a + f), ratio(*std::prev(advanced))},
         {"1 + the same, withdrawing [-]", 1 + std::tan(a - f), ratio(run.steps.back())}});
}

/// Under a weight that grows linearly with time: a = (sin a - f cos a) g t/T.
Outcome sliding_block() {
    const Run run = run_design("verification/contact-sliding-block.yaml", {});
    constexpr double duration_s = 0.1, weight_N = 0.1 * 9.81, friction = 0.3;  // of 100 g
    const double a = std::atan(0.6), by_g = std::sin(a) - friction * std::cos(a);
    const double slid_mm = 1e3 * by_g * 9.81 * duration_s * duration_s / 6;
    const auto& last = run.steps.back();
    // The integral of the force f N t/T along the slid distance.
    const double work_mJ = friction * weight_N * std::cos(a) * slid_mm * 3 / 4;
    return compare(run, "Coulomb's law",
                   {{"distance slid [mm]", slid_mm, -1e3 * last.outputs.at(0) / std::cos(a)},
                    {"work of friction [mJ]", work_mJ, 1e3 * last.friction_J.value()}});
}

std::vector<Problem> mould_problems() {
    std::vector<Problem> problems;
    const auto add = [&](const char* name, const Mould& mould) {
        problems.push_back({group, name, [mould] { return inflate(mould); }});
    };
    constexpr const char* early = "the sleeve acts from a distance of 1 % of a facet, 5.6 um, at 2.86 kPa/mm";
    add("tube in a sleeve", {"verification/contact-sleeve.yaml", 10, 12.5, 15, 2, 1.5e-3, early});
    Mould turned{"verification/contact-sleeve-axisymmetric.yaml", 10, 12.5, 15, 2};
    turned.has_equal_facets = false;
    add("tube in a sleeve, axisymmetric", turned);
    Mould shell{"verification/contact-shell.yaml", 10, 12, 15, 3};
    add("shell in a sphere", shell);
    shell.mould_mm = 20;
    shell.sets = {"obstacles.mould={sphere: {center: [0 mm, 0 mm, 0 mm], radius: 20 mm, inside: true}}"};
    add("shell in a larger sphere, past its limit point", shell);
    return problems;
}

}  // namespace

std::vector<Problem> contact_problems() {
    std::vector<Problem> problems = mould_problems();
    const auto add = [&](const char* name, auto&& solve, Duration duration = Duration::brief) {
        problems.push_back({group, name, solve, duration});
    };
    add("two blocks with different meshes", patch_test);
    add("cylinder between plates", [] { return pressed_cylinder("0.5 mm", 1); });
    add(
        "cylinder between plates, 0.25 mm cells", [] { return pressed_cylinder("0.25 mm", 0); }, Duration::slow);
    add("ring collapsed by pressure", collapsed_ring);
    add("ring collapsed by pressure, half", collapsed_half, Duration::slow);
    add("ring between plates", pressed_ring);
    add("sliding wedge", [] { return ramp("verification/contact-wedge.yaml", 0.1, {}); });
    add("sliding wedge, 1 mm cells", [] { return ramp("verification/contact-wedge.yaml", 0.1, {"mesh.size=1 mm"}); });
    add("block on an incline", [] { return ramp("verification/contact-incline.yaml", 0.3, {}); });
    add("block that slides down a ramp", sliding_block);
    add("sphere on a block", [] {
        const double force_N = 16.0 / 3 * mu_Pa * std::sqrt(10e-3) * std::pow(0.02e-3, 1.5);
        return indentation("verification/contact-hertz-sphere.yaml", "Hertz", force_N, "1");
    });
    add(
        "flat punch on a block",
        [] { return indentation("verification/contact-punch.yaml", "8 mu a d", 8 * mu_Pa * 0.5e-3 * 0.01e-3, "2"); },
        Duration::slow);
    return problems;
}

}  // namespace soft::verification
