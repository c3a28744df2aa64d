/// Rows of dynamic cases.
#include <gtest/gtest.h>

#include <limits>

#include "example_case.hpp"
#include "io/journal.hpp"
#include "tamper.hpp"

namespace soft::io {
namespace {

using namespace test;
using Image = std::vector<std::byte>;
using Numbers = std::vector<double>;

Image dynamic_image() { return write_case(dynamic_case(), example_design(), example_provenance("mesh-gen")); }

std::vector<double> displacement() { return std::vector<double>(3 * dynamic_case().mesh.points.size(), 1e-4); }

Image motion_image(int rows) {
    const Image given = dynamic_image();
    ResultWriter writer{{given, "case.h5", dynamic_case()}, example_provenance("solve"), {}};
    for (int i = 0; i < rows; ++i) writer.append(moving_step(i), displacement(), {});
    return writer.finish({model::StopReason::done, "0.75 s", {}, {}, {}, 9, 8});
}

TEST(DynamicCase, RowsReadBackWithTimeAndEnergies) {
    const Result result = read_result(motion_image(4), "result.h5", dynamic_case());
    ASSERT_EQ(result.steps.size(), 4U);
    for (int i = 0; i < 4; ++i) expect_equal(result.steps[static_cast<std::size_t>(i)], moving_step(i));
}

TEST(DynamicCase, RowsReadBackFromTheJournal) {
    expect_equal(decode_step(encode_step(moving_step(3), {}, {}), "result.h5").step, moving_step(3));
}

TEST(DynamicCase, RejectsRowsWithoutTimeAndStaticRowsWithTime) {
    const Image moving = dynamic_image(), resting = section_image();
    ResultWriter writer{{moving, "case.h5", dynamic_case()}, example_provenance("solve"), {}};
    model::Step step = moving_step(0);
    step.motion.reset();
    EXPECT_THROW(writer.append(step, displacement(), {}), Error);
    step = moving_step(0);
    step.motion->stored_energy_J = nan;
    EXPECT_THROW(writer.append(step, displacement(), {}), Error);
    ResultWriter other{{resting, "case.h5", section_case()}, example_provenance("solve"), {}};
    step = example_step(0);
    step.motion = model::Step::Motion{};
    EXPECT_THROW(other.append(step, example_displacement(0), example_pressure(0)), Error);
}

struct RowCorruption {
    std::function<void(hid_t file)> change;
    const char* location;
};

TEST(DynamicCase, CorruptedRowsAreRejectedWithTheirLocation) {
    const std::vector<RowCorruption> corruptions{
        {[](hid_t f) { overwrite(f, "/path/time", 2, Numbers{0.05}); }, "/path/time[2]: must ascend"},
        {[](hid_t f) { overwrite(f, "/path/time", 0, Numbers{-1}); }, "/path/time[0]"},
        {[](hid_t f) { overwrite(f, "/path/kinetic_energy", 1, Numbers{-1e-9}); },
         "/path/kinetic_energy[1]: is negative"},
        {[](hid_t f) { overwrite(f, "/path/load_work", 1, Numbers{nan}); }, "/path/load_work[1]"},
        {[](hid_t f) { unlink(f, "/path/damping_work"); }, "/path/damping_work"},
    };
    for (const RowCorruption& corruption : corruptions) {
        try {
            static_cast<void>(read_result(tampered(motion_image(3), corruption.change), "result.h5", dynamic_case()));
            ADD_FAILURE() << corruption.location;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_NE(std::string{error.what()}.find(corruption.location), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace soft::io
