#pragma once
/// Encodes steps and checkpoints of a running `solve -o` as payloads of records after the HDF5 data (image.hpp).
/// Layout: the members in the order of the lists in journal.cpp, little endian. int: 4 bytes; bool: 1 byte; an optional value follows a
/// bool; the length of a list (8 bytes) precedes its values. All doubles are finite. Tested by io/journal_test.
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "model/checkpoint.hpp"
#include "model/path.hpp"

namespace soft::io {

struct JournalStep {
    model::Step step;
    std::vector<double> displacement_m;  ///< [point, 3], or empty
    std::vector<double> pressure_Pa;     ///< [point], or empty
};

[[nodiscard]] std::vector<std::byte> encode_step(const model::Step& step, std::span<const double> displacement,
                                                 std::span<const double> pressure);
/// Throws Error (bad_input) if the payload does not have this layout or contains non-finite values.
[[nodiscard]] JournalStep decode_step(std::span<const std::byte> payload, std::string_view source);

[[nodiscard]] std::vector<std::byte> encode_checkpoint(const model::Checkpoint& checkpoint);
/// Throws Error (bad_input) if the payload does not have this layout or contains non-finite values.
[[nodiscard]] model::Checkpoint decode_checkpoint(std::span<const std::byte> payload, std::string_view source);

}  // namespace soft::io
