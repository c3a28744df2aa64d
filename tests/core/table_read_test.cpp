#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "core/table.hpp"

namespace soft::core {
namespace {

const Format described{.layout = Layout::described};

std::string refusal(std::string_view text, const Format& format = {}) {
    try {
        static_cast<void>(read_table(text, "m.csv", format));
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

TEST(ReadTable, PrefersASemicolonOverADecimalComma) {
    const Table table = read_table("0,5;1,25\n1,5;2,25\n", "m.csv");
    EXPECT_TRUE(table.headings.empty());
    EXPECT_EQ(numbers(table, 1), (std::vector<double>{1.25, 2.25}));
}

TEST(ReadTable, ChoosesTheDelimiterThatAlsoFitsTheHeader) {
    const Table table = read_table("Pressure_kPa Elongation_mm\n1,40 20,0\n3,20 40,0\n", "m.csv");
    EXPECT_EQ(table.delimiter, ' ');
    EXPECT_EQ(numbers(table, 0), (std::vector<double>{1.4, 3.2}));
    EXPECT_EQ(read_table("p_kPa, e_mm\n1.4, 20\n", "m.csv").delimiter, ',') << "the first of equally good delimiters";
}

TEST(ReadTable, SkipsCommentsAndEmptyLinesAndKeepsTheLineNumbers) {
    const Table table = read_table("# made by hand\n\npressure_kPa,elongation_mm\n1,2\n\n# a pause\n3,4\n", "m.csv");
    EXPECT_EQ(table.lines, (std::vector<std::size_t>{4, 7}));
    EXPECT_EQ(table.rows.size(), 2u);
}

TEST(ReadTable, QuotedCellsMayContainDelimitersQuotesAndLineBreaks) {
    const Table table = read_table("\"Pressure, kPa\",\"the \"\"big\"\" one\nin mm\"\n1,2\n", "m.csv");
    ASSERT_EQ(table.headings.size(), 2u);
    EXPECT_EQ(table.headings[0].quantity, "Pressure");
    EXPECT_EQ(table.headings[0].unit, "kPa");
    EXPECT_EQ(table.headings[1].name, "the \"big\" one\nin mm");
    EXPECT_EQ(table.lines, (std::vector<std::size_t>{3}));
}

TEST(ReadTable, ReadsALineOfUnitsBelowTheHeader) {
    const Table table = read_table("Time,Load,Extension\n(s),(N),(mm)\n0,1,2\n", "m.csv");
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.headings[0].unit, "s");
    EXPECT_EQ(table.headings[2].unit, "mm");
}

TEST(ReadTable, TrailingDelimiterAddsNoCell) { EXPECT_EQ(read_table("a,b\n1,2,\n3,4,\n", "m.csv").width(), 2u); }

TEST(ReadTable, RejectsALineOfDifferentWidthWithItsLineNumber) {
    EXPECT_EQ(refusal("a,b\n1,2\n3,4\n5\n6,7\n"),
              "m.csv:4: has 1 cells, the first line has 2; put # before lines that are not data");
}

TEST(ReadTable, RejectsAnUnclosedQuoteAtItsFirstLine) {
    EXPECT_EQ(refusal("a,b\n1,2\n3,\"4\n5,6\n"), "m.csv:3: the quote is not closed");
}

TEST(ReadTable, SkipsLinesThatConsistOfDelimiters) {
    const Table table = read_table("a;b\n;\n1;2\n ; \n", "m.csv");
    EXPECT_EQ(table.lines, (std::vector<std::size_t>{3}));
}

TEST(ReadTable, UsesTheGivenDelimiterAndDecimalMark) {
    EXPECT_EQ(numbers(read_table("1!2\n3!4\n", "m.csv", {.delimiter = '!'}), 1), (std::vector<double>{2, 4}));
    const std::string_view text = "1,5;2\n2,5;3\n";
    EXPECT_EQ(numbers(read_table(text, "m.csv", {.decimal = Decimal::comma}), 0), (std::vector<double>{1.5, 2.5}));
    EXPECT_THROW((void)numbers(read_table(text, "m.csv", {.delimiter = ';', .decimal = Decimal::point}), 0), Error);
    EXPECT_THROW((void)numbers(read_table("1.5;2\n", "m.csv", {.decimal = Decimal::comma}), 0), Error);
}

TEST(ReadTable, FindsTheDelimiterOfTheNumbersBelowAnyDescription) {
    // more lines of description than of data, with commas and blanks
    std::string text = "strain;stress\n0,1;2\n0,2;3\n";
    for (int i = 0; i < 60; ++i) text.insert(0, "Lab, town, country and street\n");
    EXPECT_EQ(read_table(text, "m.csv", described).delimiter, ';');
}

TEST(ReadTable, SkipsTheDescriptionAboveTheHeaderInTheDescribedLayout) {
    const Table table =
        read_table("\xEF\xBB\xBF# made\nSpeed;450;;\n;;;\nLab;X, Y;;\nstrain;stress\n(%);(MPa)\n\n0.1;5\n0.2\n",
                   "a.csv", described);
    ASSERT_EQ(table.headings.size(), 2u);
    EXPECT_EQ(table.headings[1].name, "stress");
    EXPECT_EQ(table.headings[1].unit, "MPa");
    EXPECT_EQ(table.header_line, 5u);
    EXPECT_EQ(table.lines, (std::vector<std::size_t>{8, 9}));
    EXPECT_EQ(table.rows[1], (std::vector<std::string>{"0.2", ""}));  // missing cells are empty
}

TEST(ReadTable, TypingErrorBelowADescriptionIsARowAndNumbersAloneHaveNoHeader) {
    EXPECT_EQ(read_table("made by hand\nstrain;stress\n0.1;5x\n0.2;6\n", "a.csv", described).rows[0][1], "5x");
    const Table table = read_table("made by hand\n0.1 5\n0.2 6\n", "a.txt", described);
    EXPECT_TRUE(table.headings.empty());
    EXPECT_EQ(table.header_line, 0u);
    EXPECT_EQ(table.rows.size(), 2u);
}

TEST(ReadTable, TableOfResultsAboveTheMeasuredTableIsDescription) {
    const std::string results = "Results\n,Maximum load,Extension at break\n,(N),(mm)\n1,36,33\n2,35,32\n\n",
                      head = "Time,Extension,Load\n(s),(mm),(N)\n", rows = "0,0,0\n1,1,2\n2,2,4\n";
    const Table table = read_table(results + head + rows, "m.csv", described);
    EXPECT_EQ(table.headings.at(1).name, "Extension");
    EXPECT_EQ(table.headings.at(1).unit, "mm");
    EXPECT_EQ(table.rows.size(), 3u);
    // Two tables with the same header are kept together, and a line of words between data is not a header.
    EXPECT_EQ(read_table(head + "0,0,0\n1,1,2\n" + head + rows, "m.csv", described).rows.size(), 7u);
    EXPECT_EQ(read_table(results + head + "0,0,0\nn/a,n/a,n/a\n1,1,2\n2,2,3\n3,3,4\n", "m.csv", described).rows.size(),
              5u);
}

TEST(ReadTable, QuotedCellsWithBlanksAreNotSplit) {
    const Table table = read_table("\"true strain\"  'stress'\n\"1\" 2\n", "m.csv");
    EXPECT_EQ(table.headings[0].name, "true strain");
    EXPECT_EQ(numbers(table, 0), (std::vector<double>{1}));
}

TEST(ReadTable, RejectsFilesThatAreNotText) {
    EXPECT_EQ(refusal(std::string_view{"a,b\n1,2\n\0\0,3\n", 13}),
              "m.csv:3: contains a zero byte: the file is not text; save it as CSV in UTF-8");
    EXPECT_EQ(refusal("PK\x03\x04..."),
              "m.csv: is an archive or a spreadsheet (xlsx, ods), not a text table; save it as CSV in UTF-8");
}

TEST(ReadTable, RejectsADescriptionWithoutATable) {
    EXPECT_EQ(refusal("e;s\na;b\n", described),
              "m.csv:2: no line consists of two or more numbers; write one row per "
              "line: numbers with a delimiter between them");
    EXPECT_EQ(refusal("", described), "m.csv: contains no row of numbers");
}

TEST(ReadTable, RejectsFilesWithoutData) {
    for (const std::string_view text : {"", "\n\n", "# nothing\n", "a,b\n", "a,b\n(mm),(kPa)\n"})
        EXPECT_EQ(refusal(text), "m.csv: contains no row of numbers") << text;
    EXPECT_EQ(refusal("\xFF\xFE"
                      "a"),
              "m.csv: is UTF-16 text; save it as CSV in UTF-8");
}

}  // namespace
}  // namespace soft::core
