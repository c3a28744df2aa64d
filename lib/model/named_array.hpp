#pragma once
/// A field for export. Plain data: the module fields computes it; view and io write it.
#include <string>
#include <vector>

namespace soft::model {

struct NamedArray {
    std::string name;         ///< including the unit: "cauchy_stress_Pa"
    std::string units;        ///< "Pa"; "1": dimensionless
    std::string description;  ///< one sentence
    int components = 1;
    std::vector<double> values;  ///< [point or cell][component]
};

}  // namespace soft::model
