#pragma once
/// The typed case: what mesh-gen writes, solve reads and the HDF5 file holds. Plain data, SI units, no behaviour.
/// Loads are stated for the WHOLE actuator; `model_fraction` says how much of it the mesh holds (1, 1/2, 1/4).
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "material/fibers.hpp"
#include "material/form.hpp"
#include "mesh/mesh.hpp"
#include "model/measure.hpp"
#include "model/settings.hpp"

namespace soft::model {

/// axisymmetric: section in (x, r), axis of revolution x, r >= 0; integrals carry 2 pi r.
/// plane_strain: section in (x, y) of unit depth 1 m. solid: (x, y, z).
enum class Kinematics { axisymmetric, plane_strain, solid };

using Formulation = material::Form;
using Volumetric = material::VolumetricLaw;
using FiberFrame = material::FiberFrame;
using Fibers = material::Fibers;
enum class Strain { finite, small };

struct Material {
    std::string name;                                      ///< region it belongs to
    std::string law;                                       ///< material::law name, e.g. "neo-hookean"
    std::map<std::string, std::vector<double>> constants;  ///< SI, by the law's own keys; scalars have one entry
    std::optional<double> bulk_modulus_Pa;                 ///< kappa; nullopt = fully incompressible
    std::optional<double> density_kg_m3 = {};              ///< undeformed; needed by body forces and dynamics
    Volumetric volumetric = Volumetric::quadratic;
    Strain strain = Strain::finite;  ///< small: the law's tangent at the undeformed state, linear in grad u
    FiberFrame fiber_frame = FiberFrame::cartesian;  ///< of rubbers with fibres; the others do not look at it
    std::string source = "material";    ///< section of the design that states it: "material" or "materials.<name>"
    std::optional<Fibers> fibers = {};  ///< that the family has laid into the region, besides those of the law
};

/// Zero displacement of the marked components (x, y, z; axisymmetric: x, r, unused) on a named face.
struct Support {
    std::string face;
    std::array<bool, 3> fixed{};
};

/// A hole that leads out of the cavity, closed by a plug when the load is sealed.
struct Opening {
    std::string face;                   ///< named face around the hole that carries the plug's thrust, spread evenly
    double area_m2 = 0;                 ///< undeformed area of the hole, whole actuator
    std::array<double, 3> direction{};  ///< unit vector out of the cavity, reference configuration
};

/// What the geometry knows of a cavity.
struct Cavity {
    std::string name;                      ///< "cavity" where there is one
    std::string wall;                      ///< named face that is always loaded
    std::vector<std::string> inner_faces;  ///< closed inner faces, loaded only when the load is sealed
    std::vector<Opening> openings;
};

/// The gas in a supply: barotropic air, p + ambient = ambient (density / ambient_density)^exponent with
/// density = mass / (enclosed volume + dead volume). exponent 1: isothermal, 1.4: adiabatic air.
/// Looked at only where a stage prescribes the mass or closes the valve.
struct Gas {
    double ambient_Pa = 101325;            ///< absolute pressure outside the body
    double ambient_density_kg_m3 = 1.204;  ///< of the gas at ambient pressure (air at 20 degrees Celsius)
    double dead_volume_m3 = 0;             ///< of the tubing, filled by the same gas; whole actuator
    double exponent = 1;
};

/// How a load goes with time in a dynamic case: its level is the value of the (only) stage times the share f(t).
///   ramp: f grows from 0 to 1 over `time_s` and stays        step: 1 from the start (t = 0 included)
///   sine: sin(2 pi frequency t)                               table: linear between (times_s, shares), held beyond its ends
enum class TimeFunctionKind { ramp, step, sine, table };
struct TimeFunction {
    TimeFunctionKind kind = TimeFunctionKind::ramp;
    double time_s = 0;                    ///< of the ramp; 0: the duration of the path
    double frequency_Hz = 0;              ///< of the sine
    std::vector<double> times_s, shares;  ///< of the table, times ascending
};

/// A tube between a source of pressure and the cavity: dm/dt = ambient density (source - cavity pressure) / resistance.
struct SupplyLine {
    double resistance_Pa_s_m3 = 0;  ///< pressure drop per volume flow, the volume measured at ambient pressure
};

/// Which shape of the body a pressure pushes on. undeformed: traction -p N on the undeformed area, a dead load.
enum class LoadShape { deformed, undeformed };

/// A pressure, traction -p n on the DEFORMED area (unless `shape` says otherwise; n out of the rubber); positive inflates a
/// cavity. The cavities of one load share one gas: one pressure, and their volumes add up. How much of it: Stage::supplies.
struct PressureLoad {
    std::string name;                  ///< its key in the design: "cavity", "left"
    std::vector<std::string> targets;  ///< names of cavities; or of one face (`sealed`, `gas` unused, no volume)
    bool sealed = true;                ///< openings are plugged; see assembly/cavity.hpp
    Gas gas;
    LoadShape shape = LoadShape::deformed;
    TimeFunction time_function = {};  ///< of its pressure, where the case is dynamic
    /// Where the case is dynamic: the pressure of the time_function feeds the cavities through this resistance, and what is in
    /// them follows the gas law (dead volume included). nullopt: the time_function is the pressure in the cavity.
    std::optional<SupplyLine> line = {};
    bool plug_thrust =
        true;  ///< false: a fixture carries the plugs of a sealed load, the actuator does not feel their thrust
};

/// Dead traction: a force per UNDEFORMED area whose direction stays fixed in space.
struct TractionLoad {
    std::string face;
    std::array<double, 3> traction_Pa{};  ///< at level 1; axisymmetric: x, r, unused
    TimeFunction time_function = {};
    double area_m2 = 0;  ///< of the whole undeformed face, where the design states a force; else 0
};

/// A force on the mass of the body, whose direction stays fixed in space. Every material needs its density.
struct BodyForce {
    std::string name = "gravity";
    std::array<double, 3> acceleration_m_s2{};  ///< at level 1; axisymmetric: x alone
    TimeFunction time_function = {};
};

/// A prescribed displacement of a face; components without a value stay free.
struct Motion {
    std::string face;
    std::array<std::optional<double>, 3> displacement_m;  ///< at level 1; axisymmetric: x, r, unused
};

struct Output {
    std::string name;                   ///< "elongation"; CSV column elongation_mm, bend_deg, block_N ...
    std::string face;                   ///< empty where a point is measured
    std::array<double, 3> direction{};  ///< unit vector
    Measure measure = Measure::displacement;
    std::string reference = {};  ///< the held face, measure bend only
    std::optional<std::array<double, 3>> point_m =
        {};  ///< undeformed position whose displacement is measured; a section's x, r, 0
};

/// What grows by itself while everything else follows. automatic: the load factor while the body is stiff, then the
/// volume where one cavity is filled, else arc length; it passes limit points and goes on to the stage's end.
enum class Control { automatic, pressure, volume, displacement, arc_length };

/// A stage ends at the first of these that is reached.
struct Until {
    std::string quantity;  ///< "pressure" [Pa], "volume_ratio" [-], "steps" [-], or the name of an output [m, rad]
    double value = 0;
};

enum class Prescription {
    pressure,      ///< gauge pressure [Pa]
    volume,        ///< enclosed by all cavities of the load [m^3], whole actuator
    volume_ratio,  ///< the same over its undeformed value [-]
    mass,  ///< of gas injected since the path began [kg]: beyond what fills the undeformed cavities at ambient pressure
    closed,  ///< the valve is shut: the gas that is there stays; `value` is unused
};
struct SupplyTarget {
    Prescription what = Prescription::pressure;
    double value = 0;  ///< at the stage's end
};

/// A part of a load programme. Its load factor runs from 0 to 1 while every level goes in proportion from where the stage
/// before has left it (0 at first) to the value here. Loads that do not change stay as they are; a stage in which nothing
/// changes is one row (hold).
struct Stage {
    std::string name;  ///< "inflate"; empty where a case has one stage
    Control control = Control::automatic;
    std::string controlled = {};              ///< load (volume) or output (displacement); empty: the first
    std::vector<Until> until = {};            ///< besides load factor 1, which always ends the stage
    std::vector<SupplyTarget> supplies = {};  ///< one for each of Case::loads
    std::vector<double> tractions = {}, body_forces = {}, motions = {};  ///< levels, one for each of the case's lists
};

/// What happens where a branch leaves the path.
enum class Branch { stay, follow };
enum class Contact { stop, ignore };

struct PathSettings {
    std::vector<Stage> stages;
    Branch branch = Branch::stay;     ///< follow: at the first bifurcation of the path
    double imperfection_m = 1e-4;     ///< how far the body is pushed onto the branch: largest displacement of the mode
    Contact contact = Contact::stop;  ///< where walls of the body touch
    double stretch_limit = 10;        ///< stretch_p99 beyond which a load that is never reached is given up
};

struct Case {
    std::string name;
    Kinematics kinematics = Kinematics::solid;
    Formulation formulation = Formulation::mixed;
    double model_fraction = 1.0;
    std::array<bool, 3> symmetry_planes{};  ///< the mesh is cut at x = 0, y = 0, z = 0 (whole actuator = mirror images)
    mesh::Mesh mesh;
    std::vector<Material> materials;  ///< by region name; every region has exactly one
    std::vector<Support> supports;    ///< symmetry planes included
    std::vector<Cavity> cavities;
    std::vector<PressureLoad> loads;
    std::vector<TractionLoad> tractions;
    std::vector<BodyForce> body_forces;
    std::vector<Motion> motions;
    std::vector<Output> outputs;
    PathSettings path;
    SolverSettings solver;
    std::optional<Dynamics> dynamics;  ///< nullopt: a static path
};

/// The cavities whose volume is measured: those of all loads, in the order of the loads and their targets.
[[nodiscard]] inline std::vector<const Cavity*> measured_cavities(const Case& input) {
    std::vector<const Cavity*> found;
    for (const auto& load : input.loads)
        for (const auto& target : load.targets)
            for (const auto& cavity : input.cavities)
                if (cavity.name == target) found.push_back(&cavity);
    return found;
}

/// What a curve shows as its load: the pressure of the first pressure load; of a case without one the size of its first
/// traction [Pa], or of its force [N] where it is stated as one; of a case without either the load factor.
enum class LeadingLoad { pressure, traction, force, load_factor };
[[nodiscard]] inline LeadingLoad leading_load(const Case& input) {
    if (!input.loads.empty()) return LeadingLoad::pressure;
    if (input.tractions.empty()) return LeadingLoad::load_factor;
    return input.tractions[0].area_m2 > 0 ? LeadingLoad::force : LeadingLoad::traction;
}

}  // namespace soft::model
