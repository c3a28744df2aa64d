#include "design/common_keys.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/materials.hpp"

namespace soft::design {

std::vector<std::string> directions() { return {"axis", "x", "y", "z", "r", "normal"}; }

std::vector<Key> head_keys(const FamilyKeys& family) {
    return {{.path = "family",
             .kind = Kind::choice,
             .meaning = "actuator family, see `mesh-gen --list`",
             .choices = {family.name}},
            {.path = "name",
             .kind = Kind::text,
             .fallback = family.name,
             .meaning = "title of the case in files and plots"}};
}

std::vector<Key> model_keys(const FamilyKeys& family) {
    std::vector<Key> keys = {
        {.path = "model",
         .kind = Kind::choice,
         .fallback = family.models.empty() ? "" : family.models.front(),
         .meaning =
             "what is meshed: the section of a body of revolution or of a long body in plane strain (1 m deep), or a solid, "
             "whole or cut at its planes of symmetry",
         .choices = family.models},
        {.path = "mesh.size",
         .kind = Kind::length,
         .meaning = "target edge length of a cell",
         .min = 0,
         .min_open = true},
        {.path = "mesh.quality",
         .kind = Kind::choice,
         .fallback = "normal",
         .meaning =
             "number of cells where mesh.size is auto: draft has half as many along every length, fine 1.5 times as many",
         .choices = {"draft", "normal", "fine"}},
        {.path = "mesh.formulation",
         .kind = Kind::choice,
         .fallback = "mixed",
         .meaning = "mixed has the pressure as an unknown and does not lock; displacement is for compressible rubber; "
                    "f-bar averages the change of volume over each first-order quadrilateral or hexahedron",
         .choices = {"mixed", "displacement", "f-bar"}},
        {.path = "mesh.order",
         .kind = Kind::count,
         .fallback = "2",
         .meaning = "polynomial order of the cells; mixed needs 2",
         .min = 1,
         .max = 2},
        {.path = "mesh.cells",
         .kind = Kind::choice,
         .fallback = "auto",
         .meaning = "auto: quadrilaterals and hexahedra; simplices: each split into triangles or tetrahedra",
         .choices = {"auto", "simplices"}},
    };
    if (family.faces_of_file) std::erase_if(keys, [](const Key& key) { return key.path == "mesh.size"; });
    keys.push_back({.path = "mesh.refine",
                    .kind = Kind::count,
                    .fallback = "0",
                    .meaning = "number of uniform refinements; each halves every cell in all directions",
                    .min = 0,
                    .max = 8});
    for (const Key& own : family.mesh) {
        const auto common =
            std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.path == own.path; });
        if (common == keys.end())
            keys.push_back(own);
        else
            *common = own;
    }
    return keys;
}

Key support_key(const std::string& component) {
    const std::string what = component == "fixed" ? "faces fixed in all displacement components"
                                                  : "faces fixed in displacement component " + component;
    return {.path = "supports." + component, .kind = Kind::faces, .meaning = what};
}

Key output_face_key(const std::string& output) {
    return {.path = "outputs." + output + ".face", .kind = Kind::faces, .meaning = "face that is measured"};
}

Key output_point_key(const std::string& output) {
    return {.path = "outputs." + output + ".point",
            .kind = Kind::length,
            .meaning =
                "point of the undeformed part whose displacement is measured, in place of a face: [x, r] of a body of "
                "revolution, [x, y] in plane strain, [x, y, z] of a solid",
            .max_count = 3};
}

namespace {

std::vector<std::string> measure_words() {
    std::vector<std::string> words;
    for (const model::Measure measure : model::all_measures) words.emplace_back(model::name_of(measure));
    return words;
}

}  // namespace

Key output_measure_key(const std::string& output) {
    return {
        .path = "outputs." + output + ".measure",
        .kind = Kind::choice,
        .fallback = "displacement",
        .meaning =
            "mean displacement of the face; angle between its normal and that of a reference face (bend); mean rotation "
            "about an axis through the origin (twist); mean increase of the distance from that axis (radial); rotation vector; "
            "curvature of the best-fit circle; force or moment of the body on its support",
        .choices = measure_words()};
}

Key output_reference_key(const std::string& output) {
    return {.path = "outputs." + output + ".reference",
            .kind = Kind::faces,
            .meaning = "face from whose normal the bend is measured, usually the fixed one"};
}

Key output_along_key(const std::string& output, std::string fallback) {
    return {
        .path = "outputs." + output + ".along",
        .kind = Kind::choice,
        .fallback = std::move(fallback),
        .meaning =
            "direction of a displacement, force or rotation, otherwise the axis; axis is positive when the actuator gets longer",
        .choices = directions()};
}

Key until_key(const std::string& section, const std::string& quantity) {
    const std::string path = section + "." + quantity;
    if (quantity == "pressure")
        return {.path = path,
                .kind = Kind::pressure,
                .meaning = "the path or stage ends at this pressure of the first load"};
    if (quantity == "volume_ratio")
        return {.path = path,
                .kind = Kind::ratio,
                .meaning = "the path or stage ends at this ratio of cavity volume to undeformed volume",
                .min = 0,
                .min_open = true};
    return {.path = path,
            .kind = Kind::count,
            .meaning = "the path or stage ends after this many steps",
            .min = 1,
            .max = 1e6};
}

std::vector<Key> name_keys(const FamilyKeys& family) {
    std::vector<Key> keys;
    for (const auto& [alias, face] : family.aliases)
        keys.push_back({.path = "names." + alias,
                        .kind = Kind::choice,
                        .fallback = face,
                        .meaning = "another name of this face",
                        .choices = {face}});
    return keys;
}

Key cavity_faces_key(const std::string& cavity) {
    return {.path = "geometry.cavities." + cavity,
            .kind = Kind::faces,
            .meaning = "faces that together are the wall of this cavity, for loads.cavities"};
}

std::vector<Key> face_rule_keys() {
    const auto point_key = [](const char* path, const char* meaning) {
        return Key{.path = path, .kind = Kind::length, .meaning = meaning, .max_count = 3};
    };
    const auto plane = [](const char* path) {
        return Key{.path = path, .kind = Kind::length, .meaning = "the facets that lie in this plane"};
    };
    return {
        plane("plane.x"),
        plane("plane.y"),
        plane("plane.z"),
        point_key("box.from", "the facets within this box, x, y, z of its lowest corner"),
        point_key("box.to", "x, y, z of the box's highest corner"),
        {.path = "normal",
         .kind = Kind::ratio,
         .meaning = "the facets whose outward normal has this direction x, y, z",
         .max_count = 3},
        {.path = "within",
         .kind = Kind::angle,
         .meaning = "largest angle between these normals and that direction (default 10 deg)",
         .min = 0,
         .max = 3.1415926535897932},
        point_key("point", "the facets connected to the surface point nearest to x, y, z, up to sharp edges (40 deg)"),
        {.path = "up_to",
         .kind = Kind::faces,
         .meaning = "with point: continue across sharp edges, up to these faces"}};
}

bool is_valid_name(std::string_view text) {
    constexpr std::size_t max_length = 40;
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !text.empty() && is_letter(text.front()) && text.size() <= max_length &&
           std::ranges::all_of(text, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

const std::vector<std::string>& support_components() {
    static const std::vector<std::string> names = {"fixed", "x", "y", "z", "r"};
    return names;
}

const std::vector<std::string>& until_quantities() {
    static const std::vector<std::string> names = {"pressure", "volume_ratio", "steps"};
    return names;
}

const std::vector<SectionNote>& section_notes() {
    static const std::vector<SectionNote> notes = {
        {"family", ""},
        {"name", ""},
        {"geometry", "dimensions of the undeformed actuator"},
        {"material", "material of the rubber"},
        {"materials", "materials of other regions by name, each with the keys of material"},
        {"model", ""},
        {"mesh", ""},
        {"names", "other names of faces"},
        {"supports", "component: face or [face, face]; fixed: all components; x, y, z or r: that component"},
        {"loads",
         "cavity (or cavities: name): {pressure | volume | volume_ratio | mass | valve: closed}, sealed, gas; a face: {pressure}, "
         "{traction, along}, {force, along} or {displacement, along}; gravity: {acceleration, along}; with dynamics also "
         "time_function: {kind: ramp, rise | step | sine, frequency | table, times, shares}, and of a cavity line: {resistance}"},
        {"path",
         "from the unloaded state to the full load, or through stages: {name: {loads, control, controlled, until}, ...}"},
        {"outputs", "name: {face or point, measure, along}; becomes a column of the curve"},
        {"dynamics", "motion in time from rest in the undeformed state; needs material.density"},
        {"solver", "methods, tolerances and limits; the defaults suit most designs"},
    };
    return notes;
}

}  // namespace soft::design
