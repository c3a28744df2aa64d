#pragma once
/// Folders with a file for each step: frame-0000.png, step-0012.vtu. Tested by view/numbered_files_test.
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace soft::view {

/// How the files of one folder are called: "frame-0012.png", four digits or more.
struct Numbering {
    std::string_view prefix;  ///< "frame-"
    std::string_view ending;  ///< ".png"
};
inline constexpr Numbering frame_numbering{"frame-", ".png"};
inline constexpr Numbering step_numbering{"step-", ".vtu"};

[[nodiscard]] std::string numbered_name(const Numbering& numbering, std::size_t number);

/// Makes the folder where it is missing; not its parent. Error(cannot_create, `place`) with what would be right.
void make_folder(const std::filesystem::path& folder, std::string_view place);

/// Removes the files of an earlier, longer series: those called just as numbered_name calls them with a number that is
/// not in `kept`. Nothing else in the folder is touched. Returns how many; Error(io_error) for one that stays.
std::size_t remove_others(const std::filesystem::path& folder, const Numbering& numbering,
                          const std::set<std::size_t>& kept);

}  // namespace soft::view
