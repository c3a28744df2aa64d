#include "fit/test_data.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "samples.hpp"

namespace soft::fit {
namespace {

const std::string header = "Engineering Strain;Engineering Stress (MPa)\n";

TEST(TestData, ConvertsEveryMeasureToTheSameCurve) {
    const TestCurve wanted = read_test(header + "0.5;0.2\n1;0.3\n", "a", Mode::uniaxial, {});
    EXPECT_EQ(wanted.stretch, (std::vector{1.5, 2.0}));
    EXPECT_EQ(wanted.nominal_Pa, (std::vector{0.2e6, 0.3e6}));
    for (const std::string text :
         {"stretch,nominal stress [kPa]\n1.5,200\n2,300\n", "eng_strain (%),eng. stress_Pa\n50,200000\n100,300000\n",
          "True Strain;True Stress (MPa)\n0.4054651081081644;0.3\n0.6931471805599453;0.6\n"}) {
        const TestCurve test = read_test(text, "a", Mode::uniaxial, {});
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(test.stretch[i], wanted.stretch[i], 1e-14) << text;
            EXPECT_NEAR(test.nominal_Pa[i], wanted.nominal_Pa[i], 1e-8) << text;
        }
    }
}

TEST(TestData, PrefersEngineeringToTrueColumnsUnlessNamed) {
    const TestCurve engineering = sample("dragon-skin-20.csv");
    EXPECT_DOUBLE_EQ(engineering.stretch[0], 1.0446);  // the file's first row
    EXPECT_DOUBLE_EQ(engineering.nominal_Pa[0], 9343.333);
    const TestCurve by_number =
        sample("dragon-skin-20.csv", Mode::uniaxial, {.strain_column = "2", .stress_column = "True Stress"});
    EXPECT_EQ(by_number.measured, StressMeasure::cauchy);
    for (std::size_t i = 0; i < by_number.stretch.size(); ++i) {
        // the README of the data: e agrees to 1e-5, stress to 0.1 kPa
        EXPECT_NEAR(by_number.stretch[i], engineering.stretch[i], 3e-5);
        EXPECT_NEAR(by_number.nominal_Pa[i], engineering.nominal_Pa[i], 100.0);
    }
}

TEST(TestData, RangeIncludesItsEnds) {
    const TestCurve test = read_test(header + "0.1;1\n1.1;2\n1.2;3\n", "a", Mode::uniaxial, {.range = {0.1, 1.1}});
    EXPECT_EQ(test.stretch.size(), 2u);
}

void expect_refused(const std::string& text, const std::string& words, const ReadSettings& settings = {}) {
    try {
        static_cast<void>(read_test(text, "a.csv", Mode::uniaxial, settings));
        ADD_FAILURE() << text;
    } catch (const Error& error) {
        EXPECT_NE(std::string{error.what()}.find(words), std::string::npos) << error.what();
    }
}

TEST(TestData, RejectsInvalidTablesWithTheLineNumber) {
    expect_refused("time;Engineering Stress (MPa)\n0.1;1\n0.2;2\n", "a.csv:1: no title identifies the strain column");
    expect_refused(header + "0.1;1\n0.2;2x\n", "a.csv:3: column 2 'Engineering Stress (MPa)': '2x' is not a number");
    expect_refused(header + "0.1;1\n0.2;\n", "a.csv:3: column 2 'Engineering Stress (MPa)': the cell is empty");
    expect_refused(header + "0.1;1\n0.2\n0.3;4\n", "a.csv:3: column 2 'Engineering Stress (MPa)': the cell is empty");
    expect_refused(header + "0.1;1\n", "a.csv:2: only 1 of the rows");
    expect_refused(header + "0.1;1\n-1.2;2\n", "a.csv:3: a stretch of -0.2");
    expect_refused(header + "0.1;1\n0.2;2\n0.15;3\n", "a.csv:4: the strain reverses direction");
    expect_refused(header + "0.1;1\n0.1;2\n", "a.csv:3: the strain equals that of the previous row");
    expect_refused(header + "10;1\n60;2\n", "a.csv:3: a strain of 60 looks like a percentage");
    expect_refused(header + "0.1;1\n0.2;2\n", "a.csv:1: there is no column 7", {.strain_column = "7"});
    expect_refused(header + "0.1;1\n0.2;2\n", "a.csv:1: no column is called 'force'", {.stress_column = "force"});
    expect_refused(header + "0.1;1\n0.2;2\n", "more than one column is called 'engineering'",
                   {.stress_column = "engineering"});
}

TEST(TestData, ReadsDecimalCommasUnlessTheTableHasDecimalPoints) {
    const TestCurve wanted = read_test(header + "0.25;1.5\n1;2.5\n", "a", Mode::uniaxial, {});
    const TestCurve commas = read_test(header + "0,25;1,5\n1;2,5\n", "a", Mode::uniaxial, {});
    EXPECT_EQ(commas.stretch, wanted.stretch);
    EXPECT_EQ(commas.nominal_Pa, wanted.nominal_Pa);
    expect_refused("Engineering Strain;Engineering Stress (Pa)\n0.1;1,234\n0.2;2,345\n", "a.csv:2: column 2", {});
}

TEST(TestData, ReadsATableWithoutHeaderByColumnNumbers) {
    const TestCurve test = read_test("Pull of 3 May\n1.1 5\n1.2 6\n", "a", Mode::uniaxial,
                                     {.strain_column = "1",
                                      .stress_column = "2",
                                      .strain_measure = StrainMeasure::stretch,
                                      .stress_measure = StressMeasure::engineering,
                                      .stress_unit = "kPa"});
    EXPECT_EQ(test.stretch, (std::vector{1.1, 1.2}));
    EXPECT_EQ(test.nominal_Pa, (std::vector{5e3, 6e3}));
}

TEST(TestData, ReadsUnitsFromASeparateLine) {
    const TestCurve test =
        read_test("Lab;Chambery;\nTime;Engineering Strain;Engineering Stress\n(s);(%);(MPa)\n0;10;1\n1;20;2\n", "a",
                  Mode::uniaxial, {});
    EXPECT_EQ(test.stretch, (std::vector{1.1, 1.2}));
    EXPECT_EQ(test.nominal_Pa, (std::vector{1e6, 2e6}));
}

TEST(TestData, RequiresMissingMeasuresAndUnits) {
    expect_refused("Engineering Strain;Engineering Stress\n0.1;1\n0.2;2\n",
                   "the unit of the stress is not stated; give --stress-unit");
    expect_refused("Strain;Engineering Stress (MPa)\n0.1;1\n0.2;2\n", "give --strain engineering, true or stretch");
    expect_refused("Engineering Strain;Stress (MPa)\n0.1;1\n0.2;2\n", "give --stress engineering or true");
    expect_refused("Engineering Strain;Engineering Stress (furlong)\n0.1;1\n0.2;2\n",
                   "'furlong' is not a known unit of stress; give --stress-unit");
    expect_refused("Strain;Stress\n0.1;1\n0.2;2\n",
                   "give --strain engineering, true or stretch and --stress engineering or true and --stress-unit MPa");
    expect_refused("0.1;1\n0.2;2\n", "no header to identify the strain column");
    EXPECT_EQ(read_test("Strain;Stress\n10;1\n20;2\n", "a", Mode::uniaxial,
                        {.strain_measure = StrainMeasure::engineering,
                         .stress_measure = StressMeasure::engineering,
                         .strain_unit = "%",
                         .stress_unit = "psi"})
                  .stretch[1],
              1.2);
}

TEST(TestData, TitlesPrecedeTheSettings) {
    const ReadSettings settings{.strain_measure = StrainMeasure::engineering,
                                .stress_measure = StressMeasure::engineering,
                                .strain_unit = "1",
                                .stress_unit = "kPa"};
    const TestCurve stated = read_test("Stretch;True stress (MPa)\n1.25;1\n1.6;2\n", "a", Mode::uniaxial, settings);
    EXPECT_EQ(stated.stretch, (std::vector{1.25, 1.6}));
    EXPECT_EQ(stated.nominal_Pa, (std::vector{8e5, 1.25e6}));
    EXPECT_EQ(read_test("Strain (%);Stress\n25;1\n60;2\n", "a", Mode::uniaxial, settings).stretch, stated.stretch);
}

TEST(TestData, FirstInvariantMatchesTheClosedFormOfEachMode) {
    EXPECT_DOUBLE_EQ(first_invariant(Mode::uniaxial, 4.0), 16.5);
    EXPECT_DOUBLE_EQ(first_invariant(Mode::equibiaxial, 2.0), 8.0 + 1.0 / 16.0);
    EXPECT_DOUBLE_EQ(first_invariant(Mode::planar, 2.0), 5.25);
}

/// Tensile test with e = 0.1, 0.2, 0.4 of a specimen with gauge length 33 mm and section 6 x 3 mm: u = 3.3, 6.6, 13.2 mm, F = 18 mm^2 s.
void expect_machine_curve(const TestCurve& test) {
    ASSERT_EQ(test.stretch.size(), 3u);
    const double strain[] = {0.1, 0.2, 0.4}, stress_Pa[] = {20e3, 50e3, 110e3};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(test.stretch[i], 1.0 + strain[i], 1e-12);
        EXPECT_NEAR(test.nominal_Pa[i], stress_Pa[i], 1e-6);
    }
}

ReadSettings of_specimen() {
    ReadSettings settings;
    settings.specimen = {.gauge_length_m = 33e-3, .area_m2 = 18e-6};
    return settings;
}

TEST(TestData, ConvertsDisplacementAndForceToStrainAndEngineeringStress) {
    const auto read = [](const char* text) { return read_test(text, "t.csv", Mode::uniaxial, of_specimen()); };
    // Instron format: quoted cells, units in brackets below the titles, a preamble
    expect_machine_curve(read(
        "Specimen label,\"A 1\"\nGeometry : Thickness,\"3.0\",\"mm\"\n\n\"Time\",\"Extension\",\"Load\"\n"
        "\"(s)\",\"(mm)\",\"(N)\"\n\"0.1\",\"3.3\",\"0.36\"\n\"0.2\",\"6.6\",\"0.90\"\n\"0.4\",\"13.2\",\"1.98\"\n"));
    // Zwick format: semicolons, decimal commas, German or English titles
    for (const char* titles : {"Pr\xfc"
                               "fzeit;Standardweg;Standardkraft",
                               "Test time;Standard travel;Standard force"})
        expect_machine_curve(read((std::string{"Vorkraft;0,1;N\nPr\xfc"
                                               "fgeschwindigkeit;450;mm/min\n\n"} +
                                   titles + "\ns;mm;N\n0,1;3,3;0,36\n0,2;6,6;0,90\n0,4;13,2;1,98\n")
                                      .c_str()));
    // other units, in the titles
    expect_machine_curve(read("Crosshead (m)\tForce (kN)\n0.0033\t0.00036\n0.0066\t0.0009\n0.0132\t0.00198\n"));
}

TEST(TestData, AcceptsDisplacementNoiseButRejectsAReversal) {
    const std::string head = "Extension (mm),Load (N)\n";
    const auto rows = [&](const std::string& text) {
        return read_test(head + text, "a.csv", Mode::uniaxial, of_specimen()).stretch.size();
    };
    EXPECT_EQ(rows("0,0\n0,0.01\n10,1\n9.99,1\n10,1.1\n20,2\n"), 6u);
    EXPECT_EQ(rows("0,0\n0.01,0.01\n-10,-1\n-20,-2\n"), 4u);
    expect_refused(head + "0,0\n10,1\n20,2\n10,0.9\n0,0\n", "a.csv:5: the displacement reverses direction",
                   of_specimen());
    expect_refused(head + "0,0\n-10,-1\n-5,-1\n", "a.csv:4: the displacement reverses direction", of_specimen());
}

TEST(TestData, ReadsAForceTogetherWithAStrain) {
    ReadSettings settings;
    settings.specimen.area_m2 = 18e-6;
    expect_machine_curve(
        read_test("Engineering strain,Force (N)\n0.1,0.36\n0.2,0.9\n0.4,1.98\n", "t.csv", Mode::uniaxial, settings));
}

TEST(TestData, NamesTheMissingSpecimenData) {
    expect_refused("Engineering strain,Load (N)\n0.1,1\n0.2,2\n", "for a force give --area");
    expect_refused("Extension (mm),Load (N)\n1,1\n2,2\n", "for a displacement give --gauge-length");
    expect_refused("Extension,Load (N)\n1,1\n2,2\n", "the unit of the displacement is not stated", of_specimen());
    expect_refused("Extension (mm),Load (kPa)\n1,1\n2,2\n", "is not a known unit of force", of_specimen());
    expect_refused("Extension (mm),Stress (kPa)\n1,1\n2,2\n", "no title identifies the force column", of_specimen());
}

}  // namespace
}  // namespace soft::fit
