#include "core/text.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace {

using namespace soft::core;

TEST(NumberText, ParsesToTheSameBits) {
    for (const double value : {0.1, 1.0 / 3.0, 1e-300, 5e-324, -0.0, 123456789.123456789, std::nextafter(1.0, 2.0)}) {
        const std::string text = number_text(value);
        double back = 0;
        std::from_chars(text.data(), text.data() + text.size(), back);
        EXPECT_EQ(std::signbit(back), std::signbit(value));
        EXPECT_EQ(back, value) << text;
    }
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(1.0), "1");
}

TEST(Counted, UsesThePluralExceptForOne) {
    EXPECT_EQ(counted(0, "step"), "0 steps");
    EXPECT_EQ(counted(1, "step"), "1 step");
    EXPECT_EQ(counted(std::size_t{2}, "step"), "2 steps");
}

TEST(Nearest, FindsTheKeyMeantByATypingError) {
    const std::vector<std::string> keys = {"wall", "pitch", "crest_radius", "bore_radius"};
    EXPECT_EQ(nearest("wal", keys), "wall");
    EXPECT_EQ(nearest("WALL", keys), "wall");
    EXPECT_EQ(nearest("ptich", keys), "pitch");  // a swap counts once
    EXPECT_EQ(nearest("crest-radus", keys), "crest_radius");
    EXPECT_EQ(nearest("temperature", keys), std::nullopt);
    EXPECT_EQ(nearest(std::string(100000, 'w'), keys), std::nullopt);
    EXPECT_EQ(nearest("x", std::vector<std::string>{}), std::nullopt);
}

TEST(DidYouMean, ListsTheKnownNamesIfNoneIsNear) {
    const std::vector<std::string> keys = {"wall", "pitch"};
    EXPECT_EQ(did_you_mean("wal", keys), "did you mean 'wall'?");
    EXPECT_EQ(did_you_mean("colour", keys), "known: wall, pitch");
}

TEST(OneLine, ContainsNoControlCharacterAndNoPartialCharacter) {
    EXPECT_EQ(one_line("a\nb\x1b[31m"), "a?b?[31m");
    const std::string cut = one_line("aaaµ", 4);  // the limit falls inside the two-byte character
    EXPECT_EQ(cut, "aaa...");
    EXPECT_EQ(one_line("aaaµ", 5), "aaaµ");
}

TEST(OneLine, IsValidUtf8ForAnyInput) {
    EXPECT_EQ(one_line("a\xff\x81 \xc3"), "a?? ?");
    EXPECT_EQ(one_line("\xc2\x9b 31m µ"), "?? 31m µ");  // a control character of ISO 8859
    EXPECT_EQ(one_line("\x80\x80\x80\x80\x80\x80", 5), "??...");
}

TEST(Utf8, AcceptsSequencesOfEveryLengthAndRejectsInvalidOnes) {
    EXPECT_EQ(first_invalid_utf8("plain µ € 😀"), std::nullopt);
    EXPECT_EQ(first_invalid_utf8("ab\xff"), 2u);
    EXPECT_EQ(first_invalid_utf8("\xC0\xAF"), 0u);          // overlong '/'
    EXPECT_EQ(first_invalid_utf8("\xED\xA0\x80"), 0u);      // a surrogate
    EXPECT_EQ(first_invalid_utf8("\xF4\x90\x80\x80"), 0u);  // beyond U+10FFFF
    EXPECT_EQ(first_invalid_utf8("a\xE2\x82"), 1u);         // cut short
}

TEST(Trimmed, RemovesBlanksAtBothEndsOnly) {
    EXPECT_EQ(trimmed(" \t a b \r\n"), "a b");
    EXPECT_EQ(trimmed(" \n"), "");
}

TEST(ShellWords, MatchTheQuotingRulesOfAShell) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(shell_words(""), Words{});
    EXPECT_EQ(shell_words("  a\tb  c "), (Words{"a", "b", "c"}));
    EXPECT_EQ(shell_words("\"a b\" 'c d' ''"), (Words{"a b", "c d", ""}));
    EXPECT_EQ(shell_words("--set='a={b: c}' x\\ y it\"'\"s"), (Words{"--set=a={b: c}", "x y", "it's"}));
    EXPECT_EQ(shell_words("\"a\\\"b\\\\c\\d\" 'e\\'"), (Words{"a\"b\\c\\d", "e\\"}));
    for (const char* open : {"\"a", "'a", "a \"", "it's", "a\\", "\"a\\\""}) EXPECT_FALSE(shell_words(open)) << open;
}

}  // namespace
