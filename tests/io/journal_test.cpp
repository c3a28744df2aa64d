/// A running and a killed `solve -o`.
#include "io/journal.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "core/files.hpp"
#include "example_case.hpp"
#include "io/image.hpp"
#include "io/result_file.hpp"

namespace soft::io {
namespace {

using namespace test;
namespace fs = std::filesystem;
using Image = std::vector<std::byte>;

class Journal : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "soft-io-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        file_ = folder_ / "result.h5";
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] ResultWriter writer(const ResultOptions& options = {}) const {
        return {file_, section_image(), "case.h5", example_provenance("solve"), options};
    }

    fs::path folder_;
    fs::path file_;
};

void append(ResultWriter& writer, int step) {
    writer.append(example_step(step), example_displacement(step), example_pressure(step));
}

void expect_steps(const Result& result, int count) {
    ASSERT_EQ(result.steps.size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        expect_equal(result.steps[static_cast<std::size_t>(i)], example_step(i));
        EXPECT_EQ(result.fields.read(i)->displacement_m, example_displacement(i));
        EXPECT_EQ(result.fields.read(i)->pressure_Pa, example_pressure(i));
    }
}

TEST_F(Journal, FileOpensFromTheFirstMomentAndShowsEachStep) {
    ResultWriter running = writer();
    for (int count = 0; count < 4; ++count) {
        const Result result = read_result(core::read_file(file_), "result.h5");
        expect_equal(result.model, section_case());
        EXPECT_FALSE(result.end.has_value());
        expect_steps(result, count);
        append(running, count);
    }
}

TEST_F(Journal, CutAnywhereKeepsAllWholeStepsBefore) {
    ResultWriter running = writer();
    std::vector<std::size_t> ends{core::read_file(file_).size()};
    for (int i = 0; i < 3; ++i) {
        append(running, i);
        ends.push_back(core::read_file(file_).size());
    }
    const Image whole = core::read_file(file_);
    for (std::size_t size = ends[0]; size <= whole.size(); size += 61) {
        const Image cut{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)};
        const auto complete = std::upper_bound(ends.begin(), ends.end(), size) - ends.begin() - 1;
        expect_steps(read_result(cut, "result.h5"), static_cast<int>(complete));
    }
}

/// SIGKILL at moments spread over the run: the reader finds a prefix of the steps, and never less than was reported.
TEST_F(Journal, SurvivesKillNineAtAnyTime) {
    for (int delay_us = 0; delay_us < 12000; delay_us += 800) {
        int pipe_ends[2];
        ASSERT_EQ(::pipe(pipe_ends), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            ResultWriter running = writer();
            for (int i = 0; i < 200; ++i) {
                const char done = static_cast<char>(i);
                if (::write(pipe_ends[1], &done, 1) != 1) ::_exit(1);   // i steps are in the file
                append(running, i);
            }
            static_cast<void>(running.finish(example_end()));
            ::_exit(0);
        }
        ::close(pipe_ends[1]);
        char reported = 0;
        ASSERT_EQ(::read(pipe_ends[0], &reported, 1), 1);
        ::usleep(static_cast<useconds_t>(delay_us));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        int least = 0;
        while (::read(pipe_ends[0], &reported, 1) == 1) least = static_cast<unsigned char>(reported);
        ::close(pipe_ends[0]);
        const Result result = read_result(core::read_file(file_), "result.h5");
        EXPECT_GE(result.steps.size(), static_cast<std::size_t>(least));
        expect_steps(result, static_cast<int>(result.steps.size()));
    }
}

TEST_F(Journal, FinishedFileIsTheSameAsTheResultInMemory) {
    for (const auto keep : {FieldsPolicy::Keep::all, FieldsPolicy::Keep::last, FieldsPolicy::Keep::none}) {
        const ResultOptions options{{keep}, {}};
        ResultWriter disk = writer(options);
        ResultWriter memory{section_image(), "<stdin>", example_provenance("solve"), options};
        for (int i = 0; i < 5; ++i) {
            append(disk, i);
            append(memory, i);
        }
        static_cast<void>(disk.finish(example_end()));
        EXPECT_EQ(core::read_file(file_), memory.finish(example_end()));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{}), 1);
}

TEST_F(Journal, DamagedRecordIsRefused) {
    ResultWriter running = writer();
    const std::size_t start = core::read_file(file_).size();
    append(running, 0);
    append(running, 1);
    const Image whole = core::read_file(file_);
    for (std::size_t place = start + 24; place < start + 400; place += 13) {
        Image damaged = whole;
        damaged[place] ^= std::byte{0x10};
        EXPECT_THROW(static_cast<void>(read_result(damaged, "result.h5")), Error) << place;
    }
}

TEST_F(Journal, RecordThatDoesNotFitTheCaseIsRefused) {
    const ResultWriter running = writer();
    const Image start = core::read_file(file_);
    const auto with = [&](const Image& payload) {
        Image image = start;
        const Image record = make_record(RecordKind::step, payload);
        image.insert(image.end(), record.begin(), record.end());
        return image;
    };
    const auto refused = [&](const Image& payload) {
        try {
            static_cast<void>(read_result(with(payload), "result.h5"));
        } catch (const Error& error) {
            return error.code() == ExitCode::bad_input;
        }
        return false;
    };
    EXPECT_FALSE(refused(encode_step(example_step(0), example_displacement(0), example_pressure(0))));
    EXPECT_TRUE(refused(encode_step(example_step(0), {}, {})));
    EXPECT_TRUE(refused({}));
    Image payload = encode_step(example_step(0), example_displacement(0), example_pressure(0));
    payload.pop_back();
    EXPECT_TRUE(refused(payload));
    payload.resize(40, std::byte{0xff});   // a list of 2^64 - 1 numbers
    EXPECT_TRUE(refused(payload));
}

TEST_F(Journal, DeviceIsWrittenToAndStaysADevice) {
    ResultWriter null{"/dev/null", section_image(), "case.h5", example_provenance("solve"), {}};
    append(null, 0);
    static_cast<void>(null.finish({}));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Journal, FolderThatIsNotThereIsReported) {
    try {
        ResultWriter lost{folder_ / "no" / "result.h5", section_image(), "case.h5", example_provenance("solve"), {}};
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
    }
}

}  // namespace
}  // namespace soft::io
