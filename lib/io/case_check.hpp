#pragma once
/// Does a typed case make sense in itself? Used after reading (the file is not trusted) and before writing.
#include <string_view>

#include "core/error.hpp"
#include "model/case.hpp"

namespace soft::io {

/// Throws Error (code) with the place in the file "source:/loads/target[0]" at the first value that is not
/// finite, out of range, or refers to something that is not there. Laws of materials are checked by the solver.
void check_case(const model::Case& model, std::string_view source, ExitCode code);

/// Names become names of HDF5 links and CSV columns: letters, digits, '_', '-', '.', at most 100, no leading '.'.
[[nodiscard]] bool is_name(std::string_view text) noexcept;

}  // namespace soft::io
