#include "view/camera.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::view {

namespace {

constexpr std::array<std::pair<std::string_view, Camera>, 5> named{
    {{"front", {0, 0}}, {"side", {90, 0}}, {"top", {0, 90}}, {"across", {0, -90}}, {"iso", {-35, 25}}}};

[[noreturn]] void refuse(std::string_view text) {
    throw Error(ExitCode::usage, "--view", core::quoted(text) + " is not a view",
                "use front, side, top, across, iso, or AZIMUTH,ELEVATION in degrees (elevation from -90 to 90)");
}

double degrees(std::string_view text, std::string_view whole) {
    const auto parsed = core::parse_quantity(core::trimmed(text), core::Dimension::ratio);
    if (const double* value = std::get_if<double>(&parsed)) return *value;
    refuse(whole);
}

}  // namespace

Camera camera_from_text(std::string_view text) {
    for (const auto& [name, camera] : named)
        if (name == text) return camera;
    const auto comma = text.find(',');
    if (comma == std::string_view::npos) refuse(text);
    const Camera camera{degrees(text.substr(0, comma), text), degrees(text.substr(comma + 1), text)};
    if (std::abs(camera.elevation_deg) > 90) refuse(text);
    return camera;
}

Screen screen_of(const Camera& camera) {
    constexpr double radian = std::numbers::pi / 180;
    const double ca = std::cos(camera.azimuth_deg * radian), sa = std::sin(camera.azimuth_deg * radian);
    const double ce = std::cos(camera.elevation_deg * radian), se = std::sin(camera.elevation_deg * radian);
    return {{ca, 0, -sa}, {-sa * se, ce, -ca * se}, {sa * ce, se, ca * ce}};
}

}  // namespace soft::view
