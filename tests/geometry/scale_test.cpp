/// Meshes depend only on the shape: the same part at another scale has the same cells, and derived dimensions fit the stated ones.
#include <gtest/gtest.h>

#include <algorithm>

#include "../meshing/gmsh_files.hpp"
#include "core/text.hpp"
#include "dice.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

using design::Kind;
using Overrides = std::vector<design::Override>;

std::string metres(double m) { return core::number_text(m) + " m"; }

/// The tables of the template shapes (designs/profiles) at another scale.
std::string scaled_table(const std::string& family, double scale) {
    const auto n = [scale](double mm) { return core::number_text(scale * mm); };
    const auto row = [&](double x, double y, const std::string& rest) { return n(x) + "," + n(y) + "," + rest + "\n"; };
    if (family == "revolved")
        return "x_mm,r_mm,tag,curve,via_x_mm,via_r_mm\n" + row(0, 8, "cavity,,,") +
               row(20, 8, "cavity,arc," + n(25.6568542495) + "," + n(5.6568542495)) + row(28, 0, "axis,,,") +
               row(30, 0, "outer,arc," + n(27.0710678119) + "," + n(7.0710678119)) + row(20, 10, "outer,,,") +
               row(0, 10, "fixed,,,");
    return "x_mm,y_mm,tag,loop\n" + row(-12, 0, "base,block") + row(12, 0, "side,block") + row(12, 12, "top,block") +
           row(-12, 12, "side,block") + row(-6, 6, "cavity,slot") + row(-6, 10, "cavity,slot") +
           row(6, 10, "cavity,slot") + row(6, 6, "cavity,slot");
}

mesh::Mesh scaled_mesh(const design::FamilyKeys& keys, double scale, Overrides overrides) {
    for (const design::Key& key : keys.geometry)
        if (const bool is_length = key.kind == Kind::length; is_length && !key.fallback.empty())
            if (const double usual = sample::number_of(key, key.fallback); usual != 0)
                overrides.push_back({key.path, metres(scale * usual)});
    for (const design::Key& key : keys.geometry)
        if (key.path == "geometry.outer_radius" && key.fallback == "auto")  // if the other radius is also auto
            overrides.push_back({key.path, metres(scale * 10e-3)});
    const meshing::sample::TemporaryFile table{"scaled-" + keys.name + ".csv", scaled_table(keys.name, scale)};
    std::string text = design::template_yaml(keys);
    if (keys.faces_of_file)
        text = "family: " + keys.name + "\ngeometry: {profile: " + table.path.string() +
               "}\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\nloads: {cavity: {pressure: 5 kPa}}\n";
    return build_case(design::read_design(text, "scaled.yaml", catalogue_keys(), overrides)).mesh;
}

void expect_scaled(const mesh::Mesh& usual, const mesh::Mesh& other, double scale) {
    ASSERT_EQ(other.cell_count(), usual.cell_count());
    ASSERT_EQ(other.connectivity, usual.connectivity);
    double extent_m = 0, difference_m = 0;
    for (std::size_t p = 0; p < usual.points.size(); ++p)
        for (std::size_t d = 0; d < 3; ++d) {
            extent_m = std::max(extent_m, std::abs(usual.points[p][d]));
            difference_m = std::max(difference_m, std::abs(other.points[p][d] / scale - usual.points[p][d]));
        }
    constexpr double rounding = 1e-8;  // gmsh computes positions along arcs iteratively
    EXPECT_LT(difference_m, rounding * extent_m);
}

class Scaled : public testing::TestWithParam<std::string> {};

TEST_P(Scaled, HasTheSameCells) {
    const design::FamilyKeys& keys = sample::family(GetParam()).keys;
    for (const std::string quality : {"draft", "normal", "fine"}) {
        if (quality == "fine" && keys.models.front() != "axisymmetric") continue;  // solids: the same code, more memory
        const Overrides overrides{{"mesh.quality", quality}};
        const mesh::Mesh usual = scaled_mesh(keys, 1, overrides);
        for (const double scale : {0.01, 0.2, 10.0}) {
            SCOPED_TRACE(quality + " " + core::number_text(scale));
            expect_scaled(usual, scaled_mesh(keys, scale, overrides), scale);
        }
    }
}

/// Other proportions than the templates, including the largest ratios of radii and walls.
TEST(ScaledShapes, HaveTheSameCellsForOtherProportions) {
    const auto cells = [](const std::string& name, const std::string& model, sample::Changes changes, double scale) {
        for (auto& [key, value] : changes)
            if (value.ends_with(" mm")) value = metres(1e-3 * scale * std::stod(value));
        return sample::solid(name, model, changes).mesh;
    };
    struct Shape {
        std::string family, model;
        sample::Changes changes;
    };
    for (const Shape& shape : std::vector<Shape>{
             {"sphere", "axisymmetric", {{"geometry.inner_radius", "1 mm"}, {"geometry.outer_radius", "4 mm"}}},
             {"sphere", "quarter", {{"geometry.inner_radius", "60 mm"}, {"geometry.outer_radius", "61 mm"}}},
             {"ring", "plane-strain", {{"geometry.inner_radius", "1 mm"}, {"geometry.outer_radius", "3 mm"}}},
             {"tube",
              "axisymmetric",
              {{"geometry.length", "30 mm"}, {"geometry.outer_radius", "3 mm"}, {"geometry.inner_radius", "1 mm"}}},
             {"plate", "quarter", {{"geometry.length", "30 mm"}, {"geometry.width", "70 mm"}}},
             {"rod",
              "solid",
              {{"geometry.length", "30 mm"}, {"geometry.width", "20 mm"}, {"geometry.height", "3 mm"}}}}) {
        const mesh::Mesh usual = cells(shape.family, shape.model, shape.changes, 1);
        for (const double scale : {0.01, 0.2, 10.0})
            if (shape.family != "plate" && shape.family != "rod")  // their other lengths stay at the defaults
                expect_scaled(usual, cells(shape.family, shape.model, shape.changes, scale), scale);
    }
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Family& family : catalogue())
        if (family.keys.name != "imported") all.push_back(family.keys.name);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Family, Scaled, testing::ValuesIn(names()),
                         [](const auto& test) { return test_name(test.param); });

TEST(CellSize, QualityAndSizeAreMutuallyExclusive) {
    try {
        (void)sample::solid("tube", "axisymmetric", {{"mesh.size", "1 mm"}, {"mesh.quality", "draft"}});
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(std::string{error.what()},
                  "test: mesh.quality: 'draft' has no effect because mesh.size is stated; use mesh.size: auto");
    }
}

/// The error of each row was measured against a mesh with cells of half the size; for spheres and rings against the default mesh.
TEST(CellSize, WarnsIfTheErrorOfTheCurveExceedsOnePerCent) {
    struct Row {
        std::string family, model;
        sample::Changes changes;
        bool warns;
    };
    const auto ring = [](const char* inner, const char* outer, const char* size, const char* through) {
        return sample::Changes{{"geometry.inner_radius", inner},
                               {"geometry.outer_radius", outer},
                               {"mesh.size", size},
                               {"mesh.through_wall", through}};
    };
    for (const Row& row : std::vector<Row>{
             {"sphere", "axisymmetric", ring("60 mm", "61 mm", "2.5 mm", "auto"), false},             // 0.0 %
             {"sphere", "axisymmetric", ring("1 mm", "4 mm", "2.5 mm", "auto"), true},                // 17.5 %
             {"sphere", "axisymmetric", ring("2 mm", "10 mm", "2.5 mm", "auto"), true},               // 2.65 %
             {"sphere", "axisymmetric", ring("10 mm", "20 mm", "1.5 mm", "1"), false},                // 0.8 %
             {"sphere", "axisymmetric", ring("10 mm", "30 mm", "1.5 mm", "1"), true},                 // 6.0 %
             {"sphere", "axisymmetric", ring("10 mm", "30 mm", "1.5 mm", "2"), false},                // 0.7 %
             {"ring", "plane-strain", ring("10 mm", "30 mm", "1.5 mm", "1"), true},                   // 1.4 %
             {"ring", "plane-strain", ring("10 mm", "30 mm", "1.5 mm", "2"), false},                  // 0.2 %
             {"bellows", "axisymmetric", {{"mesh.through_wall", "1"}}, true},                         // 4.4 %
             {"bellows", "axisymmetric", {{"mesh.through_wall", "2"}}, false},                        // 0.1 %
             {"bellows", "axisymmetric", {{"mesh.size", "6 mm"}}, true},                              // 3.7 %
             {"bellows", "axisymmetric", {{"mesh.size", "4.5 mm"}}, false},                           // 0.6 %
             {"dome", "axisymmetric", {{"mesh.size", "1.4 mm"}}, true},                               // 2.6 %
             {"dome", "axisymmetric", {{"mesh.size", "0.7 mm"}, {"mesh.through_wall", "1"}}, false},  // 0.9 %
             {"tube", "axisymmetric", {{"mesh.size", "6 mm"}}, false},                                // 0.7 %
         }) {
        const Body body = sample::family(row.family).build(sample::values(row.family, row.model, row.changes));
        EXPECT_EQ(!body.warnings.empty(), row.warns)
            << row.family << (body.warnings.empty() ? "" : body.warnings.front());
    }
}

TEST(CellSize, DraftHasFewerAndFineHasMoreCells) {
    for (const std::string& name : names()) {
        const design::FamilyKeys& keys = sample::family(name).keys;
        const auto cells = [&](const char* quality) {
            return scaled_mesh(keys, 1, {{"mesh.quality", quality}}).cell_count();
        };
        const auto normal = cells("normal");
        EXPECT_LT(cells("draft"), 0.8 * static_cast<double>(normal)) << name;
        if (normal < 2000) {
            EXPECT_GT(cells("fine"), 1.3 * static_cast<double>(normal)) << name;
        }
    }
}

/// Ranges of the main dimensions, about those of published actuators; all others stay at their defaults.
struct Range {
    std::string key;
    double from, to;  ///< mm, deg or a number
};
struct Tried {
    std::string family, model;
    std::vector<Range> ranges;
};

class DerivedDimensions : public testing::TestWithParam<Tried> {};

TEST_P(DerivedDimensions, FitTheStatedOnes) {
    const Tried& tried = GetParam();
    const Family& family = sample::family(tried.family);
    Dice dice{20261123};
    constexpr int count = 200;
    int refused = 0;
    std::string reasons;
    for (int i = 0; i < count; ++i) {
        sample::Changes changes{{"mesh.quality", "draft"}};
        for (const Range& range : tried.ranges) {
            const auto key = std::ranges::find(family.keys.geometry, "geometry." + range.key, &design::Key::path);
            ASSERT_NE(key, family.keys.geometry.end()) << range.key;
            const double value = dice.between_logs(range.from, range.to);
            changes[key->path] = key->kind == Kind::count   ? std::to_string(static_cast<int>(value + 0.5))
                                 : key->kind == Kind::angle ? core::number_text(value) + " deg"
                                                            : core::number_text(value) + " mm";
        }
        try {
            (void)family.build(sample::values(tried.family, tried.model, changes));
        } catch (const Error& error) {
            ++refused;
            reasons += std::string{error.what()} + "\n";
        }
    }
    EXPECT_LT(refused, 0.05 * count) << reasons;
}

std::vector<Tried> tried() {
    return {{"bellows",
             "axisymmetric",
             {{"convolutions", 1, 10},
              {"pitch", 9, 16},
              {"crest_radius", 15, 30},
              {"bore_radius", 2, 5},
              {"wall", 0.8, 4}}},
            {"tube", "axisymmetric", {{"outer_radius", 2, 30}, {"length", 10, 200}}},
            {"tube", "axisymmetric", {{"inner_radius", 1, 20}, {"length", 10, 200}}},
            {"fiber-tube", "axisymmetric", {{"outer_radius", 2, 30}, {"length", 10, 200}}},
            {"sphere", "axisymmetric", {{"inner_radius", 1, 100}}},
            {"sphere", "axisymmetric", {{"outer_radius", 1, 100}}},
            {"two-spheres", "axisymmetric", {{"inner_radius", 1, 100}}},
            {"ring", "plane-strain", {{"outer_radius", 1, 100}}},
            {"dome", "axisymmetric", {{"radius", 1, 200}, {"angle", 10, 120}}},
            {"plate", "quarter", {{"length", 10, 200}, {"width", 10, 200}, {"thickness", 0.5, 8}}},
            {"rod", "solid", {{"length", 10, 200}, {"width", 2, 30}, {"height", 2, 30}}},
            {"panel", "plane-strain", {{"length", 10, 200}, {"height", 2, 50}}},
            {"pneunet", "half", {{"chambers", 1, 4}, {"chamber_length", 4, 15}, {"width", 6, 30}, {"height", 4, 30}}},
            {"segment", "solid", {{"chambers", 2, 4}, {"outer_radius", 3, 25}, {"length", 10, 150}, {"web", 10, 60}}}};
}

INSTANTIATE_TEST_SUITE_P(Family, DerivedDimensions, testing::ValuesIn(tried()), [](const auto& test) {
    return test_name(test.param.family + "_" + test.param.ranges.front().key);
});

}  // namespace
}  // namespace soft::geometry
