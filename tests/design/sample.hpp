#pragma once
/// Sample families for the tests of this module; the families of the product are in lib/geometry.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "design/design.hpp"

namespace soft::design::sample {

inline FamilyKeys pipe() {
    FamilyKeys family;
    family.name = "pipe";
    family.summary = "a pipe for tests";
    family.geometry = {
        {.path = "geometry.length",
         .kind = Kind::length,
         .fallback = "100 mm",
         .meaning = "outer length",
         .min = 0,
         .min_open = true},
        {.path = "geometry.wall",
         .kind = Kind::length,
         .fallback = "3 mm",
         .meaning = "thickness of the wall",
         .min = 0,
         .min_open = true},
        {.path = "geometry.folds",
         .kind = Kind::count,
         .fallback = "4",
         .meaning = "number of folds",
         .min = 1,
         .max = 50},
        {.path = "geometry.disc.length",
         .kind = Kind::length,
         .fallback = "6 mm",
         .meaning = "length of the disc",
         .min = 0,
         .min_open = true},
        {.path = "geometry.disc.radius",
         .kind = Kind::length,
         .fallback = "14.5 mm",
         .meaning = "radius of the disc",
         .min = 0,
         .min_open = true},
        {.path = "geometry.skew", .kind = Kind::angle, .fallback = "0 deg", .meaning = "angle of the fold"},
    };
    family.models = {"axisymmetric", "solid", "quarter"};
    family.obstacles = {{"plane",
                         {{.path = "plane.point", .kind = Kind::length, .meaning = "a point", .max_count = 3},
                          {.path = "plane.normal", .kind = Kind::ratio, .meaning = "the normal", .max_count = 3}}},
                        {"surface",
                         {{.path = "surface", .kind = Kind::text, .meaning = "a file"},
                          choice_key("unit", "mm", {"mm", "m"}, "unit of the file")}}};
    family.faces = {"fixed", "inlet", "cavity", "outer"};
    family.aliases = {{"end_disc", "fixed"}};
    family.defaults =
        "supports: {fixed: end_disc}\nloads: {cavity: {pressure: 25 kPa}}\n"
        "outputs: {elongation: {face: inlet, along: axis}}\n";
    family.mesh = {{.path = "mesh.size",
                    .kind = Kind::length,
                    .fallback = "1.5 mm",
                    .meaning = "target edge length",
                    .min = 0,
                    .min_open = true}};
    return family;
}

inline FamilyKeys bar() {
    FamilyKeys family;
    family.name = "bar";
    family.summary = "a bar for tests";
    family.geometry = {{.path = "geometry.length",
                        .kind = Kind::length,
                        .fallback = "50 mm",
                        .meaning = "length",
                        .min = 0,
                        .min_open = true}};
    family.models = {"solid"};
    family.faces = {"fixed", "end"};
    family.defaults =
        "supports: {fixed: fixed}\nloads: {end: {pressure: -50 kPa}}\noutputs: {elongation: {face: end}}\n";
    family.mesh = {{.path = "mesh.size",
                    .kind = Kind::length,
                    .fallback = "5 mm",
                    .meaning = "target edge length",
                    .min = 0,
                    .min_open = true}};
    return family;
}

inline const std::vector<FamilyKeys>& families() {
    static const std::vector<FamilyKeys> all = {pipe(), bar()};
    return all;
}

inline constexpr std::string_view minimal_design =
    "family: pipe\n"
    "material: {law: neo-hookean, mu: 0.1644 MPa}\n"
    "loads: {cavity: {pressure: 30 kPa}}\n";

inline Design read(std::string_view text, const std::vector<Override>& overrides = {}) {
    return read_design(text, "p.yaml", families(), overrides);
}

/// The effective design of a case with overrides of solve.
inline Design read_built(std::string_view effective, const std::vector<Override>& overrides,
                         std::span<const FamilyKeys> known = families()) {
    return read_built_design(effective, "case.h5:/design/effective_yaml", known, overrides, {});
}

/// The target of the first pressure load in a design without stages.
inline model::SupplyTarget supply(const Design& design) { return design.path.stages.at(0).supplies.at(0); }

/// The one-line error of a refused design; a test failure if it is accepted.
inline std::string refusal(std::string_view text, const std::vector<Override>& overrides = {}) {
    try {
        static_cast<void>(read(text, overrides));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input) << error.what();
        const std::string line = error.what();
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        EXPECT_LT(line.size(), 600u) << line;
        return line;
    }
    ADD_FAILURE() << "accepted: " << text;
    return {};
}

inline bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

inline const std::string base{minimal_design};

}  // namespace soft::design::sample
