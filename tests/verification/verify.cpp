// verify [--list | --brief | WORDS]: computes the verification table, prints it, and writes results/verification.csv and
// tests/verification/README.md of the source tree. --brief keeps the lines of slow problems from README.md. With WORDS only the
// problems whose "group: name" contains them are computed, and nothing is written. Exit code 1 if a row exceeds its tolerance.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "linalg/session.hpp"
#include "problem.hpp"
#include "table.hpp"

namespace {

using namespace soft::verification;

const std::string root = SOFT_SOURCE_DIR;

std::string read_text(const std::string& path) {
    std::ifstream stream(path);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

void write_text(const std::string& path, const std::string& text) {
    std::ofstream stream(path);
    stream << text;
    if (!stream.flush()) throw std::runtime_error("cannot write " + path);
}

struct Result {
    std::vector<Report> reports;
    int misses = 0;
};

enum class Slow { computed, kept };

Result compute(const std::vector<Problem>& problems, const Printed& printed, Slow slow) {
    Result result;
    for (const Problem& problem : problems) {
        std::cerr << problem.group << ": " << problem.name << std::endl;
        const bool is_skipped = problem.duration == Duration::slow && slow == Slow::kept;
        if (is_skipped || !can_run(problem)) {
            std::cerr << "  kept from README.md"
                      << (is_skipped ? std::string() : ": set " + problem.needs + " to the required folder")
                      << std::endl;
            result.reports.push_back(kept_report(problem, printed));
            continue;
        }
        try {
            const Outcome outcome = problem.solve();
            for (const Row& row : outcome.rows)
                if (!row.is_within_tolerance()) {
                    ++result.misses;
                    std::cerr << "  EXCEEDS TOLERANCE: " << row.quantity << ": " << row.ours << " for " << row.reference
                              << ", " << 100 * row.error() << " %" << std::endl;
                }
            result.reports.push_back(make_report(problem, outcome));
        } catch (const std::exception& error) {
            ++result.misses;
            std::cerr << "  FAILED: " << error.what() << std::endl;
            result.reports.push_back(kept_report(problem, printed));
        }
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    std::string words = argc > 1 ? argv[1] : "";
    const Slow slow = words == "--brief" ? Slow::kept : Slow::computed;
    if (words == "--brief") words.clear();
    auto problems = all_problems();
    if (words == "--list") {
        for (const auto& problem : problems) std::cout << problem.group << ": " << problem.name << '\n';
        return 0;
    }
    std::erase_if(problems, [&](const Problem& problem) {
        return (problem.group + ": " + problem.name).find(words) == std::string::npos;
    });
    try {
        const soft::linalg::Session session({});
        const std::string readme = root + "/tests/verification/README.md";
        const Printed printed = parse_markdown(read_text(readme));
        auto result = compute(problems, printed, slow);
        std::cout << plain_text(result.reports);
        if (words.empty()) {
            std::filesystem::create_directories(root + "/results");
            write_text(root + "/results/verification.csv", csv_text(result.reports));
            for (Report& report : result.reports) keep_unchanged_lines(report, printed);
            write_text(readme, markdown_text(result.reports, read_text(root + "/tests/verification/notes.md")));
        }
        if (result.misses > 0) std::cerr << result.misses << " rows exceed their tolerance" << std::endl;
        return result.misses > 0 ? 1 : 0;
    } catch (const std::exception& error) {
        std::cerr << "verify: " << error.what() << std::endl;
        return 1;
    }
}
