#pragma once
/// Colour map of fields: viridis, perceptually uniform with monotonically increasing lightness, so that it is readable in greyscale
/// and by colour-blind users. Every eighth of its 256 entries with linear interpolation, which is within 0.007 of the full table.
/// Source: S. van der Walt and N. Smith, viridis (2015), public domain (CC0), as in Matplotlib. Tested by view/palette_test.
#include <span>

namespace soft::view {

/// sRGB components from 0 to 1.
struct Rgb {
    double red = 0, green = 0, blue = 0;
};

/// 33 equidistant colours, from the lowest value to the highest.
[[nodiscard]] std::span<const Rgb> viridis();

/// Colour at `share` in [0, 1]; values outside are clamped, NaN gives the lowest colour.
[[nodiscard]] Rgb viridis_at(double share);

}  // namespace soft::view
