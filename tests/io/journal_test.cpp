/// Files of a running and of a killed `solve -o`.
#include "io/journal.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>

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
        return {file_, {section_image(), "case.h5", section_case()}, example_provenance("solve"), options};
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

TEST(JournalStep, StoresTheErrorBarsOfARow) {
    model::Step step = example_step(1);
    step.pressure_error_Pa = 12.5;
    step.output_errors = {1e-5, 2e-6};
    expect_equal(decode_step(encode_step(step, {}, {}), "result.h5").step, step);
}

TEST_F(Journal, KeepsAnExistingFileUntilTheFirstStep) {
    core::AtomicFile old{file_};
    static_cast<void>(old.write(std::as_bytes(std::span{"old"})));
    old.commit();
    const Image before = core::read_file(file_);
    { const ResultWriter refused = writer(); }
    EXPECT_EQ(core::read_file(file_), before);
    ResultWriter running = writer();
    EXPECT_EQ(core::read_file(file_), before);
    EXPECT_TRUE(running.is_in_place());
    append(running, 0);
    expect_steps(read_result(core::read_file(file_), "result.h5"), 1);
    EXPECT_EQ(std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{}), 1);
}

TEST_F(Journal, OnlyOneOfTwoConcurrentSolvesWrites) {
    ResultWriter first = writer(), second = writer();
    append(first, 0);
    EXPECT_THROW(append(second, 0), Error);
    append(first, 1);
    expect_steps(read_result(core::read_file(file_), "result.h5"), 2);
}

TEST_F(Journal, FileContainsEachAppendedStep) {
    ResultWriter running = writer();
    append(running, 0);
    for (int count = 1; count < 4; ++count) {
        const Result result = read_result(core::read_file(file_), "result.h5");
        expect_equal(result.model.mesh, section_case().mesh);
        EXPECT_FALSE(result.end.has_value());
        expect_steps(result, count);
        append(running, count);
    }
}

TEST_F(Journal, TruncatedFileContainsAllCompleteSteps) {
    ResultWriter running = writer();
    append(running, 0);
    std::vector<std::size_t> ends{core::read_file(file_).size()};
    for (int i = 1; i < 4; ++i) {
        append(running, i);
        ends.push_back(core::read_file(file_).size());
    }
    const Image whole = core::read_file(file_);
    for (std::size_t size = ends[0]; size <= whole.size(); size += 61) {
        const Image cut{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)};
        const auto complete = std::upper_bound(ends.begin(), ends.end(), size) - ends.begin();
        expect_steps(read_result(cut, "result.h5"), static_cast<int>(complete));
    }
}

/// SIGKILL at different times of the run: the reader finds the first steps, and at least those whose append() returned.
TEST_F(Journal, SurvivesSigkillAtAnyTime) {
    for (int delay_us = 0; delay_us < 12000; delay_us += 800) {
        int pipe_ends[2];
        ASSERT_EQ(::pipe(pipe_ends), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            ResultWriter running = writer();
            for (int i = 0; i < 200; ++i) {
                append(running, i);
                const char done = static_cast<char>(i + 1);
                if (::write(pipe_ends[1], &done, 1) != 1) ::_exit(1);  // number of steps in the file
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
        int min_steps = 1;
        while (::read(pipe_ends[0], &reported, 1) == 1) min_steps = static_cast<unsigned char>(reported);
        ::close(pipe_ends[0]);
        const Result result = read_result(core::read_file(file_), "result.h5");
        EXPECT_GE(result.steps.size(), static_cast<std::size_t>(min_steps));
        expect_steps(result, static_cast<int>(result.steps.size()));
    }
}

TEST_F(Journal, FinishedFileIsTheSameAsTheResultInMemory) {
    for (const auto keep : {FieldsPolicy::Keep::all, FieldsPolicy::Keep::last, FieldsPolicy::Keep::none}) {
        const ResultOptions options{{keep}, {}};
        ResultWriter disk = writer(options);
        ResultWriter memory{{section_image(), "<stdin>", section_case()}, example_provenance("solve"), options};
        for (int i = 0; i < 5; ++i) {
            append(disk, i);
            append(memory, i);
        }
        static_cast<void>(disk.finish(example_end()));
        EXPECT_EQ(core::read_file(file_), memory.finish(example_end()));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{}), 1);
}

TEST_F(Journal, RejectsADamagedRecord) {
    ResultWriter running = writer();
    append(running, 0);
    const std::size_t start = split_image(core::read_file(file_), "result.h5").resume_end;
    append(running, 1);
    const Image whole = core::read_file(file_);
    for (std::size_t offset = start + 24; offset < start + 400; offset += 13) {
        Image damaged = whole;
        damaged[offset] ^= std::byte{0x10};
        EXPECT_THROW(static_cast<void>(read_result(damaged, "result.h5")), Error) << offset;
    }
}

TEST_F(Journal, RejectsARecordThatDoesNotMatchTheCase) {
    ResultWriter running = writer();
    append(running, 0);
    Image start = core::read_file(file_);
    start.resize(split_image(start, "result.h5").resume_end);
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
    payload.resize(40, std::byte{0xff});  // a list of 2^64 - 1 numbers
    EXPECT_TRUE(refused(payload));
}

TEST(Checkpoint, ReadsBackEqualInEveryField) {
    for (const bool first : {false, true}) {
        model::Checkpoint checkpoint = example_checkpoint(3);
        if (first) {
            checkpoint.before.reset();
            checkpoint.user_control_failed = false;
            checkpoint.on_branch = true;
        }
        const auto read = decode_checkpoint(encode_checkpoint(checkpoint), "result.h5");
        expect_equal(read, checkpoint);
        checkpoint.so_far.reason = {};  // not stored in a checkpoint
        checkpoint.so_far.detail.clear();
        expect_equal(read.so_far, checkpoint.so_far);
    }
}

TEST(Checkpoint, IsRejectedIfTruncatedOrNotFinite) {
    const Image whole = encode_checkpoint(example_checkpoint(3));
    for (std::size_t size = 0; size < whole.size(); size += 7)
        EXPECT_THROW(static_cast<void>(decode_checkpoint(std::span{whole}.first(size), "result.h5")), Error) << size;
    model::Checkpoint wild = example_checkpoint(3);
    wild.last.unknowns[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(static_cast<void>(decode_checkpoint(encode_checkpoint(wild), "result.h5")), Error);
}

std::string refusal_to_resume(const Image& image) {
    try {
        static_cast<void>(read_interrupted(image, "result.h5"));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

TEST_F(Journal, ResumesAfterTheLastCheckpointWithTheSameResult) {
    ResultWriter whole = writer();
    for (int i = 0; i < 5; ++i) append(whole, i);
    static_cast<void>(whole.finish(example_end()));
    const Image expected = core::read_file(file_);

    ResultWriter killed = writer();
    for (int i = 0; i < 4; ++i) {
        append(killed, i);
        if (i < 3) killed.save_checkpoint(example_checkpoint(i + 1));  // row 3 has no checkpoint after it
    }
    Image left = core::read_file(file_);
    left.resize(left.size() - 5);  // and is truncated
    core::AtomicFile cut{file_};
    static_cast<void>(cut.write(left));
    cut.commit();

    const InterruptedSolve from = read_interrupted(left, "result.h5");
    test::expect_equal(from.file.model.mesh, section_case().mesh);
    ASSERT_EQ(from.steps.size(), 3U);
    for (int i = 0; i < 3; ++i) test::expect_equal(from.steps[static_cast<std::size_t>(i)], example_step(i));
    ASSERT_TRUE(from.checkpoint.has_value());
    expect_equal(*from.checkpoint, example_checkpoint(3));
    ResultWriter resumed = ResultWriter::resume(file_, {left, "result.h5", from.file.model});
    expect_steps(read_result(core::read_file(file_), "result.h5"), 3);
    for (int i = 3; i < 5; ++i) append(resumed, i);
    static_cast<void>(resumed.finish(example_end()));
    EXPECT_EQ(core::read_file(file_), expected);
}

TEST_F(Journal, ResumesFromTheBeginningWithoutACheckpoint) {
    {
        ResultWriter killed = writer();
        append(killed, 0);
    }
    const Image left = core::read_file(file_);
    const InterruptedSolve from = read_interrupted(left, "result.h5");
    EXPECT_TRUE(from.steps.empty());
    EXPECT_FALSE(from.checkpoint.has_value());
    ResultWriter resumed = ResultWriter::resume(file_, {left, "result.h5", from.file.model});
    EXPECT_EQ(core::read_file(file_), left);  // until the next row, so that a kill leaves one
    for (int i = 0; i < 2; ++i) append(resumed, i);
    expect_steps(read_result(core::read_file(file_), "result.h5"), 2);
}

TEST_F(Journal, RejectsAFileThatIsBeingWrittenOrHasChanged) {
    const auto code_of_resume = [&](const Image& read) {
        const InterruptedSolve from = read_interrupted(read, "result.h5");
        try {
            static_cast<void>(ResultWriter::resume(file_, {read, "result.h5", from.file.model}));
        } catch (const Error& error) {
            return error.code();
        }
        return ExitCode::ok;
    };
    Image early;
    {
        ResultWriter running = writer();
        append(running, 0);
        early = core::read_file(file_);
        EXPECT_EQ(code_of_resume(early), ExitCode::cannot_create);
        EXPECT_THROW(static_cast<void>(writer()), Error);
        append(running, 1);
    }
    EXPECT_EQ(code_of_resume(early), ExitCode::cannot_create);
    EXPECT_EQ(code_of_resume(core::read_file(file_)), ExitCode::ok);
}

TEST_F(Journal, RecreatesARemovedOrReplacedFileAtTheEnd) {
    for (const bool replaced : {false, true}) {
        ResultWriter running = writer();
        append(running, 0);
        append(running, 1);
        EXPECT_TRUE(running.is_in_place());
        fs::remove(file_);
        if (replaced) {
            core::AtomicFile other{file_};
            static_cast<void>(other.write(section_image()));
            other.commit();
        }
        EXPECT_FALSE(running.is_in_place());
        append(running, 2);
        static_cast<void>(running.finish(example_end()));
        expect_steps(read_result(core::read_file(file_), "result.h5"), 3);
    }
}

TEST_F(Journal, ResumesOnlyInterruptedSolves) {
    EXPECT_NE(refusal_to_resume(section_image()).find("a case without solution"), std::string::npos);
    ResultWriter done = writer();
    append(done, 0);
    append(done, 1);
    EXPECT_NE(refusal_to_resume(done.finish(example_end())).find("is finished and cannot be resumed"),
              std::string::npos);
}

TEST_F(Journal, RejectsACheckpointThatDoesNotMatchItsSteps) {
    const auto left_by = [&](const model::Checkpoint& checkpoint) {
        ResultWriter running = writer();
        append(running, 0);
        append(running, 1);
        running.save_checkpoint(checkpoint);
        return core::read_file(file_);
    };
    EXPECT_EQ(refusal_to_resume(left_by(example_checkpoint(2))), "");
    EXPECT_NE(refusal_to_resume(left_by(example_checkpoint(3))), "");
    model::Checkpoint other = example_checkpoint(2);
    other.stage = -1;
    EXPECT_NE(refusal_to_resume(left_by(other)), "");
}

TEST_F(Journal, WritesToADeviceWithoutReplacingIt) {
    ResultWriter null{"/dev/null", {section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    append(null, 0);
    static_cast<void>(null.finish({}));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Journal, ReportsAMissingFolder) {
    try {
        ResultWriter lost{folder_ / "no" / "result.h5",
                          {section_image(), "case.h5", section_case()},
                          example_provenance("solve"),
                          {}};
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
    }
}

}  // namespace
}  // namespace soft::io
