/// One declaration of a setting gives its key and fills its struct.
#include "design/setting.hpp"

#include <gtest/gtest.h>

#include "design/collect.hpp"
#include "design/read_parts.hpp"

namespace {

using namespace soft::design;

enum class Paint { none, red };

struct Part {
    double length_m = 2e-3;
    double ratio = 1e-9;
    int rows = 3;
    bool scaled = true;
    Paint paint = Paint::red;
    std::optional<double> density_kg_m3;
    double step_s = 0;
};
struct Whole {
    Part part;
};

const Settings<Part> settings{
    quantity("length", &Part::length_m, Kind::length, above(0), "length"),
    number("ratio", &Part::ratio, share, "ratio"),
    count("rows", &Part::rows, {1, 10}, "rows"),
    flag("scaled", &Part::scaled, "scaled"),
    choice("paint", &Part::paint, {{"none", Paint::none}, {"red", Paint::red}}, "paint"),
    or_word("none", quantity("density", &Part::density_kg_m3, Kind::density, above(0), "density")),
    or_word("auto", in_unit("ms", quantity("step", &Part::step_s, Kind::time, above(0), "step"))),
};

Part read_part(const std::string& yaml) {
    Schema schema;
    schema.keys = keys_of(settings, "part");
    return read_settings(settings, values_of(collect(parse_yaml(yaml, "test.yaml"), schema, "test.yaml", {})), "part");
}

TEST(Setting, TakesItsDefaultFromTheStruct) {
    std::vector<std::string> defaults;
    for (const Key& key : keys_of(settings, "part")) defaults.push_back(key.path + ": " + key.fallback);
    EXPECT_EQ(defaults,
              (std::vector<std::string>{"part.length: 2 mm", "part.ratio: 1e-09", "part.rows: 3", "part.scaled: true",
                                        "part.paint: red", "part.density: none", "part.step: auto"}));
    const Part part = read_part("{}"), usual;
    EXPECT_EQ(part.length_m, usual.length_m);
    EXPECT_EQ(part.ratio, usual.ratio);
    EXPECT_EQ(part.rows, usual.rows);
    EXPECT_EQ(part.scaled, usual.scaled);
    EXPECT_EQ(part.paint, usual.paint);
    EXPECT_EQ(part.density_kg_m3, usual.density_kg_m3);
    EXPECT_EQ(part.step_s, usual.step_s);
}

TEST(Setting, SetsItsMember) {
    const Part part = read_part(
        "part: {length: 1 cm, ratio: 50 %, rows: 7, scaled: false, paint: none, density: 1 g/cm^3, step: 5 ms}");
    EXPECT_EQ(part.length_m, 0.01);
    EXPECT_EQ(part.ratio, 0.5);
    EXPECT_EQ(part.rows, 7);
    EXPECT_FALSE(part.scaled);
    EXPECT_EQ(part.paint, Paint::none);
    EXPECT_EQ(part.density_kg_m3, 1000.0);
    EXPECT_EQ(part.step_s, 0.005);
}

TEST(Setting, ChecksItsRangeAndItsWords) {
    EXPECT_THROW((void)read_part("part: {length: 0 m}"), soft::Error);
    EXPECT_THROW((void)read_part("part: {ratio: 2}"), soft::Error);
    EXPECT_THROW((void)read_part("part: {rows: 11}"), soft::Error);
    EXPECT_THROW((void)read_part("part: {paint: blue}"), soft::Error);
    EXPECT_THROW((void)read_part("part: {step: none}"), soft::Error);
}

TEST(Setting, OfAnInnerStructSetsItsMember) {
    const Settings<Whole> outer{inside(&Whole::part, settings.front())};
    Values values;
    values.set("length", {.number = 0.5, .text = "0.5 m", .location = "test", .numbers = {0.5}});
    Whole whole;
    outer.front().read(values, "length", whole);
    EXPECT_EQ(whole.part.length_m, 0.5);
}

TEST(Setting, ShowsItsDefaultInAGivenUnit) {
    const auto setting = in_unit("um", quantity("length", &Part::length_m, Kind::length, above(0), "length"));
    EXPECT_EQ(setting.key.fallback, "2000 um");
}

}  // namespace
