#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "table/table.hpp"

namespace soft::table {
namespace {

std::string refusal(std::string_view text) {
    try {
        static_cast<void>(read_table(text, "m.csv"));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

TEST(ReadTable, FindsTheDelimiter) {
    for (const std::string_view text : {"a,b\n1,2.5\n3,4\n", "a;b\n1;2,5\n3;4\n", "a\tb\n1\t2,5\n3\t4\n",
                                        "a|b\n1|2.5\n3|4\n", "a   b\n 1\t 2.5\n3 4\n",
                                        "\xEF\xBB\xBF"
                                        "a,b\r\n1,2.5\r\n3,4"}) {
        const Table table = read_table(text, "m.csv");
        ASSERT_EQ(table.headings.size(), 2u) << text;
        EXPECT_EQ(table.headings[0].name, "a");
        EXPECT_EQ(numbers(table, 0), (std::vector<double>{1, 3})) << text;
        EXPECT_EQ(numbers(table, 1), (std::vector<double>{2.5, 4})) << text;
    }
}

TEST(ReadTable, PrefersTheSemicolonToTheDecimalComma) {
    const Table table = read_table("0,5;1,25\n1,5;2,25\n", "m.csv");
    EXPECT_TRUE(table.headings.empty());
    EXPECT_EQ(numbers(table, 1), (std::vector<double>{1.25, 2.25}));
}

TEST(ReadTable, LeavesCommentsAndEmptyLinesOutAndKeepsTheLineNumbers) {
    const Table table = read_table("# made by hand\n\npressure_kPa,elongation_mm\n1,2\n\n# a pause\n3,4\n", "m.csv");
    EXPECT_EQ(table.lines, (std::vector<std::size_t>{4, 7}));
    EXPECT_EQ(table.rows.size(), 2u);
}

TEST(ReadTable, QuotedCellsMayHoldDelimitersQuotesAndLineBreaks) {
    const Table table = read_table("\"Pressure, kPa\",\"the \"\"big\"\" one\nin mm\"\n1,2\n", "m.csv");
    ASSERT_EQ(table.headings.size(), 2u);
    EXPECT_EQ(table.headings[0].quantity, "Pressure");
    EXPECT_EQ(table.headings[0].unit, "kPa");
    EXPECT_EQ(table.headings[1].name, "the \"big\" one\nin mm");
    EXPECT_EQ(table.lines, (std::vector<std::size_t>{3}));
}

TEST(ReadTable, TakesALineOfUnitsBelowTheHeader) {
    const Table table = read_table("Time,Load,Extension\n(s),(N),(mm)\n0,1,2\n", "m.csv");
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.headings[0].unit, "s");
    EXPECT_EQ(table.headings[2].unit, "mm");
}

TEST(ReadTable, ADelimiterAtTheEndOfALineIsNoCell) { EXPECT_EQ(read_table("a,b\n1,2,\n3,4,\n", "m.csv").width(), 2u); }

TEST(ReadTable, RefusesALineOfAnotherWidthByItsNumber) {
    EXPECT_EQ(refusal("a,b\n1,2\n3,4\n5\n6,7\n"),
              "m.csv:4: has 1 cells, the first line has 2; put # before lines that are no data");
}

TEST(ReadTable, RefusesAnOpenQuoteWhereItBegins) {
    EXPECT_EQ(refusal("a,b\n1,2\n3,\"4\n5,6\n"), "m.csv:3: a quote is opened and not closed");
}

TEST(ReadTable, RefusesFilesWithoutData) {
    for (const std::string_view text : {"", "\n\n", "# nothing\n", "a,b\n", "a,b\n(mm),(kPa)\n"})
        EXPECT_EQ(refusal(text), "m.csv: holds no row of numbers") << text;
    EXPECT_EQ(refusal("\xFF\xFE"
                      "a"),
              "m.csv: is UTF-16 text; save it as CSV in UTF-8");
}

}  // namespace
}  // namespace soft::table
