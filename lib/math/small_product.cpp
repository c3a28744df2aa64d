#include "math/small_product.hpp"

#include <cstring>

#include "math/lanes.hpp"

namespace soft {
namespace {

constexpr int columns_at_once = 8;
static_assert(columns_at_once - 1 == gemm_padding);

/// Vectors of the width of the processor's registers. Wider vectors are split through memory, which is six times slower on AVX2.
struct FourNumbers {
    using Type = double __attribute__((vector_size(4 * sizeof(double))));
};
struct EightNumbers {
    using Type = double __attribute__((vector_size(8 * sizeof(double))));
};

struct Tile {
    int depth;
    const double* a;
    int next_a;
    const double* b;
    int next_b;
    double* c;
    int next_c;
};

/// Computes Rows x 8 entries of C and stores the first `kept` columns. The sums stay in registers only if each loop over them is a
/// single unrolled loop and a partial copy is made entry by entry; otherwise the compiler spills all of them to memory at each d.
template <int Rows, class Register, bool Whole>
inline void multiply(const Tile& t, int kept) {
    using Numbers = typename Register::Type;
    constexpr int width = sizeof(Numbers) / sizeof(double), vectors = columns_at_once / width;
    Numbers sum[Rows * vectors] = {};
    for (int d = 0; d < t.depth; ++d) {
        const double* a = t.a + static_cast<std::ptrdiff_t>(d) * t.next_a;
        const double* numbers = t.b + static_cast<std::ptrdiff_t>(d) * t.next_b;
        Numbers b[vectors];
#pragma GCC unroll 2
        for (int v = 0; v < vectors; ++v) std::memcpy(&b[v], numbers + v * width, sizeof(Numbers));
#pragma GCC unroll 18
        for (int k = 0; k < Rows * vectors; ++k) sum[k] += a[k / vectors] * b[k % vectors];
    }
#pragma GCC unroll 18
    for (int k = 0; k < Rows * vectors; ++k) {
        double* c = t.c + static_cast<std::ptrdiff_t>(k / vectors) * t.next_c + k % vectors * width;
        if constexpr (Whole) {
            std::memcpy(c, &sum[k], sizeof(Numbers));
        } else {
#pragma GCC unroll 8
            for (int j = 0; j < width; ++j)
                if (k % vectors * width + j < kept) c[j] = sum[k][j];
        }
    }
}

/// Processes tiles of Rows rows, then the remaining rows with smaller tiles.
template <int Rows, class Register>
inline void multiply_all(Tile t, int rows, int columns) {
    for (; rows >= Rows; rows -= Rows, t.a += Rows, t.c += static_cast<std::ptrdiff_t>(Rows) * t.next_c) {
        Tile part = t;
        int left = columns;
        for (; left >= columns_at_once; left -= columns_at_once, part.b += columns_at_once, part.c += columns_at_once)
            multiply<Rows, Register, true>(part, columns_at_once);
        if (left > 0) multiply<Rows, Register, false>(part, left);
    }
    if constexpr (Rows > 1) multiply_all<Rows / 2, Register>(t, rows, columns);
}

/// Six rows per tile, for sixteen registers of four numbers.
SOFT_VECTOR_CLONES
void multiply_narrow(const Tile& t, int rows, int columns) { multiply_all<6, FourNumbers>(t, rows, columns); }

#ifdef SOFT_WIDE_VECTORS
/// Nine rows per tile, for thirty-two registers of eight numbers (measured: 6, 14 and 27 rows and two vectors per row are slower).
SOFT_WIDE_VECTORS
void multiply_wide(const Tile& t, int rows, int columns) { multiply_all<9, EightNumbers>(t, rows, columns); }
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
