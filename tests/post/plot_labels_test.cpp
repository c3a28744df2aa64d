#include "post/plot_labels.hpp"

#include <gtest/gtest.h>

namespace soft::post {
namespace {

using Points = std::vector<std::array<double, 2>>;

/// A rising line over the unit square.
Points diagonal() {
    Points points;
    for (int i = 0; i <= 100; ++i) points.push_back({0.01 * i, 0.01 * i});
    return points;
}

std::size_t labels_in(const std::string& commands) {
    std::size_t count = 0;
    for (auto at = commands.find("set label"); at != std::string::npos; at = commands.find("set label", at + 1))
        ++count;
    return count;
}

TEST(PlotLabels, AvoidTheCurve) {
    // There is free space above the top of a parabola, and to the left and right of a steep line.
    Points hat;
    for (int i = -100; i <= 100; ++i) hat.push_back({0.01 * i, -0.0001 * i * i});
    EXPECT_NE(label_commands(std::vector<PlotLabel>{{0, 0, "top"}}, hat).find("graph 0, graph 0.055"),
              std::string::npos);
    Points steep;
    for (int i = 0; i <= 100; ++i) steep.push_back({0.5, 0.01 * i});
    steep.push_back({0, 0.5}), steep.push_back({1, 0.5});
    const std::string side = label_commands(std::vector<PlotLabel>{{0.5, 0.5, "a"}}, steep);
    EXPECT_NE(side.find(", graph 0 noenhanced"), std::string::npos) << side;
}

TEST(PlotLabels, AppearOnceForCoincidentPointsWithTheSameText) {
    const std::vector<PlotLabel> labels{{0.5, 0.5, "19.4 kPa"}, {0.501, 0.5, "19.4 kPa"}, {0.5, 0.5, "19.4 kPa"}};
    EXPECT_EQ(labels_in(label_commands(labels, diagonal())), 1u);
}

TEST(PlotLabels, DoNotOverlap) {
    const std::vector<PlotLabel> near{{0.5, 0.5, "19.40 kPa"}, {0.51, 0.5, "19.41 kPa"}};
    EXPECT_EQ(labels_in(label_commands(near, diagonal())), 2u);  // one above, one elsewhere
    std::vector<PlotLabel> crowd;
    for (int i = 0; i < 20; ++i) crowd.push_back({0.5 + 0.001 * i, 0.5, "19.4" + std::to_string(i) + " kPa"});
    EXPECT_LE(labels_in(label_commands(crowd, diagonal())), 4u);
    EXPECT_GE(labels_in(label_commands(crowd, diagonal())), 2u);
}

TEST(PlotLabels, ArePlacedWithoutACurveToo) {
    EXPECT_EQ(labels_in(label_commands(std::vector<PlotLabel>{{1, 2, "a"}}, {})), 1u);
    EXPECT_EQ(label_commands({}, {}), "");
}

}  // namespace
}  // namespace soft::post
