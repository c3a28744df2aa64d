#include <array>
#include <vector>

#include "core/text.hpp"
#include "geometry/family.hpp"
#include "geometry/obstacle.hpp"

namespace soft::geometry {

std::span<const Family> catalogue() {
    static const std::array<Family, 15> families{bellows(), pneunet(),     segment(),  tube(),     fiber_tube(),
                                                 sphere(),  two_spheres(), ring(),     rod(),      panel(),
                                                 plate(),   dome(),        revolved(), extruded(), imported()};
    return families;
}

std::span<const design::FamilyKeys> catalogue_keys() {
    static const std::vector<design::FamilyKeys> keys = [] {
        std::vector<design::FamilyKeys> all;
        for (const Family& family : catalogue()) all.push_back(family.keys);
        for (design::FamilyKeys& family : all) family.obstacles = obstacle_keys();
        return all;
    }();
    return keys;
}

const Family& family_of(const std::string& name) {
    for (const Family& family : catalogue())
        if (family.keys.name == name) return family;
    throw Error(ExitCode::bad_input, "family", "no family is called " + core::quoted(name));
}

Model model_of(const design::Values& values) {
    const std::string& word = values.text("model");
    if (word == "axisymmetric") return Model::axisymmetric;
    if (word == "plane-strain") return Model::plane_strain;
    if (word == "solid") return Model::solid;
    if (word == "half") return Model::half;
    if (word == "quarter") return Model::quarter;
    if (word == "auto") return Model::automatic;
    throw values.refuse("model", "'" + word + "' is not a model",
                        "use axisymmetric, plane-strain, solid, half or quarter");
}

}  // namespace soft::geometry
