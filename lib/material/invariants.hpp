#pragma once
/// The variables of the energy functions.
#include <array>

namespace soft::material {

/// I1 = tr C, I2 = (tr^2 C - tr C^2)/2. Arguments of an isochoric energy are the invariants of J^-2/3 C. Both are 3 in the reference
/// state.
template <class T>
struct Invariants {
    T I1;
    T I2;
};

/// W_s of a law in principal stretches (StretchLaw) at the logarithms of the isochoric ones.
template <class L, class T>
[[nodiscard]] T energy_of_log_stretches(const L& law, const std::array<T, 3>& x) {
    return law.energy_of_log_stretch(x[0]) + law.energy_of_log_stretch(x[1]) + law.energy_of_log_stretch(x[2]);
}

}  // namespace soft::material
