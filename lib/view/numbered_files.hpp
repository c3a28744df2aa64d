#pragma once
/// Folders with one numbered file per step: frame-0000.png, step-0012.vtu. Tested by view/numbered_files_test.
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace soft::view {

/// Naming scheme of the files in a folder: "frame-0012.png", four digits or more.
struct Numbering {
    std::string_view prefix;  ///< "frame-"
    std::string_view ending;  ///< ".png"
};
inline constexpr Numbering frame_numbering{"frame-", ".png"};
inline constexpr Numbering step_numbering{"step-", ".vtu"};

[[nodiscard]] std::string numbered_name(const Numbering& numbering, std::size_t number);

/// Creates the folder if it is missing, but not its parent. Error(cannot_create, `location`) with a remedy.
void make_folder(const std::filesystem::path& folder, std::string_view location);

/// Removes the files of an earlier, longer series: regular files whose name is exactly numbered_name of a number that is not in `kept`.
/// Other files are not touched. Returns the number of removed files; Error(io_error) if one cannot be removed.
std::size_t remove_stale_files(const std::filesystem::path& folder, const Numbering& numbering,
                               const std::set<std::size_t>& kept);

}  // namespace soft::view
