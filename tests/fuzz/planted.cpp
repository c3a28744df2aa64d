/// A reader with planted faults that the fuzzing code must detect: tests/fuzz/planted contains a file for each.
#include <stdexcept>

#include "core/error.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    const std::string_view text = text_of(bytes);
    if (text.starts_with("throw")) throw std::logic_error("planted");
    if (text.starts_with("lines")) throw Error(ExitCode::bad_input, "planted", "two\nlines");
    if (text.starts_with("blame")) throw Error(ExitCode::internal, "planted", "a bug");
    if (text.starts_with("claim")) require(false, "planted");
    throw Error(ExitCode::bad_input, "planted", "correctly rejected");
}
