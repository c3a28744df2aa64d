#pragma once
/// A file of ours as bytes:   [HDF5 file] [seal record] [step record] ...
/// HDF5 ignores what follows its own end-of-file address, so every HDF5 tool opens the file as it is.
///   seal   SHA-256 of the HDF5 part. The HDF5 library is not safe on damaged metadata (1.10.8 may loop or crash):
///          with the seal it never sees any. Files that other programs wrote or changed have none (HDF5 cuts the tail
///          off when it opens a file for writing) and are read all the same, with every other check, on trial first (trial.hpp).
///   step   one step of a running or killed `solve -o` (journal.hpp); a finished file has none.
///   checkpoint   what the solver needs to go on from the steps before it (solution/checkpoint.hpp); likewise.
/// Record: 8 bytes "SOFTREC1", 8 bytes kind, 8 bytes payload length (little endian), payload, 64 bytes SHA-256 (hex)
/// of all that. A step or checkpoint record cut short at the very end is what a kill leaves and is dropped; anything else that is
/// not whole is refused.
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace soft::io {

struct ImageParts {
    std::span<const std::byte> hdf5;
    bool sealed = false;
    std::vector<std::span<const std::byte>> steps;  ///< payloads of the whole step records
    /// The last whole checkpoint: its payload, how many step records are before it, and where it ends in the image.
    struct Checkpoint {
        std::span<const std::byte> payload;
        std::size_t steps = 0, end = 0;
    };
    std::optional<Checkpoint> checkpoint;
};

enum class RecordKind { seal, step, checkpoint };

/// Checks signature, superblock, end-of-file address against the bytes present, and the seal, without the HDF5
/// library. Throws Error (bad_input), for empty input "<stdin>: empty input; did the stage before fail?".
[[nodiscard]] ImageParts split_image(std::span<const std::byte> image, std::string_view source);

/// Where the seal of a sealed image ends and its other records begin.
[[nodiscard]] std::size_t seal_end(std::span<const std::byte> image, std::string_view source);

[[nodiscard]] std::vector<std::byte> make_record(RecordKind kind, std::span<const std::byte> payload);

/// Appends the seal to a bare HDF5 image.
void seal(std::vector<std::byte>& hdf5);

}  // namespace soft::io
