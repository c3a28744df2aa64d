#pragma once
/// Runs the program gnuplot without a shell: script in, picture out; and the common style of all plots as lines of a script.
/// Tested by post/gnuplot_test and post/plot_test.
#include <filesystem>
#include <string>
#include <string_view>

#include "core/files.hpp"

namespace soft::post {

/// The text in single quotes, in which only the quote itself is special: one line without control characters, in UTF-8.
[[nodiscard]] std::string gnuplot_text(std::string_view text);

enum class PictureFormat { svg, png, pdf };

/// Format by the file extension; throws Error(usage) for an unknown one.
[[nodiscard]] PictureFormat picture_format(const std::filesystem::path& file);

/// The terminal for the given number of panels side by side. SVG and PDF are scalable; PNG has twice the pixels for printing.
[[nodiscard]] std::string terminal(PictureFormat format, int panels = 1);

/// Grid, borders and tics.
[[nodiscard]] std::string axes_style();

/// The output of gnuplot (found along PATH) on stdout for `script`, without the user's start-up files and variables. The output passes
/// through a pipe: gnuplot reports success even if its writes fail, so it must not write to a disk itself. Throws
/// Error(cannot_create, `location`) if gnuplot is missing (the message names the package) or rejects the script (the message contains
/// gnuplot's first line).
[[nodiscard]] core::Bytes gnuplot_bytes(std::string_view script, std::string_view location);

/// Writes the output to `file` atomically; no temporary file exists while gnuplot runs. Throws in addition Error(cannot_create) or
/// Error(io_error) if the file cannot be written.
void run_gnuplot(std::string_view script, const std::filesystem::path& file);

/// The output as text, for an SVG picture.
[[nodiscard]] std::string gnuplot_output(std::string_view script, std::string_view location);

}  // namespace soft::post
