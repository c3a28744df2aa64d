#pragma once
/// Check results as JUnit XML for continuous integration (Jenkins, GitLab and others).
/// Tested by post/junit_test.
#include <span>
#include <string>

namespace soft::post {

/// A checked claim; `failure` is a one-line reason, empty if the claim is true.
struct Claim {
    std::string name, failure;
};

/// One test suite. `suite` and the texts of the claims may contain any bytes; characters not allowed in XML are replaced.
[[nodiscard]] std::string junit_xml(const std::string& suite, std::span<const Claim> claims);

}  // namespace soft::post
