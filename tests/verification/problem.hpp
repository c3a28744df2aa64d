#pragma once
/// The verification problems. A problem runs a design once or a few times and compares the results with reference values. The tests and
/// the program `verify` use the same list of problems.
#include <functional>
#include <string>
#include <vector>

#include "run_design.hpp"

namespace soft::verification {

/// Relative tolerance of every quantity with a reference, 0.1 %. Rows with a larger tolerance state a reason.
inline constexpr double default_tolerance = 1e-3;
/// Relative tolerance of homogeneous states, which do not depend on the mesh.
inline constexpr double homogeneous_tolerance = 1e-4;

/// One quantity and its reference.
struct Row {
    std::string quantity;  ///< name with unit, "stretch at 300 kPa [-]"; unique within the problem
    double reference = 0;
    std::string source;  ///< formula or author of the reference
    double ours = 0;
    std::string mesh;  ///< "32 hexahedron27, 1234 unknowns"
    double seconds = 0;
    double tolerance = default_tolerance;  ///< relative
    std::string reason = {};  ///< required for a tolerance above `default_tolerance`; printed below the table

    [[nodiscard]] double error() const { return ours / reference - 1.0; }
    [[nodiscard]] bool is_within_tolerance() const;
};

/// A table in addition to the rows: values that are compared with each other, not with a reference.
struct Table {
    std::string title;  ///< unique
    std::string text;   ///< one paragraph: the quantities shown and how they are measured
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> lines;
};

struct Outcome {
    std::vector<Row> rows;
    std::vector<Table> tables;
};

enum class Duration { brief, slow };

struct Problem {
    std::string group;  ///< heading of its table
    std::string name;   ///< entry of the column 'case'; unique
    std::function<Outcome()> solve;
    Duration duration = Duration::brief;
    std::string needs = {};  ///< environment variable with the folder that the problem requires
};

/// False if the environment variable `needs` is not set.
[[nodiscard]] bool can_run(const Problem& problem);

[[nodiscard]] std::vector<Problem> homogeneous_problems();
[[nodiscard]] std::vector<Problem> inflation_problems();
[[nodiscard]] std::vector<Problem> long_tube_problems();
[[nodiscard]] std::vector<Problem> fiber_tube_problems();
[[nodiscard]] std::vector<Problem> limit_point_problems();
[[nodiscard]] std::vector<Problem> branch_problems();
[[nodiscard]] std::vector<Problem> snap_problems();
[[nodiscard]] std::vector<Problem> actuator_problems();
[[nodiscard]] std::vector<Problem> family_problems();
[[nodiscard]] std::vector<Problem> work_problems();
[[nodiscard]] std::vector<Problem> closing_wall_problems();
[[nodiscard]] std::vector<Problem> panel_problems();
[[nodiscard]] std::vector<Problem> sheared_layer_problems();
[[nodiscard]] std::vector<Problem> sample_problems();
[[nodiscard]] std::vector<Problem> locking_problems();
[[nodiscard]] std::vector<Problem> published_mesh_problems();
[[nodiscard]] std::vector<Problem> motion_problems();
[[nodiscard]] std::vector<Problem> error_bar_problems();
[[nodiscard]] std::vector<Problem> reaction_problems();
[[nodiscard]] std::vector<Problem> contact_problems();
[[nodiscard]] std::vector<Problem> inelastic_problems();

/// All problems, in the order of the README.
[[nodiscard]] std::vector<Problem> all_problems();

}  // namespace soft::verification
