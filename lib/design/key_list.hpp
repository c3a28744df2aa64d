#pragma once
/// All keys of a design as Markdown, for `mesh-gen --list-keys` and docs/reference/keys.md. Tested by design/key_list_test and
/// tests/docs.
#include <span>
#include <string>

#include "design/design.hpp"

namespace soft::design {

/// Sections from level two: the units, the keys that all families share, and the keys of each family. Every key has its allowed values
/// with their range, its default and its meaning. Names that the user chooses are upper case: outputs.OUTPUT.face.
[[nodiscard]] std::string key_list(std::span<const FamilyKeys> families);

}  // namespace soft::design
