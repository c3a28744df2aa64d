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
    std::string view;   ///< empty: front for what is drawn flat, along the axis of a bend, else iso
    std::string range;  ///< "0kPa,200kPa"; empty: that of the picture
    bool section = false, whole = false;
};

/// series: a .vtu for each stored step and a .pvd that lists them. step: one .vtu. copy: the result with fields in its
/// mesh.
enum class ParaviewFormat { series, step, copy };
/// By the ending of the name; Error(usage) for another one.
[[nodiscard]] ParaviewFormat paraview_format(const std::string& file);
/// Whether the file of the result is needed as it is.
[[nodiscard]] inline bool copies_result(const PictureOptions& options) {
    return !options.paraview.empty() && paraview_format(options.paraview) == ParaviewFormat::copy;
}

void add_picture_options(CLI::App& app, PictureOptions& options);
/// What belongs into the help below the options.
[[nodiscard]] const std::string& pictures_help();
/// Refuses bad combinations and values before any work: Error(usage).
void check_picture_options(const CLI::App& app, const PictureOptions& options);

/// What is to be shown of a result. `table` holds the rows that --at asked for (`at` false: it did not, the last step
/// is shown).
struct Shown {
    const io::Result& result;
    std::span<const std::byte> image;  ///< the file of the result
    const post::Curve& curve;
    const post::Curve& table;
    enum class Rows { last, asked } rows;
};

/// The stored steps to be shown: for each row of --at the one nearest to it in steps, in its order, also where two rows
/// have the same; without --at the last stored one.
[[nodiscard]] std::vector<std::int64_t> shown_rows(const Shown& shown);
/// FILE.png for one product; FILE-1.png, FILE-2.png ... for several.
[[nodiscard]] std::filesystem::path numbered(const std::filesystem::path& file, std::size_t k, std::size_t count);
/// "step 4, pressure 12 kPa, elongation 40 mm": which state a file shows.
[[nodiscard]] std::string state_text(const post::Curve& curve, std::int64_t row);
/// "; 3 frames of an earlier result removed" for `what` "frame", or nothing.
[[nodiscard]] std::string removed_text(std::size_t count, const std::string& what);
/// Error(bad_input) for a step without fields.
[[nodiscard]] io::FieldReader::Values stored_fields(const io::Result& result, std::int64_t row);

/// --paraview.
void write_paraview(const std::string& file, const Shown& shown, cli::Console& console);

/// Draws what the options ask for and says what it has drawn.
void make_pictures(const PictureOptions& options, const Shown& shown, cli::Console& console);

}  // namespace soft
