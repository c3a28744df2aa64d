#include "view/scene.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "stretched_bar.hpp"

namespace soft::view {
namespace {

constexpr std::size_t ample = 1u << 24;

/// Independent, simple decoder of RFC 4648.
template <class T>
std::vector<T> decoded(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned long buffer = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') break;
        buffer = buffer << 6 | digits.find(c);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(buffer >> bits & 255);
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

struct Decoded {
    nlohmann::json json;
    std::size_t frames, bases;
};

Decoded scene_of(const io::Result& result, std::size_t budget = ample) {
    const Scene scene = make_scene(result, post::make_curve(result.model, result.steps), budget);
    const auto json = nlohmann::json::parse(scene.json);
    EXPECT_EQ(json["frames"].size(), scene.frames);
    return {json, scene.frames, json["bases"].get<std::size_t>()};
}

/// Extent of the bases of a frame along an axis [mm].
double extent(const Decoded& scene, const std::vector<std::uint16_t>& positions, std::size_t frame, std::size_t axis) {
    const double low = scene.json["low"][axis], high = scene.json["high"][axis];
    double min = high, max = low;
    for (std::size_t b = 0; b < scene.bases; ++b) {
        const double x = low + (high - low) * positions[3 * (frame * scene.bases + b) + axis] / 65535;
        min = std::min(min, x);
        max = std::max(max, x);
    }
    return max - min;
}

TEST(Scene, TheBodyOfEachFrameHasTheStretchOfItsStep) {
    const Decoded scene = scene_of(test::bar_result(4));
    ASSERT_EQ(scene.frames, 4u);
    const auto positions = decoded<std::uint16_t>(scene.json["positions"]);
    ASSERT_EQ(positions.size(), 3 * scene.frames * scene.bases);
    for (std::size_t frame = 0; frame < 4; ++frame) {
        const double stretch = test::stretch_of(static_cast<int>(frame));
        EXPECT_NEAR(extent(scene, positions, frame, 0), 40 * stretch, 2 * 70.0 / 65535);
        EXPECT_NEAR(extent(scene, positions, frame, 1), 20 / std::sqrt(stretch), 2 * 20.0 / 65535);
    }
    const auto undeformed = decoded<std::uint16_t>(scene.json["undeformed"]);
    EXPECT_NEAR(extent(scene, undeformed, 0, 0), 40, 2 * 70.0 / 65535);
}

TEST(Scene, TheFieldsAreThoseOfTheUniformState) {
    const Decoded scene = scene_of(test::bar_result(3));
    const auto field = [&](const std::string& label) {
        for (const auto& candidate : scene.json["fields"])
            if (candidate["label"] == label) return candidate;
        return nlohmann::json{};
    };
    const auto stretch = field("largest principal stretch");
    EXPECT_EQ(stretch["low_text"], "1");
    EXPECT_EQ(stretch["high_text"], "1.5");
    const auto shares = decoded<std::uint16_t>(stretch["values"]);
    ASSERT_EQ(shares.size(), 3 * scene.bases);
    EXPECT_EQ(shares.front(), 0);
    EXPECT_NEAR(shares[scene.bases], 65535 / 2, 2);  // 1.25 lies half-way
    EXPECT_EQ(shares.back(), 65535);
    // neo-Hookean without change of volume: von Mises = mu (l^2 - 1/l), mu = 100 kPa, l = 1.5
    EXPECT_EQ(field("von Mises stress")["high_text"], "158.3 kPa");
}

TEST(Scene, ObstaclesMoveWithTheirLoad) {
    io::Result result = test::bar_result(3);
    result.model.obstacles = {{"wall", model::Plane{{-0.001, 0, 0}, {1, 0, 0}}}};
    result.model.motions = {{"wall", {-0.002, 0, 0}}};
    result.model.path.stages = {{.name = "path", .motions = {1}}};
    const Decoded scene = scene_of(result);
    const auto& wall = scene.json["obstacles"][0];
    const auto ends = decoded<float>(wall["lines"]);
    ASSERT_GT(ends.size(), 100u);
    for (std::size_t k = 0; k < ends.size(); k += 3) EXPECT_EQ(ends[k], -1.0F);  // [mm]
    for (std::size_t frame = 0; frame < scene.frames; ++frame)
        EXPECT_NEAR(wall["shifts"][frame][0], -2 * result.steps[frame].load_factor, 1e-12);
}

TEST(Scene, EveryIndexIsInRange) {
    const Decoded scene = scene_of(test::bar_result(2));
    const auto base = decoded<std::uint32_t>(scene.json["base"]);
    const auto placement = decoded<std::uint8_t>(scene.json["placement"]);
    EXPECT_EQ(base.size(), placement.size());
    for (const std::uint32_t b : base) EXPECT_LT(b, scene.bases);
    for (const std::uint8_t p : placement) EXPECT_LT(p, scene.json["placements"].size());
    for (const char* list : {"triangles", "creases"})
        for (const std::uint32_t v : decoded<std::uint32_t>(scene.json[list])) EXPECT_LT(v, base.size()) << list;
    EXPECT_EQ(decoded<std::uint32_t>(scene.json["triangles"]).size() / 3, 20u);  // ten sides of hexahedra
}

TEST(Scene, ASmallBudgetOmitsFramesButKeepsTheFirstAndTheLast) {
    const Decoded scene = scene_of(test::bar_result(9), 1000);
    ASSERT_LT(scene.frames, 9u);
    EXPECT_EQ(scene.json["frames"].front()["step"], 0);
    EXPECT_EQ(scene.json["frames"].back()["step"], 8);
}

TEST(Scene, IsEmptyIfNoFieldsAreStored) {
    const io::Result result = test::bar_result(3, "", io::FieldsPolicy::Keep::none);
    EXPECT_EQ(make_scene(result, post::make_curve(result.model, result.steps), ample).json, "");
}

}  // namespace
}  // namespace soft::view
