#pragma once
/// Numbers and lines of a .msh file, as text or as bytes. Private to the module; see msh_file.hpp.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::meshing {

enum class MshEncoding { text, binary };

class MshScanner {
public:
    MshScanner(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
        const std::string location =
            encoding_ == MshEncoding::binary
                ? name_ + ": byte " + std::to_string(at_)
                : name_ + ":" + std::to_string(1 + std::count(bytes_.begin(), bytes_.begin() + offset(at_), '\n'));
        throw Error(ExitCode::bad_input, location, problem, remedy);
    }
    [[noreturn]] void truncated() const { fail("the file is truncated", "export the mesh again"); }

    void set_encoding(MshEncoding encoding) { encoding_ = encoding; }
    [[nodiscard]] bool binary() const { return encoding_ == MshEncoding::binary; }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

    /// False at the end of the file.
    bool skip_blanks() {
        while (at_ < bytes_.size() && std::string_view{" \t\r\n"}.find(bytes_[at_]) != std::string_view::npos) ++at_;
        return at_ < bytes_.size();
    }

    [[nodiscard]] std::size_t position() const { return at_; }
    void return_to(std::size_t position) { at_ = position; }

    /// The rest of the line without its end.
    std::string_view line() {
        const auto end = std::min(bytes_.find('\n', at_), bytes_.size());
        std::string_view text = bytes_.substr(at_, end - at_);
        at_ = std::min(end + 1, bytes_.size());
        if (text.ends_with('\r')) text.remove_suffix(1);
        return text;
    }

    /// A blank-separated number, whatever the encoding.
    template <class T>
    T text_number() {
        if (!skip_blanks()) truncated();
        T value{};
        const auto [end, error] = std::from_chars(bytes_.data() + at_, bytes_.data() + bytes_.size(), value);
        const auto after = static_cast<std::size_t>(end - bytes_.data());
        const bool whole =
            after == bytes_.size() || std::string_view{" \t\r\n"}.find(bytes_[after]) != std::string_view::npos;
        if (error != std::errc{} || !whole)
            fail("expected a number, found " + core::quoted(word()), "export the mesh again");
        at_ = after;
        return checked(value);
    }

    /// The next number of the data.
    template <class T>
    T number() {
        if (!binary()) return text_number<T>();
        if (left() < sizeof(T)) truncated();
        T value{};
        std::memcpy(&value, bytes_.data() + at_, sizeof(T));
        at_ += sizeof(T);
        return checked(value);
    }

    /// Checks a number of items of at least `min_bytes` each against the rest of the file, so that a corrupted count does not exhaust
    /// the memory.
    std::size_t checked_count(std::size_t count, std::size_t min_bytes) const {
        if (count > left() / min_bytes) truncated();
        return count;
    }
    std::size_t count(std::size_t min_bytes) { return checked_count(number<std::size_t>(), min_bytes); }

    /// Moves past the given words, which must come next after optional blanks.
    void expect(std::string_view words) {
        if (!skip_blanks()) truncated();
        if (!bytes_.substr(at_).starts_with(words))
            fail(std::string{words} + " is missing here", "export the mesh again");
        at_ += words.size();
    }
    /// Moves past the next occurrence of the words.
    void skip_to(std::string_view words) {
        const auto found = bytes_.find(words, at_);
        if (found == std::string_view::npos) truncated();
        at_ = found + words.size();
    }

private:
    static std::ptrdiff_t offset(std::size_t at) { return static_cast<std::ptrdiff_t>(at); }
    [[nodiscard]] std::string_view word() const {
        constexpr std::size_t max_length = 20;
        const auto end = std::min({bytes_.find_first_of(" \t\r\n", at_), bytes_.size(), at_ + max_length});
        return bytes_.substr(at_, end - at_);
    }
    template <class T>
    T checked(T value) const {
        if constexpr (std::floating_point<T>)
            if (!std::isfinite(value)) fail("a coordinate is not a finite number", "export the mesh again");
        return value;
    }

    std::string_view bytes_;
    std::string name_;
    std::size_t at_ = 0;
    MshEncoding encoding_ = MshEncoding::text;
};

}  // namespace soft::meshing
