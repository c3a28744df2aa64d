#pragma once
/// Keys of a design, declared once: the table feeds the parser, the errors, --template, --explain and the README.
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace soft::design {

/// What a value is. Quantities carry a unit in the text and are SI once read; a bare number for them is refused.
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
    std::string fallback = {};  ///< default as it would stand in the YAML; empty: the key is required
    std::string meaning = {};   ///< one sentence, no full stop
    double min = -std::numeric_limits<double>::infinity();  ///< SI, inclusive unless min_open
    double max = std::numeric_limits<double>::infinity();
    bool min_open = false;                  ///< the value must be greater than min
    std::vector<std::string> choices = {};  ///< for Kind::choice; for a number, quantity or faces: words
                                            ///< allowed in its place ("incompressible"), read as 0 or none
    int most =
        1;  ///< of a text: 1 is a single line, else several are allowed too; of a number or quantity: 1 is a single value, else one or a list of up to `most`
};

}  // namespace soft::design
