#include "postprocess_pictures.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

#include "core/text.hpp"
#include "core/units.hpp"
#include "post/contact_pressure.hpp"
#include "post/interpolate.hpp"
#include "post/quantity.hpp"
#include "view/animation.hpp"
#include "view/picture.hpp"
#include "view/scene.hpp"

namespace soft {
namespace {

namespace fs = std::filesystem;

constexpr int film_width_px = 960, film_height_px = 720;
constexpr int smooth_segments = 8, smooth_sectors = 120;  // appears smooth at 1600 pixels

std::string field_names() {
    std::vector<std::string> names;
    for (const post::QuantityInfo& quantity : post::quantities()) names.emplace_back(quantity.name);
    return core::join(names);
}

core::Dimension dimension_of(post::Quantity quantity) {
    const std::string_view unit = post::info(quantity).unit;
    if (unit.empty()) return core::Dimension::ratio;
    return core::dimension_of(unit).value_or(core::Dimension::pressure);  // kJ/m^3 = kPa
}

std::optional<view::Range> range_of(const PictureOptions& options, post::Quantity quantity) {
    if (options.range.empty()) return std::nullopt;
    const auto comma = options.range.find(',');
    if (comma == std::string::npos)
        throw Error(ExitCode::usage, "--range", core::quoted(options.range) + " has only one end",
                    "use LOW,HIGH with units");
    const auto value = [&](std::string_view text) {
        return core::quantity_or_throw(text, dimension_of(quantity), ExitCode::usage, "--range");
    };
    const view::Range range{value(std::string_view{options.range}.substr(0, comma)),
                            value(std::string_view{options.range}.substr(comma + 1))};
    if (!(range.low < range.high)) throw Error(ExitCode::usage, "--range", "LOW is not below HIGH");
    return range;
}

/// View along the bending axis of a bend or curvature output, so that the bending plane is visible; otherwise iso.
std::string default_view(const model::Case& model) {
    constexpr double along = 0.9;  // cosine
    constexpr std::array views{"side", "across", "front"};
    for (const model::Output& output : model.outputs)
        if (output.measure == model::Measure::bend || output.measure == model::Measure::curvature)
            for (std::size_t i = 0; i < views.size(); ++i)
                if (std::abs(output.direction[i]) > along) return views[i];
    return "iso";
}

view::PictureStyle style_of(const PictureOptions& options, const model::Case& model) {
    view::PictureStyle style;
    style.quantity = post::quantity_from_name(options.field);
    const bool flat = options.section || model.kinematics == model::Kinematics::plane_strain;
    style.camera = view::camera_from_text(!options.view.empty() ? options.view : flat ? "front" : default_view(model));
    style.range = range_of(options, style.quantity);
    return style;
}

view::SkinOptions skin_options(const PictureOptions& options) {
    view::SkinOptions skin;
    skin.segments = smooth_segments;
    skin.sectors = smooth_sectors;
    skin.extent = options.whole ? view::Extent::whole : view::Extent::opened;
    if (options.section) skin.extent = view::Extent::flat;
    return skin;
}

/// Whether a title shows the column: step, time, leading load and outputs (the first volume if there are no outputs).
bool is_in_title(const post::Curve& curve, const post::Column& column) {
    if (column.quantity == "step" || column.source == post::Source::time || column.source == post::Source::output)
        return true;
    return &column == curve.find(post::Source::load) ||
           (curve.find(post::Source::output) == nullptr && &column == curve.find(post::Source::volume));
}

/// "step 12", "pressure 40 kPa", "elongation 31.7 mm"; `values`: one per column; `with_step`: false between steps.
std::vector<std::string> state_words(const post::Curve& curve, std::span<const double> values, bool with_step) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < curve.columns.size(); ++i) {
        const post::Column& column = curve.columns[i];
        if (!is_in_title(curve, column) || column.role == post::Role::dependent) continue;
        if (column.quantity == "step" && !with_step) continue;
        std::string words = column.quantity;
        std::ranges::replace(words, '_', ' ');
        all.push_back(words + " " + post::value_text(column, values[i]));
    }
    return all;
}

std::vector<std::string> state_words(const post::Curve& curve, std::size_t row) {
    std::vector<double> values;
    for (const post::Column& column : curve.columns) values.push_back(column.values.at(row));
    return state_words(curve, values, true);
}

std::string title_of(const PictureInput& shown, std::span<const std::string> words) {
    return shown.result.model.name + "   " + core::join(words, "   ");
}

/// Path parameters of the frames of a film: evenly spaced in time for a motion, in the leading load for a static path if it is
/// monotonic, otherwise along the path. As many as stored steps, within limits suitable for a film.
std::vector<double> frame_parameters(const post::Path& path, const PictureInput& shown) {
    constexpr std::size_t min_frames = 36, max_frames = 400;
    const std::size_t count = std::clamp(shown.result.fields.steps().size(), min_frames, max_frames);
    const post::Curve& curve = shown.curve;
    const post::Column* load = curve.find(post::Source::load);
    const bool moves = curve.find(post::Source::time) != nullptr;
    std::vector<double> loads;
    for (const std::size_t row : path.rows()) loads.push_back(load->values[row]);
    const double sign = loads.back() < loads.front() ? -1 : 1;
    for (double& value : loads) value *= sign;
    // The parameter of a motion is time.
    const bool grows = !moves && std::ranges::adjacent_find(loads, std::greater_equal<>{}) == loads.end();
    std::vector<double> parameters;
    for (std::size_t k = 0; k < count; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(count - 1);
        double s = share * path.length();
        if (grows && k > 0 && k + 1 < count) {
            const double value = sign * (loads.front() + share * (loads.back() - loads.front()));
            const auto found = path.crossings(curve.index_of(*load), value);
            if (!found.empty()) s = found.front();
        }
        parameters.push_back(s);
    }
    return parameters;
}

/// Rejects options that do not apply to the model. A plane-strain model is drawn only from the front.
void check_body(const PictureOptions& options, const model::Case& model) {
    if (options.section && model.kinematics == model::Kinematics::solid)
        throw Error(ExitCode::usage, "--section", "the model is not axisymmetric and has no such section",
                    "omit --section; --view selects the view direction");
    if (options.view.empty() || model.kinematics != model::Kinematics::plane_strain) return;
    const view::Camera camera = view::camera_from_text(options.view), front = view::camera_from_text("front");
    if (camera.azimuth_deg != front.azimuth_deg || camera.elevation_deg != front.elevation_deg)
        throw Error(ExitCode::usage, "--view", "a plane-strain model is drawn only from the front", "omit --view");
}

/// Draws pictures of one result; computes what all steps share only once.
class PictureRenderer {
public:
    PictureRenderer(const PictureOptions& options, const PictureInput& shown)
        : shown_(shown),
          style_(style_of(options, shown.result.model)),
          region_points_(post::make_region_points(shown.result.model.mesh)),
          skin_(view::make_skin(shown.result.model, region_points_, skin_options(options))),
          body_{skin_, view::base_positions(skin_, shown.result.model, region_points_, {}), &shown.result.model,
                skin_options(options).extent},
          history_(view::rubber_history(shown.result)) {}

    [[nodiscard]] std::size_t polygons() const { return skin_.faces.size(); }

    /// Of a state at or before a row and after the one before it.
    [[nodiscard]] view::Shot shot(const io::FieldReader::Values& values, std::int64_t row, double time_s,
                                  std::span<const std::string> words, std::vector<Vector3> shifts) const {
        const model::Case& model = shown_.result.model;
        const post::NodalState state{values.displacement_m, values.pressure_Pa, shifts,
                                     history_.at_if_known(row, values.displacement_m, time_s)};
        const auto nodal = post::nodal_values(style_.quantity, model, region_points_, state,
                                              post::step_fields(model, region_points_, state));
        return {view::base_positions(skin_, model, region_points_, values.displacement_m),
                view::base_values(skin_, nodal), title_of(shown_, words), std::move(shifts)};
    }
    [[nodiscard]] view::Shot shot(std::int64_t row) const {
        return shot(stored_fields(shown_.result, row), row, history_.time_of(row),
                    state_words(shown_.curve, static_cast<std::size_t>(row)), shifts(row));
    }
    [[nodiscard]] std::vector<Vector3> shifts(std::int64_t row) const {
        return post::obstacle_shifts(shown_.result.model, shown_.result.steps, static_cast<std::size_t>(row));
    }

    /// Displacements and pressures are interpolated linearly in the path parameter between two stored steps.
    [[nodiscard]] std::vector<view::Shot> even_shots() const {
        const post::Path path(shown_.curve);
        std::vector<std::pair<double, std::int64_t>> stored;  // parameter and step
        for (const std::int64_t row : shown_.result.fields.steps()) {
            const auto found = std::ranges::find(path.rows(), static_cast<std::size_t>(row));
            if (found != path.rows().end())
                stored.emplace_back(path.row_parameters()[static_cast<std::size_t>(found - path.rows().begin())], row);
        }
        std::vector<view::Shot> shots;
        for (const double s : frame_parameters(path, shown_)) {
            auto after = std::ranges::find_if(stored, [&](const auto& one) { return one.first >= s; });
            if (after == stored.end()) --after;
            const auto before = after == stored.begin() ? after : std::prev(after);
            io::FieldReader::Values values = stored_fields(shown_.result, after->second);
            std::vector<Vector3> moved = shifts(after->second);
            double time_s = history_.time_of(after->second);
            if (after->first > s && before != after) {
                const auto start = stored_fields(shown_.result, before->second);
                const double share = (s - before->first) / (after->first - before->first);
                const auto blend = [&](std::vector<double>& to, const std::vector<double>& from) {
                    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] + share * (to[i] - from[i]);
                };
                blend(values.displacement_m, start.displacement_m);
                blend(values.pressure_Pa, start.pressure_Pa);
                time_s = std::lerp(history_.time_of(before->second), time_s, share);
                const auto from = shifts(before->second);
                for (std::size_t k = 0; k < moved.size(); ++k)
                    moved[k] = along(from[k], share, difference(moved[k], from[k]));
            }
            shots.push_back(
                shot(values, after->second, time_s, state_words(shown_.curve, path.at(s), false), std::move(moved)));
        }
        return shots;
    }

    void draw(std::int64_t row, const fs::path& file) const {
        const view::Shot one = shot(row);
        view::draw_picture(body_, style_, view::framing(body_, style_, {&one, 1}), one, file);
    }

    /// Writes a film with evenly spaced frames, or a folder with a picture of each stored step.
    void animate(const fs::path& file, cli::Console& console) const {
        const bool is_film =
            view::film_format(file) != view::FilmFormat::folder && shown_.result.fields.steps().size() > 1;
        std::vector<view::Shot> shots;
        if (is_film) {
            shots = even_shots();
        } else {
            for (const std::int64_t row : shown_.result.fields.steps()) shots.push_back(shot(row));
        }
        view::PictureStyle style = style_;
        if (view::film_format(file) != view::FilmFormat::folder) {
            style.width_px = film_width_px;
            style.height_px = film_height_px;
        }
        const std::size_t removed = view::draw_animation(body_, style, shots, file, [&](std::size_t done) {
            console.progress(static_cast<double>(done) / static_cast<double>(shots.size()), "frames");
        });
        console.say(file.string() + ": " + core::counted(shots.size(), is_film ? "frame" : "step") +
                    removed_text(removed, "frame"));
    }

private:
    const PictureInput& shown_;
    view::PictureStyle style_;
    post::RegionPoints region_points_;
    view::Skin skin_;
    view::Body body_;
    mutable post::RubberHistory history_;
};

/// The stored step nearest to the (fractional) step number `step`.
std::int64_t nearest_stored(const std::vector<std::int64_t>& stored, double step) {
    return *std::ranges::min_element(stored, {},
                                     [&](std::int64_t row) { return std::abs(static_cast<double>(row) - step); });
}

void draw_pictures(const std::string& name, const PictureRenderer& renderer, const PictureInput& shown,
                   cli::Console& console) {
    const auto rows = shown_rows(shown);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const fs::path file = numbered(name, k, rows.size());
        renderer.draw(rows[k], file);
        console.say(file.string() + ": " + state_text(shown.curve, rows[k]));
    }
}

}  // namespace

std::vector<std::int64_t> shown_rows(const PictureInput& shown) {
    const auto& stored = shown.result.fields.steps();
    if (shown.rows == PictureInput::Rows::last) return {stored.back()};
    std::vector<std::int64_t> rows;
    for (const double step : shown.table.find("step")->values) rows.push_back(nearest_stored(stored, step));
    return rows;
}

std::string state_text(const post::Curve& curve, std::int64_t row) {
    return core::join(state_words(curve, static_cast<std::size_t>(row)));
}

std::string removed_text(std::size_t count, const std::string& what) {
    if (count == 0) return "";
    return "; " + core::counted(count, what) + " of an earlier result removed";
}

fs::path numbered(const fs::path& file, std::size_t k, std::size_t count) {
    if (count == 1) return file;
    return file.parent_path() / (file.stem().string() + "-" + std::to_string(k + 1) + file.extension().string());
}

io::FieldReader::Values stored_fields(const io::Result& result, std::int64_t row) {
    auto values = result.fields.read(row);
    if (!values) throw Error(ExitCode::bad_input, "/fields", "step " + std::to_string(row) + " has no fields");
    return std::move(*values);
}

void add_picture_options(CLI::App& app, PictureOptions& options) {
    app.add_option("--picture", options.picture,
                   "Draw the deformed actuator in colour at the last step, or at the stored step nearest "
                   "to each value of --at (FILE-1.png ... if several); needs gnuplot, no display")
        ->type_name("FILE.png");
    app.add_option(
           "--animate", options.animate,
           "Write a film with evenly spaced loads (needs ffmpeg), or a folder with a picture of every stored step")
        ->type_name("FILE.gif|FILE.mp4|FOLDER/");
    app.add_option("--field", options.field, "Field shown by the colours of the actuator: " + field_names())
        ->type_name("FIELD")
        ->capture_default_str();
    app.add_option(
           "--view", options.view,
           "View direction: front, side (along the axis), top, across (along y, z up), iso, or AZIMUTH,ELEVATION in degrees;\n"
           "default: along the axis of a bend or curvature output, otherwise iso")
        ->type_name("VIEW");
    app.add_option("--range", options.range,
                   "Values at the ends of the colour bar, e.g. 0kPa,200kPa; default: the range of "
                   "the picture or film")
        ->type_name("LOW,HIGH");
    app.add_flag("--section", options.section, "Draw the section of an axisymmetric actuator");
    app.add_flag("--whole", options.whole, "Draw the whole actuator: fully revolved, mirrored at its symmetry planes");
    app.add_option(
           "--paraview", options.paraview,
           "Write files for ParaView: a series with a .vtu for each stored step, or one step as .vtu, or a copy of the "
           "result with the fields of that step in its mesh (.hdf, the extension that ParaView 5.11 expects, .vtkhdf, .h5)")
        ->type_name("FILE.pvd|FILE.vtu|FILE.hdf");
}

const std::string& pictures_help() {
    static const std::string help =
        "Pictures show the deformed actuator, its undeformed outline, a scale bar and a colour bar. To show the inside, axisymmetric\n"
        "and quarter models are drawn without the quarter between +y and +z, half models without y > 0. front looks along -z with\n"
        "x to the right and y up, side along the axis, top from above. Fields: stretch (largest principal stretch), von-mises,\n"
        "pressure (in the rubber, positive in compression), displacement, energy (per undeformed volume), J (current over undeformed\n"
        "volume), contact-pressure; nodal values are means over the cells of one material. Obstacles are drawn as lines.\n"
        "ParaView files contain displacement, deformation gradient, principal stretches and directions, J, Cauchy and first\n"
        "Piola-Kirchhoff stress, von Mises stress, pressure and energy density, at nodes and cells, and contact pressure at nodes; components of axisymmetric\n"
        "models are x, r, hoop.\n";
    return help;
}

void check_picture_options(const CLI::App& app, const PictureOptions& options) {
    const bool draws = !options.picture.empty() || !options.animate.empty();
    for (const char* option : {"--field", "--view", "--range", "--section", "--whole"})
        if (app.count(option) > 0 && !draws)
            throw Error(ExitCode::usage, option, "has no effect without --picture or --animate");
    if (options.section && options.whole)
        throw Error(ExitCode::usage, "--section", "and --whole exclude each other", "use one of them");
    if (options.section && app.count("--view") > 0)
        throw Error(ExitCode::usage, "--section", "cannot be combined with --view: a section is drawn flat");
    static_cast<void>(range_of(options, post::quantity_from_name(options.field)));
    if (app.count("--view") > 0) static_cast<void>(view::camera_from_text(options.view));
    if (!options.picture.empty() && fs::path(options.picture).extension() != ".png")
        throw Error(ExitCode::usage, "--picture " + options.picture, "unknown extension; use .png");
    if (!options.animate.empty()) static_cast<void>(view::film_format(options.animate));
    if (!options.paraview.empty()) static_cast<void>(paraview_format(options.paraview));
}

void make_pictures(const PictureOptions& options, const PictureInput& shown, cli::Console& console) {
    if (options.picture.empty() && options.animate.empty() && options.paraview.empty()) return;
    if (shown.result.fields.steps().empty())
        throw Error(ExitCode::bad_input, "/fields", "the result contains no displacements",
                    "run solve with --fields all");
    check_body(options, shown.result.model);
    if (!options.animate.empty()) view::prepare_animation(options.animate);
    if (!options.paraview.empty()) write_paraview(options.paraview, shown, console);
    if (options.picture.empty() && options.animate.empty()) return;
    const PictureRenderer renderer(options, shown);
    console.detail("the surface has " + std::to_string(renderer.polygons()) + " polygons");
    if (!options.picture.empty()) draw_pictures(options.picture, renderer, shown, console);
    if (options.animate.empty()) return;
    renderer.animate(options.animate, console);
}

}  // namespace soft
