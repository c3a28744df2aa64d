#pragma once
/// The body through its steps as the viewer of a report takes it (viewer.js): JSON with base64 arrays. Internal; held by
/// report/scene_test.
///
/// Positions of the skin's bases [mm] and the fields are 16-bit shares of their range over all frames: the body is true to
/// 1/65535 of the space it moves in. Frames are the steps whose fields are stored; where the arrays would be larger than
/// `byte_budget`, curved sides are divided less, then frames are left out evenly (the last one never).
/// The colours of a field run from its value exceeded in 99 % of places and frames to that exceeded in 1 %: a sharp corner
/// does not wash out the rest. The ends say so where the field goes on beyond them.
#include <cstddef>
#include <string>

#include "io/result_file.hpp"
#include "post/curve.hpp"

namespace soft::report {

struct Scene {
    std::string json;        ///< empty where no step has fields
    std::size_t frames = 0;  ///< shown
    std::size_t stored = 0;  ///< steps with fields
};

/// Error(bad_input) where stored fields are damaged.
[[nodiscard]] Scene make_scene(const io::Result& result, const post::Curve& curve, std::size_t byte_budget);

}  // namespace soft::report
