#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "core/text.hpp"
#include "io/vtk_fields.hpp"
#include "post/arrays.hpp"
#include "post/contact_pressure.hpp"
#include "postprocess_pictures.hpp"
#include "view/numbered_files.hpp"
#include "view/scene.hpp"
#include "view/vtu.hpp"

namespace soft {
namespace {

namespace fs = std::filesystem;

class Exporter {
public:
    explicit Exporter(const PictureInput& shown)
        : shown_(shown),
          region_points_(post::make_region_points(shown.result.model.mesh)),
          history_(view::rubber_history(shown.result)) {}

    void vtu(std::int64_t row, const fs::path& file) const {
        const Step step(*this, row);
        cli::write_output(file.string(),
                          view::vtu_text(model().mesh, region_points_,
                                         post::node_arrays(model(), region_points_, step.state, step.fields),
                                         post::state_arrays(model(), step.fields.cells)));
    }

    /// The mesh in the copy has one value per point, so points on material interfaces get the mean of both sides.
    void copy(std::int64_t row, const fs::path& file) const {
        const Step step(*this, row);
        const auto bytes = io::with_vtk_fields(
            shown_.image, "the result", post::mesh_point_arrays(model(), region_points_, step.state, step.fields),
            post::state_arrays(model(), step.fields.cells));
        cli::write_output(file.string(), bytes, cli::Content::binary);
    }

    /// Time values of the series: the time of a motion; otherwise the leading load if it is monotonic, since ParaView sorts by time;
    /// otherwise the step number.
    struct Clock {
        std::string text;
        const post::Column* column = nullptr;  ///< nullptr: the step
        double sign = 1;                       ///< -1 if the load decreases, for example for suction
    };
    [[nodiscard]] Clock clock() const {
        for (const post::Source source : {post::Source::time, post::Source::load}) {
            const post::Column* found = shown_.curve.find(source);
            if (found == nullptr) continue;
            std::vector<double> values;
            for (const std::int64_t row : shown_.result.fields.steps())
                values.push_back(found->values.at(static_cast<std::size_t>(row)));
            const double sign = values.back() < values.front() ? -1 : 1;
            for (double& value : values) value *= sign;
            if (std::ranges::adjacent_find(values, std::greater_equal<>{}) != values.end()) continue;
            std::string name = found->quantity;
            std::ranges::replace(name, '_', ' ');
            return {(sign < 0 ? "negative " : "") + name + (found->unit.empty() ? "" : " in " + found->unit), found,
                    sign};
        }
        return {"step number, because the load is not monotonic"};
    }

    /// Writes FILE.pvd and FILE/step-0000.vtu etc. Returns the number of removed steps of an earlier result.
    [[nodiscard]] std::size_t series(const fs::path& file, cli::Console& console) const {
        const fs::path folder = file.parent_path() / file.stem();
        view::make_folder(folder, "--paraview " + file.string());
        std::vector<view::SeriesEntry> entries;
        std::set<std::size_t> written;
        const auto& rows = shown_.result.fields.steps();
        const Clock ticks = clock();
        for (const std::int64_t row : rows) {
            console.progress(static_cast<double>(entries.size()) / static_cast<double>(rows.size()),
                             "steps for ParaView");
            const auto number = static_cast<std::size_t>(row);
            const std::string name = view::numbered_name(view::step_numbering, number);
            vtu(row, folder / name);
            written.insert(number);
            const double time =
                ticks.column != nullptr ? ticks.sign * ticks.column->values.at(number) : static_cast<double>(row);
            entries.push_back({time, (file.stem() / name).generic_string()});
        }
        cli::write_output(file.string(), view::pvd_text(entries));  // last, so that it lists only complete files
        return view::remove_stale_files(folder, view::step_numbering, written);
    }

private:
    struct Step {
        io::FieldReader::Values values;
        post::NodalState state;
        post::StepFields fields;

        Step(const Exporter& exporter, std::int64_t row)
            : values(stored_fields(exporter.shown_.result, row)),
              state{
                  values.displacement_m, values.pressure_Pa,
                  post::obstacle_shifts(exporter.model(), exporter.shown_.result.steps, static_cast<std::size_t>(row)),
                  exporter.history_.at(row, values.displacement_m)},
              fields(post::step_fields(exporter.model(), exporter.region_points_, state)) {}
        Step(const Step&) = delete;  // `state` refers to `values`
        Step& operator=(const Step&) = delete;
    };

    [[nodiscard]] const model::Case& model() const { return shown_.result.model; }

    const PictureInput& shown_;
    post::RegionPoints region_points_;
    mutable post::RubberHistory history_;
};

}  // namespace

ParaviewFormat paraview_format(const std::string& file) {
    const std::string ending = fs::path(file).extension().string();
    if (ending == ".pvd") return ParaviewFormat::series;
    if (ending == ".vtu") return ParaviewFormat::step;
    if (ending == ".hdf" || ending == ".vtkhdf" || ending == ".h5") return ParaviewFormat::copy;
    throw Error(ExitCode::usage, "--paraview " + file, "unknown extension; use .pvd, .vtu, .hdf, .vtkhdf or .h5");
}

void write_paraview(const std::string& file, const PictureInput& shown, cli::Console& console) {
    const Exporter exporter(shown);
    const ParaviewFormat format = paraview_format(file);
    if (format == ParaviewFormat::series) {
        const std::size_t removed = exporter.series(file, console);
        return console.say(file + ": " + core::counted(shown.result.fields.steps().size(), "step") +
                           "; its time is the " + exporter.clock().text + removed_text(removed, "step"));
    }
    const auto rows = shown_rows(shown);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const fs::path one = numbered(file, k, rows.size());
        if (format == ParaviewFormat::step)
            exporter.vtu(rows[k], one);
        else
            exporter.copy(rows[k], one);
        console.say(one.string() + ": " + state_text(shown.curve, rows[k]));
    }
}

}  // namespace soft
