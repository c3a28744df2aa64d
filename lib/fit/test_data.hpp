#pragma once
/// What a test measured, as the fit wants it: nominal stress over stretch, one mode a test.
///   stretch l = 1 + e = exp(ln-strain), in the direction of the pull (equibiaxial: of both)
///   nominal stress P = force / undeformed area = sigma / l (incompressible), the natural weight: a force over a fixed
///   area has a nearly uniform noise, and sigma = P l would weigh long stretches by l^2.
/// Tested by fit/test_data_test.
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "material/homogeneous.hpp"
#include "table/table.hpp"

namespace soft::fit {

using material::Mode;  // uniaxial, equibiaxial, planar; simple_shear is refused by the fit

[[nodiscard]] std::string_view name_of(Mode mode);

enum class StrainMeasure { engineering, logarithmic, stretch };
enum class StressMeasure { engineering, cauchy };

struct TestCurve {
    Mode mode = Mode::uniaxial;
    std::vector<double> stretch = {};
    std::vector<double> nominal_Pa = {};
    double weight = 1;                                    ///< of each squared residual of this test
    std::string source = {};                              ///< file name, for reports
    std::string sha256 = {};                              ///< of the file; empty where there is none
    StressMeasure measured = StressMeasure::engineering;  ///< what the file holds
};

/// A strain of 12 is past what any rubber bears, and a small percentage: a plain ratio beyond it is taken for a slip.
inline constexpr double max_ratio = 12.0;

/// Engineering strains that take part, both ends included.
struct StrainRange {
    double least = -1, most = std::numeric_limits<double>::infinity();
};

enum class RowOrder {
    path,  ///< a pull from one end to the other: a strain that turns back is refused, a displacement that does so by more
           ///< than 0.2 % of the whole
    points  ///< rows in any order
};

/// The undeformed specimen of a tensile test, for what a testing machine writes: strain = displacement / gauge length,
/// engineering stress = force / area.
struct Specimen {
    std::optional<double> gauge_length_m = {};  ///< given: the strain's column holds a displacement
    std::optional<double> area_m2 = {};         ///< given: the stress's column holds a force
};

/// Columns are named by (part of) their title, letter case free, or by their number from 1. What is empty is taken from the
/// header: "Engineering Strain", "True Stress (MPa)", "stretch", "stress_kPa"; of engineering and true the former. With a
/// specimen: "Extension (mm)", "Crosshead [mm]", "Standard travel", "Load (N)", "Standard force", "Standardweg", "Standardkraft".
struct ReadSettings {
    table::Format format = {.layout = table::Layout::described};
    std::string strain_column = {}, stress_column = {};
    std::optional<StrainMeasure> strain_measure = {};
    std::optional<StressMeasure> stress_measure = {};
    std::string strain_unit = {};  ///< "1" or "%"; a title without one is a plain ratio. Of a displacement "mm", ...
    std::string stress_unit = {};  ///< "MPa", of a force "N"; must stand here or in the title
    Specimen specimen = {};
    std::size_t skipped_rows = 0;
    StrainRange range = {};
    RowOrder order = RowOrder::path;
};

/// Throws Error (bad_input) "source:line: ..." for a column that is missing or not unique, a unit or measure that is
/// nowhere stated, text in a number, an empty field, a stretch that is not positive, a strain that turns back or repeats,
/// fewer than two rows in the range, and what read_table refuses.
[[nodiscard]] TestCurve read_test(std::string_view text, std::string_view source, Mode mode,
                                  const ReadSettings& settings);

/// I1 = tr C of the mode at a stretch, incompressible.
[[nodiscard]] double first_invariant(Mode mode, double stretch);

/// Largest I1 of the rows: how far a law is known.
[[nodiscard]] double max_invariant(const std::vector<TestCurve>& tests);

}  // namespace soft::fit
