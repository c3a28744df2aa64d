#pragma once
/// The typed case: what mesh-gen writes, solve reads and the HDF5 file holds. Plain data, SI units, no behaviour.
/// Loads are stated for the WHOLE actuator; `model_fraction` says how much of it the mesh holds (1, 1/2, 1/4).
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "material/form.hpp"
#include "mesh/mesh.hpp"

namespace soft::model {

/// axisymmetric: section in (x, r), axis of revolution x, r >= 0; integrals carry 2 pi r.
/// plane_strain: section in (x, y) of unit depth 1 m. solid: (x, y, z).
enum class Kinematics { axisymmetric, plane_strain, solid };

using Formulation = material::Form;
using Volumetric = material::VolumetricLaw;
using FiberFrame = material::FiberFrame;

struct Material {
    std::string name;                                    ///< region it belongs to
    std::string law;                                     ///< material::law name, e.g. "neo-hookean"
    std::map<std::string, std::vector<double>> constants;  ///< SI, by the law's own keys; scalars have one entry
    std::optional<double> bulk_modulus_Pa;               ///< kappa; nullopt = fully incompressible
    Volumetric volumetric = Volumetric::quadratic;
    FiberFrame fiber_frame = FiberFrame::cartesian;      ///< of laws with fibres; the others do not look at it
};

/// Zero displacement of the marked components (x, y, z; axisymmetric: x, r, unused) on a named face.
struct Support {
    std::string face;
    std::array<bool, 3> fixed{};
};

/// A hole that leads out of the cavity, closed by a plug when the load is sealed.
struct Opening {
    std::string face;                  ///< named face around the hole that carries the plug's thrust, spread evenly
    double area_m2 = 0;                ///< undeformed area of the hole, whole actuator
    std::array<double, 3> direction{}; ///< unit vector out of the cavity, reference configuration
};

/// What the geometry knows of a cavity.
struct Cavity {
    std::string name;                       ///< "cavity" where there is one
    std::string wall;                       ///< named face that is always loaded
    std::vector<std::string> inner_faces;   ///< closed inner faces, loaded only when the load is sealed
    std::vector<Opening> openings;
};

/// Follower pressure, traction -p n on the DEFORMED area (n out of the rubber); positive inflates a cavity.
struct PressureLoad {
    std::string target;            ///< name of a Cavity, or of a face (then `sealed` is unused and no volume is measured)
    double pressure_Pa = 0;        ///< value at load factor 1
    bool sealed = true;
};

/// Dead traction: a force per UNDEFORMED area whose direction stays fixed in space.
struct TractionLoad {
    std::string face;
    std::array<double, 3> traction_Pa{};   ///< at load factor 1; axisymmetric: x, r, unused
};

/// Area mean, over the undeformed face, of the displacement along `direction` [m].
struct Output {
    std::string name;              ///< "elongation"; CSV column elongation_mm
    std::string face;
    std::array<double, 3> direction{};
};

enum class Control { pressure, volume, displacement, arc_length };

/// The path ends ("done") at the first of these that is reached.
struct Until {
    std::string quantity;          ///< "pressure" [Pa], "volume_ratio" [-], "steps" [-], or the name of an output [m]
    double value = 0;
};

struct PathSettings {
    Control control = Control::volume;
    std::vector<Until> until;      ///< besides the full load (load factor 1), which always ends the path
};

struct SolverSettings {
    double residual_tolerance = 1e-9;   ///< |residual| <= tolerance x scale of the nodal forces
    int newton_limit = 16;              ///< iterations a step
    double first_step = 0.02;           ///< first step, fraction of the full load in the linear response
    double largest_step = 0.0;          ///< 0: chosen by the solver; else a bound on the step as a fraction of the path so far
    double smallest_step = 1e-4;        ///< a step cut below this fraction of the first step ends the path
    int step_limit = 1000;              ///< stop_reason step_limit beyond
    double step_accuracy = 2e-3;        ///< wanted relative error of the predictor; smaller = denser steps
};

struct Case {
    std::string name;
    Kinematics kinematics = Kinematics::solid;
    Formulation formulation = Formulation::mixed;
    double model_fraction = 1.0;
    std::array<bool, 3> symmetry_planes{};  ///< the mesh is cut at x = 0, y = 0, z = 0 (whole actuator = mirror images)
    mesh::Mesh mesh;
    std::vector<Material> materials;        ///< by region name; every region has exactly one
    std::vector<Support> supports;          ///< symmetry planes included
    std::vector<Cavity> cavities;
    std::vector<PressureLoad> loads;        ///< scaled together by the load factor
    std::vector<TractionLoad> tractions;    ///< scaled by the same load factor
    std::vector<Output> outputs;
    PathSettings path;
    SolverSettings solver;
};

/// What the load factor scales, as a curve shows it: the pressure of the first load, or of a case without one the size of
/// its first traction.
struct LeadingLoad {
    std::string quantity;          ///< "pressure" or "traction"
    double value_Pa = 0;           ///< at load factor 1
};
/// value_Pa is 0 for a case without loads.
[[nodiscard]] inline LeadingLoad leading_load(const Case& input) {
    if (!input.loads.empty()) return {"pressure", input.loads.front().pressure_Pa};
    if (input.tractions.empty()) return {"pressure", 0.0};
    const auto& t = input.tractions.front().traction_Pa;
    return {"traction", std::hypot(t[0], t[1], t[2])};
}

}  // namespace soft::model
