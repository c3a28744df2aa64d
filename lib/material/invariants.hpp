#pragma once
/// The variables of the energy functions.
#include <array>
#include <cmath>

namespace soft::material {

/// I1 = tr C, I2 = (tr^2 C - tr C^2)/2. Arguments of an isochoric energy are the invariants of J^-2/3 C. Both are 3 in the reference
/// state.
template <class T>
struct Invariants {
    T I1;
    T I2;
};

/// Principal stretches divided by J^1/3, in arbitrary order; their product is 1.
template <class T>
using IsochoricStretches = std::array<T, 3>;

/// W_s of a law in principal stretches (StretchLaw).
template <class L, class T>
[[nodiscard]] T isochoric_energy_of_stretches(const L& law, const IsochoricStretches<T>& stretch) {
    using std::log;
    T sum = 0.0;
    for (const T& l : stretch) sum += law.energy_of_log_stretch(log(l));
    return sum;
}

}  // namespace soft::material
