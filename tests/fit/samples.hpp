#pragma once
/// Test data of this folder, and synthetic tests with known constants.
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "fit/fit.hpp"

namespace soft::fit {

inline std::string text_of(const std::string& file) {
    std::ifstream in(std::string{SOFT_SOURCE_DIR} + "/tests/fit/data/" + file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

inline TestCurve sample(const std::string& file, Mode mode = Mode::uniaxial, const ReadSettings& settings = {}) {
    return read_test(text_of(file), file, mode, settings);
}

inline std::vector<TestCurve> treloar() {
    return {sample("treloar-uniaxial.csv", Mode::uniaxial), sample("treloar-equibiaxial.csv", Mode::equibiaxial),
            sample("treloar-planar.csv", Mode::planar)};
}

/// Exact stresses of a law at evenly spaced stretches.
inline TestCurve synthetic_test(const material::AnyRubber& rubber, Mode mode, double longest, int rows = 40) {
    TestCurve test{.mode = mode, .source = "synthetic"};
    for (int i = 1; i <= rows; ++i) {
        test.stretch.push_back(1.0 + (longest - 1.0) * i / rows);
        test.nominal_Pa.push_back(
            material::nominal_stress_Pa(*material::homogeneous_state(rubber, mode, test.stretch.back()), mode));
    }
    return test;
}

inline const Candidate& law(std::string_view name) { return *find_candidate(name); }

}  // namespace soft::fit
