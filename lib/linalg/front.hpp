#pragma once
/// A front of the multifrontal method: a dense symmetric matrix whose leading columns are eliminated, F = L D L^T + update. Products
/// are computed tile by tile with math/small_product.hpp, which several threads may call at once. Internal to the module.
/// Tested by linalg/multifrontal_test.
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace soft::linalg {

class Front {
public:
    /// Sets all entries to zero. `storage` becomes that of the update.
    void reset(int rows, int columns, std::vector<double> storage);
    /// Column c of the eliminated ones; its entries from row c on are used.
    [[nodiscard]] double* column(int c) {
        return panel_.data() + static_cast<std::size_t>(c) * static_cast<std::size_t>(rows_);
    }
    /// Adds the update of another front, whose remaining rows are the rows `places` of this one.
    void add(const Front& child, std::span<const int> places);
    [[nodiscard]] std::vector<double> release_update() { return std::exchange(update_, {}); }
    /// Computes L, D and the update; false if a pivot is zero or not finite. Large fronts create OpenMP tasks.
    [[nodiscard]] bool eliminate();
    [[nodiscard]] int negative_pivots() const;

    /// Solve L D y = x, then L^T x = y, in the entries of the front's rows.
    void forward(std::span<double> x) const;
    void backward(std::span<double> x) const;

private:
    struct Area {
        int row, rows, column, columns;
    };
    /// The remaining columns from their diagonal on, one after the other; entry i of the result is row i of the front.
    [[nodiscard]] std::ptrdiff_t update_column(int c) const {
        const std::ptrdiff_t remaining = rows_ - columns_, k = c - columns_;
        return k * remaining - k * (k + 1) / 2 - columns_;
    }
    void subtract_product(int eliminated, const Area& area);
    void subtract_products(int eliminated, int first, int last);
    [[nodiscard]] bool eliminate_block(int begin, int end);

    int rows_ = 0, columns_ = 0;
    std::vector<double> panel_;   // [column][row]
    std::vector<double> pivots_;  // D
    std::vector<double> update_;
};

}  // namespace soft::linalg
