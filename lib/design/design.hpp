#pragma once
/// A design read from YAML: overrides applied, checked against the schema, defaults filled in, all quantities in SI units.
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

/// Checked values by key path; those of a list of quantities also one by one, "material.mu.1". Getters throw std::logic_error for a path
/// that is not in the schema (a bug).
class Values {
public:
    struct Entry {
        double number = 0;                 ///< SI; counts and flags are stored as numbers
        std::string text;                  ///< as written (choice, text), unit included for quantities
        std::string location;              ///< "designs/tube.yaml:7:9", "--set", or "default"
        bool given = false;                ///< written by the user, not a default
        std::vector<double> numbers = {};  ///< SI; all values of a list, or the single number
    };
    [[nodiscard]] double number(std::string_view path) const;
    [[nodiscard]] const std::vector<double>& numbers(std::string_view path) const;
    [[nodiscard]] int count(std::string_view path) const;
    [[nodiscard]] const std::string& text(std::string_view path) const;
    [[nodiscard]] bool given(std::string_view path) const;
    [[nodiscard]] const std::string& location(std::string_view path) const;
    [[nodiscard]] bool has(std::string_view path) const;
    /// Names directly below a group: "left", "right" for "geometry.cavities".
    [[nodiscard]] std::vector<std::string> names_below(std::string_view group) const;
    /// Paths of the keys whose value is the name of a file, not its content: "geometry.profile", "obstacles.die.surface".
    [[nodiscard]] std::vector<std::string> file_keys() const;
    /// Error (bad_input) "file:line:col: path: problem; remedy" for checks that involve several keys; the caller throws it.
    [[nodiscard]] Error refuse(std::string_view path, std::string_view problem, std::string_view remedy = {}) const;
    void set(std::string path, Entry entry);

private:
    std::map<std::string, Entry, std::less<>> entries_;
};

/// Face names in the file that defines the shape of a design.
struct FileFaces {
    std::vector<std::string> faces;
    std::vector<std::string> cavities = {};  ///< faces that are walls of separate cavities, in addition to "cavity"
};

/// A shape of obstacles: the word that selects it ("plane") and its keys, with paths relative to the obstacle. The path of the first
/// key begins with the word: "plane.point", or "surface".
struct ObstacleKeys {
    std::string name;
    std::vector<Key> keys;
};

/// Description of a family for the parser; the geometry module supplies one for each family (geometry::catalogue()).
struct FamilyKeys {
    std::string name;
    std::string summary;                         ///< one line for --list
    std::vector<Key> geometry;                   ///< keys under "geometry."
    std::vector<std::string> models;             ///< allowed values of `model`, default first
    std::vector<std::string> faces;              ///< named faces that supports, loads and outputs may refer to
    std::map<std::string, std::string> aliases;  ///< alias -> face, for example end_disc -> fixed
    /// Names of the cavities. The wall of a cavity is the face of the same name; a cavity without that face does not exist.
    std::vector<std::string> cavities = {"cavity"};
    std::string defaults;  ///< YAML of the default supports, loads and outputs
    /// Built-in materials that keys "geometry.<part>.material" may name: name -> YAML {law: ..., ...}.
    std::map<std::string, std::string> materials = {};
    std::vector<Key> mesh = {};  ///< keys under "mesh." with defaults of this family; they replace the common keys
    /// Set for a family whose shape is defined by a file: returns the face names in that file, given the value of the first key of
    /// `geometry` and its location; throws Error. `faces` are then those of the template's file. Such a family declares mesh.size
    /// itself. `geometry.cavity: [face, face]` adds the union of these faces as the face and cavity "cavity"; `geometry.cavities:
    /// {left: [face, face], ...}` adds several cavities; `geometry.faces: {name: {...}}` defines faces by position (face_rule_keys).
    std::function<FileFaces(const std::string& file, std::string_view location)> faces_of_file = {};
    /// A design is axisymmetric only if its family has the model axisymmetric. If faces_of_file is set, the design must select that
    /// model. Otherwise it is axisymmetric if this key of `geometry`, a length, is not 0, or always if the key is empty.
    std::string revolution_key = {};
    bool has_face_rules = false;               ///< whether `geometry.faces` is a group of keys; only with faces_of_file
    std::vector<ObstacleKeys> obstacles = {};  ///< the shapes that obstacles may have, the same for all families
};

struct Override {
    std::string path;           ///< "geometry.wall"
    std::string value;          ///< "2.5mm"
    std::string location = {};  ///< location for errors; empty: "--set geometry.wall"
};

struct Design {
    std::string family;
    std::string name;
    Values values;             ///< geometry.*, mesh.*, model, ... (scalars)
    model::Material material;  ///< region name "rubber"
    std::map<std::string, model::Material, std::less<>>
        materials;                         ///< materials of other regions, by their names below `materials`
    std::vector<model::Support> supports;  ///< by face name (aliases resolved); symmetry planes not included
    std::vector<model::PressureLoad> loads;
    /// along: axis | x | y | z | r | normal; of gravity axis | x | y | z, optionally with a leading minus
    struct DeadLoadRequest {
        std::string name;  ///< the face, or "gravity"
        model::DeadLoadKind kind;
        double size_SI;  ///< traction [Pa], force on the whole face of the whole actuator [N] or acceleration [m/s^2]
        std::string along;
        model::TimeFunction time_function = {};
    };
    std::vector<DeadLoadRequest> dead_loads;
    /// Prescribed displacement of an obstacle, or of a component of a face; along: axis | x | y | z | r | normal
    struct MotionRequest {
        std::string face;  ///< or the name of an obstacle
        double displacement_m;
        std::string along;
        model::TimeFunction time_function = {};
    };
    std::vector<MotionRequest> motions;
    /// Its dimensions are in `values`, below "obstacles.<name>".
    struct ObstacleRequest {
        std::string name;
        std::string shape;  ///< "plane"
    };
    std::vector<ObstacleRequest> obstacles;
    model::ContactSettings contact;
    /// along: axis | x | y | z | r | normal, or empty; `reference` is used by a bend only
    struct OutputRequest {
        std::string name;
        std::string face;
        std::string along;
        model::Measure measure = model::Measure::displacement;
        std::string reference = {};
        std::vector<double> point_m = {};  ///< two or three model coordinates; replaces the face
        std::string obstacle = {};         ///< or model::self_contact; replaces the face
    };
    std::vector<OutputRequest> outputs;
    model::PathSettings path;
    model::SolverSettings solver;
    std::optional<model::Dynamics> dynamics;  ///< nullopt: a static path
    /// Numbers of geometry, materials, loads and obstacles that are not 0, by which a derivative is possible. Without lower and higher value.
    std::vector<model::DesignParameter> parameters;
    std::string effective_yaml;  ///< canonical YAML with defaults and overrides; reading it gives the same design
    std::vector<std::string> warnings;  ///< plausibility warnings, one line each
};

/// Locking warning for first-order triangles and tetrahedra, with the measured factor. Public for meshes that are read from a file,
/// whose cell types the design does not contain.
[[nodiscard]] std::string first_order_simplex_warning();

/// Reads `text`; `source` names it in errors ("designs/tube.yaml" or "<stdin>").
/// Throws Error(bad_input) with "file:line:col: key: problem; remedy".
[[nodiscard]] Design read_design(std::string_view text, std::string_view source, std::span<const FamilyKeys> families,
                                 std::span<const Override> overrides);

/// Name of the main material in keys that refer to a material by name.
inline constexpr std::string_view main_region = "rubber";

/// Reads the effective design of a case. `built`: faces and cavities of its mesh, so that the file of a shape is not read again.
/// `overrides` are those of solve: they may change material, materials, loads, contact, path, dynamics and solver. Throws Error (usage) for
/// the sections that are built into the mesh.
[[nodiscard]] Design read_built_design(std::string_view effective_yaml, std::string_view source,
                                       std::span<const FamilyKeys> families, std::span<const Override> overrides,
                                       const FileFaces& built);

/// Resolves a file name that is written at `location`: relative to the folder of the design file, or to the working directory for
/// the command line and stdin.
[[nodiscard]] std::string file_from(std::string_view location, const std::string& file);

/// "a.b=value" -> Override; Error(usage) otherwise. `load.` is short for `loads.cavity.`.
[[nodiscard]] Override parse_override(std::string_view argument);

/// A commented, runnable design of the family: every key with its default, range and meaning.
[[nodiscard]] std::string template_yaml(const FamilyKeys& family);

/// The effective design with a comment on each key: the location where it was given or "default", and its meaning.
/// The text is itself a valid design. Errors as read_design.
[[nodiscard]] std::string explain_design(std::string_view text, std::string_view source,
                                         std::span<const FamilyKeys> families, std::span<const Override> overrides);

}  // namespace soft::design
