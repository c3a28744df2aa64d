#pragma once
/// What solve prints when it is interrupted (Ctrl-C, SIGTERM): what of the run is saved and how to go on.
/// Tested by tests/pipeline/interrupted.sh.
#include <string>
#include <string_view>

#include "cli.hpp"

namespace soft::cli {

/// While it lives, SIGINT and SIGTERM print the line that was set last, "tool: interrupted; ...", to stderr and end the process
/// as they would without it. Signals that the process was started with as ignored stay ignored. Nothing with Verbosity::quiet.
/// One at a time.
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

/// How a solve with `rows` rows in `output` ("-": stdout) can be continued; `obstacle`: why it cannot, empty where it can.
[[nodiscard]] std::string interrupted_text(const std::string& output, int rows, std::string_view obstacle);

}  // namespace soft::cli
