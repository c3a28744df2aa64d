/// campaign: draws random designs and collects their outcomes. scripts/campaign runs the designs.
///     campaign draw SEED FIRST LAST FOLDER PROGRAMS    writes FOLDER/designs/ID.yaml; prints index,id,family,law,load,refused
///     campaign outcomes FOLDER PLAN                    writes FOLDER/outcomes.csv, prints the tables
///     campaign confirm RESULT [REASON]                 checks the stop reason of the result, or REASON instead
/// Exit code 1 of `confirm`: the reason is not confirmed; of `outcomes`: a design is not computed or its stop reason is not confirmed.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "confirm.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "draw.hpp"
#include "geometry/build.hpp"
#include "outcomes.hpp"

namespace {

using namespace soft;
namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    const core::Bytes bytes = core::read_file(file);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The id is a hash of the content, as for the designs of a sweep: existing results are not computed again.
void draw(std::uint32_t seed, int first, int last, const fs::path& folder, const std::string& programs) {
    const fs::path designs = folder / "designs";
    fs::create_directories(designs);
    for (int index = first; index <= last; ++index) {
        const campaign::Drawn drawn = campaign::draw({seed, index}, designs);
        const std::string id = core::sha256_hex(programs + drawn.design_yaml + drawn.table_text).substr(0, 16);
        std::ofstream{designs / (id + ".yaml")} << drawn.design_yaml;
        std::cout << index << ',' << id << ',' << drawn.family << ',' << drawn.law << ',' << drawn.load << ','
                  << drawn.refused << std::endl;
    }
}

int outcomes(const fs::path& folder, const fs::path& plan) {
    std::vector<campaign::Outcome> all;
    for (const campaign::PlannedDesign& design : campaign::read_plan(plan))
        all.push_back(campaign::outcome_of(folder, design));
    std::ofstream{folder / "outcomes.csv"} << campaign::outcomes_csv(all);
    std::cout << campaign::outcomes_markdown(all);
    return !all.empty() && std::ranges::all_of(all, &campaign::Outcome::confirmed) ? 0 : 1;
}

int confirm(const fs::path& file, const std::string& claimed) {
    io::Result result = io::read_result(core::read_file(file), file.string(), geometry::rebuild_case);
    if (!claimed.empty()) {
        using enum model::StopReason;
        const auto reasons = {done, limit_point, diverged, inverted_element, self_contact, step_limit};
        const auto named = std::ranges::find(reasons, claimed, [](model::StopReason r) { return model::name(r); });
        if (named == reasons.end() || !result.end) throw std::runtime_error("unknown stop reason " + claimed);
        result.end->reason = *named;
    }
    const campaign::Verdict verdict = campaign::confirm(result);
    std::cout << (verdict.confirmed ? "confirmed: " : "not confirmed: ") << verdict.reason << "\n";
    return verdict.confirmed ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    try {
        if (words.size() == 6 && words[0] == "draw") {
            draw(static_cast<std::uint32_t>(std::stoul(words[1])), std::stoi(words[2]), std::stoi(words[3]), words[4],
                 text_of(words[5]));
            return 0;
        }
        if (words.size() >= 2 && words.size() <= 3 && words[0] == "confirm")
            return confirm(words[1], words.size() > 2 ? words[2] : "");
        if (words.size() == 3 && words[0] == "outcomes") return outcomes(words[1], words[2]);
    } catch (const std::exception& error) {
        std::cerr << "campaign: " << error.what() << "\n";
        return 70;
    }
    std::cerr << "campaign: draw SEED FIRST LAST FOLDER PROGRAMS | confirm RESULT [REASON] | outcomes FOLDER PLAN\n";
    return 64;
}
