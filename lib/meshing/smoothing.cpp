#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mesh/shape.hpp"
#include "meshing/polygons.hpp"

namespace soft::meshing {
namespace {

/// Quality of a second-order cell: the ratio of the smallest to the largest Jacobian determinant, or the smallest sine between its
/// parameter lines if that is smaller; both at its nodes. Negative if the cell is inverted.
class Smoother {
public:
    explicit Smoother(Polygons& mesh)
        : mesh_(mesh),
          cells_at_(mesh.points.size()),
          triangle_(gradients(mesh::CellType::triangle6)),
          quadrilateral_(gradients(mesh::CellType::quad9)) {
        for (std::size_t c = 0; c < mesh.cells.size(); ++c)
            for (const int p : mesh.cells[c]) cells_at_[static_cast<std::size_t>(p)].push_back(c);
        for (const auto& [ends, side] : mesh.boundary) {
            middles_[ends] = boundary_middle(mesh, ends).position;
            for (const int p : ends) cells_at_[static_cast<std::size_t>(p)].clear();  // boundary points do not move
        }
        for (const std::vector<int>& cell : mesh.cells) quality_.push_back(quality(cell));
    }

    void run() {
        constexpr int rounds = 8;
        for (int round = 0; round < rounds; ++round) {
            std::set<int> pending;
            for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
                if (quality_[c] < good_) add_around(c, pending);
            bool moved = false;
            for (const int p : pending) moved = improve(p) || moved;
            if (!moved) return;
        }
    }

private:
    static constexpr double good_ = 0.3;
    using Gradients = std::vector<std::vector<mesh::ShapeValue>>;

    static Gradients gradients(mesh::CellType type) {
        Gradients at_nodes;
        for (const auto& xi : mesh::topology(type).nodes) at_nodes.push_back(mesh::shape_values(type, xi));
        return at_nodes;
    }

    [[nodiscard]] const PlanePoint& at(int point) const { return mesh_.points[static_cast<std::size_t>(point)]; }

    /// Adds the inner points of a cell and its neighbours.
    void add_around(std::size_t cell, std::set<int>& points) const {
        for (const int p : mesh_.cells[cell])
            for (const std::size_t beside : cells_at_[static_cast<std::size_t>(p)])
                for (const int q : mesh_.cells[beside])
                    if (!cells_at_[static_cast<std::size_t>(q)].empty()) points.insert(q);
    }

    [[nodiscard]] double worst_around(int point) const {
        double worst = 1;
        for (const std::size_t c : cells_at_[static_cast<std::size_t>(point)])
            worst = std::min(worst, quality(mesh_.cells[c]));
        return worst;
    }

    /// Moves a point as long as the worst cell around it improves, with step halving.
    bool improve(int point) {
        PlanePoint& position = mesh_.points[static_cast<std::size_t>(point)];
        const auto& around = cells_at_[static_cast<std::size_t>(point)];
        double best = worst_around(point), step_m = 0;
        if (best >= good_) return false;
        for (const std::size_t c : around)
            for (const int p : mesh_.cells[c]) step_m = std::max(step_m, 0.3 * length(minus(at(p), position)));
        constexpr int halvings = 6;
        constexpr std::array<PlanePoint, 8> directions{
            {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0.7, 0.7}, {-0.7, 0.7}, {0.7, -0.7}, {-0.7, -0.7}}};
        bool moved = false;
        for (int k = 0; k < halvings;) {
            const PlanePoint from = position;
            PlanePoint to = from;
            for (const PlanePoint& direction : directions) {
                position = {from[0] + step_m * direction[0], from[1] + step_m * direction[1]};
                if (const double worst = worst_around(point); worst > best) {
                    best = worst;
                    to = position;
                }
            }
            position = to;
            if (to == from) {
                step_m *= 0.5;
                ++k;
            } else {
                moved = true;
            }
        }
        for (const std::size_t c : around) quality_[c] = quality(mesh_.cells[c]);
        return moved;
    }

    /// Nodes of the second-order cell in the order of its type.
    [[nodiscard]] std::vector<PlanePoint> nodes(const std::vector<int>& cell) const {
        std::vector<PlanePoint> positions;
        for (const int p : cell) positions.push_back(at(p));
        PlanePoint centre{};
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const int a = cell[i], b = cell[(i + 1) % cell.size()];
            const auto curved = middles_.find({a, b});
            const PlanePoint middle = curved != middles_.end()
                                          ? curved->second
                                          : PlanePoint{0.5 * (at(a)[0] + at(b)[0]), 0.5 * (at(a)[1] + at(b)[1])};
            positions.push_back(middle);
            for (std::size_t d = 0; d < 2; ++d) centre[d] += 0.5 * middle[d] - 0.25 * at(a)[d];
        }
        if (cell.size() == 4) positions.push_back(centre);
        return positions;
    }

    [[nodiscard]] double quality(const std::vector<int>& cell) const {
        const std::vector<PlanePoint> positions = nodes(cell);
        double min = INFINITY, max = -INFINITY, sine = 1;
        for (const auto& shapes : cell.size() == 4 ? quadrilateral_ : triangle_) {
            PlanePoint along_xi{}, along_eta{};
            for (std::size_t n = 0; n < positions.size(); ++n)
                for (std::size_t d = 0; d < 2; ++d) {
                    along_xi[d] += shapes[n].gradient[0] * positions[n][d];
                    along_eta[d] += shapes[n].gradient[1] * positions[n][d];
                }
            const double determinant = cross(along_xi, along_eta);
            min = std::min(min, determinant);
            max = std::max(max, determinant);
            sine = std::min(sine, determinant / (length(along_xi) * length(along_eta)));
        }
        return max > 0 ? std::min(min / max, sine) : -1;
    }

    Polygons& mesh_;
    std::vector<std::vector<std::size_t>> cells_at_;  ///< cells around each inner point
    Gradients triangle_, quadrilateral_;
    std::map<std::array<int, 2>, PlanePoint> middles_;
    std::vector<double> quality_;
};

}  // namespace

void smooth(Polygons& mesh) { Smoother{mesh}.run(); }

}  // namespace soft::meshing
