#pragma once
/// Measures the peak rate [Flop/s] of double-precision multiply-adds on one core: independent chains on the widest vectors of the
/// processor, without loads or stores. A multiply-add counts as two flops.
#include <ctime>

namespace soft::benchmarks {

namespace detail {

/// Enough chains to hide the latency of two units (4 cycles each), few enough for 16 registers.
inline constexpr int chain_count = 10;

template <int Width>
struct VectorOf {
    typedef double Type __attribute__((
        vector_size(Width * sizeof(double))));  // with `using` GCC drops the attribute of a dependent size
};

template <int Width>
[[nodiscard]] inline double multiply_adds(long rounds) {
    using Lanes = typename VectorOf<Width>::Type;
    const Lanes factor = Lanes{} + 0.999999, term = Lanes{} + 1e-6;  // converges to 1: neither overflow nor denormals
    Lanes chain[chain_count];
    for (int c = 0; c < chain_count; ++c) chain[c] = Lanes{} + 1.0 + 0.01 * c;
    for (long round = 0; round < rounds; ++round)
#pragma GCC unroll 10
        for (int c = 0; c < chain_count; ++c) chain[c] = chain[c] * factor + term;
    double sum = 0;
    for (const Lanes& value : chain)
        for (int lane = 0; lane < Width; ++lane) sum += value[lane];
    return sum;
}

#if defined(__x86_64__)
[[gnu::target("arch=x86-64-v4"), gnu::flatten]] inline double rounds_of_8(long rounds) {
    return multiply_adds<8>(rounds);
}
[[gnu::target("arch=x86-64-v3"), gnu::flatten]] inline double rounds_of_4(long rounds) {
    return multiply_adds<4>(rounds);
}
#endif
[[gnu::flatten]] inline double rounds_of_2(long rounds) { return multiply_adds<2>(rounds); }

struct WidestVector {
    int width;  // doubles
    double (*run)(long rounds);
};

[[nodiscard]] inline WidestVector widest_vector() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) return {8, rounds_of_8};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return {4, rounds_of_4};
#endif
    return {2, rounds_of_2};
}

[[nodiscard]] inline double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace detail

struct Peak {
    double flops_per_s = 0;
    int vector_width = 0;  ///< doubles
};

/// The best of several short runs, as the least disturbed one.
[[nodiscard]] inline Peak measure_peak() {
    constexpr int tries = 20;
    constexpr long rounds = 1'000'000;
    const detail::WidestVector widest = detail::widest_vector();
    Peak peak{0, widest.width};
    volatile double sink = 0;
    for (int i = 0; i < tries; ++i) {
        const double start = detail::cpu_seconds();
        sink = sink + widest.run(rounds);
        const double rate = 2.0 * widest.width * detail::chain_count * rounds / (detail::cpu_seconds() - start);
        if (rate > peak.flops_per_s) peak.flops_per_s = rate;
    }
    return peak;
}

}  // namespace soft::benchmarks
