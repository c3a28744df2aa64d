#include <algorithm>
#include <limits>

#include "io/case_read.hpp"
#include "io/image.hpp"
#include "io/journal.hpp"
#include "io/path_table.hpp"
#include "io/result_file.hpp"
#include "io/result_image.hpp"
#include "io/subprocess_read.hpp"

namespace soft::io {

/// The order of the members matters: handles must be closed before the image is freed.
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

/// Result of a running or killed solve: adds the step records after the HDF5 data to the case with an empty path.
std::vector<std::byte> replay_journal(const ImageParts& parts, std::string_view source, const model::Case& solved) {
    ResultImage image = ResultImage::resume({parts.hdf5, source, solved});
    try {
        for (const auto payload : parts.steps) {
            const JournalStep record = decode_step(payload, source);
            image.append(record.step, record.displacement_m, record.pressure_Pa);
        }
    } catch (const Error& error) {
        // ResultImage reports invalid steps as internal errors; here they come from a file.
        throw Error(ExitCode::bad_input, source, error.what(), "run solve again");
    }
    image.finish(std::nullopt);
    return image.bytes();
}

bool has_no_rows(std::span<const std::byte> hdf5, const Origin& origin) {
    const FileHandle file = open_image(hdf5, origin);
    const GroupReader root{file.get(), origin};
    if (!root.has("path"))
        throw Error(ExitCode::bad_input, origin.source, "a case without solution", "run solve on it");
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

/// The case of a result as it was solved, with the design that overrides of solve changed, if any.
struct Solved {
    CaseFile file;
    std::optional<DesignText> changed_design;
};

Solved read_solved(const GroupReader& root, const model::CaseBuilder& build) {
    StoredCase stored = read_stored_case(root);
    std::optional<DesignText> changed;
    if (root.has(changed_design_group)) changed = read_design_text(root.group(changed_design_group));
    const DesignText& design = changed ? *changed : stored.design;
    model::Case model = build(std::move(stored.mesh), stored.shape, design.effective_yaml,
                              design_location(root.origin(), changed ? changed_design_group : "design"));
    model.parameters = parameters_of(stored.variations);
    return {{std::move(model), std::move(stored.design), std::move(stored.provenance)}, std::move(changed)};
}

/// The same for an HDF5 file without seal and records.
Solved read_solved(std::span<const std::byte> hdf5, const Origin& origin, const model::CaseBuilder& build) {
    const FileHandle file = open_image(hdf5, origin);
    return read_solved(GroupReader{file.get(), origin}, build);
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

namespace {

Origin origin_of(const ImageParts& parts, std::string_view source) {
    return {std::string{source}, parts.hdf5.size(), "run solve again"};
}

/// `parts` are those of the image, or of another image with the same HDF5 part.
Result read_bare_result(std::vector<std::byte> image, const ImageParts& parts, const Origin& origin,
                        const model::CaseBuilder& build) {
    std::size_t hdf5_size = parts.hdf5.size();
    if (has_no_rows(parts.hdf5, origin)) {
        image = replay_journal(parts, origin.source, read_solved(parts.hdf5, origin, build).file.model);
        hdf5_size = image.size();
    }
    auto state = std::make_unique<FieldReader::State>();
    state->image = std::move(image);
    state->origin = origin;
    state->origin.image_bytes = hdf5_size;
    state->file = open_image(std::span{state->image}.first(hdf5_size), state->origin);
    const GroupReader root{state->file.get(), state->origin};
    Solved solved = read_solved(root, build);
    CaseFile& file = solved.file;
    const std::size_t points = file.model.mesh.points.size();
    const GroupReader path = root.group("path");
    auto steps = read_steps(path, file.model);
    std::optional<model::PathEnd> end;
    if (path.has_attribute("stop_reason")) {
        end = read_end(path, file.model, steps.size());
        read_modes(root, *end, points);
    }
    check_fields(*state, root, steps.size(), points);
    const FieldsPolicy policy = read_policy(root.group("fields"));
    return {std::move(file.model),
            std::move(file.design),
            std::move(solved.changed_design),
            policy,
            std::move(file.provenance),
            std::move(steps),
            std::move(end),
            FieldReader{std::move(state)}};
}

/// Reads everything in the image, so that later reads cannot crash. Invalid values in fields are ignored here; FieldReader reports
/// them.
void read_all(const ImageParts& parts, const Origin& origin, const model::CaseBuilder& build) {
    const Result result = read_bare_result({parts.hdf5.begin(), parts.hdf5.end()}, parts, origin, build);
    for (const std::int64_t step : result.fields.steps()) try {
            static_cast<void>(result.fields.read(step));
        } catch (const Error&) {}
}

}  // namespace

InterruptedSolve read_interrupted(std::span<const std::byte> image, std::string_view source,
                                  const model::CaseBuilder& build) {
    const QuietErrors quiet;
    const ImageParts parts = split_image(image, source);
    const Origin origin = origin_of(parts, source);
    if (!parts.sealed) read_in_subprocess(origin, [&](const Origin& noted) { read_all(parts, noted, build); });
    if (!has_no_rows(parts.hdf5, origin))
        throw Error(ExitCode::bad_input, source, "is finished and cannot be resumed", "read it with postprocess");
    Solved solved = read_solved(parts.hdf5, origin, build);
    InterruptedSolve interrupted{std::move(solved.file), std::move(solved.changed_design), {}, std::nullopt};
    if (!parts.checkpoint) return interrupted;
    interrupted.checkpoint = decode_checkpoint(*parts.checkpoint, source);
    for (std::size_t i = 0; i < parts.resume_steps; ++i)
        interrupted.steps.push_back(decode_step(parts.steps[i], source).step);
    // The solver checks whether the states match its unknowns.
    if (interrupted.steps.size() != static_cast<std::size_t>(interrupted.checkpoint->rows) ||
        interrupted.steps.empty() || interrupted.steps.back().stage > interrupted.checkpoint->stage)
        throw Error(ExitCode::bad_input, source, "the last checkpoint does not match the steps before it",
                    "run solve again");
    return interrupted;
}

Result read_result(std::vector<std::byte> image, std::string_view source, const model::CaseBuilder& build) {
    const QuietErrors quiet;
    const ImageParts parts = split_image(image, source);
    const Origin origin = origin_of(parts, source);
    if (!parts.sealed) read_in_subprocess(origin, [&](const Origin& noted) { read_all(parts, noted, build); });
    Result result = read_bare_result(std::move(image), parts, origin, build);
    if (result.steps.empty())
        throw Error(ExitCode::bad_input, std::string{source} + ":/path", "the path has no row", "run solve again");
    return result;
}

}  // namespace soft::io
