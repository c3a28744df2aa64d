#include <filesystem>
#include <system_error>

#include "fields/arrays.hpp"
#include "io/vtk_fields.hpp"
#include "postprocess_pictures.hpp"
#include "view/vtu.hpp"

namespace soft {
namespace {

namespace fs = std::filesystem;

class Exporter {
public:
    explicit Exporter(const Shown& shown) : shown_(shown), places_(fields::region_points(shown.result.model.mesh)) {}

    void vtu(std::int64_t row, const fs::path& file) const {
        const Step step(*this, row);
        cli::write_output(file.string(), view::vtu_text(model().mesh, places_,
                                                        fields::node_arrays(model(), places_, step.state, step.fields),
                                                        fields::state_arrays(model(), step.fields.cells)));
    }

    /// The mesh of the copy has one place for a point, so interfaces get the mean of both sides.
    void copy(std::int64_t row, const fs::path& file) const {
        const Step step(*this, row);
        const auto bytes = io::with_vtk_fields(shown_.image, "the result",
                                               fields::mesh_point_arrays(model(), places_, step.state, step.fields),
                                               fields::state_arrays(model(), step.fields.cells));
        cli::write_output(file.string(), bytes, cli::Content::binary);
    }

    /// FILE.pvd, and FILE/step-0000.vtu and so on beside it.
    void series(const fs::path& file, cli::Console& console) const {
        const fs::path folder = file.parent_path() / file.stem();
        std::error_code failure;
        fs::create_directory(folder, failure);
        if (failure) throw Error(ExitCode::cannot_create, folder.string(), failure.message());
        std::vector<view::SeriesEntry> entries;
        const auto& rows = shown_.result.fields.steps();
        for (const std::int64_t row : rows) {
            console.progress(static_cast<double>(entries.size()) / static_cast<double>(rows.size()),
                             "steps for ParaView");
            const std::string digits = std::to_string(row);
            const std::string name =
                "step-" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits + ".vtu";
            vtu(row, folder / name);
            const auto& motion = shown_.result.steps[static_cast<std::size_t>(row)].motion;
            entries.push_back(
                {motion ? motion->time_s : static_cast<double>(row), (file.stem() / name).generic_string()});
        }
        cli::write_output(file.string(), view::pvd_text(entries));  // last: it names whole files only
    }

private:
    struct Step {
        io::FieldReader::Values values;
        fields::NodalState state;
        fields::StepFields fields;

        Step(const Exporter& exporter, std::int64_t row)
            : values(stored_fields(exporter.shown_.result, row)),
              state{values.displacement_m, values.pressure_Pa},
              fields(fields::step_fields(exporter.model(), exporter.places_, state)) {}
        Step(const Step&) = delete;  // the state looks at the values
        Step& operator=(const Step&) = delete;
    };

    [[nodiscard]] const model::Case& model() const { return shown_.result.model; }

    const Shown& shown_;
    fields::RegionPoints places_;
};

}  // namespace

ParaviewFormat paraview_format(const std::string& file) {
    const std::string ending = fs::path(file).extension().string();
    if (ending == ".pvd") return ParaviewFormat::series;
    if (ending == ".vtu") return ParaviewFormat::step;
    if (ending == ".hdf" || ending == ".vtkhdf" || ending == ".h5") return ParaviewFormat::copy;
    throw Error(ExitCode::usage, "--paraview " + file,
                "ParaView gets .pvd, .vtu or .hdf files (the last also as .vtkhdf or .h5)");
}

void write_paraview(const std::string& file, const Shown& shown, cli::Console& console) {
    const Exporter exporter(shown);
    const ParaviewFormat format = paraview_format(file);
    if (format == ParaviewFormat::series) {
        exporter.series(file, console);
        return console.say(file + ": " + std::to_string(shown.result.fields.steps().size()) + " steps");
    }
    const auto rows = shown_rows(shown);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const fs::path one = numbered(file, k, rows.size());
        if (format == ParaviewFormat::step)
            exporter.vtu(rows[k], one);
        else
            exporter.copy(rows[k], one);
        console.say(one.string() + ": step " + std::to_string(rows[k]));
    }
}

}  // namespace soft
