#pragma once
/// Pictures of the body, films and files for ParaView. Tested by tests/pipeline/pictures.sh.
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli.hpp"
#include "io/result_file.hpp"
#include "post/curve.hpp"

namespace CLI {
class App;
}

namespace soft {

struct PictureOptions {
    std::string picture;   ///< FILE.png; empty: none
    std::string animate;   ///< FILE.gif, FILE.mp4 or FOLDER/; empty: none
    std::string paraview;  ///< FILE.pvd, FILE.vtu, FILE.hdf, FILE.vtkhdf or FILE.h5; empty: none
    std::string field = "stretch";
    std::string view;   ///< empty: front for sections, along the axis of a bend output, otherwise iso
    std::string range;  ///< "0kPa,200kPa"; empty: range of the picture
    bool section = false, whole = false;
};

/// series: a .vtu for each stored step and a .pvd that lists them. step: one .vtu. copy: the result with fields in its
/// mesh.
enum class ParaviewFormat { series, step, copy };
/// Format by the file extension; throws Error(usage) for an unknown one.
[[nodiscard]] ParaviewFormat paraview_format(const std::string& file);
/// Whether the bytes of the result file are needed.
[[nodiscard]] inline bool copies_result(const PictureOptions& options) {
    return !options.paraview.empty() && paraview_format(options.paraview) == ParaviewFormat::copy;
}

void add_picture_options(CLI::App& app, PictureOptions& options);
/// Help text below the options.
[[nodiscard]] const std::string& pictures_help();
/// Throws Error(usage) for invalid combinations and values, before any work.
void check_picture_options(const CLI::App& app, const PictureOptions& options);

/// A result and the steps to draw: the rows of `table` (those of --at) with Rows::requested, otherwise the last stored step.
struct PictureInput {
    const io::Result& result;
    std::span<const std::byte> image;  ///< bytes of the result file
    const post::Curve& curve;
    const post::Curve& table;
    enum class Rows { last, requested } rows;
};

/// The stored steps to draw: for each row of --at the nearest one by step number, in order, with repetitions;
/// without --at the last stored step.
[[nodiscard]] std::vector<std::int64_t> shown_rows(const PictureInput& shown);
/// FILE.png for a single file; FILE-1.png, FILE-2.png ... for several.
[[nodiscard]] std::filesystem::path numbered(const std::filesystem::path& file, std::size_t k, std::size_t count);
/// "step 4, pressure 12 kPa, elongation 40 mm": the state shown by a file.
[[nodiscard]] std::string state_text(const post::Curve& curve, std::int64_t row);
/// "; 3 frames of an earlier result removed" for `what` "frame"; empty if `count` is 0.
[[nodiscard]] std::string removed_text(std::size_t count, const std::string& what);
/// Reads the fields of a step; throws Error(bad_input) for a step without fields.
[[nodiscard]] io::FieldReader::Values stored_fields(const io::Result& result, std::int64_t row);

/// Writes the files of --paraview.
void write_paraview(const std::string& file, const PictureInput& shown, cli::Console& console);

/// Writes the requested pictures and ParaView files and prints a line for each.
void make_pictures(const PictureOptions& options, const PictureInput& shown, cli::Console& console);

}  // namespace soft
