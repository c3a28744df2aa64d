#pragma once
/// Second-order forward automatic differentiation in N variables: value, gradient and Hessian in one pass.
/// f(x + d) = v + g.d + 1/2 d.H d. The kernels use N = 3 (I1, I2, J); the tests use N = 9 (components of F) as a reference.
/// Tested by math/dual_test (against closed-form derivatives).
#include <array>
#include <cmath>

namespace soft {

template <int N>
struct Dual {
    static constexpr int hessian_size = N * (N + 1) / 2;

    double v = 0;
    std::array<double, N> g{};
    std::array<double, hessian_size> h{};  // packed upper triangle, row by row

    Dual() = default;
    Dual(double value) : v(value) {}  // NOLINT(google-explicit-constructor): constants mix freely with variables
    [[nodiscard]] static Dual variable(double value, int index) {
        Dual x{value};
        x.g[index] = 1.0;
        return x;
    }
    [[nodiscard]] static constexpr int packed(int i, int j) {
        if (i > j) return packed(j, i);
        return i * N - i * (i - 1) / 2 + (j - i);
    }
    [[nodiscard]] double hessian(int i, int j) const { return h[packed(i, j)]; }

    Dual& operator+=(const Dual& b) { return *this = *this + b; }
    Dual& operator-=(const Dual& b) { return *this = *this - b; }
    Dual& operator*=(const Dual& b) { return *this = *this * b; }

    friend Dual operator+(Dual a, const Dual& b) {
        a.v += b.v;
        for (int i = 0; i < N; ++i) a.g[i] += b.g[i];
        for (int i = 0; i < hessian_size; ++i) a.h[i] += b.h[i];
        return a;
    }
    friend Dual operator-(const Dual& a) {
        Dual r;
        r.v = -a.v;
        for (int i = 0; i < N; ++i) r.g[i] = -a.g[i];
        for (int i = 0; i < hessian_size; ++i) r.h[i] = -a.h[i];
        return r;
    }
    friend Dual operator-(const Dual& a, const Dual& b) { return a + (-b); }
    friend Dual operator*(const Dual& a, const Dual& b) {
        Dual r;
        r.v = a.v * b.v;
        for (int i = 0; i < N; ++i) r.g[i] = a.v * b.g[i] + b.v * a.g[i];
        for (int i = 0, k = 0; i < N; ++i)
            for (int j = i; j < N; ++j, ++k) r.h[k] = a.v * b.h[k] + b.v * a.h[k] + a.g[i] * b.g[j] + a.g[j] * b.g[i];
        return r;
    }
    friend Dual operator/(const Dual& a, const Dual& b) {
        const double inverse = 1.0 / b.v;
        return a * compose(b, inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse);
    }
    friend bool operator<(const Dual& a, double b) { return a.v < b; }
    friend bool operator>(const Dual& a, double b) { return a.v > b; }

    /// Chain rule: f(a) from f, f' and f'' at a.v.
    [[nodiscard]] static Dual compose(const Dual& a, double f, double f1, double f2) {
        Dual r;
        r.v = f;
        for (int i = 0; i < N; ++i) r.g[i] = f1 * a.g[i];
        for (int i = 0, k = 0; i < N; ++i)
            for (int j = i; j < N; ++j, ++k) r.h[k] = f1 * a.h[k] + f2 * a.g[i] * a.g[j];
        return r;
    }
    friend Dual log(const Dual& a) { return compose(a, std::log(a.v), 1.0 / a.v, -1.0 / (a.v * a.v)); }
    friend Dual log1p(const Dual& a) {
        const double d = 1.0 / (1.0 + a.v);
        return compose(a, std::log1p(a.v), d, -d * d);
    }
    friend Dual exp(const Dual& a) {
        const double e = std::exp(a.v);
        return compose(a, e, e, e);
    }
    friend Dual expm1(const Dual& a) {
        const double e = std::exp(a.v);
        return compose(a, std::expm1(a.v), e, e);
    }
    friend Dual sqrt(const Dual& a) {
        const double s = std::sqrt(a.v);
        return compose(a, s, 0.5 / s, -0.25 / (s * a.v));
    }
    friend Dual pow(const Dual& a, double n) {
        const double f2 = std::pow(a.v, n - 2.0);
        return compose(a, f2 * a.v * a.v, n * f2 * a.v, n * (n - 1.0) * f2);
    }
};

}  // namespace soft
