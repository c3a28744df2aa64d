#include "design/materials.hpp"

#include <algorithm>

namespace soft::design {

std::span<const Law> laws() {
    static const std::vector<Law> table = {
        {.name = "neo-hookean",
         .energy = "mu/2 (I1 - 3)",
         .source = "Treloar, Trans. Faraday Soc. 39 (1943) 241",
         .constants = {{{.path = "mu",
                         .kind = Kind::pressure,
                         .meaning = "initial shear modulus, a third of Young's modulus of an incompressible rubber",
                         .min = 0,
                         .min_open = true},
                        "0.1644 MPa"}},
         .initial_shear_modulus_Pa = [](const Constants& constants) { return constants.at("mu").front(); }},
    };
    return table;
}

std::vector<std::string> law_names() {
    std::vector<std::string> names;
    for (const Law& law : laws()) names.push_back(law.name);
    return names;
}

std::span<const std::string> reserved_law_names() {
    static const std::vector<std::string> names = {
        "linear-elastic", "saint-venant-kirchhoff", "mooney-rivlin", "yeoh", "ogden", "gent", "arruda-boyce", "kraken"};
    return names;
}

const Law* find_law(std::string_view name) {
    const auto table = laws();
    const auto law = std::find_if(table.begin(), table.end(), [&](const Law& l) { return l.name == name; });
    return law == table.end() ? nullptr : &*law;
}

}  // namespace soft::design
