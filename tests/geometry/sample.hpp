#pragma once
/// Default values of a family as the parser returns them, with changes; and measurements on a mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/units.hpp"
#include "geometry/build.hpp"
#include "mesh/cell_map.hpp"

namespace soft::geometry {

using std::numbers::pi;
/// Relative area error of quadratic edges over at most 45 degrees of a circle: fourth power of their angle.
inline constexpr double curved = 1.5e-4;

inline std::string test_name(std::string words) {
    std::replace(words.begin(), words.end(), '-', '_');
    return words;
}

}  // namespace soft::geometry

namespace soft::geometry::sample {

inline const Family& family(const std::string& name) {
    for (const Family& candidate : catalogue())
        if (candidate.keys.name == name) return candidate;
    throw std::logic_error("no family " + name);
}

inline double number_of(const design::Key& key, const std::string& text) {
    if (std::find(key.choices.begin(), key.choices.end(), text) != key.choices.end())
        return 0;  // a word instead of a number
    switch (key.kind) {
        case design::Kind::length:
            return core::quantity_or_throw(text, core::Dimension::length, ExitCode::bad_input, key.path);
        case design::Kind::pressure:
            return core::quantity_or_throw(text, core::Dimension::pressure, ExitCode::bad_input, key.path);
        case design::Kind::angle:
            return core::quantity_or_throw(text, core::Dimension::angle, ExitCode::bad_input, key.path);
        case design::Kind::count:
        case design::Kind::ratio: return std::stod(text);
        case design::Kind::flag:
        case design::Kind::text: return 0;
        default: throw std::logic_error("no family uses this kind of key");
    }
}

/// The values of a list such as "[0, 1]", or a single value.
inline std::vector<double> numbers_of(const design::Key& key, std::string text) {
    if (!text.starts_with('[')) return {number_of(key, text)};
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '[' || c == ']' || c == ','; }, ' ');
    std::vector<double> numbers;
    std::istringstream words(text);
    for (double number = 0; words >> number;) numbers.push_back(number);
    return numbers;
}

using Changes = std::map<std::string, std::string>;

inline design::Values values(const std::string& name, const std::string& model, const Changes& changes = {}) {
    design::Values result;
    const design::FamilyKeys& keys = family(name).keys;
    const auto add = [&](const design::Key& key) {
        const auto change = changes.find(key.path);
        const std::string text = change == changes.end() ? key.fallback : change->second;
        const auto numbers = numbers_of(key, text);
        result.set(key.path, {numbers.front(), text, "test", change != changes.end(), numbers});
    };
    for (const design::Key& key : keys.geometry) add(key);
    for (const design::Key& key : keys.mesh) add(key);
    result.set("model", {0, model, "test", true});
    const auto quality = changes.find("mesh.quality");
    result.set("mesh.quality", {0, quality == changes.end() ? "normal" : quality->second, "test", true});
    const auto cells = changes.find("mesh.cells"), order = changes.find("mesh.order");
    result.set("mesh.cells", {0, cells == changes.end() ? "auto" : cells->second, "test", true});
    const std::string power = order == changes.end() ? "2" : order->second;
    result.set("mesh.order", {std::stod(power), power, "test", true});
    const auto refine = changes.find("mesh.refine");
    const std::string times = refine == changes.end() ? "0" : refine->second;
    result.set("mesh.refine", {std::stod(times), times, "test", true});
    const auto formulation = changes.find("mesh.formulation");
    result.set("mesh.formulation", {0, formulation == changes.end() ? "mixed" : formulation->second, "test", true});
    return result;
}

inline Solid solid(const std::string& name, const std::string& model, const Changes& changes = {}) {
    const design::Values v = values(name, model, changes);
    return mesh_body(family(name).build(v), v);
}

inline bool is_turned(const Solid& s) { return s.kinematics == model::Kinematics::axisymmetric; }

/// Volume of the whole actuator; in plane strain for 1 m of depth.
inline double rubber_m3(const Solid& s) {
    return mesh::measure(s.mesh, is_turned(s) ? mesh::Measure::revolved : mesh::Measure::plain) / s.fraction;
}

/// Sum of `density`(position, normal) over a named face, whole actuator. The normal has the length of the area element.
template <class Density>
double face_integral(const Solid& s, const std::string& face, const Density& density) {
    double sum = 0;
    for (const mesh::Facet& facet : s.mesh.facet_sets.at(face)) {
        const mesh::CellType type = mesh::facet_type(s.mesh, facet);
        const auto nodes = mesh::facet_nodes(s.mesh, facet);
        for (const mesh::QuadraturePoint& point : mesh::volume_rule(type)) {
            const auto shapes = mesh::shape_values(type, point.xi);
            mesh::Point p{};
            for (std::size_t a = 0; a < nodes.size(); ++a)
                for (std::size_t i = 0; i < 3; ++i) p[i] += shapes[a].value * s.mesh.point(nodes[a])[i];
            sum += point.weight * density(p, mesh::facet_normal(s.mesh, facet, shapes)) *
                   (is_turned(s) ? 2 * std::numbers::pi * p[1] : 1.0);
        }
    }
    return sum / s.fraction;
}

/// Volume of the cavity by the divergence theorem: flux of half the position vector normal to the axis (0 x, 2 z), which has
/// divergence 1. Planes across the axis, including plugs, contribute nothing.
inline double cavity_m3(const Solid& s, std::size_t axis = 0, const std::string& wall = "cavity") {
    return face_integral(s, wall, [axis](const mesh::Point& p, const mesh::Point& n) {
        double flux = 0;
        for (std::size_t i = 0; i < 3; ++i) flux -= i == axis ? 0.0 : 0.5 * p[i] * n[i];
        return flux;
    });
}

/// Undeformed area of a named face, whole actuator.
inline double area_m2(const Solid& s, const std::string& face) {
    return face_integral(s, face,
                         [](const mesh::Point&, const mesh::Point& n) { return std::hypot(n[0], n[1], n[2]); });
}

/// A value of the key "geometry.KEY", and the problem and remedy that the error states.
struct Refusal {
    const char *key, *value, *words;
};
inline void expect_refusals(const std::string& family, const std::string& model,
                            std::initializer_list<Refusal> refusals) {
    for (const Refusal& r : refusals) {
        const std::string key = std::string{"geometry."} + r.key;
        try {
            (void)solid(family, model, {{key, r.value}});
            ADD_FAILURE() << key << " accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_EQ(std::string{error.what()}, "test: " + key + ": " + r.words);
        }
    }
}

/// The error message for a design, or "accepted".
inline std::string refusal(const design::Design& design) {
    try {
        (void)build_case(design);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "accepted";
}

}  // namespace soft::geometry::sample
