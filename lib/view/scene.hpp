#pragma once
/// Data of the 3D viewer of a report (viewer.js): the body in all frames, as JSON with base64 arrays. Internal; tested by
/// view/scene_test.
///
/// Positions of the skin's bases [mm] and the fields are stored as 16-bit fractions of their range over all frames, so the resolution
/// of positions is 1/65535 of the space in which the body moves. Frames are the steps with stored fields. If the arrays would exceed
/// `byte_budget`, curved facets are subdivided less, then frames are omitted evenly (never the last one).
/// The colour range of a field extends from its 1 % to its 99 % quantile over all bases and frames, so that a stress peak at a sharp
/// corner does not dominate the colours. The labels of the colour bar indicate values outside the range.
#include <cstddef>
#include <string>

#include "io/result_file.hpp"
#include "post/curve.hpp"
#include "post/rubber_history.hpp"

namespace soft::view {

struct Scene {
    std::string json;        ///< empty if no step has fields
    std::size_t frames = 0;  ///< shown
    std::size_t stored = 0;  ///< steps with fields
};

/// Error(bad_input) if stored fields are damaged.
/// Of a result that outlives it.
[[nodiscard]] post::RubberHistory rubber_history(const io::Result& result);

[[nodiscard]] Scene make_scene(const io::Result& result, const post::Curve& curve, std::size_t byte_budget);

}  // namespace soft::view
