#include "contact/block.hpp"

namespace soft::contact {

void add_function(Block& block, std::span<const double> weights, const Vector3& g, const std::array<Vector3, 3>& H) {
    const std::size_t n = block.points(), size = n * block.dimension;
    for (std::size_t i = 0; i < block.dimension; ++i)
        for (std::size_t a = 0; a < n; ++a) block.gradient[i * n + a] += g[i] * weights[a];
    if (block.hessian.empty()) return;
    for (std::size_t i = 0; i < block.dimension; ++i)
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t j = 0; j < block.dimension; ++j) {
                const double factor = H[i][j] * weights[a];
                if (factor == 0) continue;
                double* row = &block.hessian[(i * n + a) * size + j * n];
                for (std::size_t b = 0; b < n; ++b) row[b] += factor * weights[b];
            }
}

void add_sliding(Block& block, std::span<const double> weights, const FacetJet& y, const ClosestPoint& closest,
                 const Vector3& r, std::span<const mesh::ShapeValue> dN, double factor) {
    const auto count = static_cast<std::size_t>(closest.free);
    if (count == 0) return;
    const std::size_t n = block.points(), size = n * block.dimension, first = n - dN.size();
    std::array<std::vector<double>, 2> v;
    std::array<std::array<double, 2>, 2> h{};
    for (std::size_t a = 0; a < count; ++a) {
        const auto& along_a = closest.directions[a];
        Vector3 t{};
        for (std::size_t d = 0; d < 3; ++d) t[d] = along_a[0] * y.first[0][d] + along_a[1] * y.first[1][d];
        v[a].assign(size, 0);
        for (std::size_t i = 0; i < block.dimension; ++i)
            for (std::size_t c = 0; c < n; ++c) {
                v[a][i * n + c] = -weights[c] * t[i];
                if (c < first) continue;
                const auto& slope = dN[c - first].gradient;
                v[a][i * n + c] -= (along_a[0] * slope[0] + along_a[1] * slope[1]) * r[i];
            }
        for (std::size_t b = 0; b < count; ++b) {
            const auto& along_b = closest.directions[b];
            for (std::size_t i = 0; i < 2; ++i)
                for (std::size_t j = 0; j < 2; ++j)
                    h[a][b] += along_a[i] * along_b[j] * (dot(y.first[i], y.first[j]) - dot(y.second[i][j], r));
        }
    }
    const double det = count == 1 ? h[0][0] : h[0][0] * h[1][1] - h[0][1] * h[1][0];
    if (det == 0) return;
    const std::array<std::array<double, 2>, 2> inverse =
        count == 1
            ? std::array<std::array<double, 2>, 2>{{{1 / det, 0}, {0, 0}}}
            : std::array<std::array<double, 2>, 2>{{{h[1][1] / det, -h[0][1] / det}, {-h[1][0] / det, h[0][0] / det}}};
    for (std::size_t p = 0; p < size; ++p)
        for (std::size_t a = 0; a < count; ++a) {
            double left = 0;
            for (std::size_t b = 0; b < count; ++b) left += inverse[a][b] * v[b][p];
            left *= -factor;
            if (left == 0) continue;
            for (std::size_t q = 0; q < size; ++q) block.hessian[p * size + q] += left * v[a][q];
        }
}

}  // namespace soft::contact
