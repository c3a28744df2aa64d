#pragma once
/// The result file: the unchanged case plus /path, /modes, /fields and /provenance/<solver> (format: lib/io/README.md).
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
#include "model/checkpoint.hpp"
#include "model/path.hpp"

namespace soft::io {

/// Steps whose fields are stored. every: rows 0, N, 2N ... and the last one.
struct FieldsPolicy {
    enum class Keep { all, last, none, every };
    Keep keep = Keep::all;
    int interval = 1;  ///< N of every=N

    friend bool operator==(const FieldsPolicy&, const FieldsPolicy&) = default;
};

/// Parses "all", "last", "none" or "every=N"; throws Error (usage) otherwise.
[[nodiscard]] FieldsPolicy parse_fields_policy(std::string_view text);
[[nodiscard]] std::string to_text(const FieldsPolicy& policy);

struct ResultOptions {
    FieldsPolicy fields;
    std::optional<DesignText> changed_design;  ///< the design with overrides of solve, if any
};

/// Input of solve: the file as read (including the seal), its name for errors, and its case with the overrides of solve applied.
/// All must outlive the call to which they are passed.
struct SolveInput {
    std::span<const std::byte> image;
    std::string_view source;
    const model::Case& solved;
};

/// Writes converged steps one at a time. A result in memory and one on disk have the same bytes.
///
/// On disk: the first append() creates FILE, which contains the case (with an empty path) and one checksummed record after the HDF5
/// data. An existing file of that name is replaced only then. Each later append() adds a record with a single write and does not
/// change existing data. If the process is killed at any time, FILE can be opened (by other HDF5 tools as the case), and
/// read_result() returns all complete steps.
/// finish() replaces FILE with the plain result by renaming. Steps may be lost if the machine crashes.
/// A target that is not a regular file (/dev/null, a named pipe) is written only at finish().
/// Memory: the stored fields, compressed. With the policies last and every=N, the records on disk contain the fields of every step
/// until finish(); with none they contain no fields.
class ResultWriter {
public:
    /// In memory. `given`: a case. Throws Error (bad_input) as read_case_file does, and if the case already has a path.
    ResultWriter(const SolveInput& given, const Provenance& provenance, const ResultOptions& options);
    /// On disk. Also throws Error (cannot_create) if the file cannot be created or another process is writing it.
    ResultWriter(const std::filesystem::path& file, const SolveInput& given, const Provenance& provenance,
                 const ResultOptions& options);
    /// Continues the file of an interrupted solve; `given` is the file that was passed to read_interrupted. Truncates the file after its
    /// last checkpoint; the steps before it count as appended. Throws Error (bad_input) if the file is not an interrupted solve,
    /// Error (cannot_create) if it cannot be written, another process is writing it, or its size has changed since it was read.
    static ResultWriter resume(const std::filesystem::path& file, const SolveInput& given);

    ResultWriter(ResultWriter&&) noexcept;
    ResultWriter& operator=(ResultWriter&&) noexcept;
    ~ResultWriter();

    /// `displacement` [point, 3] in m, `pressure` [point] in Pa or empty (then for every step). The first step determines whether the
    /// steps have volumes and pressures. Throws Error (internal) for a step that is not finite or does not match the case or the
    /// previous steps, Error (io_error) if the disk is full.
    void append(const model::Step& step, std::span<const double> displacement, std::span<const double> pressure);

    /// Stores the state from which the solver can continue after the last appended step. Does nothing in memory. Errors as append().
    void save_checkpoint(const model::Checkpoint& checkpoint);

    /// Replaces the steps appended so far by those of `rows`, a writer in memory for the same case and options. append() must not be
    /// called afterwards. FILE is replaced, by renaming, with the complete result of these rows and `end`, and stays locked. publish()
    /// can be called again; finish() returns the last result. A target that is not a regular file is written only at finish().
    void publish(ResultWriter rows, const model::PathEnd& end);

    /// False if FILE has been removed or replaced by another file since the writer created it. Steps appended since then are not in a
    /// file that can be opened. finish() creates FILE again.
    [[nodiscard]] bool is_in_place() const;

    /// Writes the path and its end (those of the last publish(), if it was called). Returns the complete result; on disk it is also
    /// written to FILE. Must be the last call. Throws Error (internal) if there is no step, because read_result() would reject the file.
    std::vector<std::byte> finish(const model::PathEnd& end);

private:
    struct State;
    explicit ResultWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Reads the stored fields, one step at a time.
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
    /// nullopt for a step without fields. Throws Error (bad_input) for invalid data.
    [[nodiscard]] std::optional<Values> read(std::int64_t step) const;

private:
    std::unique_ptr<State> state_;
};

struct Result {
    model::Case model;                         ///< as it was solved, with the overrides of solve applied
    DesignText design;                         ///< of the case
    std::optional<DesignText> changed_design;  ///< with the overrides of solve applied, if there were any
    FieldsPolicy fields_policy;
    std::vector<Provenance> provenance;  ///< in alphabetical order of the tools
    std::vector<model::Step> steps;
    std::optional<model::PathEnd> end;  ///< empty: solve was killed or is still running
    FieldReader fields;
};

/// An interrupted `solve -o`, the input of `solve --resume`.
struct InterruptedSolve {
    CaseFile file;  ///< its model as it was solved, with the overrides of solve applied
    std::optional<DesignText> changed_design;
    std::vector<model::Step> steps;  ///< up to the checkpoint
    /// Empty if killed before the first checkpoint: start from the beginning.
    std::optional<model::Checkpoint> checkpoint;
};

/// Throws Error (bad_input) for a case, a finished result or a damaged file.
[[nodiscard]] InterruptedSolve read_interrupted(std::span<const std::byte> image, std::string_view source,
                                                const model::CaseBuilder& build);

/// Reads a finished result, or the file of a running or killed `solve -o`. Checks the file as read_case_file does.
/// The result keeps the image to read fields later. Throws Error (bad_input) for a case without solution (remedy "run solve on it")
/// and for a path without rows ("run solve again").
[[nodiscard]] Result read_result(std::vector<std::byte> image, std::string_view source,
                                 const model::CaseBuilder& build);

}  // namespace soft::io
