#pragma once
/// The variables a law is written in.

namespace soft::material {

/// Isochoric invariants I1bar = J^-2/3 I1, I2bar = J^-4/3 I2 (both 3 in the reference state).
template <class T>
struct Invariants {
    T I1;
    T I2;
};

}  // namespace soft::material
