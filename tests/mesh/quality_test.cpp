#include <gtest/gtest.h>

#include "blocks.hpp"
#include "mesh/quality.hpp"

namespace soft::mesh {
namespace {

TEST(Quality, IsOneForAParallelepiped) {
    for (const CellType type :
         {CellType::quad9, CellType::triangle6, CellType::hex27, CellType::wedge18, CellType::tet10}) {
        Mesh mesh = sample::reference_cell(type);
        for (Point& p : mesh.points) p = {3 * p[0] + p[1], 0.2 * p[1], p[2] + p[0]};
        EXPECT_NEAR(quality(mesh).min_scaled_jacobian, 1, 1e-13) << topology(type).name;
    }
}

TEST(Quality, IsZeroAndRejectedForAFlatCorner) {
    Mesh mesh = sample::reference_cell(CellType::quad4);
    mesh.points[2] = {0, 0, 0};  // on the diagonal between its neighbours
    EXPECT_THROW((void)quality(mesh), Error);
}

/// A trapezoid with parallel sides 2 and 1: the determinant is linear between them.
TEST(Quality, IsTheQuotientOfMinimumAndMaximumDeterminant) {
    Mesh mesh = sample::row_of(CellType::quad4, 2);
    for (Point& p : mesh.points)
        if (p[0] > 2) p[1] *= 0.5;
    const Quality found = quality(mesh);
    EXPECT_NEAR(found.min_scaled_jacobian, 0.5, 1e-14);
    EXPECT_NEAR(found.mean_scaled_jacobian, 0.75, 1e-14);
    EXPECT_EQ(found.worst_cell, 1);
    EXPECT_EQ(found.worst_position_m[0], 3);
}

TEST(Quality, RejectsAnInvertedCellAndReportsItsPosition) {
    Mesh mesh = sample::row_of(CellType::hex27, 2);
    for (Point& p : mesh.points)
        if (p[0] > 1.5) p[0] = 1 - 0.25 * (p[0] - 1);  // the second cell folded back into the first
    try {
        (void)quality(mesh);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_NE(std::string{error.what()}.find("cell 1 is inverted at ("), std::string::npos) << error.what();
    }
}

TEST(Quality, RejectsAMirroredMesh) {
    Mesh mesh = sample::reference_cell(CellType::tet10);
    for (Point& p : mesh.points) p[0] = -p[0];
    EXPECT_THROW((void)quality(mesh), Error);
}

}  // namespace
}  // namespace soft::mesh
