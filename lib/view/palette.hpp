#pragma once
/// The colours of fields: viridis, perceptually uniform, its lightness rising from end to end, so that it reads in grey
/// and by the colour-blind. Every eighth of its 256 entries; linear in between, that is within 0.007 of the whole
/// table.
/// Source: S. van der Walt and N. Smith, viridis (2015), public domain (CC0), as in Matplotlib. Held by
/// view/palette_test.
#include <span>

namespace soft::view {

/// sRGB components from 0 to 1.
struct Rgb {
    double red = 0, green = 0, blue = 0;
};

/// 33 colours at equal distances, from the lowest value to the highest.
[[nodiscard]] std::span<const Rgb> viridis();

/// `share` from 0 to 1; beyond them the ends, and the lowest for what is no number.
[[nodiscard]] Rgb viridis_at(double share);

}  // namespace soft::view
