#pragma once
/// Outcomes of the designs of a campaign, one row each, and the tables of tests/campaign/README.md.
#include <filesystem>
#include <string>
#include <vector>

namespace soft::campaign {

/// A line printed by `campaign draw`: index,id,family,law,load,refused.
struct PlannedDesign {
    int index = 0;
    std::string id, family, law, load;
};
[[nodiscard]] std::vector<PlannedDesign> read_plan(const std::filesystem::path& file);

struct Outcome {
    PlannedDesign design;
    int exit_code = -1;
    std::string reason = "not_computed";  ///< stop_reason, or killed, hangs, refused, failed
    double cpu_s = 0;                     ///< mesh-gen and solve
    int rows = 0;
    double stretch = 1;  ///< in the last row, exceeded in 1 % of the rubber
    bool confirmed = false;
    std::string detail;  ///< text of the confirmation, or the error
};
/// Outcome of the design in FOLDER/<id>, as written by scripts/sweep-design.
[[nodiscard]] Outcome outcome_of(const std::filesystem::path& folder, const PlannedDesign& design);

[[nodiscard]] std::string outcomes_csv(const std::vector<Outcome>& outcomes);
[[nodiscard]] std::string outcomes_markdown(const std::vector<Outcome>& outcomes);

}  // namespace soft::campaign
