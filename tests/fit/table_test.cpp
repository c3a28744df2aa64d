#include "fit/table.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace soft::fit {
namespace {

TEST(Table, ReadsAnyUsualDelimiterAndQuotes) {
    for (const std::string delimiter : {";", ",", "\t", "|", " "}) {
        const std::string text =
            "strain" + delimiter + "\"stress\"\r\n0.1" + delimiter + "2\r\n0.2" + delimiter + "\"3\"\r\n";
        const Table table = read_table(text, "a.csv");
        ASSERT_EQ(table.rows.size(), 2u) << delimiter;
        EXPECT_EQ(table.header, (std::vector<std::string>{"strain", "stress"}));
        EXPECT_EQ(table.rows[1].fields, (std::vector<std::string>{"0.2", "3"}));
        EXPECT_EQ(table.rows[1].line, 3u);
    }
}

TEST(Table, QuotesHoldDelimitersAndQuotes) {
    EXPECT_EQ(read_table("\"a \"\"b\"\"; c\";d\n1;2\n3;4\n", "a.csv").header[0], "a \"b\"; c");
}

TEST(Table, DescriptionAboveTheHeaderIsSkippedAndLinesKeepTheirNumber) {
    const Table table =
        read_table("\xEF\xBB\xBF# made\nSpeed;450;;\n;;;\nLab;X, Y;;\nstrain;stress\n\n0.1;5\n", "a.csv");
    EXPECT_EQ(table.header_line, 5u);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0].line, 7u);
}

TEST(Table, NumbersAloneHaveNoHeader) {
    const Table table = read_table("0.1 5\n0.2 6\n", "a.txt");
    EXPECT_TRUE(table.header.empty());
    EXPECT_EQ(table.rows.size(), 2u);
}

TEST(Table, ASlipInTheFirstRowOfDataIsARow) {
    EXPECT_EQ(read_table("strain;stress\n0.1;5x\n0.2;6\n", "a.csv").rows[0].fields[1], "5x");
}

TEST(Table, DecimalCommasAreRead) {
    const Table table = read_table("e;s\n0,1;5,5\n", "a.csv", {.delimiter = std::nullopt, .decimal = Decimal::comma});
    EXPECT_EQ(number_of(table.rows[0].fields[1], Decimal::comma), 5.5);
}

TEST(Table, ANumberIsTheWholeField) {
    EXPECT_EQ(number_of(" +1.5e-3 ", Decimal::point), 1.5e-3);
    for (const char* text : {"", "1.5x", "nan", "inf", "1,5", "--1"})
        EXPECT_FALSE(number_of(text, Decimal::point)) << text;
}

void expect_refused(const std::string& text, const std::string& words) {
    try {
        static_cast<void>(read_table(text, "a.csv"));
        ADD_FAILURE() << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_NE(std::string{error.what()}.find(words), std::string::npos) << error.what();
    }
}

TEST(Table, WhatIsNoTableIsRefusedWithItsLine) {
    expect_refused("e;s\n\"0.1;5\n", "a.csv:2: a quote is not closed");
    expect_refused("e;s\na;b\n", "a.csv:2: no line holds two numbers");
    expect_refused("", "a.csv:1: no line holds two numbers");
}

}  // namespace
}  // namespace soft::fit
