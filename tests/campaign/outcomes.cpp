#include "outcomes.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "confirm.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "geometry/build.hpp"
#include "sweep/outcome.hpp"

namespace soft::campaign {
namespace {

constexpr int exit_cpu_limit = 128 + 24;  // SIGXCPU
constexpr int exit_timeout = 124;         // exit code of timeout
constexpr int max_slowest = 10;

std::string text_of(const std::filesystem::path& file) {
    const core::Bytes bytes = core::read_file(file);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Sum of user and system time in lines such as "mesh_gen_s user system wall".
double cpu_of(const std::string& status) {
    std::istringstream lines(status);
    double sum = 0, user = 0, system = 0;
    for (std::string line, name; std::getline(lines, line);) {
        std::istringstream words(line);
        if (words >> name >> user >> system && name.ends_with("_s")) sum += user + system;
    }
    return sum;
}

std::string percent(std::ptrdiff_t part, std::size_t whole) {
    return core::rounded_text(100.0 * static_cast<double>(part) / static_cast<double>(whole), 3) + " %";
}

/// Table of counts by a property of each row and by stop reason.
template <class Word>
std::string table_by(const std::vector<Outcome>& outcomes, const std::string& title, Word word_of) {
    std::map<std::string, std::map<std::string, int>> counts;
    std::map<std::string, int> all;
    std::map<std::string, double> cpu;
    for (const Outcome& outcome : outcomes) {
        ++counts[word_of(outcome)][outcome.reason];
        ++all[outcome.reason];
        cpu[word_of(outcome)] += outcome.cpu_s;
    }
    std::string text = "| " + title + " | designs |", rule = "|---|---|";
    for (const auto& [reason, count] : all) text += " " + reason + " |", rule += "---|";
    text += " CPU s per design |\n" + rule + "---|\n";
    const auto row = [&](const std::string& word, const std::map<std::string, int>& of, double cpu_s) {
        int sum = 0;
        for (const auto& [reason, count] : of) sum += count;
        text += "| " + word + " | " + std::to_string(sum) + " |";
        for (const auto& [reason, count] : all)
            text += " " + (of.contains(reason) ? std::to_string(of.at(reason)) : std::string{}) + " |";
        text += " " + core::rounded_text(cpu_s / sum, 2) + " |\n";
    };
    double cpu_s = 0;
    for (const auto& [word, of] : counts) row(word, of, cpu[word]), cpu_s += cpu[word];
    row("all", all, cpu_s);
    return text + "\n";
}

}  // namespace

std::vector<PlannedDesign> read_plan(const std::filesystem::path& file) {
    std::ifstream lines(file);
    std::vector<PlannedDesign> plan;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string index;
        PlannedDesign row;
        std::getline(words, index, ',');
        std::getline(words, row.id, ',');
        std::getline(words, row.family, ',');
        std::getline(words, row.law, ',');
        std::getline(words, row.load, ',');
        row.index = std::stoi(index);
        plan.push_back(std::move(row));
    }
    return plan;
}

Outcome outcome_of(const std::filesystem::path& folder, const PlannedDesign& design) {
    Outcome outcome;
    outcome.design = design;
    const std::filesystem::path own = folder / design.id;
    if (!std::filesystem::exists(own / "status")) return outcome;
    const std::string text = text_of(own / "status");
    const auto status = sweep::read_status(text);
    if (!status) return outcome;
    outcome.exit_code = status->exit_code;
    outcome.cpu_s = cpu_of(text);
    outcome.detail = status->error;
    if (outcome.exit_code != 0 && outcome.exit_code != 2) {
        outcome.reason = outcome.exit_code == exit_cpu_limit || outcome.exit_code == exit_timeout ? "hangs"
                         : outcome.exit_code == 65                                                ? "refused"
                         : outcome.exit_code > 128                                                ? "killed"
                                                                                                  : "failed";
        return outcome;
    }
    const io::Result result =
        io::read_result(core::read_file(own / "result.h5"), (own / "result.h5").string(), geometry::rebuild_case);
    outcome.rows = static_cast<int>(result.steps.size());
    if (!result.steps.empty()) outcome.stretch = result.steps.back().stretch_p99;
    if (result.end) outcome.reason = model::name(result.end->reason);
    const Verdict verdict = confirm(result);
    // The exit code must agree with the stop reason.
    outcome.confirmed = verdict.confirmed && (outcome.exit_code == 0) == (outcome.reason == "done");
    outcome.detail = verdict.reason;
    return outcome;
}

std::string outcomes_csv(const std::vector<Outcome>& outcomes) {
    std::string text = "index,id,family,law,load,exit_code,stop_reason,confirmed,rows,stretch_p99,cpu_s,said\n";
    for (const Outcome& o : outcomes) {
        std::string detail = o.detail;
        std::ranges::replace(detail, '"', '\'');
        text += std::to_string(o.design.index) + "," + o.design.id + "," + o.design.family + "," + o.design.law + "," +
                o.design.load + "," + std::to_string(o.exit_code) + "," + o.reason + "," + (o.confirmed ? "1" : "0") +
                "," + std::to_string(o.rows) + "," + core::rounded_text(o.stretch, 4) + "," +
                core::rounded_text(o.cpu_s, 3) + ",\"" + detail + "\"\n";
    }
    return text;
}

std::string outcomes_markdown(const std::vector<Outcome>& outcomes) {
    const auto count = [&](auto what) { return std::ranges::count_if(outcomes, what); };
    double cpu_s = 0;
    for (const Outcome& o : outcomes) cpu_s += o.cpu_s;
    const auto unconfirmed = count([](const Outcome& o) { return !o.confirmed; });
    const auto diverged = count([](const Outcome& o) { return o.reason == "diverged"; });
    std::string text = std::to_string(outcomes.size()) + " designs, " + core::rounded_text(cpu_s / 60, 3) +
                       " CPU minutes; `diverged` " + std::to_string(diverged) + " (" +
                       percent(diverged, outcomes.size()) + "), reason not confirmed " + std::to_string(unconfirmed) +
                       " (" + percent(unconfirmed, outcomes.size()) + ").\n\n";
    text += table_by(outcomes, "family", [](const Outcome& o) { return o.design.family; });
    text += table_by(outcomes, "law", [](const Outcome& o) { return o.design.law; });
    text += table_by(outcomes, "load", [](const Outcome& o) { return o.design.load; });
    text +=
        "| not confirmed | family | law | load | stop_reason | rows | reason given by the check |\n|---|---|---|---|---|---|---|\n";
    for (const Outcome& o : outcomes)
        if (!o.confirmed)
            text += "| " + std::to_string(o.design.index) + " | " + o.design.family + " | " + o.design.law + " | " +
                    o.design.load + " | " + o.reason + " | " + std::to_string(o.rows) + " | " + o.detail + " |\n";
    std::vector<Outcome> slowest = outcomes;
    std::ranges::stable_sort(slowest, std::greater{}, &Outcome::cpu_s);
    slowest.resize(std::min<std::size_t>(slowest.size(), max_slowest));
    text += "\n| slowest | family | law | load | stop_reason | rows | CPU s |\n|---|---|---|---|---|---|---|\n";
    for (const Outcome& o : slowest)
        text += "| " + std::to_string(o.design.index) + " | " + o.design.family + " | " + o.design.law + " | " +
                o.design.load + " | " + o.reason + " | " + std::to_string(o.rows) + " | " +
                core::rounded_text(o.cpu_s, 3) + " |\n";
    return text;
}

}  // namespace soft::campaign
