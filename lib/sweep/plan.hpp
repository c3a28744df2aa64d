#pragma once
/// The designs of a sweep, each checked and identified by a hash of its content. Tested by sweep/plan_test.
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/sweep.hpp"

namespace soft::sweep {

/// The inputs that all designs of a sweep share.
struct PlanInput {
    std::string_view design_text;
    std::string_view design_source;  ///< file name, for errors and to resolve files that the design names
    std::span<const design::FamilyKeys> families;
    std::string_view programs;  ///< versions of the programs that will run the designs; part of the identifier
    /// Throws Error(bad_input) for an invalid geometry. Such a design is always a row of the plan, never an error of the sweep.
    std::function<void(const design::Design&)> check_geometry = {};
};

struct PlannedDesign {
    /// 16 hex digits of the SHA-256 of the effective design (with the content of a mesh file, not its name) and of the programs.
    /// For a refused design, of the design text and the settings instead.
    std::string id;
    std::vector<std::string> values;  ///< one per factor, as written in a design
    /// Effective design with absolute file paths; empty if refused. Its first line is "# sensitivity: KEY,KEY" if the sweep requests
    /// derivatives that the design has; scripts/sweep-design passes them to mesh-gen.
    std::string design_yaml;
    std::string refusal;            ///< one line; empty for a valid design
    bool geometry_refused = false;  ///< refused by PlanInput::check_geometry instead of by the keys of the design
};

struct Plan {
    std::vector<PlannedDesign> designs;  ///< in a grid the last factor varies fastest; designs may be equal
};

/// Whether `id` is a valid design identifier: 16 hex digits.
[[nodiscard]] bool is_design_id(std::string_view id) noexcept;

/// Makes the designs of a sweep. A refused combination of values becomes a row with its refusal. Throws Error(bad_input), as
/// read_design does, if no design has a number under `sensitivity`, if all designs are refused, if a listed value is refused in all designs that have it, or if an end of a range
/// is refused in the first valid design.
[[nodiscard]] Plan make_plan(const Sweep& sweep, const PlanInput& input);

/// The values of the factors of each design, before any check.
[[nodiscard]] std::vector<std::vector<std::string>> sampled_values(const Sweep& sweep);

/// The arguments that make mesh-gen produce this design: "--set mesh.size=3mm --set 'geometry.cap=4 mm'".
[[nodiscard]] std::string settings_text(const Sweep& sweep, const PlannedDesign& design);

}  // namespace soft::sweep
