#include "post/junit.hpp"

#include <gtest/gtest.h>

#include <pugixml.hpp>

namespace soft::post {
namespace {

TEST(Junit, CountsTheClaimsAndKeepsTheirTexts) {
    const std::vector<Claim> claims = {{"pressure_kPa agrees", ""}, {"bend_deg agrees", "a < b & \"c\"\n\x01"}};
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(junit_xml("check <1>", claims).c_str()));
    const pugi::xml_node suite = document.child("testsuites").child("testsuite");
    EXPECT_STREQ(suite.attribute("name").value(), "check <1>");
    EXPECT_EQ(suite.attribute("tests").as_int(), 2);
    EXPECT_EQ(suite.attribute("failures").as_int(), 1);
    const pugi::xml_node first = suite.child("testcase"), second = first.next_sibling("testcase");
    EXPECT_FALSE(first.child("failure"));
    EXPECT_STREQ(second.attribute("name").value(), "bend_deg agrees");
    EXPECT_STREQ(second.child("failure").attribute("message").value(), "a < b & \"c\"??");
}

}  // namespace
}  // namespace soft::post
