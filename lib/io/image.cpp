#include "io/image.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"

namespace soft::io {
namespace {

static_assert(std::endian::native == std::endian::little, "records and superblocks are read without byte swapping");

constexpr std::string_view hdf5_signature{"\x89HDF\r\n\x1a\n", 8};
constexpr std::string_view record_magic = "SOFTREC1";
constexpr std::array<std::string_view, 3> kind_words{"seal    ", "step    ",
                                                     "state   "};  ///< in the order of RecordKind
constexpr std::size_t header_size = 24;
constexpr std::size_t hash_size = 64;
constexpr std::uint64_t no_address = ~std::uint64_t{0};

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint64_t u64_at(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

Error truncated(std::string_view source, std::size_t present, std::string_view wanted) {
    return {ExitCode::bad_input, source,
            "truncated: " + std::to_string(present) + " bytes present, " + std::string{wanted},
            "check whether the program that wrote it was killed or the disk was full"};
}

Error damaged(std::string_view source, std::string_view problem) {
    return {ExitCode::bad_input, source, problem, "copy the file again, or rerun mesh-gen or solve"};
}

/// Offsets of the fields of a superblock (HDF5 File Format Specification 3.0, section II.A).
struct SuperblockLayout {
    std::size_t offset_size, base, end, driver, size;  ///< driver: 0 where the version has no such field
};

std::optional<SuperblockLayout> superblock_layout(unsigned version) {
    switch (version) {
        case 0: return SuperblockLayout{13, 24, 40, 48, 96};
        case 1: return SuperblockLayout{13, 28, 44, 52, 100};
        case 2:
        case 3: return SuperblockLayout{9, 12, 28, 0, 48};
        default: return std::nullopt;
    }
}

/// Length of the HDF5 part.
std::size_t hdf5_size(std::span<const std::byte> image, std::string_view source) {
    const std::string_view head = text_of(image.first(std::min(image.size(), hdf5_signature.size())));
    if (head != hdf5_signature.substr(0, head.size()))
        throw Error(ExitCode::bad_input, source, "not an HDF5 file (it begins with " + core::quoted(head) + ")",
                    "expected a case from mesh-gen or a result from solve");
    if (image.size() < 9) throw truncated(source, image.size(), "too few for an HDF5 file");
    const unsigned version = std::to_integer<unsigned>(image[8]);
    const auto layout = superblock_layout(version);
    if (!layout) throw damaged(source, "unknown HDF5 superblock version " + std::to_string(version));
    if (image.size() < layout->size) throw truncated(source, image.size(), "too few for an HDF5 superblock");
    if (std::to_integer<int>(image[layout->offset_size]) != 8)
        throw damaged(source, "HDF5 addresses do not have 8 bytes");
    if (u64_at(image, layout->base) != 0) throw damaged(source, "the HDF5 base address is not 0");
    if (layout->driver != 0 && u64_at(image, layout->driver) != no_address)
        throw damaged(source, "the HDF5 file requires a special storage driver");
    const std::uint64_t end = u64_at(image, layout->end);
    if (end < layout->size) throw damaged(source, "the HDF5 end-of-file address lies within the superblock");
    if (end > image.size()) throw truncated(source, image.size(), std::to_string(end) + " expected");
    return static_cast<std::size_t>(end);
}

struct Record {
    RecordKind kind;
    std::span<const std::byte> payload;
    std::size_t size;  ///< of the complete record
};

/// nullopt: an incomplete record at the end of the image.
std::optional<Record> record_at(std::span<const std::byte> tail, std::string_view source) {
    if (!record_magic.starts_with(text_of(tail.first(std::min(tail.size(), record_magic.size())))))
        throw damaged(source, std::to_string(tail.size()) + " unknown bytes after the end of the HDF5 data");
    if (tail.size() < header_size + hash_size) return std::nullopt;
    const std::uint64_t length = u64_at(tail, header_size - sizeof length);
    if (length > tail.size() - header_size - hash_size) return std::nullopt;
    const std::size_t hashed = header_size + static_cast<std::size_t>(length);
    const auto kind = std::ranges::find(kind_words, text_of(tail.subspan(record_magic.size(), kind_words[0].size())));
    if (kind == kind_words.end() || core::sha256_hex(tail.first(hashed)) != text_of(tail.subspan(hashed, hash_size)))
        throw damaged(source, "a record after the HDF5 data does not match its checksum");
    return Record{static_cast<RecordKind>(kind - kind_words.begin()),
                  tail.subspan(header_size, static_cast<std::size_t>(length)), hashed + hash_size};
}

}  // namespace

ImageParts split_image(std::span<const std::byte> image, std::string_view source) {
    if (image.empty())
        throw Error(ExitCode::bad_input, source, "empty input", "check whether the previous program failed");
    ImageParts parts;
    parts.hdf5 = image.first(hdf5_size(image, source));
    for (std::size_t at = parts.hdf5.size(); at < image.size();) {
        const auto record = record_at(image.subspan(at), source);
        if (!record && !parts.sealed)
            throw truncated(source, image.size() - at, "too few for the seal after the HDF5 data");
        if (!record) break;
        if ((record->kind == RecordKind::seal) == parts.sealed)
            throw damaged(source, "there must be one seal after the HDF5 data, before the other records");
        at += record->size;
        if (record->kind == RecordKind::seal && core::sha256_hex(parts.hdf5) != text_of(record->payload))
            throw damaged(source, "the content does not match its SHA-256 seal");
        parts.sealed = true;
        if (record->kind == RecordKind::step) {
            parts.steps.push_back(record->payload);
            continue;
        }
        parts.resume_end = at;
        parts.resume_steps = parts.steps.size();
        if (record->kind == RecordKind::checkpoint) parts.checkpoint = record->payload;
    }
    return parts;
}

std::vector<std::byte> make_record(RecordKind kind, std::span<const std::byte> payload) {
    std::vector<std::byte> record;
    record.reserve(header_size + payload.size() + hash_size);
    const auto put = [&](std::span<const std::byte> bytes) { record.insert(record.end(), bytes.begin(), bytes.end()); };
    const std::uint64_t length = payload.size();
    put(std::as_bytes(std::span{record_magic}));
    put(std::as_bytes(std::span{kind_words.at(static_cast<std::size_t>(kind))}));
    put(std::as_bytes(std::span{&length, 1}));
    put(payload);
    const std::string hash = core::sha256_hex(std::span<const std::byte>{record});
    put(std::as_bytes(std::span{hash}));
    return record;
}

void seal(std::vector<std::byte>& hdf5) {
    const std::string hash = core::sha256_hex(std::span<const std::byte>{hdf5});
    const auto record = make_record(RecordKind::seal, std::as_bytes(std::span{hash}));
    hdf5.insert(hdf5.end(), record.begin(), record.end());
}

}  // namespace soft::io
