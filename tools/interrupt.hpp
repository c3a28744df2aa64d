#pragma once
/// Message of solve and optimize when they are interrupted (Ctrl-C, SIGTERM): which results are saved and how to continue.
/// Tested by tests/pipeline/interrupted.sh, tests/pipeline/inverse.sh.
#include <string>
#include <string_view>

#include "cli.hpp"

namespace soft::cli {

/// During its lifetime SIGINT and SIGTERM first print the last line set, "tool: interrupted; ...", to stderr and then end the process
/// with the default action. Signals that were ignored at start stay ignored. Has no effect with Verbosity::quiet.
/// At most one instance may exist at a time.
class InterruptNotice {
public:
    InterruptNotice(std::string_view tool, Verbosity verbosity);
    ~InterruptNotice();
    InterruptNotice(const InterruptNotice&) = delete;
    InterruptNotice& operator=(const InterruptNotice&) = delete;

    void set(std::string_view line);

private:
    std::string tool_;
    bool active_;
};

/// Text that says how to continue a solve with `rows` rows in `output` ("-": stdout). `obstacle` says why it cannot be continued;
/// empty if it can.
[[nodiscard]] std::string interrupted_text(const std::string& output, int rows, std::string_view obstacle);

}  // namespace soft::cli
