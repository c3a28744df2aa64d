#pragma once
/// A sweep, read from YAML: a design, the keys that vary, and their values. Tested by sweep/read_test.
///
///     design: tube.yaml                    # relative to this file
///     method: latin-hypercube              # grid | random | latin-hypercube
///     samples: 1000                        # not for a grid
///     seed: 1
///     vary:
///       geometry.cap: {from: 4 mm, to: 8 mm}                  # in a grid also steps: 5; scale: linear | log | whole
///       material.mu: [60 kPa, 164.4 kPa]
///     set: {mesh.size: 3 mm}               # the same in all designs
///     at: [elongation=5mm,10mm, limit, end]
///     outputs: [pressure_kPa, volume_mL]   # columns of the curve; default all
///     sensitivity: [geometry.wall]         # numbers of the design by which the outputs are differentiated; or all
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "design/design.hpp"

namespace soft::sweep {

/// A word or value as written in the file, and its location.
struct SourceText {
    std::string text;
    std::string location;  ///< "sweeps/tube.yaml:7:9"
};

/// Spacing of the values in a range: uniform, uniform in the logarithm, or whole numbers.
enum class Scale { linear, log, whole };

/// A closed range; both ends have the same unit.
struct Range {
    SourceText from, to;
    double low = 0, high = 0;  ///< the ends as numbers in `unit`, low < high
    std::string unit;          ///< as written, "mm"; empty for pure numbers
    int steps = 0;             ///< number of grid levels, at least 2; 0 for other methods
    Scale scale = Scale::linear;
};
using Choices = std::vector<SourceText>;  ///< at least one

struct Factor {
    std::string path;      ///< "geometry.cap"
    std::string location;  ///< of the key
    std::variant<Range, Choices> values;
};

enum class Method { grid, random, latin_hypercube };

struct Sweep {
    std::string source;           ///< file name, for errors
    SourceText design;            ///< file name as written
    std::vector<Factor> factors;  ///< at least one, in the order of the file
    Method method = Method::grid;
    int samples = 0;  ///< 0 for a grid
    std::uint64_t seed = 1;
    std::vector<design::Override> fixed;  ///< `set`, with locations
    std::vector<SourceText> at;           ///< one point each: "elongation=5mm", "limit", "end"; default "end"
    std::vector<SourceText> outputs;      ///< empty: all columns
    std::vector<SourceText> sensitivity;  ///< keys of numbers of the design, or "all"; empty: no derivatives
};

/// Maximum number of designs; the plan is kept in memory.
inline constexpr int max_designs = 100000;

/// Reads a sweep. Errors (bad_input, "file:line:column: key: problem; remedy"): invalid YAML, unknown keys (with the nearest known
/// key), missing keys, keys that the method does not use, range ends with missing or different units. make_plan checks whether the
/// design has the keys that vary and whether their values are valid.
[[nodiscard]] Sweep read_sweep(std::string_view text, std::string_view source);

/// The value at the fraction u in [0, 1) of a range or list: "2.5 mm". Numbers of a range have at most nine digits, so that machines
/// whose logarithms differ in the last bit write the same text; the ends are written as in the file.
[[nodiscard]] std::string value_at(const Factor& factor, double u);

/// Number of values of a factor in a grid, and the text of the k-th value.
[[nodiscard]] int level_count(const Factor& factor);
[[nodiscard]] std::string level(const Factor& factor, int k);

}  // namespace soft::sweep
