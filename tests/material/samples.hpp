#pragma once
/// Rubbers and deformations for the tests of the module.
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "examples.hpp"
#include "material/catalogue.hpp"
#include "material/response.hpp"

namespace soft::material::sample {

inline constexpr double mu_Pa = 0.1644e6;
inline constexpr double kappa_Pa = 3.0e6;

/// Constants of the order of mu_Pa with which every term of a law contributes: those of the catalogue, or larger terms.
inline Constants constants_of(std::string_view law) {
    if (law == "mooney-rivlin")
        return {{"c10", {6.4e4}}, {"c01", {1.8e4}}, {"c20", {3e3}}, {"c11", {-2e3}}, {"c02", {1e3}}};
    if (law == "yeoh") return {{"c1", {8.2e4}}, {"c2", {-4e3}}, {"c3", {5e2}}, {"a", {6e4}}, {"b", {0.7}}};
    if (law == "ogden") return {{"mu", {6.3e5, 1.2e3, -1e4, 2e4}}, {"alpha", {1.3, 5.0, -2.0, 0.7}}};
    if (law == "gent") return {{"mu", {mu_Pa}}, {"jm", {12.0}}};
    if (law == "arruda-boyce") return {{"mu", {mu_Pa}}, {"locking_stretch", {2.1}}};
    if (law == "holzapfel-gasser-ogden") return {{"mu", {mu_Pa}}, {"k1", {2e5}}, {"k2", {0.8}}, {"angle", {0.5}}};
    return example_constants(law);
}

inline Description description_of(std::string_view law, std::optional<double> bulk_modulus_Pa = kappa_Pa,
                                  VolumetricLaw volumetric = VolumetricLaw::quadratic) {
    return {.law = law, .constants = constants_of(law), .bulk_modulus_Pa = bulk_modulus_Pa, .volumetric = volumetric};
}

template <class L>
Rubber<L> rubber(VolumetricLaw volumetric = VolumetricLaw::quadratic) {
    const LawInfo law = L::info();
    return std::get<Rubber<L>>(make_rubber(description_of(law.name, kappa_Pa, volumetric)));
}

inline constexpr Fibers two_families{0.5, 2e5, 0.8, 2};

/// A rubber with fibres: those of the law, or the given ones.
template <class L>
requires MayHaveFibers<L> Rubber<L> fibered(VolumetricLaw volumetric = VolumetricLaw::quadratic) {
    const LawInfo law = L::info();
    Description description = description_of(law.name, kappa_Pa, volumetric);
    if (!law.fibers) description.fibers = two_families;
    return std::get<Rubber<L>>(make_rubber(description));
}

inline constexpr std::array<VolumetricLaw, 3> volumetric_laws{VolumetricLaw::quadratic, VolumetricLaw::log,
                                                              VolumetricLaw::mixed};

/// A deformation gradient without symmetry, J = 1.054, that stretches all directions in the plane of the fibres.
inline constexpr Tensor F{1.31, 0.22, -0.17, 0.11, 1.07, 0.26, -0.09, 0.31, 0.92};

/// Rotation about (1, 2, 2)/3, Rodrigues.
inline Tensor rotation(double angle) {
    const double c = std::cos(angle), s = std::sin(angle), t = 1 - c, x = 1.0 / 3, y = 2.0 / 3, z = 2.0 / 3;
    return {t * x * x + c,     t * x * y - s * z, t * x * z + s * y, t * x * y + s * z, t * y * y + c,
            t * y * z - s * x, t * x * z - s * y, t * y * z + s * x, t * z * z + c};
}

inline Tensor transposed(const Tensor& A) { return {A[0], A[3], A[6], A[1], A[4], A[7], A[2], A[5], A[8]}; }

template <class L>
PointResponse displacement(const Rubber<L>& rubber, const Tensor& at, const FiberAxes& axes = {}) {
    PointResponse point;
    displacement_response(rubber, axes, at, Wanted::stress_and_tangent, point);
    return point;
}

template <class L>
PointResponse mixed(const Rubber<L>& rubber, const Tensor& at, double p, const FiberAxes& axes = {}) {
    PointResponse point;
    mixed_response(rubber, axes, at, p, Wanted::stress_and_tangent, point);
    return point;
}

/// The largest entry, used as the scale of errors.
template <std::size_t N>
double size_of(const std::array<double, N>& entries) {
    double size = 0;
    for (const double entry : entries) size = std::max(size, std::abs(entry));
    return size;
}

template <std::size_t N>
double distance(const std::array<double, N>& a, const std::array<double, N>& b) {
    double size = 0;
    for (std::size_t m = 0; m < N; ++m) size = std::max(size, std::abs(a[m] - b[m]));
    return size;
}

template <std::size_t N>
std::array<double, N> difference(const std::array<double, N>& a, const std::array<double, N>& b) {
    std::array<double, N> d;
    for (std::size_t m = 0; m < N; ++m) d[m] = a[m] - b[m];
    return d;
}

/// A : H.
inline Tensor contracted(const Tangent& A, const Tensor& H) {
    Tensor sum{};
    for (std::size_t m = 0; m < 9; ++m)
        for (std::size_t n = 0; n < 9; ++n) sum[m] += A[9 * m + n] * H[n];
    return sum;
}

}  // namespace soft::material::sample
