#include "io/result_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>

#include "example_case.hpp"
#include "io/hdf5_write.hpp"
#include "io/image.hpp"

namespace soft::io {
namespace {

using namespace test;
using Keep = FieldsPolicy::Keep;
using Image = std::vector<std::byte>;

void append_steps(ResultWriter& writer, int count) {
    for (int i = 0; i < count; ++i) writer.append(example_step(i), example_displacement(i), example_pressure(i));
}

Image result_image(int steps, const ResultOptions& options = {}) {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), options};
    append_steps(writer, steps);
    return writer.finish(example_end());
}

TEST(ResultFile, ReadsBackEqualInEveryField) {
    const Result result = read_result(result_image(4), "result.h5");
    expect_equal(result.model.mesh, section_case().mesh);
    EXPECT_EQ(result.design, example_design());
    EXPECT_FALSE(result.changed_design.has_value());
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

/// A step as `solve --tolerance` writes it.
model::Step step_with_errors(int number) {
    model::Step step = example_step(number);
    step.pressure_error_Pa = 12.5 * number;
    step.output_errors = {1e-5 * number, 2e-6};
    return step;
}

TEST(ResultFile, ErrorBarsReadBack) {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    for (int i = 0; i < 3; ++i) writer.append(step_with_errors(i), example_displacement(i), example_pressure(i));
    EXPECT_THROW(writer.append(example_step(3), example_displacement(3), example_pressure(3)), Error);
    const Result result = read_result(writer.finish(example_end()), "result.h5");
    ASSERT_EQ(result.steps.size(), 3U);
    for (int i = 0; i < 3; ++i) expect_equal(result.steps[static_cast<std::size_t>(i)], step_with_errors(i));
}

/// As in `solve --tolerance`: rows without error bars, then the same rows with error bars. The file is complete and locked each time.
TEST(ResultFile, IsCompleteAfterEachPublishAndStaysLocked) {
    const auto file = std::filesystem::temp_directory_path() / ("published-" + std::to_string(::getpid()) + ".h5");
    const auto image = section_image();
    const model::Case solved = section_case();
    const SolveInput given{image, "case.h5", solved};
    const auto read = [&] {
        std::ifstream stream(file, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        const auto bytes = std::as_bytes(std::span(text));
        return read_result(std::vector<std::byte>(bytes.begin(), bytes.end()), "result.h5");
    };
    ResultWriter writer{file, given, example_provenance("solve"), {}};
    for (int i = 0; i < 3; ++i) writer.append(example_step(i), example_displacement(i), example_pressure(i));
    EXPECT_FALSE(read().end.has_value());
    for (const int rows : {3, 2}) {
        ResultWriter finer{given, example_provenance("solve"), {}};
        for (int i = 0; i < rows; ++i) finer.append(step_with_errors(i), example_displacement(i), example_pressure(i));
        writer.publish(std::move(finer), example_end());
        const Result result = read();
        EXPECT_TRUE(result.end.has_value());
        ASSERT_EQ(result.steps.size(), static_cast<std::size_t>(rows));
        expect_equal(result.steps[1], step_with_errors(1));
        EXPECT_TRUE(writer.is_in_place());
        EXPECT_THROW(ResultWriter(file, given, example_provenance("solve"), {}), Error);
    }
    EXPECT_EQ(read_result(writer.finish({}), "result.h5").steps.size(), 2U);
    EXPECT_EQ(read().steps.size(), 2U);
    std::filesystem::remove(file);
}

TEST(ResultFile, RejectsInvalidErrorBars) {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    const auto refuses = [&](const model::Step& step) {
        EXPECT_THROW(writer.append(step, example_displacement(0), example_pressure(0)), Error);
    };
    model::Step step = step_with_errors(1);
    step.pressure_error_Pa = -1;
    refuses(step);
    step = step_with_errors(1);
    step.output_errors = {1e-5, nan};
    refuses(step);
    step.output_errors.pop_back();
    refuses(step);
    step.pressure_error_Pa.reset();
    refuses(step);
}

TEST(ResultFile, RejectsMissingAndInvalidFrequencies) {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    for (const std::vector<double>& frequencies : {std::vector<double>{}, {1.0}, {1.0, nan}}) {
        model::Step step = example_step(0);
        step.frequencies_Hz = frequencies;
        EXPECT_THROW(writer.append(step, example_displacement(0), example_pressure(0)), Error);
    }
}

/// The section with other loads, as after `solve --set`. Its path has other columns.
model::Case changed_case() {
    model::Case model = section_case();
    model.materials[0].law = "yeoh";
    model.materials[0].constants = {{"c1", {1e5}}};
    model.loads = {{"left", {"main"}, true, {}}, {"right", {"annex"}, true, {}}, {"outside", {"inlet"}, false, {}}};
    model.dead_loads.resize(1);
    model.motions.clear();
    const model::SupplyTarget full{model::Prescription::pressure, 3e4};
    model.path.stages.resize(1);
    model.path.stages[0].supplies = {full, full, full};
    model.path.stages[0].dead_loads = {0};
    model.path.stages[0].motions.clear();
    model.path.stages[0].controlled = "left";
    model.solver.step_limit = 5;
    return model;
}

model::Step changed_step() {
    model::Step step = example_step(1);
    step.pressures_Pa = step.tangent_pressures = {1, 2, 3};
    return step;
}

TEST(ResultFile, ContainsTheCaseAsItWasSolved) {
    const model::Case solved = changed_case();
    const ResultOptions options{{Keep::all}, DesignText{"solved: otherwise\n", {"load.pressure=1kPa"}}};
    ResultWriter writer{{section_image(), "case.h5", solved}, example_provenance("solve"), options};
    writer.append(changed_step(), example_displacement(1), example_pressure(1));
    const Image image = writer.finish({});
    const auto build = [&](const mesh::Mesh&, const model::Shape&, std::string_view yaml, std::string_view source) {
        EXPECT_EQ(yaml, "solved: otherwise\n");
        EXPECT_EQ(source, "result.h5:/solve_design/effective_yaml");
        return solved;
    };
    const Result result = io::read_result(image, "result.h5", build);
    expect_equal(result.steps.at(0), changed_step());
    EXPECT_EQ(result.changed_design, options.changed_design);
    EXPECT_EQ(result.design, example_design());
    EXPECT_EQ(read_case_file(image, "result.h5").design, example_design());  // as mesh-gen wrote it
}

TEST(ResultFile, WithoutVolumesAndPressuresReadsBack) {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    model::Step step = example_step(1);
    step.volume_m3.reset();
    step.tangent_volume = 0;
    writer.append(step, example_displacement(1), {});
    const Result one = read_result(writer.finish({}), "result.h5");
    expect_equal(one.steps.at(0), step);
    EXPECT_TRUE(one.fields.read(0)->pressure_Pa.empty());
}

TEST(ResultFile, RejectsAPathWithoutRows) {
    ResultWriter idle{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    EXPECT_THROW(static_cast<void>(idle.finish({})), Error);
    const auto drop_rows = [](hid_t file) {  // as an older solve left it when it was killed before its first row
        H5Ldelete(file, "/path", H5P_DEFAULT);
        const GroupHandle path = create_group(file, "path", "");
        H5Ldelete(file, "/fields/steps", H5P_DEFAULT);
        H5Ldelete(file, "/fields/displacement", H5P_DEFAULT);
        H5Ldelete(file, "/fields/pressure", H5P_DEFAULT);
    };
    try {
        static_cast<void>(read_result(tampered(result_image(2), drop_rows), "result.h5"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_STREQ(error.what(), "result.h5:/path: the path has no row; run solve again");
    }
}

TEST(ResultFile, PolicySelectsTheStoredSteps) {
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

TEST(ResultFile, ParsesFieldsPolicies) {
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

TEST(ResultFile, DoesNotChangeTheCase) {
    const Image result = result_image(3);
    const CaseFile file = read_case_file(result, "result.h5");
    expect_stored(result, section_case());
    EXPECT_EQ(file.design, example_design());
}

TEST(ResultFile, EqualInputGivesEqualBytes) { EXPECT_EQ(result_image(4), result_image(4)); }

TEST(ResultFile, RejectsACaseWithoutSolutionWithARemedy) {
    try {
        static_cast<void>(read_result(section_image(), "case.h5"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_STREQ(error.what(), "case.h5: a case without solution; run solve on it");
    }
}

TEST(ResultFile, RejectsAResultAsInputOfSolve) {
    EXPECT_THROW((ResultWriter{{result_image(2), "result.h5", section_case()}, example_provenance("solve"), {}}),
                 Error);
}

TEST(ResultFile, RejectsPartsOfASolutionAsInputOfSolve) {
    const ResultOptions options{{Keep::all}, DesignText{"solved: otherwise\n", {"load.pressure=1kPa"}}};
    const std::vector<std::string> groups{"path", "fields", "modes", "solve_design", "provenance/solve"};
    for (const std::string& kept : groups) {
        const auto drop = [&](hid_t file) {
            for (const std::string& group : groups)
                if (group != kept) H5Ldelete(file, group.c_str(), H5P_DEFAULT);
        };
        const Image image = tampered(result_image(2, options), drop);
        try {
            const ResultWriter writer{{image, "result.h5", section_case()}, example_provenance("solve"), {}};
            ADD_FAILURE() << kept;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_EQ(error.what(),
                      "result.h5:/" + kept + ": already contains a solution; give solve the case from mesh-gen");
        }
    }
}

TEST(ResultFile, RejectsStepsThatDoNotMatchTheCase) {
    const auto refused = [](const model::Step& step, const std::vector<double>& displacement,
                            const std::vector<double>& pressure) {
        ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
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
    model::Step step = example_step(1);
    step.outputs.pop_back();
    EXPECT_TRUE(refused(step, displacement, pressure));
    step = example_step(1);
    step.pressures_Pa.clear();
    EXPECT_TRUE(refused(step, displacement, pressure));
    step = example_step(1);
    step.tangent_volumes.push_back(0);
    EXPECT_TRUE(refused(step, displacement, pressure));
    step = example_step(1);
    step.volumes_m3[1] = nan;
    EXPECT_TRUE(refused(step, displacement, pressure));
    step = example_step(1);
    step.stage = 3;
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

TEST(ResultFile, RejectsALimitPointBeyondThePath) {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    append_steps(writer, 1);  // the limit point of example_end() is at row 1
    EXPECT_THROW(static_cast<void>(writer.finish(example_end())), Error);
}

TEST(ResultFile, RejectsAModeThatDoesNotMatchTheMesh) {
    for (const bool finite : {false, true}) {
        ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
        append_steps(writer, 2);
        model::PathEnd end = example_end();
        if (finite)
            end.bifurcations[1].mode.pop_back();
        else
            end.bifurcations[1].mode[4] = nan;
        EXPECT_THROW(static_cast<void>(writer.finish(end)), Error);
    }
}

TEST(ResultFile, CorruptedValuesAreRejectedWithTheirLocation) {
    using Integers = std::vector<std::int64_t>;
    const auto drop = [](hid_t file, const char* name) { H5Ldelete(file, name, H5P_DEFAULT); };
    const std::vector<Corruption> corruptions{
        {"row number", [](hid_t f) { overwrite(f, "/path/step", 1, Integers{7}); }, "/path/step[1]"},
        {"pressure", [](hid_t f) { overwrite(f, "/path/pressure", 2, std::vector{nan}); }, "/path/pressure[2]"},
        {"iterations", [](hid_t f) { overwrite(f, "/path/newton_iterations", 2, Integers{-1}); },
         "/path/newton_iterations[2]"},
        {"missing output", [&](hid_t f) { drop(f, "/path/outputs/bend"); }, "/path/outputs/bend"},
        {"limit point", [](hid_t f) { overwrite(f, "/path/limit_points/step", 0, Integers{3}); },
         "/path/limit_points/step[0]"},
        {"stage", [](hid_t f) { overwrite(f, "/path/stage", 1, Integers{3}); }, "/path/stage[1]"},
        {"pressure of a load", [&](hid_t f) { drop(f, "/path/pressures/outside"); }, "/path/pressures/outside"},
        {"volume of a cavity", [](hid_t f) { overwrite(f, "/path/volumes/annex", 0, std::vector{nan}); },
         "/path/volumes/annex[0]"},
        {"tangent of that volume", [&](hid_t f) { drop(f, "/path/tangents/volumes/annex"); },
         "/path/tangents/volumes/annex"},
        {"bifurcation", [](hid_t f) { overwrite(f, "/path/bifurcations/step", 1, Integers{-1}); },
         "/path/bifurcations/step[1]"},
        {"number of modes", [](hid_t f) { overwrite(f, "/path/bifurcations/modes", 0, Integers{0}); },
         "/path/bifurcations/modes[0]"},
        {"owner of a mode", [](hid_t f) { overwrite(f, "/modes/bifurcation", 0, Integers{2}); },
         "/modes/bifurcation[0]"},
        {"mode", [](hid_t f) { overwrite(f, "/modes/displacement", 3, std::vector{nan}); }, "/modes/displacement"},
        {"missing mode", [&](hid_t f) { drop(f, "/modes/displacement"); }, "/modes/displacement"},
        {"stored step", [](hid_t f) { overwrite(f, "/fields/steps", 2, Integers{3}); }, "/fields/steps[2]"},
        {"order", [](hid_t f) { overwrite(f, "/fields/steps", 1, Integers{0}); }, "/fields/steps[1]"},
        {"field", [&](hid_t f) { drop(f, "/fields/displacement"); }, "/fields/displacement"},
        {"fewer rows",
         [](hid_t f) {
             const DatasetHandle rows{H5Dopen2(f, "/fields/displacement", H5P_DEFAULT)};
             const hsize_t shape[3] = {2, 15, 3};
             H5Dset_extent(rows.get(), shape);
         },
         "/fields/displacement"},
        {"reason",
         [](hid_t f) {
             const GroupHandle path{H5Gopen2(f, "/path", H5P_DEFAULT)};
             H5Adelete(path.get(), "stop_reason");
             write_attribute(path.get(), "stop_reason", "bored");
         },
         "/path/stop_reason"},
    };
    for (const Corruption& corruption : corruptions) {
        try {
            static_cast<void>(read_result(tampered(result_image(3), corruption.change), "result.h5"));
            ADD_FAILURE() << corruption.what;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_NE(std::string{error.what()}.find(corruption.location), std::string::npos) << error.what();
        }
    }
}

TEST(ResultFile, RejectsADamagedFieldWhenItIsRead) {
    const Image image =
        tampered(result_image(3), [](hid_t file) { overwrite(file, "/fields/displacement", 50, std::vector{nan}); });
    const Result result = read_result(image, "result.h5");
    EXPECT_TRUE(result.fields.read(0).has_value());
    EXPECT_THROW(static_cast<void>(result.fields.read(1)), Error);
}

}  // namespace
}  // namespace soft::io
