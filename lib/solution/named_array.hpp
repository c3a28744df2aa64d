#pragma once
/// A field for other programs: plain data that fields makes, and view and io write.
#include <string>
#include <vector>

namespace soft::solution {

struct NamedArray {
    std::string name;         ///< with its unit: "cauchy_stress_Pa"
    std::string units;        ///< "Pa"; "1": a pure number
    std::string description;  ///< one sentence
    int components = 1;
    std::vector<double> values;  ///< [place][component]
};

}  // namespace soft::solution
