#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "core/text.hpp"

namespace soft::verification {
namespace {

using Cells = std::vector<std::string>;

std::string fixed_text(double value, int digits) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.setf(std::ios::fixed);
    text.precision(digits);
    text << value;
    const std::string shown = text.str();
    return shown.find_first_not_of("-0.") == std::string::npos && shown.front() == '-' ? shown.substr(1)
                                                                                       : shown;  // no -0.0000
}

/// nullopt for text that is not a number.
std::optional<double> as_number(const std::string& text) {
    if (text.empty()) return {};
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() + text.size()) return {};
    return value;
}

bool same(const std::string& a, const std::string& b) {
    if (a == b) return true;
    const auto x = as_number(a), y = as_number(b);
    if (!x || !y) return false;
    const double larger = std::max(std::abs(*x), std::abs(*y));
    const double unit = std::pow(10.0, std::floor(std::log10(larger)) - 4);  // of the fifth digit
    return std::abs(*x - *y) <= unit * (1.0 + 1e-9);
}

bool is_compared(const std::string& heading) {
    return heading != "time [s]" && heading.find("error") == std::string::npos;
}

std::string markdown_line(const Cells& cells) {
    std::string line = "|";
    for (const auto& cell : cells) line += ' ' + cell + " |";
    return line + '\n';
}

std::string markdown_table(const Cells& header, const std::vector<Cells>& lines) {
    std::string text = markdown_line(header) + '|';
    for (std::size_t i = 0; i < header.size(); ++i) text += "---|";
    text += '\n';
    for (const auto& line : lines) text += markdown_line(line);
    return text;
}

Cells split_line(const std::string& line) {
    Cells cells;
    std::size_t begin = line.find('|') + 1;
    for (std::size_t end = line.find('|', begin); end != std::string::npos; end = line.find('|', begin)) {
        std::string cell = line.substr(begin, end - begin);
        cell.erase(0, cell.find_first_not_of(' '));
        cell.erase(cell.find_last_not_of(' ') + 1);
        cells.push_back(cell);
        begin = end + 1;
    }
    return cells;
}

std::string aligned(const Cells& header, const std::vector<Cells>& lines) {
    std::vector<std::size_t> width;
    for (const auto& cell : header) width.push_back(cell.size());
    for (const auto& line : lines)
        for (std::size_t i = 0; i < line.size() && i < width.size(); ++i) width[i] = std::max(width[i], line[i].size());
    std::string text;
    const auto add = [&](const Cells& cells) {
        std::string line;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            line += cells[i];
            if (i + 1 < cells.size()) line += std::string(width[i] - cells[i].size() + 2, ' ');
        }
        text += line + '\n';
    };
    add(header);
    for (const auto& line : lines) add(line);
    return text;
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::vector<std::string> groups_of(std::span<const Report> reports) {
    std::vector<std::string> groups;
    for (const auto& report : reports)
        if (std::find(groups.begin(), groups.end(), report.problem->group) == groups.end())
            groups.push_back(report.problem->group);
    return groups;
}

struct Group {
    std::vector<Cells> rows;
    std::vector<Table> tables;
    std::vector<std::string> reasons;
};
Group collect(std::span<const Report> reports, const std::string& name) {
    Group group;
    for (const auto& report : reports) {
        if (report.problem->group != name) continue;
        group.rows.insert(group.rows.end(), report.rows.begin(), report.rows.end());
        group.tables.insert(group.tables.end(), report.tables.begin(), report.tables.end());
        group.reasons.insert(group.reasons.end(), report.reasons.begin(), report.reasons.end());
    }
    return group;
}

constexpr const char* introduction =
    "# Verification\n\n"
    "`make verify` computes every number below from a design in `designs/verification/`. A test checks that this file agrees\n"
    "with the computed values to five digits, except for times. The test evaluates *closed form* and *quadrature* references\n"
    "from the formula. *Independent code* is the reference code of the specification, with its error in brackets. The tolerance\n"
    "is 0.1 % (0.01 % for homogeneous states); larger tolerances are listed below the table with a reason.\n"
    "`make verify` writes this file; the last sections come from `notes.md`.\n";

}  // namespace

const std::vector<std::string>& row_header() {
    static const Cells header{"case", "quantity", "reference", "source", "ours", "error [%]", "mesh", "time [s]"};
    return header;
}

std::string printed_number(double value) { return core::rounded_text(value, 6); }

Report make_report(const Problem& problem, const Outcome& outcome) {
    Report report{&problem, {}, outcome.tables, {}, true};
    for (const Row& row : outcome.rows) {
        report.rows.push_back({problem.name, row.quantity, printed_number(row.reference), row.source,
                               printed_number(row.ours), fixed_text(100 * row.error(), 4), row.mesh,
                               fixed_text(row.seconds, 2)});
        if (row.tolerance > default_tolerance)
            report.reasons.push_back(problem.name + ", " + row.quantity + ": within " +
                                     core::rounded_text(100 * row.tolerance, 2) + " %: " + row.reason);
    }
    return report;
}

Report kept_report(const Problem& problem, const Printed& printed) {
    Report report{&problem, {}, {}, {}, false};
    if (const auto rows = printed.rows.find(problem.name); rows != printed.rows.end()) report.rows = rows->second;
    for (const auto& [title, lines] : printed.tables)
        if (title.starts_with(problem.name))
            report.tables.push_back({title, printed.text.at(title), printed.header.at(title), lines});
    for (const auto& reason : printed.reasons)
        if (reason.starts_with(problem.name + ", ")) report.reasons.push_back(reason);
    return report;
}

void keep_unchanged_lines(Report& report, const Printed& printed) {
    const auto keep = [](const Cells& header, const std::map<std::string, std::vector<Cells>>& kept,
                         const std::string& title, std::vector<Cells>& lines) {
        const auto found = kept.find(title);
        if (found == kept.end()) return;
        for (Cells& line : lines)
            for (const Cells& old : found->second)
                if (differences(header, {old}, {line}).empty()) {
                    line = old;
                    break;
                }
    };
    keep(row_header(), printed.rows, report.problem->name, report.rows);
    for (Table& table : report.tables) keep(table.header, printed.tables, table.title, table.lines);
}

Printed parse_markdown(const std::string& text) {
    Printed printed;
    std::istringstream stream(text);
    std::string line, title;
    bool in_table = false, of_rows = false;  // untitled tables with another header belong to the notes
    while (std::getline(stream, line)) {
        if (line.starts_with("#")) {
            title = line.starts_with("### ") ? line.substr(4) : "";
            in_table = false;
        } else if (line.starts_with("|---")) {
            in_table = true;
        } else if (line.starts_with("|")) {
            const Cells cells = split_line(line);
            if (!in_table) {
                of_rows = cells == row_header();
                if (!title.empty()) printed.header[title] = cells;
            } else if (!title.empty()) {
                printed.tables[title].push_back(cells);
            } else if (of_rows) {
                printed.rows[cells.front()].push_back(cells);
            }
        } else if (line.starts_with("- ") && title.empty()) {
            printed.reasons.push_back(line.substr(2));
        } else if (!title.empty() && !line.empty() && !in_table) {
            auto& paragraph = printed.text[title];
            paragraph += (paragraph.empty() ? "" : "\n") + line;
        } else {
            in_table = false;
        }
    }
    return printed;
}

std::string markdown_text(std::span<const Report> reports, const std::string& notes) {
    std::string text = introduction;
    for (const auto& name : groups_of(reports)) {
        const Group group = collect(reports, name);
        if (group.rows.empty() && group.tables.empty()) continue;
        text += "\n## " + name + "\n";
        if (!group.rows.empty()) text += '\n' + markdown_table(row_header(), group.rows);
        if (!group.reasons.empty()) text += "\nTolerances above 0.1 %, with the reason:\n\n";
        for (const auto& reason : group.reasons) text += "- " + reason + '\n';
        for (const auto& table : group.tables)
            text += "\n### " + table.title + "\n\n" + table.text + "\n\n" + markdown_table(table.header, table.lines);
    }
    return text + '\n' + notes;
}

std::string csv_text(std::span<const Report> reports) {
    const auto line_of = [](Cells cells) {
        for (auto& cell : cells) cell = csv_cell(cell);
        return core::join(cells, ",") + '\n';
    };
    std::string text = line_of(row_header());
    for (const auto& report : reports)
        for (const auto& row : report.rows) text += line_of(row);
    return text;
}

std::string plain_text(std::span<const Report> reports) {
    std::string text;
    for (const auto& name : groups_of(reports)) {
        const Group group = collect(reports, name);
        if (group.rows.empty() && group.tables.empty()) continue;
        text += '\n' + name + '\n';
        if (!group.rows.empty()) text += aligned(row_header(), group.rows);
        for (const auto& reason : group.reasons) text += "  " + reason + '\n';
        for (const auto& table : group.tables)
            text += '\n' + table.title + '\n' + table.text + '\n' + aligned(table.header, table.lines);
    }
    return text;
}

std::vector<std::string> differences(const Cells& header, const std::vector<Cells>& expected,
                                     const std::vector<Cells>& computed) {
    if (expected.size() != computed.size())
        return {"README.md has " + std::to_string(expected.size()) + " lines, the computed table " +
                std::to_string(computed.size())};
    std::vector<std::string> found;
    for (std::size_t i = 0; i < computed.size(); ++i)
        for (std::size_t k = 0; k < header.size(); ++k) {
            if (!is_compared(header[k])) continue;
            const std::string there = k < expected[i].size() ? expected[i][k] : "nothing";
            const std::string here = k < computed[i].size() ? computed[i][k] : "nothing";
            if (!same(there, here))
                found.push_back(computed[i][0] + ", " + header[k] + ": README.md has " + there + ", computed " + here);
        }
    return found;
}

}  // namespace soft::verification
