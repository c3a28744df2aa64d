#include "view/numbered_files.hpp"

#include <charconv>
#include <optional>
#include <system_error>
#include <vector>

#include "core/error.hpp"

namespace soft::view {

namespace {

namespace fs = std::filesystem;

/// The number in a file name of this scheme.
std::optional<std::size_t> number_in(const Numbering& numbering, std::string_view name) {
    if (!name.starts_with(numbering.prefix) || !name.ends_with(numbering.ending)) return std::nullopt;
    std::size_t number = 0;
    std::from_chars(name.data() + numbering.prefix.size(), name.data() + name.size(), number);
    if (name != numbered_name(numbering, number)) return std::nullopt;  // frame-7.png was not written by us
    return number;
}

}  // namespace

std::string numbered_name(const Numbering& numbering, std::size_t number) {
    const std::string digits = std::to_string(number);
    return std::string(numbering.prefix) + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits +
           std::string(numbering.ending);
}

void make_folder(const fs::path& folder, std::string_view location) {
    const fs::path plain = folder.has_filename() ? folder : folder.parent_path();  // "a/" is a folder's name too
    std::error_code failure, ignored;
    fs::create_directory(plain, failure);
    if (fs::is_directory(plain, ignored)) return;
    if (fs::exists(fs::symlink_status(plain, ignored)))
        throw Error(ExitCode::cannot_create, location, "'" + plain.string() + "' exists and is not a folder",
                    "choose another name or move the file");
    if (failure == std::errc::no_such_file_or_directory)
        throw Error(
            ExitCode::cannot_create, location,
            "the folder '" + plain.parent_path().string() + "' for '" + plain.filename().string() + "' does not exist",
            "create it first or name an existing folder");
    throw Error(ExitCode::cannot_create, location,
                "the folder '" + plain.string() + "' cannot be created: " + failure.message(),
                "choose a folder with write permission");
}

std::size_t remove_stale_files(const fs::path& folder, const Numbering& numbering, const std::set<std::size_t>& kept) {
    std::vector<fs::path> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        std::error_code ignored;
        const auto number = number_in(numbering, entry.path().filename().string());
        if (number && !kept.contains(*number) && entry.symlink_status(ignored).type() == fs::file_type::regular)
            old.push_back(entry.path());
    }
    for (const fs::path& file : old) {
        std::error_code failure;
        fs::remove(file, failure);
        if (failure)
            throw Error(ExitCode::io_error, file.string(),
                        "this file of an earlier, longer series cannot be removed: " + failure.message());
    }
    return old.size();
}

}  // namespace soft::view
