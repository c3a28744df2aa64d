#include "geometry/half_round.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/strip.hpp"
#include "meshing/cell_counts.hpp"
#include "meshing/section_mesher.hpp"

namespace soft::geometry {
namespace {

using Names = std::vector<std::string>;

constexpr const char *cavity = "cavity", *bottom = "bottom", *outer = "outer";
/// Width and height of the square in the middle of the cavity, relative to the inner radius.
constexpr double core_share = 0.5;

/// A strip of cells between two values of y, or of z.
struct Band {
    double from_m, to_m;
    int cells;
};

class Drawing {
public:
    Drawing(const HalfRound& shape, std::span<const WallLayer> layers, const HalfRoundCells& cells, Cut cut)
        : shape_(shape), layers_(layers.begin(), layers.end()), cells_(cells), cut_(cut) {
        const double core_m = core_share * shape.inner_m;
        columns_ = {{0, core_m, cells.eighth},
                    {core_m, shape.inner_m, meshing::divisions(shape.inner_m - core_m, cells.size_m)}};
        double from_m = shape.inner_m;
        for (const WallLayer& layer : layers_) {
            columns_.push_back({from_m, layer.outer_m, layer.through.cells});
            from_m = layer.outer_m;
        }
        add_rows();
    }

    meshing::Section draw() {
        side(1);
        if (cut_ == Cut::whole) side(-1);
        return std::move(section_);
    }

private:
    /// Columns of the cavity; those of the ring follow.
    static constexpr std::size_t own_columns = 2;

    /// Rows of the flat wall from the cavity floor down, divided where a layer or the strip begins.
    void add_rows() {
        const auto depth_m = [&](std::size_t layer) {
            return layer + 1 == layers_.size()
                       ? shape_.flat_m
                       : shape_.flat_m * (layers_[layer].outer_m - shape_.inner_m) / (shape_.outer_m - shape_.inner_m);
        };
        const double strip_m = shape_.flat_m - shape_.strip_m;
        double from_m = 0;
        const auto add = [&](double to_m, std::size_t layer) {
            const int cells = meshing::cell_count([&] {
                return std::max(1, static_cast<int>(std::lround((to_m - from_m) / shape_.flat_m * cells_.flat)));
            });
            rows_.push_back({from_m, to_m, cells});
            row_layers_.push_back(layer);
            from_m = to_m;
        };
        for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
            constexpr double rounding = 1e-9;
            const double to_m = depth_m(layer), min_m = rounding * shape_.flat_m;
            if (shape_.strip_m > 0 && from_m + min_m < strip_m && strip_m < to_m - min_m) add(strip_m, layer);
            add(to_m, layer);
        }
    }

    /// The point at (y, z), created on first use.
    int at(double y, double z) {
        const auto [found, fresh] = points_.try_emplace({y, z}, 0);
        if (fresh) found->second = add_point(section_, {y, z});
        return found->second;
    }

    struct Line {
        int cells;
        Names faces = {};
    };
    void line(int start, int end, const Line& line) {
        if (!lines_.try_emplace(std::minmax(start, end), true).second) return;
        add_line(section_, {start, end}, line.cells, line.faces);
    }

    void block(const std::array<int, 4>& p, const std::string& region) {
        add_block(section_, {{{p[0], p[1]}, {p[1], p[2]}, {p[2], p[3]}, {p[3], p[0]}}}, region);
    }

    /// Face of lines at y = 0: the symmetry plane, if the section is cut there.
    [[nodiscard]] Names middle() const { return cut_ == Cut::half ? Names{meshing::symmetry_y_face} : Names{}; }

    void side(int sign) {
        sign_ = sign;
        fill_cavity();
        for (std::size_t ring = own_columns; ring < columns_.size(); ++ring)
            draw_ring(columns_[ring], layers_[ring - own_columns].region);
        for (std::size_t row = 0; row < rows_.size(); ++row)
            for (std::size_t column = 0; column < columns_.size(); ++column) draw_flat(column, row);
    }

    int mirrored_at(double y, double z) { return at(sign_ * y + 0.0, z); }  // -0 + 0 = 0
    std::array<int, 3> arc_points(double r) {
        const double slope = r * std::numbers::sqrt2 / 2;
        return {mirrored_at(r, 0), mirrored_at(slope, slope), mirrored_at(0, r)};
    }
    void arcs(double r, const Names& faces) {
        const auto p = arc_points(r);
        const int centre = mirrored_at(0, 0);
        for (std::size_t k = 0; k < 2; ++k)
            if (lines_.try_emplace(std::minmax(p[k], p[k + 1]), true).second)
                add_arc(section_, {p[k], p[k + 1]}, centre, cells_.eighth, faces);
    }

    /// Meshes one side of the cavity by a square in the middle and two blocks around it.
    void fill_cavity() {
        const Band &core = columns_[0], &rest = columns_[1];
        const double c = core.to_m;
        const int centre = mirrored_at(0, 0), right = mirrored_at(c, 0), corner = mirrored_at(c, c),
                  top = mirrored_at(0, c);
        const auto rim = arc_points(shape_.inner_m);
        arcs(shape_.inner_m, {});
        line(centre, right, {core.cells});
        line(right, corner, {core.cells});
        line(corner, top, {core.cells});
        line(top, centre, {core.cells, middle()});
        line(right, rim[0], {rest.cells});
        line(corner, rim[1], {rest.cells});
        line(top, rim[2], {rest.cells, middle()});
        block({centre, right, corner, top}, cavity);
        block({right, rim[0], rim[1], corner}, cavity);
        block({corner, rim[1], rim[2], top}, cavity);
    }

    void draw_ring(const Band& ring, const std::string& region) {
        const bool last = ring.to_m == shape_.outer_m;
        arcs(ring.to_m, last ? Names{outer} : Names{});
        const auto in = arc_points(ring.from_m), out = arc_points(ring.to_m);
        for (std::size_t k = 0; k < 3; ++k) line(in[k], out[k], {ring.cells, k == 2 ? middle() : Names{}});
        for (std::size_t k = 0; k < 2; ++k) block({in[k], out[k], out[k + 1], in[k + 1]}, region);
    }

    /// Below the ring a layer continues downwards until it turns into the flat wall: a cell there belongs to the outer one of the two
    /// layers given by its column and its row.
    [[nodiscard]] std::string flat_region(std::size_t column, std::size_t row) const {
        const std::size_t layer = row_layers_[row];
        const bool down = column >= own_columns && column - own_columns > layer;
        const std::string& name = layers_[down ? column - own_columns : layer].region;
        const std::string region = down || name == meshing::rubber_region ? name : name + "_flat";
        return rows_[row].from_m >= (shape_.flat_m - shape_.strip_m) * (1 - 1e-9) && shape_.strip_m > 0
                   ? strip_region(region)
                   : region;
    }

    void draw_flat(std::size_t column, std::size_t row) {
        const Band &c = columns_[column], &r = rows_[row];
        const bool lowest = row + 1 == rows_.size(), outermost = column + 1 == columns_.size();
        const int upper_left = mirrored_at(c.from_m, -r.from_m), upper_right = mirrored_at(c.to_m, -r.from_m);
        const int lower_left = mirrored_at(c.from_m, -r.to_m), lower_right = mirrored_at(c.to_m, -r.to_m);
        line(upper_left, upper_right, {c.cells});
        line(lower_left, lower_right, {c.cells, lowest ? Names{bottom} : Names{}});
        line(upper_left, lower_left, {r.cells, column == 0 ? middle() : Names{}});
        line(upper_right, lower_right, {r.cells, outermost ? Names{outer} : Names{}});
        block({lower_left, lower_right, upper_right, upper_left}, flat_region(column, row));
    }

    HalfRound shape_;
    std::vector<WallLayer> layers_;
    HalfRoundCells cells_;
    Cut cut_;
    int sign_ = 1;
    std::vector<Band> columns_, rows_;
    std::vector<std::size_t> row_layers_;
    meshing::Section section_;
    std::map<meshing::PlanePoint, int> points_;
    std::map<std::pair<int, int>, bool> lines_;
};

}  // namespace

meshing::Section half_round_section(const HalfRound& shape, std::span<const WallLayer> layers,
                                    const HalfRoundCells& cells, Cut cut) {
    return Drawing{shape, layers, cells, cut}.draw();
}

}  // namespace soft::geometry
