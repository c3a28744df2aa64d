#pragma once
/// What became of the designs of a campaign, one row each, and the tables of tests/campaign/README.md.
#include <filesystem>
#include <string>
#include <vector>

namespace soft::campaign {

/// As `campaign draw` prints it: index,id,family,law,load,refused.
struct Planned {
    int index = 0;
    std::string id, family, law, load;
};
[[nodiscard]] std::vector<Planned> read_plan(const std::filesystem::path& file);

struct Outcome {
    Planned design;
    int exit_code = -1;
    std::string reason = "not_computed";  ///< stop_reason; else killed, hangs, refused, failed
    double cpu_s = 0;                     ///< mesh-gen and solve
    int rows = 0;
    double stretch = 1;  ///< of the last row, exceeded in 1 % of the rubber
    bool confirmed = false;
    std::string said;  ///< by the confirmation, or the error
};
/// Of the design in FOLDER/<id>, as scripts/sweep-design has left it.
[[nodiscard]] Outcome outcome_of(const std::filesystem::path& folder, const Planned& design);

[[nodiscard]] std::string outcomes_csv(const std::vector<Outcome>& outcomes);
[[nodiscard]] std::string outcomes_markdown(const std::vector<Outcome>& outcomes);

}  // namespace soft::campaign
