#pragma once
/// Verdicts in the XML that continuous integration reads (the JUnit format as Jenkins, GitLab and others take it).
/// Tested by post/junit_test.
#include <span>
#include <string>

namespace soft::post {

/// A claim; `failure` says in one line why it is not true, empty where it is.
struct Claim {
    std::string name, failure;
};

/// One suite. `suite` and the claims' texts may hold anything; what XML cannot hold is replaced.
[[nodiscard]] std::string junit_xml(const std::string& suite, std::span<const Claim> claims);

}  // namespace soft::post
