#pragma once
/// The colour bar of a picture as lines of a gnuplot script. No two ticks have the same text, and numbers and label stay inside
/// the picture for any length. Tested by view/colour_bar_test.
#include <string>
#include <string_view>
#include <vector>

namespace soft::view {

struct Tick {
    double value;
    std::string text;
};

/// The largest of 1, 2 or 5 times a power of ten that does not exceed `max_step`; also the length of a scale bar.
[[nodiscard]] double round_step(double max_step);

/// Multiples of 1, 2 or 5 times a power of ten from `low` to `high` (low < high): 4 to 9 of them. All texts have the
/// same number of decimals, enough to distinguish neighbours.
[[nodiscard]] std::vector<Tick> bar_ticks(double low, double high);

struct ColourBar {
    double low = 0, high = 1;            ///< in the unit of the label
    std::string label;                   ///< "von Mises stress (kPa)"
    double width_px = 0, height_px = 0;  ///< of the whole picture
    double font = 0;                     ///< font size of the picture, points
};

/// For a plot that fills the whole picture. Uses label 3.
[[nodiscard]] std::string colour_bar_script(const ColourBar& bar);
}  // namespace soft::view
