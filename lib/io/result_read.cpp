#include <algorithm>
#include <limits>

#include "io/case_read.hpp"
#include "io/image.hpp"
#include "io/journal.hpp"
#include "io/path_table.hpp"
#include "io/result_file.hpp"
#include "io/result_image.hpp"

namespace soft::io {

/// The order of members is that of dependence: handles close before the bytes go.
struct FieldReader::State {
    std::vector<std::byte> image;
    Origin origin;
    FileHandle file;
    std::optional<GroupReader> group;
    std::vector<std::int64_t> steps;
    std::int64_t points = 0;
    DatasetHandle displacement;
    DatasetHandle pressure;
};

namespace {

/// What a running or killed solve left: the case with an empty path, and steps behind the HDF5 data.
std::vector<std::byte> folded(const ImageParts& parts, std::string_view source) {
    ResultImage image = ResultImage::resume(parts.hdf5, source);
    try {
        for (const auto payload : parts.steps) {
            const JournalStep record = decode_step(payload, source);
            image.append(record.step, record.displacement_m, record.pressure_Pa);
        }
    } catch (const Error& error) {
        // The image refuses steps of the solver as a bug; here they came from a file.
        throw Error(ExitCode::bad_input, source, error.what(), "run solve again");
    }
    image.finish(std::nullopt);
    return image.bytes();
}

bool lacks_rows(std::span<const std::byte> hdf5, std::string_view source) {
    const Origin origin{std::string{source}, hdf5.size()};
    const FileHandle file = open_image(hdf5, origin);
    const GroupReader root{file.get(), origin};
    if (!root.has("path"))
        throw Error(ExitCode::bad_input, source, "a case without solution", "run solve on it");
    return !root.group("path").has("step");
}

void check_fields(FieldReader::State& state, const GroupReader& root, std::size_t rows, std::size_t points) {
    state.group.emplace(root.group("fields"));
    const GroupReader& group = *state.group;
    state.points = static_cast<std::int64_t>(points);
    state.steps = group.array<std::int64_t>("steps", {any});
    for (std::size_t i = 0; i < state.steps.size(); ++i) {
        const std::int64_t before = i == 0 ? -1 : state.steps[i - 1];
        if (state.steps[i] <= before || state.steps[i] >= static_cast<std::int64_t>(rows))
            throw group.refuse("steps[" + std::to_string(i) + "]",
                               "step " + std::to_string(state.steps[i]) + " does not exist or is out of order");
    }
    if (state.steps.empty()) return;
    const auto stored = static_cast<std::int64_t>(state.steps.size());
    state.displacement = group.checked_rows("displacement", {stored, state.points, 3});
    if (group.has("pressure")) state.pressure = group.checked_rows("pressure", {stored, state.points});
}

FieldsPolicy read_policy(const GroupReader& fields) {
    try {
        return parse_fields_policy(fields.text_attribute("policy"));
    } catch (const Error& error) {
        throw fields.refuse("policy", error.what());
    }
}

}  // namespace

FieldReader::FieldReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
FieldReader::FieldReader(FieldReader&&) noexcept = default;
FieldReader& FieldReader::operator=(FieldReader&&) noexcept = default;
FieldReader::~FieldReader() {
    const QuietErrors quiet;
    state_.reset();
}

const std::vector<std::int64_t>& FieldReader::steps() const noexcept { return state_->steps; }

std::optional<FieldReader::Values> FieldReader::read(std::int64_t step) const {
    const auto found = std::lower_bound(state_->steps.begin(), state_->steps.end(), step);
    if (found == state_->steps.end() || *found != step) return std::nullopt;
    const QuietErrors quiet;
    const std::int64_t row = found - state_->steps.begin();
    const auto points = static_cast<std::size_t>(state_->points);
    Values values;
    values.displacement_m = state_->group->row(state_->displacement.get(), "displacement", row, 3 * points);
    if (state_->pressure) values.pressure_Pa = state_->group->row(state_->pressure.get(), "pressure", row, points);
    return values;
}

Interrupted read_interrupted(std::span<const std::byte> image, std::string_view source) {
    const QuietErrors quiet;
    const ImageParts parts = split_image(image, source);
    if (!lacks_rows(parts.hdf5, source))
        throw Error(ExitCode::bad_input, source, "is finished, there is nothing to resume", "postprocess reads it");
    const Origin origin{std::string{source}, parts.hdf5.size(), "run solve again"};
    const FileHandle file = open_image(parts.hdf5, origin);
    const GroupReader root{file.get(), origin};
    Interrupted interrupted;
    interrupted.file = read_case_groups(root);
    if (root.has("solve_design")) interrupted.changed_design = read_design_text(root.group("solve_design"));
    if (!parts.checkpoint) return interrupted;
    interrupted.checkpoint = decode_checkpoint(parts.checkpoint->payload, source);
    for (std::size_t i = 0; i < parts.checkpoint->steps; ++i)
        interrupted.steps.push_back(decode_step(parts.steps[i], source).step);
    if (interrupted.steps.size() != static_cast<std::size_t>(interrupted.checkpoint->rows))
        throw Error(ExitCode::bad_input, source, "the last checkpoint does not fit the steps before it", "run solve again");
    return interrupted;
}

Result read_result(std::vector<std::byte> image, std::string_view source) {
    const QuietErrors quiet;
    const ImageParts parts = split_image(image, source);
    std::size_t hdf5_size = parts.hdf5.size();
    if (lacks_rows(parts.hdf5, source)) {
        image = folded(parts, source);
        hdf5_size = image.size();
    }
    auto state = std::make_unique<FieldReader::State>();
    state->image = std::move(image);
    state->origin = {std::string{source}, hdf5_size, "run solve again"};
    state->file = open_image(std::span{state->image}.first(hdf5_size), state->origin);
    const GroupReader root{state->file.get(), state->origin};
    CaseFile file = read_case_groups(root);
    std::vector<std::string> outputs;
    for (const model::Output& output : file.model.outputs) outputs.push_back(output.name);
    const GroupReader path = root.group("path");
    auto steps = read_steps(path, outputs);
    std::optional<solution::PathEnd> end;
    if (path.has_attribute("stop_reason")) end = read_end(path, outputs, steps.size());
    check_fields(*state, root, steps.size(), file.model.mesh.points.size());
    const FieldsPolicy policy = read_policy(root.group("fields"));
    std::optional<DesignText> changed;
    if (root.has("solve_design")) changed = read_design_text(root.group("solve_design"));
    return {std::move(file.model), std::move(file.design), std::move(changed), policy, std::move(file.provenance),
            std::move(steps), std::move(end), FieldReader{std::move(state)}};
}

}  // namespace soft::io
