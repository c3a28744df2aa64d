#pragma once
/// Consistency checks of a typed case. Used after reading (files are untrusted input) and before writing.
#include <string_view>

#include "core/error.hpp"
#include "model/case.hpp"

namespace soft::io {

/// Throws Error (code) with the location in the file ("source:/loads/target[0]") at the first value that is not finite, is out of
/// range, or refers to an object that does not exist. The solver checks the constants of the material laws.
void check_case(const model::Case& model, std::string_view source, ExitCode code);

/// True for valid names of HDF5 links and CSV columns: letters, digits, '_', '-', '.', at most 100 characters, no leading '.'.
[[nodiscard]] bool is_name(std::string_view text) noexcept;

}  // namespace soft::io
