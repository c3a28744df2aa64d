#include "geometry/cell_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "geometry/keys.hpp"
#include "meshing/cell_counts.hpp"
#include "meshing/section.hpp"

namespace soft::geometry {
namespace {

constexpr const char *size_path = "mesh.size", *quality_path = "mesh.quality", *through_path = "mesh.through_wall";

constexpr const char* coarse = " are too coarse for this shape, the error of the curve may exceed 1 %; use ";

int stated_through_wall(const design::Values& values) {
    return values.has(through_path) ? values.count(through_path) : 0;  // 0 means "auto"
}

}  // namespace

double quality_factor(const design::Values& values) {
    constexpr double draft = 0.5, fine = 1.5;
    if (!values.has(quality_path)) return 1;
    const std::string& word = values.text(quality_path);
    return word == "draft" ? draft : word == "fine" ? fine : 1;
}

int scaled_count(const design::Values& values, int normal) {
    return std::max(1, static_cast<int>(std::lround(normal * quality_factor(values))));
}

CellSize::CellSize(const design::Values& values, double own_m)
    : values_(values),
      own_m_(own_m),
      length_m_(values.number(size_path)),
      factor_(quality_factor(values)),
      stated_(values.number(size_path) > 0) {
    if (!stated_) length_m_ = own_m / factor_;
    if (stated_ && factor_ != 1)
        throw values.refuse(quality_path,
                            core::quoted(values.text(quality_path)) + " has no effect because mesh.size is stated",
                            "use mesh.size: auto");
}

int CellSize::along(double length_m, int min_cells) const {
    return meshing::divisions(length_m, length_m_, stated_ ? min_cells : scaled_count(values_, min_cells));
}

bool CellSize::is_through_stated() const { return stated_through_wall(values_) > 0; }

int CellSize::through(double wall_m, int own, int min_cells) const {
    if (const int stated = stated_through_wall(values_); stated > 0) return stated;
    return stated_ || own == 0 ? along(wall_m, min_cells) : scaled_count(values_, own);
}

Division CellSize::through_ring(double inner_m, double outer_m) const {
    constexpr double cells_per_doubling = 4;
    constexpr int min_cells = 2;
    const int own = meshing::cell_count([&] {
        return std::max(min_cells, static_cast<int>(std::lround(cells_per_doubling * std::log2(outer_m / inner_m))));
    });
    const int cells = through(outer_m - inner_m, own);
    if (stated_) return {cells};
    return {cells, std::pow(outer_m / inner_m, 1 - 1.0 / cells)};
}

std::vector<std::string> CellSize::too_long(double max_ratio) const {
    constexpr double rounding = 1e-9;
    if (length_m_ <= max_ratio * own_m_ * (1 + rounding)) return {};
    const std::string cells = ": cells of " + length_text(length_m_) + coarse;
    if (!stated_) return {quality_path + cells + "mesh.quality: normal"};
    return {size_path + cells + "at most " + core::rounded_text(1e3 * max_ratio * own_m_, 2) + " mm, or auto"};
}

std::vector<std::string> CellSize::too_few(int through, int min_cells) const {
    if (through >= min_cells) return {};
    const char* path = stated_through_wall(values_) > 0 ? through_path : stated_ ? size_path : quality_path;
    return {path + std::string{": walls of "} + core::counted(static_cast<std::size_t>(through), "cell") + coarse +
            "mesh.through_wall: " + std::to_string(min_cells)};
}

double innermost_cell(double inner_m, double outer_m, const Division& through) {
    return through.grading == 1 ? (outer_m / inner_m - 1) / through.cells
                                : std::pow(outer_m / inner_m, 1.0 / through.cells) - 1;
}

std::vector<std::string> too_few_through_ring(const CellSize& size, double inner_m, double outer_m,
                                              const Division& through, double max_ratio) {
    if (innermost_cell(inner_m, outer_m, through) <= max_ratio) return {};
    return size.too_few(through.cells, static_cast<int>(std::ceil((outer_m / inner_m - 1) / max_ratio)));
}

meshing::Sectors sectors(const design::Values& values) {
    using meshing::quarter_rad;
    constexpr double rounding = 1e-9;
    const int stated = values.count("mesh.sectors");
    const double factor = quality_factor(values);
    if (!values.has("geometry.strip.angle") || values.number("geometry.strip.angle") == 0)
        return meshing::Sectors::even(stated > 0 ? stated : factor > 1 ? 8 : factor < 1 ? 3 : 5);
    const double max_rad = (factor > 1 ? 10 : 29) * std::numbers::pi / 180;
    const auto part = [&](double angle_rad) {
        const double largest_rad = stated > 0 ? quarter_rad / stated : max_rad;
        const int cells =
            meshing::cell_count([&] { return static_cast<int>(std::ceil(angle_rad / largest_rad - rounding)); });
        return meshing::Sectors::Part{angle_rad, cells};
    };
    const double strip_rad = 0.5 * values.number("geometry.strip.angle"), beside_rad = quarter_rad - strip_rad;
    meshing::Sectors sectors{{part(strip_rad)}, {part(quarter_rad)}};
    if (beside_rad > 1e-9) sectors.lower.push_back(part(beside_rad));
    return sectors;
}

double bending_length(double radius_m, double thickness_m) { return std::sqrt(radius_m * thickness_m); }

double ring_cell_m(double inner_m, double outer_m) {
    constexpr double share = 0.21;  // of the bending length
    constexpr int min_cells = 8;    // around a quarter turn: quadratic edges deviate from the circle by 3e-6
    const double radius_m = 0.5 * (inner_m + outer_m);
    return std::min(share * bending_length(radius_m, outer_m - inner_m), 0.5 * std::numbers::pi * radius_m / min_cells);
}

}  // namespace soft::geometry
