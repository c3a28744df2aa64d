#pragma once
/// SIMD arithmetic on four doubles, with the compiler's vector types; the compiler maps them to the vector registers of the
/// processor. Arrays of values at many points are stored component by component ([component][point]); each row has padded(points)
/// entries, so that every load reads a full vector. Tested by math/lanes_test.
#include <cstring>

namespace soft {

inline constexpr int lane_count = 4;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

/// n rounded up to a multiple of lane_count.
[[nodiscard]] constexpr int padded(int n) noexcept { return (n + lane_count - 1) / lane_count * lane_count; }

// Free functions instead of std::array members: those would not be compiled for the vector width of a caller's clone.
inline void load(const double* from, Lanes& to) { std::memcpy(&to, from, sizeof to); }
inline void store(const Lanes& from, double* to) { std::memcpy(to, &from, sizeof from); }

// One build runs on every x86-64 processor: a function with this attribute is compiled once per listed level, with all callees
// inlined, and the widest supported clone is chosen at program start. On other targets it is compiled once.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SOFT_VECTOR_CLONES __attribute__((flatten, target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
// For code of a single level; the caller must check the processor first (__builtin_cpu_supports("x86-64-v4")).
#define SOFT_WIDE_VECTORS __attribute__((flatten, target("arch=x86-64-v4")))
#else
#define SOFT_VECTOR_CLONES
#endif

}  // namespace soft
