#pragma once
/// The designs of a sweep, each checked, with an address made of its content. Tested by sweep/plan_test.
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/sweep.hpp"

namespace soft::sweep {

/// What all designs of a sweep are made of.
struct Basis {
    std::string_view design_text;
    std::string_view design_source;  ///< file, for errors and for files the design names
    std::span<const design::FamilyKeys> families;
    std::string_view programs;  ///< versions of the programs that will run it; part of the address
    /// Refuses a geometry, with Error(bad_input); it is a row of the plan, whatever its values.
    std::function<void(const design::Design&)> check_geometry = {};
};

struct Planned {
    /// 16 hex digits: SHA-256 of the effective design (of a mesh file its content, not its name) and of the programs.
    /// Where the design is refused, of the design's text and the settings instead.
    std::string id;
    std::vector<std::string> values;  ///< one a factor, as a design would have them
    std::string design_yaml;          ///< effective; files it names by their whole path; empty where refused
    std::string refusal;              ///< one line; empty where nothing is wrong with it
    bool geometry_refused = false;    ///< by Basis::check_geometry rather than by the keys of the design
};

struct Plan {
    std::vector<Planned> designs;  ///< of a grid the last factor varies fastest; designs may be equal
};

/// Whether it is one of these: 16 hex digits.
[[nodiscard]] bool is_address(std::string_view id) noexcept;

/// A combination of values that is refused is a row with its refusal. The sweep itself is refused, with Error(bad_input) as
/// read_design would: where no design is left, where a listed value is refused in all designs that have it, or an end of a
/// range in the first design that is sound.
[[nodiscard]] Plan make_plan(const Sweep& sweep, const Basis& basis);

/// The values of the factors of each design, before any check.
[[nodiscard]] std::vector<std::vector<std::string>> sampled_values(const Sweep& sweep);

/// "--set mesh.size=3mm --set 'geometry.cap=4 mm'": what gives mesh-gen this design.
[[nodiscard]] std::string settings_text(const Sweep& sweep, const Planned& design);

}  // namespace soft::sweep
