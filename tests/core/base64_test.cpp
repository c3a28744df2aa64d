#include "core/base64.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace soft::core {
namespace {

TEST(Base64, MatchesTheExamplesOfRfc4648) {
    const auto of = [](std::string_view text) { return base64(std::as_bytes(std::span{text})); };
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foob"), "Zm9vYg==");
    EXPECT_EQ(of("fooba"), "Zm9vYmE=");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace soft::core
