#pragma once
/// The verification table as text, CSV and Markdown, and the parser for the Markdown: README.md is both the document for readers and the
/// reference of the test.
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "problem.hpp"

namespace soft::verification {

/// The result of one problem, or the lines from README.md for a problem that was not run.
struct Report {
    const Problem* problem;
    std::vector<std::vector<std::string>> rows;  ///< cells as printed, in the order of row_header()
    std::vector<Table> tables;
    std::vector<std::string> reasons;  ///< of rows with a tolerance above the default
    bool computed = true;
};

/// case, quantity, reference, source, ours, error, mesh, time.
[[nodiscard]] const std::vector<std::string>& row_header();

[[nodiscard]] Report make_report(const Problem& problem, const Outcome& outcome);

/// The parts of a README by problem and by the title of a table.
struct Printed {
    std::map<std::string, std::vector<std::vector<std::string>>> rows;    ///< by case, in order
    std::map<std::string, std::vector<std::vector<std::string>>> tables;  ///< by title, without header
    std::map<std::string, std::vector<std::string>> header;               ///< by title
    std::map<std::string, std::string> text;                              ///< by title
    std::vector<std::string> reasons;                                     ///< "case, quantity: ..."
};
[[nodiscard]] Printed parse_markdown(const std::string& text);

/// The lines from README.md for a problem that was not run.
[[nodiscard]] Report kept_report(const Problem& problem, const Printed& printed);

/// Replaces computed lines by those of README.md if they agree (see `differences`), so that times change only with a result.
void keep_unchanged_lines(Report& report, const Printed& printed);

/// All reports as Markdown, with `notes` (hand-written) at the end.
[[nodiscard]] std::string markdown_text(std::span<const Report> reports, const std::string& notes);
[[nodiscard]] std::string csv_text(std::span<const Report> reports);
/// All reports as plain text in aligned columns.
[[nodiscard]] std::string plain_text(std::span<const Report> reports);

/// Differences between two lists of printed cells, one sentence each: numbers may differ by one unit in the fifth digit.
/// Columns whose header names an error or a time are not compared.
[[nodiscard]] std::vector<std::string> differences(const std::vector<std::string>& header,
                                                   const std::vector<std::vector<std::string>>& expected,
                                                   const std::vector<std::vector<std::string>>& computed);

/// A number as it is printed: six digits, no trailing zeros.
[[nodiscard]] std::string printed_number(double value);

}  // namespace soft::verification
