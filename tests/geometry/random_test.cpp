/// Random designs with values within the ranges of their keys and slightly outside: each becomes a mesh with valid cells, or is
/// rejected with one line that names the key. SOFT_RANDOM_DESIGNS=200 geometry_tests --gtest_filter='Random*' generates 200 designs
/// of each family and prints the smallest scaled Jacobian.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "../meshing/gmsh_files.hpp"
#include "core/text.hpp"
#include "dice.hpp"
#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

std::string millimetres(double m) { return core::number_text(1e3 * m) + " mm"; }

/// A value near the default; sometimes a word, if the key has one; rarely a value out of range.
std::string drawn(const design::Key& key, Dice& dice) {
    if (key.max_count > 1) {  // two fractions: from, to
        const double from = dice.between(-0.05, 0.6), to = dice.between(0.4, 1.05);
        return "[" + core::number_text(from) + ", " + core::number_text(to) + "]";
    }
    const double usual =
        key.choices.empty() || key.kind != design::Kind::choice ? sample::number_of(key, key.fallback) : 0;
    if (!key.choices.empty() && (key.kind == design::Kind::choice || dice.chance(key.fallback == "auto" ? 0.8 : 0.5)))
        return dice.one_of(key.choices);
    switch (key.kind) {
        case design::Kind::length: {
            const double base = usual > 0 ? usual : 5e-3;
            return dice.chance(0.02)                                 ? "-1 mm"
                   : usual == 0 && dice.chance(0.5) && !key.min_open ? "0 mm"
                                                                     : millimetres(dice.scaled(base, 1.6));
        }
        case design::Kind::angle: return core::number_text(dice.scaled(usual, 2) * 180 / pi) + " deg";
        case design::Kind::count:
            return std::to_string(
                dice.whole(std::max(1, static_cast<int>(0.5 * usual)), std::max(2, static_cast<int>(1.5 * usual))));
        case design::Kind::ratio: return core::number_text(dice.scaled(usual > 0 ? usual : 1, 2));
        default: return key.fallback;
    }
}

/// A closed outline around a point with lines, arcs and splines; the first two points may lie on the axis.
std::string drawn_table(Dice& dice, bool turned) {
    std::string text =
        std::string{"x_mm,"} + (turned ? "r" : "y") + "_mm,tag,curve,via_x_mm,via_" + (turned ? "r" : "y") + "_mm\n";
    const int points = dice.whole(3, 9);
    const double high = turned ? dice.between(0, 25) : 0;
    std::vector<std::array<double, 2>> p;
    for (int k = 0; k < points; ++k) {
        const double angle = 2 * pi * (k + dice.between(-0.3, 0.3)) / points, radius = dice.between(4, 20);
        p.push_back({radius * std::cos(angle), high + radius * std::sin(angle)});
    }
    if (turned && dice.chance(0.4)) {  // closed on the axis
        for (auto& point : p) point[1] = std::abs(point[1]);
        std::ranges::sort(p,
                          [](const auto& a, const auto& b) { return std::atan2(a[1], a[0]) < std::atan2(b[1], b[0]); });
        p.front()[1] = p.back()[1] = 0;
        std::ranges::rotate(p, p.end() - 1);
    }
    for (std::size_t k = 0; k < p.size(); ++k) {
        const auto &a = p[k], &b = p[(k + 1) % p.size()];
        const bool axis = turned && a[1] == 0 && b[1] == 0;
        const double share = dice.between(-0.2, 0.6);
        const std::string curve = axis ? "line" : dice.one_of(std::vector<std::string>{"line", "arc", "spline"});
        text += core::number_text(a[0]) + "," + core::number_text(a[1]) + "," +
                (axis ? "axis" : dice.one_of(std::vector<std::string>{"fixed", "cavity", "outer"})) + "," + curve;
        text += curve == "arc" ? "," + core::number_text(0.5 * (a[0] + b[0]) + share * (b[1] - a[1])) + "," +
                                     core::number_text(0.5 * (a[1] + b[1]) - share * (b[0] - a[0])) + "\n"
                               : ",,\n";
    }
    return text;
}

/// The template of the family with other values.
struct Drawn {
    std::string text;
    std::vector<design::Override> overrides;
};

Drawn drawn_design(const design::FamilyKeys& keys, Dice& dice) {
    Drawn design{design::template_yaml(keys), {}};
    const std::string model = dice.one_of(keys.models);
    design.overrides.push_back({"model", model});
    for (const design::Key& key : keys.geometry)
        if (key.kind != design::Kind::text && dice.chance(0.8))
            design.overrides.push_back({key.path, drawn(key, dice)});
    const bool plane = model == "axisymmetric" || model == "plane-strain";
    for (const design::Key& key : keys.mesh) {
        if (key.path == "mesh.size")
            design.overrides.push_back(plane && dice.chance(0.5)
                                           ? design::Override{key.path, millimetres(dice.between_logs(0.7e-3, 5e-3))}
                                           : design::Override{"mesh.quality", plane ? "normal" : "draft"});
        if (key.path == "mesh.through_wall" && !plane) design.overrides.push_back({key.path, "1"});
        if (key.path == "mesh.sectors") design.overrides.push_back({key.path, "3"});
    }
    return design;
}

int count() {
    const char* requested = std::getenv("SOFT_RANDOM_DESIGNS");
    return requested == nullptr ? 20 : std::atoi(requested);
}

class RandomDesigns : public testing::TestWithParam<std::string> {};

TEST_P(RandomDesigns, AreMeshedOrRejectedWithAReason) {
    const design::FamilyKeys& keys = sample::family(GetParam()).keys;
    Dice dice{20261122};
    int meshed = 0, refused = 0;
    double min_jacobian = 1;
    std::map<std::string, int> reasons;
    for (int k = 0; k < count(); ++k) {
        Drawn drawn = drawn_design(keys, dice);
        const bool turned = GetParam() == "revolved";
        const meshing::sample::TemporaryFile table{"random-" + GetParam() + ".csv", drawn_table(dice, turned)};
        if (keys.faces_of_file) {
            drawn.text = "family: " + GetParam() + "\ngeometry: {profile: " + table.path.string() +
                         "}\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\nloads: {outer: {pressure: 5 kPa}}\n";
        }
        std::string what;
        for (const design::Override& change : drawn.overrides) what += " --set " + change.path + "=" + change.value;
        try {
            const model::Case built =
                build_case(design::read_design(drawn.text, "random.yaml", catalogue_keys(), drawn.overrides));
            try {
                min_jacobian = std::min(min_jacobian, mesh::quality(built.mesh).min_scaled_jacobian);
            } catch (const Error& error) {
                ADD_FAILURE() << GetParam() << " " << k << ":" << what << "\n"
                              << error.what() << "\n"
                              << (keys.faces_of_file ? table.text() : "");
            }
            ++meshed;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input) << what << "\n" << error.what();
            EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos) << error.what();
            ++refused;
            if (count() > 20) std::cout << GetParam() << " refused: " << error.what() << "\n";
        }
    }
    EXPECT_GT(meshed, count() / 10);
    std::cout << GetParam() << ": " << meshed << " meshed, " << refused << " refused, smallest scaled Jacobian "
              << min_jacobian << "\n";
    RecordProperty("min_scaled_jacobian", core::number_text(min_jacobian));
}

std::vector<std::string> drawing_families() {
    std::vector<std::string> names;
    for (const Family& family : catalogue())
        if (family.keys.name != "imported") names.push_back(family.keys.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Random, RandomDesigns, testing::ValuesIn(drawing_families()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace soft::geometry
