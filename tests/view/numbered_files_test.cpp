#include "view/numbered_files.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "picture_samples.hpp"

namespace soft::view {
namespace {

using namespace test;
namespace fs = std::filesystem;

std::string folder_refusal(const fs::path& folder) {
    try {
        make_folder(folder, "x");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
        return error.what();
    }
    return "none";
}

TEST(NumberedFiles, HaveFourDigitsOrMore) {
    EXPECT_EQ(numbered_name(frame_numbering, 7), "frame-0007.png");
    EXPECT_EQ(numbered_name(step_numbering, 12345), "step-12345.vtu");
}

TEST(NumberedFiles, AFolderThatCannotBeCreatedIsRefusedWithARemedy) {
    const fs::path here = fresh_folder("soft_make_folder");
    std::ofstream(here / "file") << "x";
    EXPECT_EQ(folder_refusal(here / "new"), "none");
    EXPECT_EQ(folder_refusal(here / "new/"), "none");
    EXPECT_EQ(folder_refusal(here / "a/b/"),
              "x: the folder '" + (here / "a").string() +
                  "' for 'b' does not exist; create it first or name an existing folder");
    for (const char* name : {"file", "file/"})
        EXPECT_EQ(
            folder_refusal(here / name),
            "x: '" + (here / "file").string() + "' exists and is not a folder; choose another name or move the file");
}

TEST(NumberedFiles, OnlyStaleFilesOfTheSeriesAreRemoved) {
    const fs::path here = fresh_folder("soft_remove_others");
    const auto make = [&](const std::string& name) { std::ofstream(here / name) << "x"; };
    for (std::size_t k : {0U, 1U, 2U, 12345U}) make(numbered_name(frame_numbering, k));
    const std::set<std::string> others{"frame-2.png",    "frame-00002.png", "frame-0002.png.x", "my-frame-0002.png",
                                       "frame-000a.png", "frame-0002.jpg",  "step-0002.vtu",    "frame-.png",
                                       "frame--001.png", "Frame-0002.png",  "notes.txt"};
    for (const std::string& name : others) make(name);
    fs::create_directory(here / "frame-0009.png");
    fs::create_symlink("notes.txt", here / "frame-0010.png");
    EXPECT_EQ(remove_stale_files(here, frame_numbering, {0, 1}), 2U);
    std::set<std::string> left;
    for (const auto& entry : fs::directory_iterator(here)) left.insert(entry.path().filename());
    std::set<std::string> expected = others;
    expected.insert({"frame-0000.png", "frame-0001.png", "frame-0009.png", "frame-0010.png"});
    EXPECT_EQ(left, expected);
}

}  // namespace
}  // namespace soft::view
