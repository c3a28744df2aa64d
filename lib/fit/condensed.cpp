#include "fit/separable.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soft::fit {
namespace {

constexpr int nodes = 56;

struct Piece {  // one test
    std::vector<std::size_t> rows;
    Mode mode = Mode::uniaxial;
    double middle = 0, half = 0;  // of ln l
};

std::vector<Piece> pieces_of(const Rows& rows) {
    std::vector<Piece> pieces(rows.test_count);
    for (std::size_t i = 0; i < rows.stretch.size(); ++i) {
        pieces[rows.test[i]].rows.push_back(i);
        pieces[rows.test[i]].mode = rows.mode[i];
    }
    for (Piece& piece : pieces) {
        const auto ends = std::minmax_element(piece.rows.begin(), piece.rows.end(), [&](std::size_t a, std::size_t b) {
            return rows.stretch[a] < rows.stretch[b];
        });
        const double low = std::log(rows.stretch[*ends.first]), high = std::log(rows.stretch[*ends.second]);
        piece.middle = 0.5 * (low + high);
        piece.half = 0.5 * (high - low);
    }
    return pieces;
}

double node(int k) { return std::cos(std::numbers::pi * k / (nodes - 1)); }

/// Weights of the nodal values at t in [-1, 1], by the barycentric formula for Chebyshev points of the second kind.
void interpolate(double t, Eigen::Ref<Eigen::RowVectorXd> weight) {
    double sum = 0;
    for (int k = 0; k < nodes; ++k) {
        const double distance = t - node(k);
        if (distance == 0.0) {
            weight.setZero();
            weight[k] = 1.0;
            return;
        }
        const double end = k == 0 || k == nodes - 1 ? 0.5 : 1.0;
        weight[k] = (k % 2 == 0 ? end : -end) / distance;
        sum += weight[k];
    }
    weight /= sum;
}

}  // namespace

Rows condensed(const Rows& rows) {
    const std::vector<Piece> pieces = pieces_of(rows);
    const auto width = static_cast<Eigen::Index>(nodes * pieces.size());
    const bool flat = std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.half <= 0.0; });
    if (2 * width > rows.target.size() || flat) return rows;
    Eigen::MatrixXd both = Eigen::MatrixXd::Zero(rows.target.size(), width + 1);
    Rows fewer = rows;
    fewer.mode.clear(), fewer.stretch.clear(), fewer.test.clear();
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const Piece& piece = pieces[p];
        Eigen::RowVectorXd weight(nodes);
        for (const std::size_t row : piece.rows) {
            const auto at = static_cast<Eigen::Index>(row);
            interpolate(std::clamp((std::log(rows.stretch[row]) - piece.middle) / piece.half, -1.0, 1.0), weight);
            both.row(at).segment(static_cast<Eigen::Index>(p) * nodes, nodes) = rows.weight[at] * weight;
        }
        for (int k = 0; k < nodes; ++k) {
            fewer.mode.push_back(piece.mode);
            fewer.stretch.push_back(std::exp(piece.middle + piece.half * node(k)));
            fewer.test.push_back(p);
        }
    }
    both.col(width) = rows.target;
    const Eigen::MatrixXd R = both.householderQr().matrixQR().topRows(width).triangularView<Eigen::Upper>();
    fewer.mix = R.leftCols(width);
    fewer.target = R.col(width);
    fewer.weight = Eigen::VectorXd::Ones(width);
    return fewer;
}

}  // namespace soft::fit
