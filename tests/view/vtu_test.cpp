#include "view/vtu.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <pugixml.hpp>

#include "../fem/block_mesh.hpp"

namespace soft::view {
namespace {

using model::NamedArray;

/// Independent decoder of RFC 4648 for doubles preceded by a byte count.
std::vector<double> decoded(std::string_view text) {
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned buffer = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') break;
        buffer = (buffer << 6) | static_cast<unsigned>(digits.find(c));
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>((buffer >> bits) & 0xFF);
        }
    }
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    EXPECT_EQ(bytes.size(), size + sizeof size);
    std::vector<double> values(size / sizeof(double));
    std::memcpy(values.data(), bytes.data() + sizeof size, size);
    return values;
}

TEST(Vtu, ContainsTheGivenMeshAndArrays) {
    const auto model =
        block_case(mesh::CellType::hex27, model::Kinematics::solid, model::Formulation::displacement, {.n = 2});
    const auto region_points = post::make_region_points(model.mesh);
    NamedArray heights{"z <&> \"m\"", "m", "", 1, {}}, twice{"two", "1", "", 2, {}};
    for (const mesh::Index node : region_points.node) heights.values.push_back(model.mesh.point(node)[2] / 3);
    for (int c = 0; c < 8; ++c) twice.values.insert(twice.values.end(), {1.0 * c, -0.1 * c});
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(vtu_text(model.mesh, region_points, {&heights, 1}, {&twice, 1}).c_str()));
    const auto piece = document.select_node("/VTKFile[@type='UnstructuredGrid']/UnstructuredGrid/Piece").node();
    EXPECT_EQ(piece.attribute("NumberOfPoints").as_int(), 125);
    EXPECT_EQ(piece.attribute("NumberOfCells").as_int(), 8);
    const auto point_array = piece.child("PointData").child("DataArray");
    EXPECT_STREQ(point_array.attribute("Name").as_string(), "z <&> \"m\"");
    EXPECT_EQ(decoded(point_array.text().as_string()), heights.values);
    EXPECT_EQ(decoded(piece.child("CellData").child("DataArray").text().as_string()), twice.values);
    EXPECT_EQ(piece.child("CellData").child("DataArray").attribute("NumberOfComponents").as_int(), 2);
    EXPECT_EQ(decoded(piece.child("Points").child("DataArray").text().as_string()).size(), 375U);
}

TEST(Vtu, ASeriesListsItsFilesWithTheirTimes) {
    const std::array<SeriesEntry, 2> entries{{{0, "a/step-0000.vtu"}, {0.125, "a/step & 1.vtu"}}};
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(pvd_text(entries).c_str()));
    const auto sets = document.select_nodes("/VTKFile[@type='Collection']/Collection/DataSet");
    ASSERT_EQ(sets.size(), 2U);
    EXPECT_STREQ(sets[1].node().attribute("file").as_string(), "a/step & 1.vtu");
    EXPECT_DOUBLE_EQ(sets[1].node().attribute("timestep").as_double(), 0.125);
}

}  // namespace
}  // namespace soft::view
