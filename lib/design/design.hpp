#pragma once
/// A design read from YAML: checked against the schema, defaults filled in, overrides applied, everything SI.
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "design/schema.hpp"
#include "model/case.hpp"

namespace soft::design {

/// Checked values by key path. Getters throw std::logic_error for a path that the schema does not have (a bug).
class Values {
public:
    struct Entry {
        double number = 0;                 ///< SI; counts and flags as numbers
        std::string text;                  ///< as written (choice, text), unit included for quantities
        std::string place;                 ///< "designs/tube.yaml:7:9", "--set", or "default"
        bool given = false;                ///< written by the user rather than a default
        std::vector<double> numbers = {};  ///< SI, all values of a list; of a single number that one
    };
    [[nodiscard]] double number(std::string_view path) const;
    [[nodiscard]] const std::vector<double>& numbers(std::string_view path) const;
    [[nodiscard]] int count(std::string_view path) const;
    [[nodiscard]] const std::string& text(std::string_view path) const;
    [[nodiscard]] bool given(std::string_view path) const;
    [[nodiscard]] const std::string& place(std::string_view path) const;
    [[nodiscard]] bool has(std::string_view path) const;
    /// What stands directly below a group, by name: "left", "right" of "geometry.cavities".
    [[nodiscard]] std::vector<std::string> names_below(std::string_view group) const;
    /// Error (bad_input) "file:line:col: path: problem; remedy" for a check across keys, for the families to throw.
    [[nodiscard]] Error refuse(std::string_view path, std::string_view problem, std::string_view remedy = {}) const;
    void set(std::string path, Entry entry);

private:
    std::map<std::string, Entry, std::less<>> entries_;
};

/// Names in a file that a family takes its shape from.
struct FileFaces {
    std::vector<std::string> faces;
    std::vector<std::string> cavities = {};  ///< those faces that are walls of cavities of their own, besides "cavity"
};

/// What the parser must know of a family; the geometry room supplies one for each (geometry::catalogue()).
struct FamilyKeys {
    std::string name;
    std::string summary;                         ///< one line for --list
    std::vector<Key> geometry;                   ///< keys under "geometry."
    std::vector<std::string> models;             ///< allowed values of `model`, default first
    std::vector<std::string> faces;              ///< named faces supports, loads and outputs may refer to
    std::map<std::string, std::string> aliases;  ///< other names of faces, e.g. end_disc -> fixed
    /// Names of its cavities, each that of its wall among `faces`; a cavity whose wall is no face is not there.
    std::vector<std::string> cavities = {"cavity"};
    std::string defaults;  ///< YAML of supports, loads, outputs where the design is silent
    /// Materials that keys "geometry.<part>.material" may name without the design stating them: name -> YAML {law: ..., ...}.
    std::map<std::string, std::string> materials = {};
    std::vector<Key> mesh = {};  ///< own defaults for keys under "mesh." (override the common ones)
    /// For a family whose shape stands in a file: the names of the faces in it, from what the first key of `geometry` says
    /// and the place where it says so; throws Error. `faces` then are those of the template's file. Such a family has
    /// mesh.size only among its own keys, and `geometry.cavity: [face, face]` adds the face and cavity "cavity", their union; `geometry.cavities:
    /// {left: [face, face], ...}` adds several; `geometry.faces: {name: {...}}` names faces by where they are (face_rule_keys).
    std::function<FileFaces(const std::string& file, std::string_view place)> faces_of_file = {};
    /// Bodies of revolution are those of a family with the model axisymmetric: always; where this key of `geometry`, a length, is
    /// not 0; of a file in that model alone.
    std::string revolution_key = {};
    bool has_face_rules = false;  ///< of such a family: whether `geometry.faces` is a group of keys
};

struct Override {
    std::string path;        ///< "geometry.wall"
    std::string value;       ///< "2.5mm"
    std::string place = {};  ///< where it is written, for errors; empty: "--set geometry.wall"
};

struct Design {
    std::string family;
    std::string name;
    Values values;             ///< geometry.*, mesh.*, model, ... (scalars)
    model::Material material;  ///< region name "rubber"
    std::map<std::string, model::Material, std::less<>>
        materials;                         ///< of other regions, by their names below `materials`
    std::vector<model::Support> supports;  ///< by face name (aliases resolved); symmetry planes not included
    std::vector<model::PressureLoad> loads;
    /// Dead traction [Pa] on a face, or the force [N] on the whole face of the whole actuator; along: axis | x | y | z | r | normal
    enum class Spread { per_area, whole_face };
    struct TractionRequest {
        std::string face;
        double size;
        std::string along;
        model::TimeFunction time_function = {};
        Spread spread = Spread::per_area;
    };
    std::vector<TractionRequest> tractions;
    /// along: axis | x | y | z, or one of these with a minus before it
    struct BodyForceRequest {
        std::string name;
        double acceleration_m_s2;
        std::string along;
        model::TimeFunction time_function = {};
    };
    std::vector<BodyForceRequest> body_forces;
    /// A component of a face's displacement, along: axis | x | y | z | r | normal
    struct MotionRequest {
        std::string face;
        double displacement_m;
        std::string along;
    };
    std::vector<MotionRequest> motions;
    /// along: axis | x | y | z | r | normal; `reference` of a bend alone
    struct OutputRequest {
        std::string name;
        std::string face;
        std::string along;
        model::Measure measure = model::Measure::displacement;
        std::string reference = {};
        std::vector<double> point_m = {};  ///< in place of the face: coordinates of the model, two or three
    };
    std::vector<OutputRequest> outputs;
    model::PathSettings path;
    model::SolverSettings solver;
    std::optional<model::Dynamics> dynamics;  ///< nullopt: a static path
    std::string effective_yaml;               ///< canonical, defaults and overrides in place; reads back the same
    std::vector<std::string> warnings;        ///< plausibility, one line each
};

/// The warning for first-order triangles and tetrahedra, with the measured factor; for meshes that come from a file, of
/// which a design alone does not know the cells.
[[nodiscard]] std::string first_order_simplices_lock();

/// Reads `text`; `source` names it in errors ("designs/tube.yaml" or "<stdin>").
/// Throws Error(bad_input) with "file:line:col: key: problem; remedy".
[[nodiscard]] Design read_design(std::string_view text, std::string_view source, std::span<const FamilyKeys> families,
                                 std::span<const Override> overrides);

/// The name of the main material where a key asks for one by name.
inline constexpr std::string_view main_region = "rubber";

/// Applies overrides to the keys solve may still change (material, materials, loads, path, dynamics, solver) of a case's effective design
/// and returns the changed parts; geometry, mesh, model, supports, outputs and family are refused with the reason.
/// Loads may change in size and kind, but stay on the faces and cavities that the case loads, whatever these are called.
/// What has a direction keeps the one the mesh gave it: the changed load is `factor` times the case's.
struct ScaledLoad {
    std::size_t index;  ///< into the case's list; one that is not listed is taken away
    double factor;
    model::TimeFunction time_function = {};  ///< in place of the case's
};
struct SolveChanges {
    model::Material material;
    std::map<std::string, model::Material, std::less<>> materials;
    std::vector<model::PressureLoad> loads;
    std::vector<ScaledLoad> tractions, body_forces, motions;  ///< of Case::tractions, body_forces, motions
    model::PathSettings path;
    model::SolverSettings solver;
    std::optional<model::Dynamics> dynamics;
    std::string effective_yaml;
};
[[nodiscard]] SolveChanges apply_overrides(std::string_view effective_yaml, std::span<const Override> overrides);

/// The file that a value at `place` names: one in a file is meant from that file's folder, one on the command line or stdin
/// from the working directory.
[[nodiscard]] std::string file_from(std::string_view place, const std::string& file);

/// "a.b=value" -> Override; Error(usage) otherwise. `load.` is short for `loads.cavity.`.
[[nodiscard]] Override parse_override(std::string_view argument);

/// A commented, runnable design of the family: every key with its default, range and meaning.
[[nodiscard]] std::string template_yaml(const FamilyKeys& family);

/// The effective design, each key with a comment: where it was given or that it is a default, and what it means.
/// A design itself. Errors as read_design.
[[nodiscard]] std::string explain_design(std::string_view text, std::string_view source,
                                         std::span<const FamilyKeys> families, std::span<const Override> overrides);

}  // namespace soft::design
