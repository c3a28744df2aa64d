#pragma once
/// The program gnuplot as a function: script in, picture out. No shell in between. Held by post/gnuplot_test.
#include <filesystem>
#include <string>
#include <string_view>

namespace soft::post {

/// Runs gnuplot (found along PATH) with `script` and puts what it writes to stdout into `file`, under a temporary name
/// in the same folder until it is whole. Error(cannot_create): no gnuplot (names the package), the file cannot be
/// written, or gnuplot refused the script (its first words are in the message).
void run_gnuplot(const std::string& script, const std::filesystem::path& file);

/// What gnuplot writes to stdout, as text: an SVG picture. `place` stands in errors, which are those of the other.
[[nodiscard]] std::string gnuplot_output(const std::string& script, std::string_view place);

}  // namespace soft::post
