#include "design/common_keys.hpp"

#include <algorithm>
#include <numbers>

#include "core/text.hpp"
#include "design/load_keys.hpp"
#include "design/setting.hpp"

namespace soft::design {

std::vector<std::string> directions() { return {"axis", "x", "y", "z", "r", "normal"}; }

std::vector<std::string> obstacle_directions() { return {"axis", "x", "y", "z"}; }

std::vector<Key> head_keys(const FamilyKeys& family) {
    return {choice_key("family", "", {family.name}, "actuator family, see `mesh-gen --list`"),
            with_default(family.name, value_key("name", Kind::text, {}, "title of the case in files and plots"))};
}

std::vector<Key> model_keys(const FamilyKeys& family) {
    const bool selects = std::ranges::find(family.models, "auto") != family.models.end();
    std::vector<Key> keys = {
        choice_key(
            "model", family.models.empty() ? "" : family.models.front(), family.models,
            std::string{
                "what is meshed: the section of a body of revolution or of a long body in plane strain (1 m deep), or "
                "a solid, whole or cut at its planes of symmetry"} +
                (selects ? "; auto: half unless a load, an output or an obstacle may break the symmetry, else solid"
                         : "")),
        value_key("mesh.size", Kind::length, above(0), "target edge length of a cell"),
        choice_key("mesh.quality", "normal", {"draft", "normal", "fine"},
                   "number of cells where mesh.size is auto: draft has half as many along every length, fine 1.5 times "
                   "as many"),
        choice_key("mesh.formulation", "mixed", {"mixed", "displacement", "f-bar"},
                   "mixed has the pressure as an unknown and does not lock; displacement is for compressible rubber; "
                   "f-bar averages the change of volume over each first-order quadrilateral or hexahedron"),
        with_default("2", value_key("mesh.order", Kind::count, {1, 2}, "polynomial order of the cells; mixed needs 2")),
        choice_key("mesh.cells", "auto", {"auto", "simplices"},
                   "auto: quadrilaterals and hexahedra; simplices: each split into triangles or tetrahedra"),
        with_default("0", value_key("mesh.refine", Kind::count, {0, 8},
                                    "number of uniform refinements; each halves every cell in all directions")),
    };
    if (family.faces_of_file) std::erase_if(keys, [](const Key& key) { return key.path == "mesh.size"; });
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
    return value_key("supports." + component, Kind::faces, {}, what);
}

Key output_face_key(const std::string& output) {
    return value_key("outputs." + output + ".face", Kind::faces, {}, "face that is measured");
}

Key output_point_key(const std::string& output) {
    return {.path = "outputs." + output + ".point",
            .kind = Kind::length,
            .meaning =
                "point of the undeformed part whose displacement is measured, in place of a face: [x, r] of a body of "
                "revolution, [x, y] in plane strain, [x, y, z] of a solid",
            .max_count = 3};
}

Key output_obstacle_key(const std::string& output, std::vector<std::string> obstacles) {
    return choice_key(
        "outputs." + output + ".obstacle", "", std::move(obstacles),
        "obstacle whose contact with the actuator, or displacement, is measured, in place of a face; self: contact of the "
        "actuator with itself");
}

Key output_measure_key(const std::string& output, model::MeasuredObject object, const model::MeasureInfo* measure) {
    using model::MeasuredObject;
    std::vector<std::string> words, meanings;
    for (const model::MeasureInfo& row : model::measures) {
        if (object != row.object && object != MeasuredObject::face_or_obstacle &&
            row.object != MeasuredObject::face_or_obstacle)
            continue;
        words.emplace_back(row.name);
        meanings.push_back(std::string{row.name} + ": " + std::string{row.meaning});
    }
    return choice_key("outputs." + output + ".measure", object == MeasuredObject::obstacle ? "" : "displacement",
                      std::move(words),
                      measure == nullptr ? core::join(meanings, "; ") : std::string{measure->meaning});
}

Key output_reference_key(const std::string& output) {
    return value_key("outputs." + output + ".reference", Kind::faces, {},
                     "face from whose normal the bend is measured, usually the fixed one");
}

Key output_along_key(const std::string& output, std::string fallback) {
    return choice_key(
        "outputs." + output + ".along", std::move(fallback), directions(),
        "direction of a displacement, force or rotation, otherwise the axis; axis is positive when the actuator gets "
        "longer");
}

Key until_key(const std::string& section, const std::string& quantity) {
    const std::string path = section + "." + quantity;
    if (quantity == "pressure")
        return value_key(path, Kind::pressure, {}, "the path or stage ends at this pressure of the first load");
    if (quantity == "volume_ratio")
        return value_key(path, Kind::ratio, above(0),
                         "the path or stage ends at this ratio of cavity volume to undeformed volume");
    return value_key(path, Kind::count, {1, 1e6}, "the path or stage ends after this many steps");
}

std::vector<Key> name_keys(const FamilyKeys& family) {
    std::vector<Key> keys;
    for (const auto& [alias, face] : family.aliases)
        keys.push_back(choice_key("names." + alias, face, {face}, "another name of this face"));
    return keys;
}

Key cavity_faces_key(const std::string& cavity) {
    return value_key("geometry.cavities." + cavity, Kind::faces, {},
                     "faces that together are the wall of this cavity, for loads.cavities");
}

std::vector<Key> face_rule_keys() {
    const auto vector_key = [](const char* path, Kind kind, const char* meaning) {
        Key key = value_key(path, kind, {}, meaning);
        key.max_count = 3;
        return key;
    };
    const auto plane = [](const char* path) {
        return value_key(path, Kind::length, {}, "the facets that lie in this plane");
    };
    return {plane("plane.x"),
            plane("plane.y"),
            plane("plane.z"),
            vector_key("box.from", Kind::length, "the facets within this box, x, y, z of its lowest corner"),
            vector_key("box.to", Kind::length, "x, y, z of the box's highest corner"),
            vector_key("normal", Kind::ratio, "the facets whose outward normal has this direction x, y, z"),
            value_key("within", Kind::angle, {0, std::numbers::pi},
                      "largest angle between these normals and that direction (default 10 deg)"),
            vector_key("point", Kind::length,
                       "the facets connected to the surface point nearest to x, y, z, up to sharp edges (40 deg)"),
            value_key("up_to", Kind::faces, {}, "with point: continue across sharp edges, up to these faces")};
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
         "cavity (or cavities: name): {pressure | volume | volume_ratio | mass | valve: closed}, sealed, gas; a face: " +
             form_list(LoadTarget::face) +
             "; an obstacle: {displacement, along}; gravity: " + form_list(LoadTarget::gravity) +
             "; with dynamics also "
             "time_function: {kind: ramp, rise | step | sine, frequency | table, times, shares}, and of a cavity line: {resistance}"},
        {"obstacles",
         "name: {plane | cylinder | sphere | box | profile | surface}; rigid, at rest or moved by a load of the same "
         "name"},
        {"contact", "of the actuator with itself and with the obstacles"},
        {"path",
         "from the unloaded state to the full load, or through stages: {name: {loads, control, controlled, until}, ...}"},
        {"outputs", "name: {face, point or obstacle, measure, along}; becomes a column of the curve"},
        {"dynamics", "motion in time from rest in the undeformed state; needs material.density"},
        {"solver", "methods, tolerances and limits; the defaults suit most designs"},
    };
    return notes;
}

}  // namespace soft::design
