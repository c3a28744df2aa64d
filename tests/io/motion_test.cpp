/// Dynamic cases and their rows, and invalid solver settings in files.
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
using Integers = std::vector<std::int64_t>;
using Words = std::vector<std::string>;

Image dynamic_image() { return write_case(dynamic_case(), example_design(), example_provenance("mesh-gen")); }

std::vector<double> displacement() { return std::vector<double>(3 * dynamic_case().mesh.points.size(), 1e-4); }

Image motion_image(int rows) {
    const Image given = dynamic_image();
    ResultWriter writer{{given, "case.h5", dynamic_case()}, example_provenance("solve"), {}};
    for (int i = 0; i < rows; ++i) writer.append(moving_step(i), displacement(), {});
    return writer.finish({model::StopReason::done, "0.75 s", {}, {}, 9, 8});
}

TEST(DynamicCase, ReadsBackEqualInEveryField) {
    expect_equal(read_case(dynamic_image(), "case.h5"), dynamic_case());
    model::Case model = dynamic_case();
    model.dynamics->integrator = model::Integrator::hht;
    model.dynamics->spectral_radius = 0.5;
    model.loads[0].time_function = {model::TimeFunctionKind::sine, 0, 3.5, {}, {}};
    expect_equal(read_case(write_case(model, example_design(), example_provenance("mesh-gen")), "case.h5"), model);
}

TEST(DynamicCase, RowsReadBackWithTimeAndEnergies) {
    const Result result = read_result(motion_image(4), "result.h5");
    expect_equal(result.model, dynamic_case());
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
            static_cast<void>(read_result(tampered(motion_image(3), corruption.change), "result.h5"));
            ADD_FAILURE() << corruption.location;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_NE(std::string{error.what()}.find(corruption.location), std::string::npos) << error.what();
        }
    }
}

void expect_refused(const Image& image, const std::vector<RowCorruption>& corruptions) {
    for (const RowCorruption& corruption : corruptions) {
        const std::string message = refusal(tampered(image, corruption.change));
        EXPECT_NE(message.find(corruption.location), std::string::npos) << message;
    }
}

TEST(DynamicCase, CorruptedSettingsAreRejectedWithTheirLocation) {
    const std::string dynamics = "/control/dynamics";
    const auto number = [](const char* name, double value) {
        return [=](hid_t f) { overwrite(f, name, 0, Numbers{value}); };
    };
    expect_refused(
        dynamic_image(),
        {{number("/control/dynamics/duration", 0), "/control/dynamics/duration: must be positive"},
         {number("/control/dynamics/step", -1e-3), "/control/dynamics/step"},
         {number("/control/dynamics/accuracy", 0), "/control/dynamics/accuracy"},
         {number("/control/dynamics/spectral_radius", 1.01), "/control/dynamics/spectral_radius"},
         {number("/control/dynamics/mass_damping", -1), "/control/dynamics/mass_damping"},
         {number("/control/dynamics/stiffness_damping", nan), "/control/dynamics/stiffness_damping"},
         {[](hid_t f) { overwrite(f, "/control/dynamics/rows", 0, Integers{0}); }, "/control/dynamics/rows"},
         {[](hid_t f) { overwrite(f, "/control/frequencies", 0, Integers{3}); },
          "/control/frequencies: must be 0 in a dynamic case"},
         {[&](hid_t f) { replace_text(f, dynamics, "integrator", "magic"); }, "/control/dynamics/integrator: 'magic'"},
         {[&](hid_t f) {
              replace_text(f, dynamics, "integrator", "hht");  // spectral radius 0.25: alpha = 0.6
          },
          "/control/dynamics/spectral_radius"},
         {[](hid_t f) { unlink(f, "/materials/rubber/density"); },
          "/materials/rubber/density: is missing, but a dynamic case requires it"}});
}

TEST(DynamicCase, RequiresOneStageOfPressures) {
    model::Case model = dynamic_case();
    model.path.stages.push_back(model.path.stages[0]);
    model.path.stages[0].name = "a";
    model.path.stages[1].name = "b";
    EXPECT_THROW(static_cast<void>(write_case(model, example_design(), example_provenance("mesh-gen"))), Error);
    model = section_case();  // its first supply is a volume
    model.path.stages.resize(1);
    model.dynamics = dynamic_case().dynamics;
    EXPECT_THROW(static_cast<void>(write_case(model, example_design(), example_provenance("mesh-gen"))), Error);
}

TEST(LoadTimeFunctions, CorruptedValuesAreRejectedWithTheirLocation) {
    expect_refused(
        section_image(),
        {{[](hid_t f) {
              replace_texts(f, "/loads/time_function", "kind", Words{"table", "leap"});
          },
          "/loads/time_function/kind[1]: 'leap'"},
         {[](hid_t f) {
              replace_texts(f, "/loads/time_function", "kind", Words{"step", "ramp"});
          },
          "/loads/time_function/kind[0]: has table points"},
         {[](hid_t f) {
              replace_texts(f, "/loads/time_function", "kind", Words{"table", "table"});
          },
          "/loads/time_function/kind[1]: is a table without points"},
         {[](hid_t f) { overwrite(f, "/loads/time_function/rise", 1, Numbers{-1}); }, "/loads/time_function/rise[1]"},
         {[](hid_t f) { overwrite(f, "/loads/tractions/time_function/frequency", 0, Numbers{0}); },
          "/loads/tractions/time_function/frequency[0]: must be positive"},
         {[](hid_t f) { overwrite(f, "/loads/time_function/table/load", 0, Integers{2}); },
          "/loads/time_function/table/load[0]"},
         {[](hid_t f) { overwrite(f, "/loads/tractions/time_function/table/time", 1, Numbers{0.5}); },
          "/loads/tractions/time_function/table/time: must ascend"},
         {[](hid_t f) { overwrite(f, "/loads/time_function/table/share", 1, Numbers{nan}); },
          "/loads/time_function/table/share[1]"},
         {[](hid_t f) {
              replace_texts(f, "/loads", "shape", Words{"deformed", "bent"});
          },
          "/loads/shape[1]: 'bent'"},
         {[](hid_t f) { overwrite(f, "/loads/line_resistance", 0, Numbers{-1}); },
          "/loads/line_resistance[0]: must be positive"},
         {[](hid_t f) { overwrite(f, "/loads/line_resistance", 1, Numbers{1e8}); },
          "/loads/line_resistance[1]: the load 'outside' acts on a face"},
         {[](hid_t f) { replace_text(f, "/materials/rubber", "strain", "none"); },
          "/materials/rubber/strain: 'none'"}});
}

TEST(SolverSettings, CorruptedValuesAreRejectedWithTheirLocation) {
    std::vector<RowCorruption> corruptions{
        {[](hid_t f) { overwrite(f, "/control/solver/linear_tolerance", 0, Numbers{1}); },
         "/control/solver/linear_tolerance"},
        {[](hid_t f) { overwrite(f, "/control/solver/linear_limit", 0, Integers{0}); }, "/control/solver/linear_limit"},
        {[](hid_t f) { overwrite(f, "/control/solver/threads", 0, Integers{257}); }, "/control/solver/threads"},
        {[](hid_t f) { overwrite(f, "/control/solver/wanted_iterations", 0, Integers{0}); },
         "/control/solver/wanted_iterations"},
        {[](hid_t f) { replace<std::uint8_t>(f, "/control/solver", "scaling", {2}); }, "/control/solver/scaling"},
        {[](hid_t f) { unlink(f, "/control/solver/threads"); }, "/control/solver/threads: is missing"},
    };
    for (const char* name : {"newton", "line_search", "tangent", "linear", "preconditioner", "steps", "predictor"})
        corruptions.push_back(
            {[=](hid_t f) { replace_text(f, "/control/solver", name, "guess"); }, "'guess' is not a known value"});
    expect_refused(section_image(), corruptions);
}

}  // namespace
}  // namespace soft::io
