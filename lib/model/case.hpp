#pragma once
/// The typed case: mesh-gen writes it to the HDF5 file and solve reads it. Plain data in SI units.
/// Loads are given for the WHOLE actuator; `model_fraction` is the fraction of it that the mesh represents (1, 1/2, 1/4).
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "material/fibers.hpp"
#include "material/form.hpp"
#include "material/inelastic.hpp"
#include "mesh/mesh.hpp"
#include "model/measure.hpp"
#include "model/obstacle.hpp"
#include "model/settings.hpp"

namespace soft::model {

/// axisymmetric: section in (x, r), axis of revolution x, r >= 0; integrals include 2 pi r.
/// plane_strain: section in (x, y) of unit depth 1 m. solid: (x, y, z).
enum class Kinematics { axisymmetric, plane_strain, solid };

using Formulation = material::Form;
using Volumetric = material::VolumetricLaw;
using FiberFrame = material::FiberFrame;
using Fibers = material::Fibers;
enum class Strain { finite, small };

struct Material {
    std::string name;                                      ///< region it belongs to
    std::string law;                                       ///< name of the law, e.g. "neo-hookean"
    std::map<std::string, std::vector<double>> constants;  ///< SI, by parameter name of the law; scalars have one entry
    std::optional<double> bulk_modulus_Pa;                 ///< kappa; nullopt = fully incompressible
    std::optional<double> density_kg_m3 = {};              ///< undeformed; needed by body forces and dynamics
    Volumetric volumetric = Volumetric::quadratic;
    Strain strain = Strain::finite;  ///< small: the law's tangent at the undeformed state, linear in grad u
    FiberFrame fiber_frame = FiberFrame::cartesian;  ///< used only by materials with fibres
    std::string source = "material";    ///< section of the design that defines it: "material" or "materials.<name>"
    std::optional<Fibers> fibers = {};  ///< fibres that the actuator family adds to the region; not those of the law
    std::optional<material::Inelastic> inelastic = {};  ///< viscoelasticity and softening

    bool operator==(const Material&) const = default;
};

/// Zero displacement of the marked components (x, y, z; axisymmetric: x, r, unused) on a named face.
struct Support {
    std::string face;
    std::array<bool, 3> fixed{};
};

/// A hole in the cavity wall, closed by a plug when the load is sealed.
struct Opening {
    std::string face;    ///< named face around the hole; carries the plug's thrust, distributed uniformly
    double area_m2 = 0;  ///< undeformed area of the hole, whole actuator
    std::array<double, 3> direction{};  ///< unit vector out of the cavity, reference configuration
};

/// Geometry of a cavity.
struct Cavity {
    std::string name;                      ///< "cavity" if there is only one
    std::string wall;                      ///< named face that is always loaded
    std::vector<std::string> inner_faces;  ///< closed inner faces, loaded only when the load is sealed
    std::vector<Opening> openings;
};

/// The gas in a supply: barotropic air, p + ambient = ambient (density / ambient_density)^exponent with
/// density = mass / (enclosed volume + dead volume). exponent 1: isothermal, 1.4: adiabatic air.
/// Used only if a stage prescribes the mass or closes the valve.
struct Gas {
    double ambient_Pa = 101325;            ///< absolute pressure outside the actuator
    double ambient_density_kg_m3 = 1.204;  ///< of the gas at ambient pressure (air at 20 degrees Celsius)
    double dead_volume_m3 = 0;             ///< volume of the tubing, filled with the same gas; whole actuator
    double exponent = 1;
};

/// Time function f(t) of a load in a dynamic case: the load is f(t) times its value in the (only) stage.
///   ramp: f increases from 0 to 1 over `time_s`, then stays 1   step: 1 from the start (t = 0 included)
///   sine: sin(2 pi frequency t)                               table: linear between (times_s, shares), constant beyond its ends
enum class TimeFunctionKind { ramp, step, sine, table };
struct TimeFunction {
    TimeFunctionKind kind = TimeFunctionKind::ramp;
    double time_s = 0;                    ///< ramp: rise time; 0: the duration of the path
    double frequency_Hz = 0;              ///< sine
    std::vector<double> times_s, shares;  ///< table: times in ascending order and values of f
};

/// A tube between a pressure source and the cavity: dm/dt = ambient density (source - cavity pressure) / resistance.
struct SupplyLine {
    double resistance_Pa_s_m3 = 0;  ///< pressure drop per volume flow rate, with the volume taken at ambient pressure
};

/// Configuration in which a pressure acts. deformed: follower pressure. undeformed: traction -p N on the undeformed area, a dead load.
enum class LoadShape { deformed, undeformed };

/// A pressure: traction -p n on the DEFORMED area (unless `shape` is undeformed), n out of the material; positive p inflates a
/// cavity. The cavities of one load share one gas: they have the same pressure, and their volumes add up. The magnitude is in
/// Stage::supplies.
struct PressureLoad {
    std::string name;  ///< its key in the design: "cavity", "left"
    /// Names of cavities, or of one face (then `sealed` and `gas` are unused, no volume).
    std::vector<std::string> targets;
    bool sealed = true;  ///< openings are plugged; see fem/loads.hpp
    Gas gas;
    LoadShape shape = LoadShape::deformed;
    TimeFunction time_function = {};  ///< of the pressure, in a dynamic case
    /// Dynamic case: the time function is the source pressure, which feeds the cavities through this line, and the gas in them
    /// follows the gas law (dead volume included). nullopt: the time function is the pressure in the cavity.
    std::optional<SupplyLine> line = {};
    /// False: a fixture carries the plugs of a sealed load, so their thrust does not load the actuator.
    bool plug_thrust = true;
};

/// traction: force per UNDEFORMED area of a face [Pa]   force: the same, where the design states the force on the whole face [N]
/// gravity: force per mass [m/s^2]; it requires the density of every material
enum class DeadLoadKind { traction, force, gravity };

/// A load whose nodal forces do not depend on the displacements (fem/nodal_forces.hpp).
struct DeadLoad {
    std::string name;  ///< the face on which it acts, or "gravity"
    DeadLoadKind kind = DeadLoadKind::traction;
    std::array<double, 3> vector_SI{};  ///< at level 1: traction [Pa] or acceleration [m/s^2]; axisymmetric: x, r
    TimeFunction time_function = {};
    double area_m2 = 0;  ///< force: area of the whole undeformed face
    double sign = 1;     ///< of the traction or force that the design states, along its direction
};

/// A prescribed displacement of a face or of an obstacle. Components without a value are free; those of an obstacle are fixed.
struct Motion {
    std::string face;                                     ///< or the name of an obstacle
    std::array<std::optional<double>, 3> displacement_m;  ///< at level 1; axisymmetric: x, r, unused
    TimeFunction time_function = {};                      ///< of an obstacle in a motion in time
};

/// Output::obstacle of the contact of the actuator with itself.
inline constexpr std::string_view self_contact = "self";

struct Output {
    std::string name;                   ///< "elongation"; CSV column elongation_mm, bend_deg, block_N ...
    std::string face;                   ///< empty if a point or an obstacle is measured
    std::array<double, 3> direction{};  ///< unit vector; zero for a measure without a direction
    Measure measure = Measure::displacement;
    std::string reference = {};  ///< the supported reference face of measure bend; else empty
    /// Undeformed position of the measured point; x, r, 0 in a section.
    std::optional<std::array<double, 3>> point_m = {};
    std::string obstacle = {};  ///< name of an obstacle, or self_contact; else empty
};

/// Controlled quantity of the path following. automatic: the load factor while the actuator is stiff, then the volume if one
/// cavity is filled, else the arc length; it passes limit points and continues to the end of the stage.
enum class Control { automatic, pressure, volume, displacement, arc_length };

/// Stopping condition. A stage ends at the first one that is reached.
struct Until {
    std::string quantity;  ///< "pressure" [Pa], "volume_ratio" [-], "steps" [-], or the name of an output [m, rad]
    double value = 0;
};

enum class Prescription {
    pressure,      ///< gauge pressure [Pa]
    volume,        ///< enclosed by all cavities of the load [m^3], whole actuator
    volume_ratio,  ///< volume divided by its undeformed value [-]
    mass,  ///< mass of gas injected since the start of the path [kg], beyond the gas in the undeformed cavities at ambient pressure
    closed,  ///< the valve is shut: the mass of gas is constant; `value` is unused
};
struct SupplyTarget {
    Prescription what = Prescription::pressure;
    double value = 0;  ///< at the end of the stage
};

/// A stage of a load programme. While its load factor runs from 0 to 1, every level changes linearly from its value at the end of
/// the previous stage (0 at first) to the value here. A stage in which no load changes is one row (hold).
struct Stage {
    std::string name;  ///< "inflate"; empty where a case has one stage
    Control control = Control::automatic;
    std::string controlled = {};    ///< load (volume control) or output (displacement control); empty: the first
    std::vector<Until> until = {};  ///< in addition to load factor 1, which always ends the stage
    std::vector<SupplyTarget> supplies = {};            ///< one per entry of Case::loads
    std::vector<double> dead_loads = {}, motions = {};  ///< levels, one per entry of the lists in Case
    /// Duration: loads change linearly in time, and the load factor is the share of it that has passed. All stages of a path have one,
    /// or none.
    std::optional<double> time_s = {};
    int cycle = 1;  ///< of a repeated programme
};

/// Behaviour at a bifurcation and at contact.
enum class Branch { stay, follow };
enum class Contact { solve, stop, ignore };
/// Response of viscoelastic materials on a path without times: infinitely slow, or infinitely fast.
enum class Modulus { long_term, instantaneous };

inline constexpr int max_frequencies = 50;

struct PathSettings {
    std::vector<Stage> stages;
    Branch branch = Branch::stay;  ///< follow: switch to the other branch at the first bifurcation of the path
    double imperfection_m = 1e-4;  ///< perturbation used to switch branches: maximum displacement of the scaled mode
    /// Behaviour where walls of the actuator touch each other. Obstacles are always respected.
    Contact contact = Contact::solve;
    double stretch_limit = 10;  ///< stretch_p99 beyond which a load that cannot be reached is abandoned
    int frequencies = 0;        ///< number of natural frequencies of each row of a static path, at most max_frequencies
    int cycles = 1;             ///< repetitions that `stages` consists of
    Modulus modulus = Modulus::long_term;
    double time_accuracy = 1e-3;  ///< relative error of viscous stress by the size of the steps in time
};

/// A number of the design, by which solve differentiates the rows of the path (solver/sensitivities.hpp).
struct DesignParameter {
    std::string key;               ///< "geometry.wall"
    std::string unit;              ///< as written in the design; empty for a pure number
    double SI_per_unit = 1;        ///< of `unit`
    double value = 0;              ///< SI
    double lower = 0, higher = 0;  ///< SI, of the cases between which the derivative is a difference
};

struct Case {
    std::string name;
    Kinematics kinematics = Kinematics::solid;
    Formulation formulation = Formulation::mixed;
    double model_fraction = 1.0;
    std::array<bool, 3> symmetry_planes{};  ///< symmetry planes x = 0, y = 0, z = 0 at which the mesh is cut
    mesh::Mesh mesh;
    std::vector<Material> materials;  ///< exactly one per region, matched by name
    std::vector<Support> supports;    ///< symmetry planes included
    std::vector<Cavity> cavities;
    std::vector<PressureLoad> loads;
    std::vector<DeadLoad> dead_loads;
    std::vector<Motion> motions;
    std::vector<Obstacle> obstacles;
    ContactSettings contact;
    std::vector<Output> outputs;
    PathSettings path;
    SolverSettings solver;
    std::optional<Dynamics> dynamics;         ///< nullopt: a static path
    std::vector<DesignParameter> parameters;  ///< of the derivatives of the rows
};

/// Whether a static path runs in time.
[[nodiscard]] inline bool is_timed(const Case& input) {
    return !input.dynamics && !input.path.stages.empty() && input.path.stages.front().time_s.has_value();
}
[[nodiscard]] inline bool runs_in_time(const Case& input) { return input.dynamics || is_timed(input); }

/// Whether a material relaxes or softens.
[[nodiscard]] inline bool is_inelastic(const Case& input) {
    return std::ranges::any_of(input.materials,
                               [](const Material& material) { return material.inelastic.has_value(); });
}

/// Whether a motion is that of an obstacle, not of a face.
[[nodiscard]] inline bool moves_obstacle(const Case& input, const Motion& motion) {
    return std::ranges::any_of(input.obstacles, [&](const Obstacle& obstacle) { return obstacle.name == motion.face; });
}

/// Whether the case has friction anywhere.
[[nodiscard]] inline bool has_friction(const Case& input) {
    return input.contact.friction > 0 ||
           std::ranges::any_of(input.obstacles, [](const Obstacle& obstacle) { return obstacle.friction > 0; });
}

/// The cavities whose volume is measured: the targets of all loads, in the order of the loads and their targets.
[[nodiscard]] inline std::vector<const Cavity*> measured_cavities(const Case& input) {
    std::vector<const Cavity*> found;
    for (const auto& load : input.loads)
        for (const auto& target : load.targets)
            for (const auto& cavity : input.cavities)
                if (cavity.name == target) found.push_back(&cavity);
    return found;
}

/// Index of the first traction or force among the dead loads; nullopt without one.
[[nodiscard]] inline std::optional<std::size_t> first_traction(const Case& input) {
    for (std::size_t i = 0; i < input.dead_loads.size(); ++i)
        if (input.dead_loads[i].kind == DeadLoadKind::traction || input.dead_loads[i].kind == DeadLoadKind::force)
            return i;
    return std::nullopt;
}

/// The load that a curve shows: the pressure of the first pressure load; without one, the first traction [Pa], or
/// its force [N] if the design states a force, positive along its direction; without either, the load factor, in a motion the level of gravity or of the first obstacle.
enum class LeadingLoad { pressure, traction, force, load_factor };
[[nodiscard]] inline LeadingLoad leading_load(const Case& input) {
    if (!input.loads.empty()) return LeadingLoad::pressure;
    const auto first = first_traction(input);
    if (!first) return LeadingLoad::load_factor;
    return input.dead_loads[*first].kind == DeadLoadKind::force ? LeadingLoad::force : LeadingLoad::traction;
}

}  // namespace soft::model
