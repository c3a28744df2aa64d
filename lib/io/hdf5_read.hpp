#pragma once
/// Reads typed datasets from an untrusted file. Internal to the module. Failures throw
/// Error (bad_input, "case.h5:/mesh/points/tip", problem, remedy).
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "io/handle.hpp"
#include "io/hdf5_checks.hpp"
#include "io/names.hpp"

namespace soft::io {

/// Opens the image read-only without copying it; `hdf5` must outlive the file.
[[nodiscard]] FileHandle open_image(std::span<const std::byte> hdf5, const Origin& origin);

/// A group and its path in the file. Only hard links are followed, one level per call.
class GroupReader {
public:
    /// The root group, after its attributes `format` and `format_version` are checked.
    GroupReader(hid_t file, const Origin& origin);

    [[nodiscard]] GroupReader group(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Links of the group in alphabetical order; each passes is_name().
    [[nodiscard]] std::vector<std::string> names() const;

    /// Values of a dataset of exactly this type and shape; doubles are finite. T: double, int64, int32, uint8.
    template <class T>
    [[nodiscard]] std::vector<T> array(const std::string& name, const Shape& shape) const;
    [[nodiscard]] double number(const std::string& name) const;
    /// Converts a value that was read from `item` to int; throws if it is below `min` or too large.
    [[nodiscard]] int to_int(const std::string& item, std::int64_t value, int min = 0) const;
    [[nodiscard]] std::string text(const std::string& name) const;
    [[nodiscard]] std::vector<std::string> texts(const std::string& name, std::int64_t expected = any) const;
    /// uint8 values that are all 0 or 1.
    [[nodiscard]] std::vector<std::uint8_t> flags(const std::string& name, const Shape& shape) const;
    template <class Enum, std::size_t size>
    [[nodiscard]] Enum word(const std::string& name, const std::array<Named<Enum>, size>& table) const {
        const std::string read = text(name);
        if (const auto value = value_of(table, read)) return *value;
        throw unknown_word(name, read);
    }

    /// Opens and checks a dataset [row, row shape ...] of doubles without reading it; row() reads one of its rows.
    [[nodiscard]] DatasetHandle checked_rows(const std::string& name, const Shape& shape) const;
    [[nodiscard]] std::vector<double> row(hid_t dataset, const std::string& name, std::int64_t row,
                                          std::size_t length) const;

    [[nodiscard]] bool has_attribute(const char* name) const;
    [[nodiscard]] std::string text_attribute(const char* name) const;
    [[nodiscard]] std::vector<std::int64_t> integer_attribute(const char* name, std::size_t expected) const;

    /// Error for checks of the caller: its location is "case.h5:/fields/steps[2]" if `item` is "steps[2]".
    [[nodiscard]] Error refuse(std::string_view item, std::string_view problem) const;
    [[nodiscard]] const Origin& origin() const noexcept { return *origin_; }
    [[nodiscard]] hid_t get() const noexcept { return group_.get(); }

private:
    GroupReader(GroupHandle group, std::string path, const Origin& origin);
    void note(const std::string& name) const;  ///< writes the location to Origin::note
    void require_hard_link(const std::string& name) const;
    struct TextBytes {
        std::vector<char> characters;
        std::size_t width;
    };
    [[nodiscard]] TextBytes text_bytes(const std::string& name, const Shape& shape) const;
    [[nodiscard]] DatasetHandle open_dataset(const std::string& name) const;
    [[nodiscard]] AttributeHandle open_attribute(const char* name) const;
    [[nodiscard]] std::string location_of(std::string_view item) const;
    void require_finite(std::span<const double> values, const std::string& name) const;
    [[nodiscard]] Error unknown_word(const std::string& name, const std::string& word) const;

    GroupHandle group_;
    std::string path_;      ///< "/mesh"; "" for the root
    const Origin* origin_;  ///< must outlive the reader
};

}  // namespace soft::io
