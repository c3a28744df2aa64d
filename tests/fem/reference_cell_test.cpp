#include <gtest/gtest.h>

#include <map>

#include "core/error.hpp"
#include "matrix.hpp"

namespace soft::fem {
namespace {

using mesh::CellType;

TEST(ReferenceCell, HasTheDocumentedNumberOfPoints) {
    const std::map<CellType, int> displacement{
        {CellType::triangle3, 3}, {CellType::quad4, 4},     {CellType::tet4, 1},  {CellType::hex8, 8},
        {CellType::wedge6, 6},    {CellType::triangle6, 3}, {CellType::quad9, 9}, {CellType::tet10, 4},
        {CellType::hex27, 27},    {CellType::wedge18, 21}};
    const std::map<CellType, int> mixed{{CellType::triangle6, 7},
                                        {CellType::quad9, 9},
                                        {CellType::tet10, 14},
                                        {CellType::hex27, 27},
                                        {CellType::wedge18, 21}};
    for (const auto& [type, points] : displacement)
        EXPECT_EQ(make_reference_cell(type, Form::displacement).points, points);
    for (const auto& [type, points] : mixed) EXPECT_EQ(make_reference_cell(type, Form::mixed).points, points);
    for (const auto type : {CellType::quad4, CellType::hex8})
        EXPECT_EQ(make_reference_cell(type, Form::f_bar).points, displacement.at(type));
}

TEST(ReferenceCell, RefusesALineAsASolid) {
    for (const auto type : {CellType::line2, CellType::line3})
        for (const auto form : forms) EXPECT_THROW((void)make_reference_cell(type, form), Error);
}

TEST(ReferenceCell, WeightsSumToTheVolumeOfTheReferenceCell) {
    using mesh::Shape;
    const std::map<Shape, double> volume{{Shape::triangle, 0.5},
                                         {Shape::quadrilateral, 4.0},
                                         {Shape::tetrahedron, 1.0 / 6.0},
                                         {Shape::hexahedron, 8.0},
                                         {Shape::wedge, 1.0}};
    for (const auto& c : all_combinations()) {
        double sum = 0;
        for (const double weight : make_reference_cell(c.type, c.form).weight) sum += weight;
        EXPECT_NEAR(sum, volume.at(mesh::topology(c.type).shape), 1e-14) << label(c);
    }
}

}  // namespace
}  // namespace soft::fem
