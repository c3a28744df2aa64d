#include "model/measure.hpp"

#include <numbers>
#include <stdexcept>

namespace soft::model {
namespace {

constexpr MeasureUnit length{"m", "m", "mm", "mm", 1e-3, core::Dimension::length};
constexpr MeasureUnit angle{"rad", "rad", "deg", "deg", std::numbers::pi / 180, core::Dimension::angle};
constexpr MeasureUnit curvature{"1/m", "per_m", "1/m", "per_m", 1, core::Dimension::curvature};
constexpr MeasureUnit force{"N", "N", "N", "N", 1, core::Dimension::force};
constexpr MeasureUnit moment{"N.m", "Nm", "N.mm", "Nmm", 1e-3, core::Dimension::moment};

struct Entry {
    Measure measure;
    std::string_view name, meaning;
    const MeasureUnit& unit;
};
constexpr std::array entries{
    Entry{Measure::displacement, "displacement", "mean displacement of a face along a direction", length},
    Entry{Measure::bend, "bend", "bending angle of a face relative to another face, about a direction", angle},
    Entry{Measure::twist, "twist", "mean rotation of a face about an axis through the origin", angle},
    Entry{Measure::radial, "radial", "mean change of a face's distance from an axis through the origin", length},
    Entry{Measure::rotation, "rotation", "component of the rotation vector of a face's mean rotation", angle},
    Entry{Measure::curvature, "curvature", "curvature of the best-fit circle of a face, projected along a direction",
          curvature},
    Entry{Measure::force, "force", "force of the actuator on its support or drive at a face", force},
    Entry{Measure::moment, "moment",
          "moment of the actuator on its support or drive at a face, about an axis through its centroid", moment},
};

const Entry& entry_of(Measure measure) {
    for (const Entry& entry : entries)
        if (entry.measure == measure) return entry;
    throw std::logic_error("unit_of: unknown measure");
}

}  // namespace

const MeasureUnit& unit_of(Measure measure) { return entry_of(measure).unit; }
std::string_view name_of(Measure measure) { return entry_of(measure).name; }
std::string_view meaning_of(Measure measure) { return entry_of(measure).meaning; }
bool is_angle(Measure measure) { return unit_of(measure).dimension == core::Dimension::angle; }
bool is_reaction(Measure measure) { return measure == Measure::force || measure == Measure::moment; }

}  // namespace soft::model
