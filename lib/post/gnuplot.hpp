#pragma once
/// The program gnuplot as a function: script in, picture out. No shell in between. Tested by post/gnuplot_test.
#include <filesystem>
#include <string>
#include <string_view>

#include "core/files.hpp"

namespace soft::post {

/// A text in single quotes, in which only the quote itself is special: one line without control characters, in UTF-8.
[[nodiscard]] std::string gnuplot_text(std::string_view text);

/// What gnuplot (found along PATH) writes to stdout when it is given `script`, without start-up
/// files and variables of the user. It passes through a pipe: gnuplot ends
/// well also where its writes fail, so it must not write to a disk itself. Error(cannot_create, `place`): no gnuplot
/// (names the package), or it refused the script (its first words are in the message).
[[nodiscard]] core::Bytes gnuplot_bytes(std::string_view script, std::string_view place);

/// The same into `file`, whole or not at all; no temporary file exists while gnuplot works. Besides:
/// Error(cannot_create) or Error(io_error) where the file cannot be written.
void run_gnuplot(std::string_view script, const std::filesystem::path& file);

/// The same as text: an SVG picture.
[[nodiscard]] std::string gnuplot_output(std::string_view script, std::string_view place);

}  // namespace soft::post
