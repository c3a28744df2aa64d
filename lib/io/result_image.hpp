#pragma once
/// A result under construction in memory. ResultWriter appends steps to it, and reading a journal replays them into it.
/// Internal to the module.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/handle.hpp"
#include "io/result_file.hpp"

namespace soft::io {

class ResultImage {
public:
    // In this class, the image of `given` is an HDF5 file without seal and records.
    /// Adds the empty groups of a result to a case.
    static ResultImage begin(const SolveInput& given, const Provenance& provenance, const ResultOptions& options);
    /// Opens an image that begin() created.
    static ResultImage resume(const SolveInput& given);

    [[nodiscard]] const FieldsPolicy& policy() const noexcept { return policy_; }
    /// The current HDF5 file, without seal.
    [[nodiscard]] std::vector<std::byte> bytes() const;

    void append(const model::Step& step, std::span<const double> displacement, std::span<const double> pressure);
    /// Writes the path. Without `end` it is marked as the path of a killed solver.
    void finish(const std::optional<model::PathEnd>& end);

private:
    ResultImage() = default;
    static ResultImage open(const SolveInput& given);
    void require_valid(const model::Step& step) const;
    void require_valid(std::span<const double> displacement, std::span<const double> pressure) const;
    void write_fields(std::int64_t row, std::span<const double> displacement, std::span<const double> pressure);

    FileHandle file_;
    std::size_t points_ = 0;
    model::Case solved_;  ///< without mesh
    FieldsPolicy policy_;
    std::vector<model::Step> steps_;
    bool has_pressure_ = false;  ///< set by the first step
    DatasetHandle displacement_;
    DatasetHandle pressure_;
    std::vector<std::int64_t> stored_rows_;
    std::vector<double> last_displacement_;  ///< of the last step, if its fields are not yet stored
    std::vector<double> last_pressure_;
};

}  // namespace soft::io
