#include "core/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace {

using namespace soft::core;
namespace fs = std::filesystem;

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span{text}); }

std::string text(const Bytes& data) { return {reinterpret_cast<const char*>(data.data()), data.size()}; }

class Files : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "soft-files-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    void TearDown() override { fs::remove_all(folder_); }
    [[nodiscard]] fs::path in(std::string_view name) const { return folder_ / name; }
    [[nodiscard]] long entries() const {
        return std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{});
    }

    fs::path folder_;
};

soft::ExitCode code_of(auto&& action) {
    try {
        action();
    } catch (const soft::Error& error) {
        return error.code();
    }
    return soft::ExitCode::ok;
}

TEST_F(Files, CommittedFileContainsAllBytesAndNoTemporaryFileRemains) {
    const std::string content = std::string(300000, 'x') + '\0' + "end";
    AtomicFile file{in("a")};
    EXPECT_EQ(file.write(bytes(content)), WriteStatus::complete);
    EXPECT_FALSE(fs::exists(in("a")));
    file.commit();
    EXPECT_EQ(text(read_file(in("a"))), content);
    EXPECT_EQ(entries(), 1);
}

TEST_F(Files, NameWithControlCharactersStaysOnOneLineOfTheMessage) {
    try {
        static_cast<void>(read_file(in("a\nb\t\x1b[31m")));
        FAIL() << "the file does not exist";
    } catch (const soft::Error& error) {
        EXPECT_NE(std::string_view{error.what()}.find("a?b??[31m: cannot be opened"), std::string_view::npos)
            << error.what();
    }
}

/// A design may name any file; none of them may block the program or be read without end.
TEST_F(Files, FileNamedInADesignIsReadOnlyIfItIsARegularFile) {
    constexpr std::size_t limit = 1000;
    std::ofstream{in("a")} << "text";
    EXPECT_EQ(text(read_regular_file(in("a"), limit)), "text");
    ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
    for (const fs::path& path : {fs::path{"/dev/zero"}, fs::path{"/dev/tty"}, in("pipe"), folder_, in("absent")})
        EXPECT_EQ(code_of([&] { static_cast<void>(read_regular_file(path, limit)); }), soft::ExitCode::cannot_open)
            << path;
    std::ofstream{in("long")} << std::string(limit + 1, 'x');
    EXPECT_EQ(code_of([&] { static_cast<void>(read_regular_file(in("long"), limit)); }), soft::ExitCode::bad_input);
}

TEST_F(Files, UncommittedFileLeavesTheOldFileUnchanged) {
    std::ofstream{in("a")} << "old";
    {
        AtomicFile file{in("a")};
        static_cast<void>(file.write(bytes("new")));
    }
    EXPECT_EQ(text(read_file(in("a"))), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(Files, ReplacedFileKeepsItsPermissionsAndNewFileFollowsTheMask) {
    std::ofstream{in("a")} << "old";
    ::chmod(in("a").c_str(), 0640);
    AtomicFile replaced{in("a")};
    replaced.commit();
    struct stat status {};
    ::stat(in("a").c_str(), &status);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
    const mode_t mask = ::umask(022);
    AtomicFile fresh{in("b")};
    fresh.commit();
    ::umask(mask);
    ::stat(in("b").c_str(), &status);
    EXPECT_EQ(status.st_mode & 0777, 0644u);
}

TEST_F(Files, SymbolicLinkIsKept) {
    std::ofstream{in("real")} << "old";
    fs::create_symlink(in("real"), in("link"));
    AtomicFile file{in("link")};
    static_cast<void>(file.write(bytes("new")));
    file.commit();
    EXPECT_TRUE(fs::is_symlink(in("link")));
    EXPECT_EQ(text(read_file(in("real"))), "new");
}

TEST_F(Files, DanglingSymbolicLinkCreatesItsTarget) {
    fs::create_directory(in("other"));
    fs::create_symlink("other/real", in("link"));
    fs::create_symlink("link", in("chain"));
    AtomicFile file{in("chain")};
    static_cast<void>(file.write(bytes("new")));
    file.commit();
    EXPECT_TRUE(fs::is_symlink(in("chain")) && fs::is_symlink(in("link")));
    EXPECT_EQ(text(read_file(in("other/real"))), "new");
    fs::create_symlink("loop", in("loop"));
    EXPECT_EQ(code_of([&] { AtomicFile{in("loop")}; }), soft::ExitCode::cannot_create);
    EXPECT_TRUE(fs::is_symlink(in("loop")));
}

TEST_F(Files, NameMayHaveTheMaximumLengthOfTheFileSystem) {
    constexpr std::size_t max_length = 255;
    const fs::path name = in(std::string(max_length, 'a').c_str());
    AtomicFile file{name};
    static_cast<void>(file.write(bytes("new")));
    file.commit();
    EXPECT_EQ(text(read_file(name)), "new");
    EXPECT_EQ(code_of([&] { AtomicFile{in(std::string(max_length + 1, 'a').c_str())}; }),
              soft::ExitCode::cannot_create);
}

TEST_F(Files, LinkToAPipeIsWrittenToThePipe) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    fs::create_symlink("/proc/self/fd/" + std::to_string(ends[1]), in("link"));
    AtomicFile file{in("link")};
    static_cast<void>(file.write(bytes("through")));
    file.commit();
    ::close(ends[1]);
    EXPECT_EQ(text(read_descriptor(ends[0], "pipe")), "through");
    ::close(ends[0]);
}

TEST_F(Files, DeviceIsWrittenAndNotReplaced) {
    AtomicFile file{"/dev/null"};
    EXPECT_EQ(file.write(bytes("gone")), WriteStatus::complete);
    file.commit();
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, FailureToCreateAndToOpenHaveDifferentExitCodes) {
    EXPECT_EQ(code_of([&] { AtomicFile file{in("no/such/folder")}; }), soft::ExitCode::cannot_create);
    EXPECT_EQ(code_of([&] { AtomicFile file{folder_}; }), soft::ExitCode::cannot_create);
    EXPECT_EQ(code_of([&] { static_cast<void>(read_file(in("absent"))); }), soft::ExitCode::cannot_open);
    EXPECT_EQ(code_of([&] { static_cast<void>(read_file(folder_)); }), soft::ExitCode::cannot_open);
}

TEST_F(Files, FullDiskIsAnInputOutputError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP();
    EXPECT_EQ(code_of([] {
                  AtomicFile file{"/dev/full"};
                  static_cast<void>(file.write(bytes("x")));
              }),
              soft::ExitCode::io_error);
}

TEST_F(Files, InputBeyondTheLimitIsRejected) {
    std::ofstream{in("a")} << "12345";
    EXPECT_EQ(text(read_file(in("a"), 5)), "12345");
    EXPECT_EQ(code_of([&] { static_cast<void>(read_file(in("a"), 4)); }), soft::ExitCode::bad_input);
}

TEST_F(Files, ClosedReaderIsNotAnError) {
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ::close(ends[0]);
    EXPECT_EQ(write_all(ends[1], bytes("x"), "pipe"), WriteStatus::reader_closed);
    ::close(ends[1]);
    std::signal(SIGPIPE, before);
}

TEST_F(Files, PipeIsReadToItsEndInAnyChunkSizes) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    std::string content;
    for (int i = 0; i < 50000; ++i) content += std::to_string(i);
    std::thread writer{[&] {
        static_cast<void>(write_all(ends[1], bytes(content), "pipe"));
        ::close(ends[1]);
    }};
    const Bytes got = read_descriptor(ends[0], "pipe");
    writer.join();
    ::close(ends[0]);
    EXPECT_EQ(text(got), content);
}

}  // namespace
