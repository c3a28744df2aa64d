#pragma once
/// The result file: the case as it was given plus /path, /modes, /fields and /provenance/<solver> (schema: lib/io/README.md).
/// Tested by io/result_file_test, io/damage_test.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/case_file.hpp"
#include "io/provenance.hpp"
#include "model/case.hpp"
#include "solution/checkpoint.hpp"
#include "solution/path.hpp"

namespace soft::io {

/// Which steps keep their fields. every: rows 0, N, 2N ... and the last one.
struct FieldsPolicy {
    enum class Keep { all, last, none, every };
    Keep keep = Keep::all;
    int interval = 1;  ///< N of every=N

    friend bool operator==(const FieldsPolicy&, const FieldsPolicy&) = default;
};

/// "all", "last", "none", "every=N"; Error (usage) otherwise.
[[nodiscard]] FieldsPolicy parse_fields_policy(std::string_view text);
[[nodiscard]] std::string to_text(const FieldsPolicy& policy);

struct ResultOptions {
    FieldsPolicy fields;
    std::optional<DesignText> changed_design;  ///< where solve was given overrides of its own
};

/// What is solved: a file as read, seal included, how errors call it, and its case with solve's own overrides in place.
/// All must outlive the call they are given to, no longer.
struct Given {
    std::span<const std::byte> image;
    std::string_view source;
    const model::Case& solved;
};

/// Takes converged steps one by one. The bytes of the result are the same whether it is kept in memory or on disk.
///
/// On disk: the first append() makes FILE, the whole case (with an empty path) and one checksummed record behind the HDF5 data;
/// until then what stands under that name stays. Each later append() adds a record with a single write. Nothing that is already
/// in the file is touched, so after a kill at any time FILE opens (in every HDF5 tool: as the case) and read_result() finds all
/// whole steps in it.
/// finish() replaces FILE by the plain result, by renaming. Not promised: that steps survive a crash of the machine.
/// A target that is no regular file (/dev/null, a named pipe) is written at finish() only.
/// Memory: the fields that are kept, compressed. With policy last or every=N the records on disk still hold the fields
/// of every step until finish(); with none they hold no fields.
class ResultWriter {
public:
    /// `given`: a case. Throws Error (bad_input) as read_case does, or if it already has a path.
    ResultWriter(const Given& given, const Provenance& provenance, const ResultOptions& options);
    /// The same on disk. Throws Error (cannot_create) as well, also while another process writes the file.
    ResultWriter(const std::filesystem::path& file, const Given& given, const Provenance& provenance,
                 const ResultOptions& options);
    /// Goes on with the file of an interrupted solve, `given` as read_interrupted gave it: what is behind its last
    /// checkpoint is cut off, the steps before it count as appended. Throws Error (bad_input) for a file that is no such,
    /// Error (cannot_create) where it cannot be written, is being written by another process, or has changed since.
    static ResultWriter resume(const std::filesystem::path& file, const Given& given);

    ResultWriter(ResultWriter&&) noexcept;
    ResultWriter& operator=(ResultWriter&&) noexcept;
    ~ResultWriter();

    /// `displacement` [point, 3] in m, `pressure` [point] in Pa or empty (then for every step). The first step decides
    /// whether there are volumes and pressures. Throws Error (internal) for a step that does not fit the case or the
    /// steps before or is not finite, Error (io_error) for a full disk.
    void append(const solution::Step& step, std::span<const double> displacement, std::span<const double> pressure);

    /// Remembers what the solver needs to go on from the step last appended. Nothing to do in memory. Errors as append.
    void remember(const solution::Checkpoint& checkpoint);

    /// `rows`, a writer in memory for the same case and options, replaces the steps appended so far; nothing is appended after
    /// it. FILE becomes, by renaming, the whole result of them and `end`, and stays locked: it can be called again, and finish()
    /// returns the last one. A target that is no regular file is written at finish() only.
    void publish(ResultWriter rows, const solution::PathEnd& end);

    /// False where FILE has been removed, or replaced by another file, since the writer made it: steps appended since then
    /// are in no file that can be opened. finish() makes FILE anew.
    [[nodiscard]] bool is_in_place() const;

    /// Writes path and end (those of publish(), where it was called). Returns the whole result; on disk it is also FILE. Call it
    /// once, nothing after it. Throws Error (internal) without a step: read_result() would refuse the file.
    std::vector<std::byte> finish(const solution::PathEnd& end);

private:
    struct State;
    explicit ResultWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// The stored fields; reads one step at a time.
class FieldReader {
public:
    struct Values {
        std::vector<double> displacement_m;  ///< [point, 3]
        std::vector<double> pressure_Pa;     ///< [point]; empty if the formulation has none
    };
    struct State;
    explicit FieldReader(std::unique_ptr<State> state);
    FieldReader(FieldReader&&) noexcept;
    FieldReader& operator=(FieldReader&&) noexcept;
    ~FieldReader();

    /// Rows of the path whose fields are stored, ascending.
    [[nodiscard]] const std::vector<std::int64_t>& steps() const noexcept;
    /// nullopt for a step without fields. Throws Error (bad_input) for damaged data.
    [[nodiscard]] std::optional<Values> read(std::int64_t step) const;

private:
    std::unique_ptr<State> state_;
};

struct Result {
    model::Case model;                         ///< as it was solved: solve's own overrides in place
    DesignText design;                         ///< of the case
    std::optional<DesignText> changed_design;  ///< solve's own overrides applied, where there were any
    FieldsPolicy fields_policy;
    std::vector<Provenance> provenance;  ///< in alphabetical order of the tools
    std::vector<solution::Step> steps;
    std::optional<solution::PathEnd> end;  ///< empty: solve was killed or is still at work
    FieldReader fields;
};

/// An interrupted `solve -o` as `solve --resume` wants it.
struct Interrupted {
    CaseFile file;  ///< its model as it was solved, solve's own overrides in place
    std::optional<DesignText> changed_design;
    std::vector<solution::Step> steps;               ///< up to the checkpoint
    std::optional<solution::Checkpoint> checkpoint;  ///< empty: killed before the second row; start from the beginning
};

/// Throws Error (bad_input) for a case, a finished result ("is finished") or a damaged file.
[[nodiscard]] Interrupted read_interrupted(std::span<const std::byte> image, std::string_view source);

/// Reads a finished result, or what a running or killed `solve -o` has left. Checks as read_case does.
/// The image is kept for reading fields later. A case without solution is refused with the remedy "run solve on it", a path
/// without a row with "run solve again".
[[nodiscard]] Result read_result(std::vector<std::byte> image, std::string_view source);

}  // namespace soft::io
