#pragma once
/// Data of one material test in the form used by the fit: nominal stress over stretch, one mode per test.
///   stretch l = 1 + e = exp(ln-strain), in the loading direction (equibiaxial: in both)
///   nominal stress P = force / undeformed area = sigma / l (incompressible). The fit uses P because the noise of a force over a fixed
///   area is nearly uniform; sigma = P l would weight large stretches by l^2.
/// Tested by fit/test_data_test.
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/table.hpp"
#include "material/homogeneous.hpp"

namespace soft::fit {

using material::Mode;  // uniaxial, equibiaxial, planar; fit() rejects simple_shear

[[nodiscard]] std::string_view name_of(Mode mode);

enum class StrainMeasure { engineering, logarithmic, stretch };
enum class StressMeasure { engineering, cauchy };

struct TestCurve {
    Mode mode = Mode::uniaxial;
    std::vector<double> stretch = {};
    std::vector<double> nominal_Pa = {};
    std::vector<double> time_s = {};                      ///< by row; empty unless requested
    double weight = 1;                                    ///< of each squared residual of this test
    std::string source = {};                              ///< file name, for reports
    std::string sha256 = {};                              ///< of the file; empty without a file
    StressMeasure measured = StressMeasure::engineering;  ///< measure in the file
};

/// No rubber reaches a strain of 12 (1200 %), but 12 is a small percentage: a larger plain ratio is rejected as a missing % sign.
inline constexpr double max_ratio = 12.0;

/// Range of engineering strains that are used, both ends included.
struct StrainRange {
    double min = -1, max = std::numeric_limits<double>::infinity();
};

enum class RowOrder {
    path,  ///< one loading ramp: a strain that reverses direction is rejected, and a displacement that does so by more than
           ///< 0.2 % of its range
    points  ///< rows in any order
};

/// The undeformed specimen of a tensile test, to convert the output of a testing machine: strain = displacement / gauge length,
/// engineering stress = force / area.
struct Specimen {
    std::optional<double> gauge_length_m = {};  ///< if given, the strain column contains a displacement
    std::optional<double> area_m2 = {};         ///< if given, the stress column contains a force
};

/// Columns are named by (part of) their title, case-insensitive, or by their number from 1. Measures and units are those that the title
/// states, and settings only where it states none, so that files with different titles can be read together:
/// "Engineering Strain", "True Stress (MPa)", "stretch", "stress_kPa"; engineering is preferred to true. With a specimen:
/// "Extension (mm)", "Crosshead [mm]", "Standard travel", "Load (N)", "Standard force", "Standardweg", "Standardkraft".
struct ReadSettings {
    core::Format format = {.layout = core::Layout::described};
    std::string strain_column = {}, stress_column = {};
    std::optional<StrainMeasure> strain_measure = {};
    std::optional<StressMeasure> stress_measure = {};
    std::string strain_unit =
        {};  ///< "1" or "%"; a title without a unit means a plain ratio; for a displacement "mm", ...
    std::string stress_unit = {};  ///< "MPa", for a force "N"; required here or in the title
    Specimen specimen = {};
    std::size_t skipped_rows = 0;
    StrainRange range = {};
    RowOrder order = RowOrder::path;
    bool wants_time = false;       ///< reads the times of the rows; `order` has no effect
    std::string time_column = {};  ///< "time", "Zeit" by default
    std::string time_unit = {};    ///< "s", "ms", "min"; s unless the title states another
};

/// Throws Error (bad_input) "source:line: ..." for a column that is missing or not unique, a unit or measure that is not stated,
/// text in a number, an empty field, a stretch that is not positive, a strain that reverses direction or repeats, fewer than two rows
/// in the range, and as read_table.
[[nodiscard]] TestCurve read_test(std::string_view text, std::string_view source, Mode mode,
                                  const ReadSettings& settings);

/// I1 = tr C of the mode at a stretch, incompressible.
[[nodiscard]] double first_invariant(Mode mode, double stretch);

/// Largest I1 of all rows: the limit of validity of a fitted law.
[[nodiscard]] double max_invariant(const std::vector<TestCurve>& tests);

}  // namespace soft::fit
