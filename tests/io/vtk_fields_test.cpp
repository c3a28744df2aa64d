#include "io/vtk_fields.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "example_case.hpp"
#include "io/hdf5_read.hpp"
#include "io/hdf5_write.hpp"
#include "io/image.hpp"
#include "io/result_file.hpp"

namespace soft::io {
namespace {

using namespace test;
using model::NamedArray;
using Image = std::vector<std::byte>;

Image result_image(int steps) {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    for (int i = 0; i < steps; ++i) writer.append(example_step(i), example_displacement(i), example_pressure(i));
    return writer.finish(example_end());
}

std::vector<double> counted(std::size_t count, double scale) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(scale * static_cast<double>(i) - 0.1);
    return values;
}

struct Arrays {
    NamedArray stress{"cauchy_stress_Pa", "Pa", "force per current area", 9, {}}, J{"J", "1", "volume ratio", 1, {}};
    Arrays() {
        stress.values = counted(9 * section_case().mesh.points.size(), 1e3 / 3);
        J.values = counted(static_cast<std::size_t>(section_case().mesh.cell_count()), 0.7);
    }
};

TEST(VtkFields, AreAddedToTheMeshOfTheCopy) {
    const Arrays arrays;
    const Image copy = with_vtk_fields(result_image(3), "result.h5", {&arrays.stress, 1}, {&arrays.J, 1});
    const FileHandle file = open_memory_copy(split_image(copy, "copy").hdf5);
    const Origin origin{"copy", copy.size()};
    const GroupReader mesh = GroupReader{file.get(), origin}.group("VTKHDF");
    const auto points = static_cast<std::int64_t>(section_case().mesh.points.size());
    EXPECT_EQ(mesh.group("PointData").array<double>("cauchy_stress_Pa", {points, 9}), arrays.stress.values);
    EXPECT_EQ(mesh.group("CellData").array<double>("J", {section_case().mesh.cell_count()}), arrays.J.values);
}

TEST(VtkFields, LeaveEverythingElseUnchanged) {
    const Arrays arrays;
    const Image copy = with_vtk_fields(result_image(3), "result.h5", {&arrays.stress, 1}, {&arrays.J, 1});
    const Result result = read_result(copy, "copy.hdf");
    expect_equal(result.model.mesh, section_case().mesh);
    ASSERT_EQ(result.steps.size(), 3U);
    for (int i = 0; i < 3; ++i) expect_equal(result.steps[static_cast<std::size_t>(i)], example_step(i));
    EXPECT_EQ(result.fields.read(2)->displacement_m, example_displacement(2));
}

TEST(VtkFields, ReplaceTheArraysOfAnEarlierCopy) {
    const Arrays arrays;
    const Image once = with_vtk_fields(result_image(3), "result.h5", {&arrays.stress, 1}, {&arrays.J, 1});
    const Image twice = with_vtk_fields(once, "copy.hdf", {}, {&arrays.J, 1});
    const FileHandle file = open_memory_copy(split_image(twice, "copy").hdf5);
    const Origin origin{"copy", twice.size()};
    EXPECT_TRUE(GroupReader(file.get(), origin).group("VTKHDF").group("PointData").names().empty());
}

TEST(VtkFields, RejectArraysOfAnotherMesh) {
    Arrays arrays;
    arrays.J.values.pop_back();
    EXPECT_THROW(static_cast<void>(with_vtk_fields(result_image(2), "result.h5", {}, {&arrays.J, 1})), Error);
}

TEST(VtkFields, RejectDamagedFilesBeforeHdf5ReadsThem) {
    Image image = result_image(2);
    image[image.size() / 2] ^= std::byte{1};
    EXPECT_THROW(static_cast<void>(with_vtk_fields(image, "result.h5", {}, {})), Error);
}

}  // namespace
}  // namespace soft::io
