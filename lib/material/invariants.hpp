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

/// Principal stretches divided by J^1/3, in arbitrary order; their product is 1.
template <class T>
using IsochoricStretches = std::array<T, 3>;

}  // namespace soft::material
