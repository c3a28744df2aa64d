#include "linalg/front.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "math/lanes.hpp"
#include "math/small_product.hpp"

namespace soft::linalg {

namespace {

/// Columns eliminated at once, rows solved at once, and depth, rows and columns of a product (measured).
constexpr int block = 72, rows_at_once = 192, depth_at_once = 128, tile_size = 144;
/// Columns of a task, which copies its rows once.
constexpr int columns_of_area = 4 * tile_size;
/// Work with fewer flops is not divided among the threads.
constexpr double flops_to_divide = 4e6;

using Stride = std::size_t;

/// a -= factor * b
inline void subtract(double* a, double factor, const double* b, int count) {
    for (int i = 0; i < count; ++i) a[i] -= factor * b[i];
}

/// L D L^T of the leading n columns; column c begins at P + c * stride. False if a pivot is zero or not finite.
SOFT_VECTOR_CLONES
bool factorize_diagonal(double* P, Stride stride, int n, double* D) {
    for (int c = 0; c < n; ++c) {
        double* column = P + static_cast<Stride>(c) * stride;
        const double pivot = column[c];
        if (pivot == 0.0 || !std::isfinite(pivot)) return false;
        D[c] = pivot;
        for (int j = c + 1; j < n; ++j)
            subtract(P + static_cast<Stride>(j) * stride + j, column[j] / pivot, column + j, n - j);
        for (int i = c + 1; i < n; ++i) column[i] /= pivot;
    }
    return true;
}

/// X := X L^-T D^-1 for `count` rows below the leading n columns, L and D of which are known.
SOFT_VECTOR_CLONES
void solve_rows(const double* P, Stride stride, int n, const double* D, double* X, int count) {
    const auto at = [stride](auto* matrix, int column) { return matrix + static_cast<Stride>(column) * stride; };
    for (int c = 0; c < n; ++c) {
        double* x = at(X, c);
        int b = 0;
        for (; b + 4 <= c; b += 4) {  // four at once, because x is read and written each time
            const double *x0 = at(X, b), *x1 = at(X, b + 1), *x2 = at(X, b + 2), *x3 = at(X, b + 3);
            const double l0 = at(P, b)[c], l1 = at(P, b + 1)[c], l2 = at(P, b + 2)[c], l3 = at(P, b + 3)[c];
            for (int i = 0; i < count; ++i) x[i] -= l0 * x0[i] + l1 * x1[i] + l2 * x2[i] + l3 * x3[i];
        }
        for (; b < c; ++b) subtract(x, at(P, b)[c], at(X, b), count);
    }
    for (int c = 0; c < n; ++c) {
        double* x = at(X, c);
        const double inverse = 1.0 / D[c];
        for (int i = 0; i < count; ++i) x[i] *= inverse;
    }
}

/// Solves L y = x in place. Four columns at once, because y is read and written each time.
SOFT_VECTOR_CLONES
void forward_columns(const double* panel, int rows, int columns, double* y) {
    const auto at = [=](int column) { return panel + static_cast<Stride>(column) * static_cast<Stride>(rows); };
    int c = 0;
    for (; c + 4 <= columns; c += 4) {
        const double *p0 = at(c), *p1 = at(c + 1), *p2 = at(c + 2), *p3 = at(c + 3);
        const double y0 = y[c], y1 = y[c + 1] - p0[c + 1] * y0, y2 = y[c + 2] - p0[c + 2] * y0 - p1[c + 2] * y1,
                     y3 = y[c + 3] - p0[c + 3] * y0 - p1[c + 3] * y1 - p2[c + 3] * y2;
        y[c + 1] = y1;
        y[c + 2] = y2;
        y[c + 3] = y3;
        for (int i = c + 4; i < rows; ++i) y[i] -= p0[i] * y0 + p1[i] * y1 + p2[i] * y2 + p3[i] * y3;
    }
    for (; c < columns; ++c) subtract(y + c + 1, y[c], at(c) + c + 1, rows - c - 1);
}

/// Solves L^T x = y in place.
SOFT_VECTOR_CLONES
void backward_columns(const double* panel, int rows, int columns, double* y) {
    const auto at = [=](int column) { return panel + static_cast<Stride>(column) * static_cast<Stride>(rows); };
    int c = columns;
    for (; c % 4 != 0; --c) {
        const double* p = at(c - 1);
        for (int i = c; i < rows; ++i) y[c - 1] -= p[i] * y[i];
    }
    for (c -= 4; c >= 0; c -= 4) {
        const double *p0 = at(c), *p1 = at(c + 1), *p2 = at(c + 2), *p3 = at(c + 3);
        std::array<Lanes, 4> sums{};
        int i = c + 4;
        for (; i + lane_count <= rows; i += lane_count) {
            Lanes x, a0, a1, a2, a3;
            load(y + i, x);
            load(p0 + i, a0);
            load(p1 + i, a1);
            load(p2 + i, a2);
            load(p3 + i, a3);
            sums[0] += a0 * x;
            sums[1] += a1 * x;
            sums[2] += a2 * x;
            sums[3] += a3 * x;
        }
        std::array<double, 4> sum{};
        for (int k = 0; k < lane_count; ++k)
            for (std::size_t v = 0; v < 4; ++v) sum[v] += sums[v][k];
        for (; i < rows; ++i) {
            sum[0] += p0[i] * y[i];
            sum[1] += p1[i] * y[i];
            sum[2] += p2[i] * y[i];
            sum[3] += p3[i] * y[i];
        }
        y[c + 3] -= sum[3];
        y[c + 2] -= sum[2] + p2[c + 3] * y[c + 3];
        y[c + 1] -= sum[1] + p1[c + 2] * y[c + 2] + p1[c + 3] * y[c + 3];
        y[c] -= sum[0] + p0[c + 1] * y[c + 1] + p0[c + 2] * y[c + 2] + p0[c + 3] * y[c + 3];
    }
}

/// Not on the heap, because an exception must not leave a task.
struct WorkSpace {
    std::array<double, std::size_t{depth_at_once} * tile_size> left;
    std::array<double, std::size_t{depth_at_once} * tile_size + gemm_padding> right;
    std::array<double, std::size_t{tile_size} * tile_size> product;
};

}  // namespace

void Front::reset(int rows, int columns, std::vector<double> storage) {
    rows_ = rows;
    columns_ = columns;
    const auto r = static_cast<std::size_t>(rows), c = static_cast<std::size_t>(columns);
    panel_.assign(r * c, 0.0);
    pivots_.assign(c, 0.0);
    update_ = std::move(storage);
    update_.assign((r - c) * (r - c + 1) / 2, 0.0);
}

void Front::add(const Front& child, std::span<const int> places) {
    for (std::size_t j = 0; j < places.size(); ++j) {
        const int c = places[j];
        const double* from =
            child.update_.data() + child.update_column(child.columns_ + static_cast<int>(j)) + child.columns_;
        double* to = c < columns_ ? column(c) : update_.data() + update_column(c);
        for (std::size_t i = j; i < places.size(); ++i) to[places[i]] += from[i];
    }
}

/// Subtracts the part of L D L^T of the first `eliminated` columns from some rows of the columns of an area.
void Front::subtract_product(int eliminated, const Area& area) {
    static thread_local WorkSpace work;
    for (int begin = 0; begin < eliminated; begin += depth_at_once) {
        const int depth = std::min(depth_at_once, eliminated - begin);
        double* right = work.right.data();
        for (int k = begin; k < begin + depth; ++k, right += area.rows)
            std::memcpy(right, column(k) + area.row, sizeof(double) * static_cast<std::size_t>(area.rows));
        for (int first = area.column; first < area.column + area.columns; first += tile_size) {
            const int columns = std::min(tile_size, area.column + area.columns - first);
            double* left = work.left.data();
            for (int k = begin; k < begin + depth; ++k, left += columns) {
                const double* from = column(k) + first;
                const double pivot = pivots_[static_cast<std::size_t>(k)];
                for (int j = 0; j < columns; ++j) left[j] = pivot * from[j];
            }
            transposed_product(depth, {work.left.data(), columns}, {work.right.data(), area.rows}, work.product.data(),
                               area.rows);
            const double* product = work.product.data();
            for (int c = first; c < first + columns; ++c, product += area.rows) {
                const int above = std::max(0, c - area.row);
                double* to = (c < columns_ ? column(c) : update_.data() + update_column(c)) + area.row;
                subtract(to + above, 1.0, product + above, area.rows - above);
            }
        }
    }
}

/// The same for all rows of the columns [first, last).
void Front::subtract_products(int eliminated, int first, int last) {
    if (eliminated == 0) return;
    std::vector<Area> areas;
    for (int row = first; row < rows_; row += tile_size)
        for (int c = first; c < std::min(last, row + tile_size); c += columns_of_area)
            areas.push_back(
                {row, std::min(tile_size, rows_ - row), c, std::min({columns_of_area, last - c, row + tile_size - c})});
    const double flops = 2.0 * eliminated * (last - first) * (rows_ - first);
#pragma omp taskloop if (flops > flops_to_divide) grainsize(1)
    for (std::size_t t = 0; t < areas.size(); ++t) subtract_product(eliminated, areas[t]);
}

bool Front::eliminate_block(int begin, int end) {
    const int columns = end - begin;
    double* P = column(begin) + begin;
    const auto stride = static_cast<Stride>(rows_);
    if (!factorize_diagonal(P, stride, columns, &pivots_[static_cast<std::size_t>(begin)])) return false;
    const double flops = static_cast<double>(rows_ - end) * columns * columns;
    const auto parts = static_cast<std::size_t>((rows_ - end + rows_at_once - 1) / rows_at_once);
#pragma omp taskloop if (flops > flops_to_divide)
    for (std::size_t part = 0; part < parts; ++part) {
        const int row = end + static_cast<int>(part) * rows_at_once;
        solve_rows(P, stride, columns, &pivots_[static_cast<std::size_t>(begin)], column(begin) + row,
                   std::min(rows_at_once, rows_ - row));
    }
    return true;
}

bool Front::eliminate() {
    for (int begin = 0; begin < columns_; begin += block) {
        const int end = std::min(begin + block, columns_);
        subtract_products(begin, begin, end);
        if (!eliminate_block(begin, end)) return false;
    }
    subtract_products(columns_, columns_, rows_);
    return true;
}

int Front::negative_pivots() const {
    return static_cast<int>(std::ranges::count_if(pivots_, [](double pivot) { return pivot < 0.0; }));
}

void Front::forward(std::span<double> x) const {
    forward_columns(panel_.data(), rows_, columns_, x.data());
    for (std::size_t c = 0; c < pivots_.size(); ++c) x[c] /= pivots_[c];
}

void Front::backward(std::span<double> x) const { backward_columns(panel_.data(), rows_, columns_, x.data()); }

}  // namespace soft::linalg
