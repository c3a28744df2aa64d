#include "post/junit.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "core/text.hpp"

namespace soft::post {
namespace {

constexpr std::size_t max_length = 2000;  // of a text in a report

std::string fit(const std::string& text) {
    const std::string line = core::one_line(text, max_length);
    return core::first_invalid_utf8(line) ? "?" : line;
}

}  // namespace

std::string junit_xml(const std::string& suite, std::span<const Claim> claims) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node node = document.append_child("testsuites").append_child("testsuite");
    const auto failures =
        std::count_if(claims.begin(), claims.end(), [](const Claim& claim) { return !claim.failure.empty(); });
    node.append_attribute("name") = fit(suite).c_str();
    node.append_attribute("tests") = static_cast<unsigned long long>(claims.size());
    node.append_attribute("failures") = static_cast<long long>(failures);
    node.append_attribute("errors") = 0;
    for (const Claim& claim : claims) {
        pugi::xml_node test = node.append_child("testcase");
        test.append_attribute("classname") = fit(suite).c_str();
        test.append_attribute("name") = fit(claim.name).c_str();
        if (!claim.failure.empty())
            test.append_child("failure").append_attribute("message") = fit(claim.failure).c_str();
    }
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

}  // namespace soft::post
