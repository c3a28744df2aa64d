#pragma once
/// A sweep: one design, which of its keys vary and how, read from YAML. Tested by sweep/read_test.
///
///     design: tube.yaml                    # from this file's folder
///     method: latin-hypercube              # grid | random | latin-hypercube
///     samples: 1000                        # not of a grid
///     seed: 1
///     vary:
///       geometry.cap: {from: 4 mm, to: 8 mm}                  # in a grid also steps: 5; scale: linear | log | whole
///       material.mu: [60 kPa, 164.4 kPa]
///     set: {mesh.size: 3 mm}               # the same in all designs
///     at: [elongation=5mm,10mm, limit, end]
///     outputs: [pressure_kPa, volume_mL]   # columns of the curve; default all
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "design/design.hpp"

namespace soft::sweep {

/// A word or value as it stands in the file, and where.
struct Written {
    std::string text;
    std::string place;  ///< "sweeps/tube.yaml:7:9"
};

/// How the numbers of a range are spread: evenly, their logarithms evenly, or whole numbers.
enum class Scale { linear, log, whole };

/// Both ends belong to it and have the same unit.
struct Range {
    Written from, to;
    double low = 0, high = 0;  ///< the ends as numbers in `unit`, low <= high
    std::string unit;          ///< as written, "mm"; empty of pure numbers
    int steps = 0;             ///< of a grid, at least 2; else 0
    Scale scale = Scale::linear;
};
using Choices = std::vector<Written>;  ///< at least one

struct Factor {
    std::string path;   ///< "geometry.cap"
    std::string place;  ///< of the key
    std::variant<Range, Choices> values;
};

enum class Method { grid, random, latin_hypercube };

struct Sweep {
    std::string source;           ///< the file, for errors
    Written design;               ///< file as written
    std::vector<Factor> factors;  ///< at least one, in the order of the file
    Method method = Method::grid;
    int samples = 0;  ///< 0 of a grid
    std::uint64_t seed = 1;
    std::vector<design::Override> fixed;  ///< `set`, with places
    std::vector<Written> at;       ///< one value each: "elongation=5mm", "limit", "end"; "end" where none is given
    std::vector<Written> outputs;  ///< empty: all columns
};

/// More are refused: the plan is kept in memory.
inline constexpr int max_designs = 100000;

/// Errors (bad_input, "file:line:column: key: problem; remedy"): no YAML, unknown keys with the nearest known one, what is
/// missing, what the method does not have, ends without or with different units. Whether a design has the keys that vary,
/// and what they may be, make_plan says.
[[nodiscard]] Sweep read_sweep(std::string_view text, std::string_view source);

/// The value at the share u of a range or list, u in [0, 1): "2.5 mm". Numbers of a range have nine digits at most, so that
/// machines whose logarithms differ in the last bit write the same; its ends are written as they stand.
[[nodiscard]] std::string value_at(const Factor& factor, double u);

/// How many values a factor has in a grid, and the text of the k-th.
[[nodiscard]] int level_count(const Factor& factor);
[[nodiscard]] std::string level(const Factor& factor, int k);

}  // namespace soft::sweep
