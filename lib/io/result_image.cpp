#include "io/result_image.hpp"

#include <algorithm>
#include <charconv>

#include "core/text.hpp"
#include "io/hdf5_read.hpp"
#include "io/hdf5_write.hpp"
#include "io/path_columns.hpp"
#include "io/path_table.hpp"
#include "io/provenance_io.hpp"

namespace soft::io {
namespace {

GroupHandle open_group(hid_t parent, const char* name) {
    GroupHandle group{H5Gopen2(parent, name, H5P_DEFAULT)};
    if (!group) throw Error(ExitCode::internal, name, "the group does not exist");
    return group;
}

/// The case without its mesh, which is large and not needed here.
model::Case without_mesh(const model::Case& input) {
    return {input.name,           input.kinematics,      input.formulation,
            input.model_fraction, input.symmetry_planes, {},
            input.materials,      input.supports,        input.cavities,
            input.loads,          input.dead_loads,      input.motions,
            input.obstacles,      input.contact,         input.outputs,
            input.path,           input.solver,          input.dynamics,
            input.parameters};
}

/// Throws Error (bad_input) if the file contains a result or parts of one.
void require_no_solution(hid_t root, const std::string& tool, std::string_view source) {
    for (const std::string& name : {std::string{"path"}, std::string{"fields"}, std::string{"modes"},
                                    std::string{changed_design_group}, "provenance/" + tool})
        if (H5Lexists(root, name.c_str(), H5P_DEFAULT) > 0)
            throw Error(ExitCode::bad_input, std::string{source} + ":/" + name, "already contains a solution",
                        "give solve the case from mesh-gen");
}

void write_changed_design(hid_t root, const DesignText& design) {
    const GroupHandle group =
        create_group(root, changed_design_group, "the design with the overrides of solve applied");
    write_text(group.get(), {"effective_yaml", "1", "the design that was solved"}, design.effective_yaml);
    write_texts(group.get(), {"overrides", "1", "key.path=value, as given to --set"}, design.overrides);
}

}  // namespace

FieldsPolicy parse_fields_policy(std::string_view text) {
    using Keep = FieldsPolicy::Keep;
    if (text == "all") return {Keep::all};
    if (text == "last") return {Keep::last};
    if (text == "none") return {Keep::none};
    constexpr std::string_view every = "every=";
    int interval = 0;
    if (text.starts_with(every)) {
        const auto [end, error] = std::from_chars(text.data() + every.size(), text.data() + text.size(), interval);
        if (error == std::errc{} && end == text.data() + text.size() && interval >= 1) return {Keep::every, interval};
    }
    throw Error(ExitCode::usage, "--fields", core::quoted(text) + " is not a valid choice",
                "use all, last, none or every=N");
}

std::string to_text(const FieldsPolicy& policy) {
    switch (policy.keep) {
        case FieldsPolicy::Keep::all: return "all";
        case FieldsPolicy::Keep::last: return "last";
        case FieldsPolicy::Keep::none: return "none";
        case FieldsPolicy::Keep::every: return "every=" + std::to_string(policy.interval);
    }
    return "all";
}

ResultImage ResultImage::open(const SolveInput& given) {
    ResultImage image;
    const Origin origin{std::string{given.source}, given.image.size()};
    image.file_ = open_memory_copy(given.image);
    if (!image.file_)
        throw Error(ExitCode::bad_input, given.source, "HDF5 cannot open it: " + hdf5_reason(), origin.remedy);
    const GroupReader root{image.file_.get(), origin};
    const GroupReader mesh = root.group("VTKHDF");
    const std::int64_t points = mesh.array<std::int64_t>("NumberOfPoints", {1})[0];
    static_cast<void>(mesh.checked_rows("Points", {points, 3}));
    image.points_ = static_cast<std::size_t>(points);
    image.solved_ = without_mesh(given.solved);
    return image;
}

ResultImage ResultImage::begin(const SolveInput& given, const Provenance& provenance, const ResultOptions& options) {
    ResultImage image = open(given);
    const GroupHandle root = open_group(image.file_.get(), "/");
    require_no_solution(root.get(), provenance.tool, given.source);
    image.policy_ = options.fields;
    const GroupHandle path = create_group(root.get(), "path", "the equilibrium path, one row per step");
    const GroupHandle fields = create_group(root.get(), "fields", "nodal fields of the stored steps");
    write_attribute(fields.get(), "policy", to_text(options.fields));
    if (options.changed_design) write_changed_design(root.get(), *options.changed_design);
    write_provenance(open_group(root.get(), "provenance").get(), provenance);
    // HDF5 allocates new objects in free gaps of the file, which it forgets when the file is reopened. Reopening here makes the bytes
    // of an uninterrupted path equal to those of a resumed one.
    const auto begun = image.bytes();
    return resume({begun, given.source, given.solved});
}

ResultImage ResultImage::resume(const SolveInput& given) {
    ResultImage image = open(given);
    const Origin origin{std::string{given.source}, given.image.size(), "run solve again"};
    const GroupReader root{image.file_.get(), origin};
    const GroupReader path = root.group("path");
    if (!path.names().empty()) throw path.refuse("", "already has rows, but more rows follow the HDF5 data");
    image.policy_ = parse_fields_policy(root.group("fields").text_attribute("policy"));
    return image;
}

std::vector<std::byte> ResultImage::bytes() const { return memory_image(file_.get()); }

void ResultImage::require_valid(const model::Step& step) const {
    if (const auto problem = problem_of(step, steps_.empty() ? nullptr : &steps_.back(), solved_))
        throw Error(ExitCode::internal, "/path/" + problem->column, problem->text);
}

void ResultImage::require_valid(std::span<const double> displacement, std::span<const double> pressure) const {
    if (displacement.size() != 3 * points_)
        throw Error(ExitCode::internal, "/fields/displacement", "a step does not have three values per point");
    if (!pressure.empty() && pressure.size() != points_)
        throw Error(ExitCode::internal, "/fields/pressure", "a step does not have one value per point");
    if (!steps_.empty() && has_pressure_ == pressure.empty())
        throw Error(ExitCode::internal, "/fields/pressure", "some steps have pressures, some have none");
    if (!all_finite(displacement) || !all_finite(pressure))
        throw Error(ExitCode::internal, "/fields", "a converged step has a value that is not finite");
}

void ResultImage::append(const model::Step& step, std::span<const double> displacement,
                         std::span<const double> pressure) {
    using Keep = FieldsPolicy::Keep;
    require_valid(step);
    if (policy_.keep != Keep::none) require_valid(displacement, pressure);
    if (steps_.empty()) has_pressure_ = !pressure.empty();
    const auto row = static_cast<std::int64_t>(steps_.size());
    steps_.push_back(step);
    if (policy_.keep == Keep::all || (policy_.keep == Keep::every && row % policy_.interval == 0)) {
        write_fields(row, displacement, pressure);
        last_displacement_.clear();
    } else if (policy_.keep != Keep::none) {
        last_displacement_.assign(displacement.begin(), displacement.end());
        last_pressure_.assign(pressure.begin(), pressure.end());
    }
}

void ResultImage::write_fields(std::int64_t row, std::span<const double> displacement,
                               std::span<const double> pressure) {
    const GroupHandle fields = open_group(file_.get(), "/fields");
    if (!displacement_) {
        displacement_ = create_rows(fields.get(), {"displacement", "m", "stored step, point, component"}, {points_, 3});
        if (has_pressure_) pressure_ = create_rows(fields.get(), {"pressure", "Pa", "stored step, point"}, {points_});
    }
    append_row(displacement_.get(), displacement);
    if (has_pressure_) append_row(pressure_.get(), pressure);
    stored_rows_.push_back(row);
}

void ResultImage::finish(const std::optional<model::PathEnd>& end) {
    if (end && steps_.empty()) throw Error(ExitCode::internal, "/path", "the path has no row");
    if (!last_displacement_.empty())
        write_fields(static_cast<std::int64_t>(steps_.size()) - 1, last_displacement_, last_pressure_);
    const GroupHandle fields = open_group(file_.get(), "/fields");
    write_array<std::int64_t>(fields.get(), {"steps", "1", "row of /path of each stored step"}, stored_rows_);
    const GroupHandle path = open_group(file_.get(), "/path");
    write_steps(path.get(), steps_, solved_);
    if (!end) return;
    write_end(path.get(), *end, solved_, steps_.size());
    write_modes(open_group(file_.get(), "/").get(), *end, points_);
}

}  // namespace soft::io
