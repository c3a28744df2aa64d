#pragma once
/// Sets environment variables for tests that start programs.
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace soft::test {

/// Sets an environment variable and restores its value on destruction.
class Variable {
public:
    Variable(std::string name, const std::string& value) : name_(std::move(name)) {
        if (const char* before = std::getenv(name_.c_str())) before_ = before;
        ::setenv(name_.c_str(), value.c_str(), 1);
    }
    ~Variable() {
        if (before_)
            ::setenv(name_.c_str(), before_->c_str(), 1);
        else
            ::unsetenv(name_.c_str());
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    std::string name_;
    std::optional<std::string> before_;
};

/// Sets PATH, which determines the programs that are found.
class PathVariable : Variable {
public:
    explicit PathVariable(const std::string& value) : Variable("PATH", value) {}
};

}  // namespace soft::test
