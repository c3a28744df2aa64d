#pragma once
/// The growing result in memory: what ResultWriter fills step by step and what a journal is folded into. Internal.
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
    // The image of `given` is a bare HDF5 file here.
    /// A case to which the empty groups of a result are added.
    static ResultImage begin(const Given& given, const Provenance& provenance, const ResultOptions& options);
    /// An image made by begin().
    static ResultImage resume(const Given& given);

    [[nodiscard]] const FieldsPolicy& policy() const noexcept { return policy_; }
    /// The HDF5 file as it is now, not sealed.
    [[nodiscard]] std::vector<std::byte> bytes() const;

    void append(const solution::Step& step, std::span<const double> displacement, std::span<const double> pressure);
    /// Writes the path; without `end` as that of a solver that was killed.
    void finish(const std::optional<solution::PathEnd>& end);

private:
    ResultImage() = default;
    static ResultImage open(const Given& given);
    void require_fitting(const solution::Step& step, std::span<const double> displacement,
                         std::span<const double> pressure) const;
    void write_fields(std::int64_t row, std::span<const double> displacement, std::span<const double> pressure);

    FileHandle file_;
    std::size_t points_ = 0;
    model::Case solved_;  ///< its mesh is empty
    FieldsPolicy policy_;
    std::vector<solution::Step> steps_;
    bool has_pressure_ = false;  ///< decided by the first step
    DatasetHandle displacement_;
    DatasetHandle pressure_;
    std::vector<std::int64_t> stored_rows_;
    std::vector<double> last_displacement_;  ///< of the last step, if its fields are not stored yet
    std::vector<double> last_pressure_;
};

}  // namespace soft::io
