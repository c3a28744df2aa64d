#pragma once
/// For tests of programs that are started: which of them are found.
#include <cstdlib>
#include <string>

namespace soft::test {

/// Another PATH for the length of a test.
class PathVariable {
public:
    explicit PathVariable(const std::string& value) : before_(std::getenv("PATH") ? std::getenv("PATH") : "") {
        ::setenv("PATH", value.c_str(), 1);
    }
    ~PathVariable() { ::setenv("PATH", before_.c_str(), 1); }
    PathVariable(const PathVariable&) = delete;
    PathVariable& operator=(const PathVariable&) = delete;

private:
    std::string before_;
};

}  // namespace soft::test
