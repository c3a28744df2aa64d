#pragma once
/// Layout of case and result files:   [HDF5 file] [seal record] [step record] ...
/// HDF5 ignores bytes after its end-of-file address, so every HDF5 tool can open the file directly.
///   seal   SHA-256 of the HDF5 part. The HDF5 library is not robust against damaged metadata (1.10.8 may loop or crash); the seal
///          detects damage before the library reads the file. Files that other programs wrote or changed have no seal (HDF5 removes
///          the records when it opens a file for writing). They are first read in a subprocess (subprocess_read.hpp) and then with
///          all other checks.
///   step   one step of a running or killed `solve -o` (journal.hpp). Finished files have none.
///   checkpoint   state from which the solver can continue after the preceding steps (model/checkpoint.hpp). Finished files
///          have none.
/// Record: 8 bytes "SOFTREC1", 8 bytes kind, 8 bytes payload length (little endian), payload, 64 bytes SHA-256 (hex)
/// of all preceding bytes of the record. An incomplete step or checkpoint record at the end of the file is the result of a killed
/// process and is ignored. Any other incomplete record is an error.
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace soft::io {

struct ImageParts {
    std::span<const std::byte> hdf5;
    bool sealed = false;
    std::vector<std::span<const std::byte>> steps;         ///< payloads of the complete step records
    std::optional<std::span<const std::byte>> checkpoint;  ///< payload of the last complete one
    std::size_t resume_steps = 0;                          ///< number of step records before the last checkpoint
    std::size_t resume_end = 0;  ///< offset of the end of the last checkpoint, or of the seal if there is none
};

enum class RecordKind { seal, step, checkpoint };

/// Checks the signature, the superblock, the end-of-file address against the size of the image, and the seal, without the HDF5
/// library. Throws Error (bad_input), e.g. "<stdin>: empty input; check whether the previous program failed".
[[nodiscard]] ImageParts split_image(std::span<const std::byte> image, std::string_view source);

[[nodiscard]] std::vector<std::byte> make_record(RecordKind kind, std::span<const std::byte> payload);

/// Appends the seal to a bare HDF5 image.
void seal(std::vector<std::byte>& hdf5);

}  // namespace soft::io
