#pragma once
/// A goal of the inverse design: which numbers of a design may vary, which values its curve must have, and what is to be smallest.
///
///     design: bellows.yaml                     # from the folder of this file
///     set: {mesh.size: 2 mm}                   # the same in all trials
///     vary: {geometry.wall: {from: 1.5 mm, to: 4 mm}, geometry.convolutions: {from: 6, to: 14}}
///     targets:
///       - {elongation: 60 mm, at: {pressure: 20 kPa}, within: 1 %}     # within: 0.5 % if it is omitted
///       - {limit: {pressure: 45 kPa}}                                  # the first limit point
///       - {curve: measured.csv, at: elongation, within: 2 %}           # every row; the load where the elongation is as measured
///       - {curve: tip.csv, design: beam.yaml, set: {loads.tip.force: 1 N}}   # of another design, or of this one with other loads
///     minimize: rubber_volume                  # rubber_volume | cavity_volume | nothing | {stretch_p99: {at: {pressure: 20 kPa}}}
///     constraints:
///       - {stretch_p99: {below: 2}, at: {pressure: 20 kPa}}
///       - {geometry.bore_radius + 2 * geometry.wall: {above: 6 mm, below: 9 mm}}
///       - {limit: {pressure: {above: 40 kPa}}}
///       - {stable: true}
/// With a `prior` ({from: 50 kPa, to: 200 kPa, prior: 84 kPa, sd: 5 kPa}) a variable is a measured value too.
/// Tested by optimize/goal_test.
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "design/design.hpp"

namespace soft::optimize {

struct Variable {
    std::string key;
    double from = 0, to = 0;  ///< SI
    bool is_whole = false;
    std::string unit;  ///< as written; empty for a pure number
    double SI_per_unit = 1;

    [[nodiscard]] double range() const { return to - from; }
    /// "2.5 mm", as in a design.
    [[nodiscard]] std::string text_of(double value_SI) const;
};

/// A number that follows from a trial.
struct Measure {
    /// keys: a sum of numbers of the design.
    enum class Kind { curve, limit, rubber_volume, cavity_volume, keys };
    struct Term {
        double factor = 1;
        std::string key;
    };
    Kind kind = Kind::curve;
    std::size_t run = 0;        ///< index of the path
    std::string quantity = {};  ///< curve: a column without its unit
    std::string at = {};        ///< curve: the quantity whose value is given
    double at_SI = 0;
    std::string at_text = {};      ///< "20 kPa"
    std::vector<Term> terms = {};  ///< keys: sum of factor x number of the design
    std::string text = {};         ///< for messages: "elongation at pressure 20 kPa"
};

struct Condition {
    enum class Relation { equal, below, above };
    Measure measure;
    Relation relation = Relation::equal;
    double value_SI = 0;
    std::string value_text = {}, unit = {};  ///< "60 mm", "mm"
    double SI_per_unit = 1;
    double scale_SI = 1;  ///< differences are relative to this
    double within = 0;    ///< equal: allowed relative difference; of data its standard deviation
    /// A measured value, to be approached, not met: a prior, or a row of a curve, with its index and the line in the file.
    bool is_data = false;
    std::optional<std::size_t> curve = {};
    std::size_t line = 0;

    [[nodiscard]] double allowed_SI() const { return within * scale_SI; }
};

/// A path that each trial solves: a design with changes.
struct Run {
    std::string design_file;  ///< as written
    std::string location;     ///< of design_file
    std::vector<design::Override> set;
    std::vector<std::size_t> variables = {};  ///< those that the design has, by index; set by start_of
};

/// A target that is a measured curve. add_data (data.hpp) makes a condition of each of its rows.
struct MeasuredCurve {
    std::size_t run = 0;
    std::string file, location;  ///< as written
    std::string columns;         ///< as `postprocess --columns`
    std::string at;        ///< the quantity at whose measured values the others are compared; empty: chosen by add_data
    std::string from, to;  ///< as written: rows with `at` outside are left out; empty: none
    double within = 0;     ///< standard deviation of a row over the largest value of its column
    std::size_t left_out = 0;  ///< rows, by add_data
};

struct Goal {
    std::vector<Run> runs;  ///< the first is that of the design to be found
    std::vector<Variable> variables;
    std::vector<Condition> conditions;
    std::vector<MeasuredCurve> curves;
    std::optional<Measure> minimize;  ///< nullopt: nothing, then the differences from the targets
    bool stable = false;              ///< the states up to the last value of a target must be stable

    /// Whether there are measured values to be approached.
    [[nodiscard]] bool has_data() const {
        return !curves.empty() || std::ranges::any_of(conditions, &Condition::is_data);
    }
};

/// Throws Error (bad_input) with file, line, problem and remedy. Whole numbers are found by start_of.
[[nodiscard]] Goal read_goal(std::string_view text, std::string_view source);

/// The values of the variables, SI, in the first design that has them; `designs`: one for each run. Sets Variable::is_whole for the keys of
/// counts, and Run::variables. Throws Error (bad_input) for a variable that is not a number of any design, and for a count whose range
/// does not end at whole numbers.
[[nodiscard]] std::vector<double> start_of(Goal& goal, std::span<const design::Design> designs);

}  // namespace soft::optimize
