#pragma once
/// What is verified. A problem is one or a few runs of a design and the numbers they must give; the tests and the program
/// `verify` share the one list of problems.
#include <functional>
#include <string>
#include <vector>

#include "run_design.hpp"

namespace soft::verification {

/// A tenth of a per cent: what is promised of every number that has a reference. Looser rows give a reason.
inline constexpr double promised = 1e-3;
/// Of states that are homogeneous, so that the mesh plays no part.
inline constexpr double homogeneous = 1e-4;

/// One number against its reference.
struct Row {
    std::string quantity;  ///< with its unit, "stretch at 300 kPa [-]"; unique within the problem
    double reference = 0;
    std::string source;  ///< formula or author of the reference
    double ours = 0;
    std::string mesh;  ///< "32 hexahedron27, 1234 unknowns"
    double seconds = 0;
    double tolerance = promised;  ///< relative
    std::string reason = {};      ///< of a tolerance above `promised`; printed below the table

    [[nodiscard]] double error() const { return ours / reference - 1.0; }
    [[nodiscard]] bool holds() const;
};

/// A table beside the rows: numbers that are compared with each other rather than with a reference.
struct Table {
    std::string title;  ///< unique
    std::string text;   ///< what is shown and how it is measured; one paragraph
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> lines;
};

struct Outcome {
    std::vector<Row> rows;
    std::vector<Table> tables;
};

enum class Duration { brief, slow };

struct Problem {
    std::string group;  ///< heading of the table it stands in
    std::string name;   ///< the column 'case'; unique
    std::function<Outcome()> solve;
    Duration duration = Duration::brief;
    std::string needs = {};  ///< environment variable naming a folder, without which it cannot run
};

/// False where the folder of `needs` is not given.
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
[[nodiscard]] std::vector<Problem> contact_problems();
[[nodiscard]] std::vector<Problem> panel_problems();
[[nodiscard]] std::vector<Problem> sheared_layer_problems();
[[nodiscard]] std::vector<Problem> sample_problems();
[[nodiscard]] std::vector<Problem> locking_problems();
[[nodiscard]] std::vector<Problem> published_mesh_problems();
[[nodiscard]] std::vector<Problem> motion_problems();
[[nodiscard]] std::vector<Problem> error_bar_problems();
[[nodiscard]] std::vector<Problem> reaction_problems();

/// All of them, in the order of the README.
[[nodiscard]] std::vector<Problem> all_problems();

}  // namespace soft::verification
