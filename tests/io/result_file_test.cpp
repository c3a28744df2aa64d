#include "io/result_file.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "example_case.hpp"
#include "io/hdf5_write.hpp"
#include "io/image.hpp"

namespace soft::io {
namespace {

using namespace test;
using Keep = FieldsPolicy::Keep;
using Image = std::vector<std::byte>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void append_steps(ResultWriter& writer, int count) {
    for (int i = 0; i < count; ++i) writer.append(example_step(i), example_displacement(i), example_pressure(i));
}

Image result_image(int steps, const ResultOptions& options = {}) {
    ResultWriter writer{section_image(), "case.h5", example_provenance("solve"), options};
    append_steps(writer, steps);
    return writer.finish(example_end());
}

TEST(ResultFile, ReadsBackEqualInEveryField) {
    const ResultOptions options{{Keep::all}, DesignText{"", "solved: otherwise\n", {"load.pressure=1kPa"}}};
    const Result result = read_result(result_image(4, options), "result.h5");
    expect_equal(result.model, section_case());
    EXPECT_EQ(result.design, example_design());
    EXPECT_EQ(result.changed_design, options.changed_design);
    EXPECT_EQ(result.provenance, (std::vector{example_provenance("mesh-gen"), example_provenance("solve")}));
    ASSERT_EQ(result.steps.size(), 4U);
    for (int i = 0; i < 4; ++i) expect_equal(result.steps[static_cast<std::size_t>(i)], example_step(i));
    ASSERT_TRUE(result.end.has_value());
    expect_equal(*result.end, example_end());
    EXPECT_EQ(result.fields.steps(), (std::vector<std::int64_t>{0, 1, 2, 3}));
    for (int i = 0; i < 4; ++i) {
        const auto values = result.fields.read(i);
        ASSERT_TRUE(values.has_value());
        EXPECT_EQ(values->displacement_m, example_displacement(i));
        EXPECT_EQ(values->pressure_Pa, example_pressure(i));
    }
}

TEST(ResultFile, WithoutVolumesPressuresAndStepsReadsBack) {
    ResultWriter writer{section_image(), "case.h5", example_provenance("solve"), {}};
    solution::Step step = example_step(1);
    step.volume_m3.reset();
    step.tangent_volume = 0;
    writer.append(step, example_displacement(1), {});
    const Result one = read_result(writer.finish({}), "result.h5");
    expect_equal(one.steps.at(0), step);
    EXPECT_TRUE(one.fields.read(0)->pressure_Pa.empty());
    ResultWriter idle{section_image(), "case.h5", example_provenance("solve"), {}};
    const Result none = read_result(idle.finish({}), "result.h5");
    EXPECT_TRUE(none.steps.empty());
    EXPECT_TRUE(none.fields.steps().empty());
}

TEST(ResultFile, PolicyChoosesTheStoredSteps) {
    const auto stored = [](const FieldsPolicy& policy, int steps) {
        const Result result = read_result(result_image(steps, {policy, {}}), "result.h5");
        EXPECT_EQ(result.steps.size(), static_cast<std::size_t>(steps));
        for (const std::int64_t step : result.fields.steps())
            EXPECT_EQ(result.fields.read(step)->displacement_m, example_displacement(static_cast<int>(step)));
        EXPECT_FALSE(result.fields.read(steps).has_value());
        EXPECT_EQ(result.fields_policy, policy);
        return result.fields.steps();
    };
    using Rows = std::vector<std::int64_t>;
    EXPECT_EQ(stored({Keep::all}, 5), (Rows{0, 1, 2, 3, 4}));
    EXPECT_EQ(stored({Keep::last}, 5), (Rows{4}));
    EXPECT_EQ(stored({Keep::none}, 5), (Rows{}));
    EXPECT_EQ(stored({Keep::every, 3}, 5), (Rows{0, 3, 4}));
    EXPECT_EQ(stored({Keep::every, 2}, 5), (Rows{0, 2, 4}));
}

TEST(ResultFile, PolicyIsReadAsTyped) {
    for (const char* text : {"all", "last", "none", "every=7"}) EXPECT_EQ(to_text(parse_fields_policy(text)), text);
    for (const char* text : {"", "every", "every=", "every=0", "every=-1", "every=2x", "every=99999999999", "All"}) {
        try {
            static_cast<void>(parse_fields_policy(text));
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
        }
    }
}

TEST(ResultFile, LeavesTheCaseUntouched) {
    const Image result = result_image(3);
    const CaseFile file = read_case_file(result, "result.h5");
    expect_equal(file.model, section_case());
    EXPECT_EQ(file.design, example_design());
}

TEST(ResultFile, EqualInputGivesEqualBytes) { EXPECT_EQ(result_image(4), result_image(4)); }

TEST(ResultFile, CaseWithoutSolutionSaysWhatToDo) {
    try {
        static_cast<void>(read_result(section_image(), "case.h5"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_STREQ(error.what(), "case.h5: a case without solution; run solve on it");
    }
}

TEST(ResultFile, ResultIsNotSolvedTwice) {
    EXPECT_THROW((ResultWriter{result_image(1), "result.h5", example_provenance("solve"), {}}), Error);
}

TEST(ResultFile, StepsThatDoNotFitAreABug) {
    const auto refused = [](const solution::Step& step, const std::vector<double>& displacement,
                            const std::vector<double>& pressure) {
        ResultWriter writer{section_image(), "case.h5", example_provenance("solve"), {}};
        writer.append(example_step(0), example_displacement(0), example_pressure(0));
        try {
            writer.append(step, displacement, pressure);
        } catch (const Error& error) {
            return error.code() == ExitCode::internal;
        }
        return false;
    };
    const auto displacement = example_displacement(1);
    const auto pressure = example_pressure(1);
    EXPECT_FALSE(refused(example_step(1), displacement, pressure));
    solution::Step step = example_step(1);
    step.outputs_m.pop_back();
    EXPECT_TRUE(refused(step, displacement, pressure));
    step = example_step(1);
    step.min_jacobian = nan;
    EXPECT_TRUE(refused(step, displacement, pressure));
    step = example_step(1);
    step.volume_m3.reset();
    EXPECT_TRUE(refused(step, displacement, pressure));
    EXPECT_TRUE(refused(example_step(1), {1, 2, 3}, pressure));
    EXPECT_TRUE(refused(example_step(1), displacement, {}));
    auto wild = displacement;
    wild[7] = nan;
    EXPECT_TRUE(refused(example_step(1), wild, pressure));
}

TEST(ResultFile, LimitPointBeyondThePathIsABug) {
    ResultWriter writer{section_image(), "case.h5", example_provenance("solve"), {}};
    append_steps(writer, 1);   // the limit point of example_end() is at row 1
    EXPECT_THROW(static_cast<void>(writer.finish(example_end())), Error);
}

struct Lie {
    const char* what;
    std::function<void(hid_t file)> change;
    const char* place;
};

TEST(ResultFile, LiesAreRefusedWithTheirPlace) {
    using Integers = std::vector<std::int64_t>;
    const auto drop = [](hid_t file, const char* name) { H5Ldelete(file, name, H5P_DEFAULT); };
    const std::vector<Lie> lies{
        {"row number", [](hid_t f) { overwrite(f, "/path/step", 1, Integers{7}); }, "/path/step[1]"},
        {"pressure", [](hid_t f) { overwrite(f, "/path/pressure", 2, std::vector{nan}); }, "/path/pressure[2]"},
        {"iterations", [](hid_t f) { overwrite(f, "/path/newton_iterations", 2, Integers{-1}); },
         "/path/newton_iterations[2]"},
        {"missing output", [&](hid_t f) { drop(f, "/path/outputs/bulge"); }, "/path/outputs/bulge"},
        {"limit point", [](hid_t f) { overwrite(f, "/path/limit_points/step", 0, Integers{3}); },
         "/path/limit_points/step[0]"},
        {"stored step", [](hid_t f) { overwrite(f, "/fields/steps", 2, Integers{3}); }, "/fields/steps[2]"},
        {"order", [](hid_t f) { overwrite(f, "/fields/steps", 1, Integers{0}); }, "/fields/steps[1]"},
        {"field", [&](hid_t f) { drop(f, "/fields/displacement"); }, "/fields/displacement"},
        {"fewer rows", [](hid_t f) {
             const DatasetHandle rows{H5Dopen2(f, "/fields/displacement", H5P_DEFAULT)};
             const hsize_t shape[3] = {2, 15, 3};
             H5Dset_extent(rows.get(), shape);
         }, "/fields/displacement"},
        {"reason", [](hid_t f) {
             const GroupHandle path{H5Gopen2(f, "/path", H5P_DEFAULT)};
             H5Adelete(path.get(), "stop_reason");
             write_attribute(path.get(), "stop_reason", "bored");
         }, "/path/stop_reason"},
    };
    for (const Lie& lie : lies) {
        try {
            static_cast<void>(read_result(tampered(result_image(3), lie.change), "result.h5"));
            ADD_FAILURE() << lie.what;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_NE(std::string{error.what()}.find(lie.place), std::string::npos) << error.what();
        }
    }
}

TEST(ResultFile, DamagedFieldIsRefusedWhenItIsRead) {
    const Image image = tampered(result_image(3), [](hid_t file) {
        overwrite(file, "/fields/displacement", 50, std::vector{nan});
    });
    const Result result = read_result(image, "result.h5");
    EXPECT_TRUE(result.fields.read(0).has_value());
    EXPECT_THROW(static_cast<void>(result.fields.read(1)), Error);
}

}  // namespace
}  // namespace soft::io
