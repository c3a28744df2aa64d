#pragma once
/// Help footer, man page and shell completion, all generated from the option tables, so that every option is documented.
#include <string>

#include "cli.hpp"

namespace soft::cli {

/// The examples and the table of exit codes.
[[nodiscard]] std::string help_footer(const About& about);
[[nodiscard]] std::string man_page(const CLI::App& app, const About& about);
/// `shell`: bash, zsh or fish.
[[nodiscard]] std::string completion(const CLI::App& app, const About& about, const std::string& shell);

}  // namespace soft::cli
