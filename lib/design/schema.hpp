#pragma once
/// Declaration of the keys of a design, used by the parser, the errors, --template, --explain and docs/reference/keys.md.
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace soft::design {

/// Kind of a value. Quantities are written with a unit and stored in SI; a number without a unit is rejected.
enum class Kind {
    length,
    area,
    volume,
    pressure,
    angle,
    density,
    mass,
    acceleration,
    time,
    rate,
    flow_resistance,
    force,
    moment,
    curvature,
    ratio,
    count,
    flag,
    text,
    choice,
    faces,
    list
};

struct Key {
    std::string path;  ///< "geometry.wall"
    Kind kind = Kind::length;
    std::string fallback = {};                              ///< default as written in YAML; empty: the key is required
    std::string meaning = {};                               ///< one sentence, no full stop
    double min = -std::numeric_limits<double>::infinity();  ///< SI, inclusive unless min_open
    double max = std::numeric_limits<double>::infinity();
    bool min_open = false;                  ///< the value must be greater than min
    std::vector<std::string> choices = {};  ///< for Kind::choice; for a number, quantity or faces: words
                                            ///< allowed instead ("incompressible"), stored as 0 or as no face
    int max_count =
        1;  ///< text: 1 allows a single line only; number or quantity: maximum length of a list, 1 allows a single value only
};

/// Allowed numbers, SI.
struct Range {
    double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
    bool min_open = false;
};
constexpr Range above(double min) { return {.min = min, .min_open = true}; }
constexpr Range at_least(double min) { return {.min = min}; }
inline constexpr Range share{0, 1, true};

/// The key of a number, quantity, text or faces, without a default.
[[nodiscard]] Key value_key(std::string path, Kind kind, Range range, std::string meaning);
/// The key of a choice; `fallback` may be empty.
[[nodiscard]] Key choice_key(std::string path, std::string fallback, std::vector<std::string> choices,
                             std::string meaning);
[[nodiscard]] Key with_default(std::string fallback, Key key);
/// Allows `word` in place of a value and makes it the default.
[[nodiscard]] Key or_word(std::string word, Key key);

}  // namespace soft::design
