#include "view/text.hpp"

#include <gtest/gtest.h>

namespace soft::view {
namespace {

TEST(Escaped, ReplacesTheSpecialCharactersOfHtml) {
    EXPECT_EQ(escaped("<b title=\"x\" id='y'>&amp;</b>"),
              "&lt;b title=&quot;x&quot; id=&#39;y&#39;&gt;&amp;amp;&lt;/b&gt;");
    EXPECT_EQ(escaped("\xC3\xA4 \xE2\x82\xAC\n\t"), "\xC3\xA4 \xE2\x82\xAC\n\t");
}

TEST(Escaped, InvalidCharactersBecomeTheReplacementCharacter) {
    EXPECT_EQ(escaped(std::string_view("a\0b", 3)),
              "a\xEF\xBF\xBD"
              "b");
    EXPECT_EQ(escaped("\xC3(\xFF"), "\xEF\xBF\xBD(\xEF\xBF\xBD");
    EXPECT_EQ(escaped("\xED\xA0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");  // a surrogate
}

TEST(JsonInPage, CannotCloseItsElement) {
    EXPECT_EQ(json_in_page("{\"a\":\"</script><!--\"}"), "{\"a\":\"\\u003c/script>\\u003c!--\"}");
}

/// SHA-256 of "abc" (FIPS 180-4, example B.1), in base64.
TEST(PolicyHash, IsTheDigestInBase64) {
    EXPECT_EQ(policy_hash("abc"), "sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

}  // namespace
}  // namespace soft::view
