#pragma once
/// Four doubles computed side by side: the arithmetic of the compiler's vector types, on whatever vectors the processor has.
/// Arrays of numbers at many points lie component by component ([component][point]) with rows of padded(points) numbers, so
/// that every load is whole. Tested by core/lanes_test.
#include <cstring>

namespace soft {

inline constexpr int lane_count = 4;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

/// n rounded up to whole lanes.
[[nodiscard]] constexpr int padded(int n) noexcept { return (n + lane_count - 1) / lane_count * lane_count; }

// Not by std::array of them, whose functions would not be compiled for the vectors of a caller's clone.
inline void load(const double* from, Lanes& to) { std::memcpy(&to, from, sizeof to); }
inline void store(const Lanes& from, double* to) { std::memcpy(to, &from, sizeof from); }

// One build runs on every x86-64 processor: a function marked so is compiled for each of these, everything it calls inline,
// and the program takes the widest at its start. Elsewhere it is compiled once.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SOFT_VECTOR_CLONES __attribute__((flatten, target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
// For the code of one level alone, behind a test of the processor (__builtin_cpu_supports("x86-64-v4")).
#define SOFT_WIDE_VECTORS __attribute__((flatten, target("arch=x86-64-v4")))
#else
#define SOFT_VECTOR_CLONES
#endif

}  // namespace soft
