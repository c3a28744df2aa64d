#pragma once
/// Camera with parallel projection, so that a scale bar is valid in the whole picture.
/// In the front view, x of the model (the axis of bodies of revolution) points to the right, y up and z towards the eye. The azimuth
/// rotates the eye about y (towards +x), the elevation raises it. Tested by view/camera_test.
#include <string>
#include <string_view>

#include "math/tensor.hpp"

namespace soft::view {

struct Camera {
    double azimuth_deg = 0, elevation_deg = 0;
};

/// "front" (0, 0), "side" (90, 0: along the axis), "top" (0, 90), "across" (0, -90: along y, x to the right and z up, the plane in
/// which fingers bend), "iso" (-35, 25), or "AZIMUTH,ELEVATION" in degrees,
/// elevation from -90 to 90. Throws Error(usage, location "--view").
[[nodiscard]] Camera camera_from_text(std::string_view text);

/// Unit vectors of the picture: to the right, up, and towards the eye.
struct Screen {
    Vector3 right, up, eye;
};
[[nodiscard]] Screen screen_of(const Camera& camera);

}  // namespace soft::view
