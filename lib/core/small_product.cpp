#include "core/small_product.hpp"

#include <cstring>

#include "core/lanes.hpp"

namespace soft {
namespace {

constexpr int columns_at_once = 8;
using Vector = double __attribute__((vector_size(columns_at_once * sizeof(double))));

struct Tile {
    int depth;
    const double* a;
    int next_a;
    const double* b;
    int next_b;
    double* c;
    int next_c;
};

/// Rows x 8 entries of C, of which the first `kept` columns are stored. The sums stay in registers: a copy of a part is made
/// entry by entry, because one by memcpy would move all of them to memory.
template <int Rows, bool Whole>
inline void multiply(const Tile& t, int kept) {
    Vector sum[Rows] = {};
    for (int d = 0; d < t.depth; ++d) {
        const double* a = t.a + static_cast<std::ptrdiff_t>(d) * t.next_a;
        Vector b;
        std::memcpy(&b, t.b + static_cast<std::ptrdiff_t>(d) * t.next_b, sizeof b);
        for (int i = 0; i < Rows; ++i) sum[i] += a[i] * b;
    }
    for (int i = 0; i < Rows; ++i) {
        double* c = t.c + static_cast<std::ptrdiff_t>(i) * t.next_c;
        if constexpr (Whole)
            std::memcpy(c, &sum[i], sizeof(Vector));
        else
            for (int j = 0; j < columns_at_once; ++j)
                if (j < kept) c[j] = sum[i][j];
    }
}

/// Tiles of Rows rows, then what remains by the same with fewer.
template <int Rows>
inline void multiply_all(Tile t, int rows, int columns) {
    for (; rows >= Rows; rows -= Rows, t.a += Rows, t.c += static_cast<std::ptrdiff_t>(Rows) * t.next_c) {
        Tile part = t;
        int left = columns;
        for (; left >= columns_at_once; left -= columns_at_once, part.b += columns_at_once, part.c += columns_at_once)
            multiply<Rows, true>(part, columns_at_once);
        if (left > 0) multiply<Rows, false>(part, left);
    }
    if constexpr (Rows > 1) multiply_all<Rows / 2>(t, rows, columns);
}

/// Rows for sixteen registers of four numbers.
SOFT_VECTOR_CLONES
void multiply_narrow(const Tile& t, int rows, int columns) { multiply_all<6>(t, rows, columns); }

#ifdef SOFT_WIDE_VECTORS
/// Rows for thirty-two registers of eight numbers (measured: 6, 14 and 27 rows are slower, and so are two vectors a row).
SOFT_WIDE_VECTORS
void multiply_wide(const Tile& t, int rows, int columns) { multiply_all<9>(t, rows, columns); }
bool has_wide_vectors() { return __builtin_cpu_supports("x86-64-v4") != 0; }
#else
void multiply_wide(const Tile& t, int rows, int columns) { multiply_narrow(t, rows, columns); }
bool has_wide_vectors() { return false; }
#endif

}  // namespace

void transposed_product(int depth, MatrixView A, MatrixView B, double* C, int next) {
    static const bool wide = has_wide_vectors();
    const Tile whole{depth, A.numbers, A.columns, B.numbers, B.columns, C, next};
    (wide ? multiply_wide : multiply_narrow)(whole, A.columns, B.columns);
}

}  // namespace soft
