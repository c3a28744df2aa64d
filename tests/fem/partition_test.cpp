#include "fem/partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample_cases.hpp"

namespace soft::fem {
namespace {

TEST(Partition, GivesEveryPartAboutTheSameNumberOfCells) {
    const auto mesh = box_case(6, false).mesh;
    for (const int parts : {2, 8, 27}) {
        const auto part = partition_cells(mesh, MPI_COMM_WORLD, parts);
        const auto share = static_cast<double>(mesh.cell_count()) / parts;
        for (int p = 0; p < parts; ++p) {
            const auto count = static_cast<double>(std::ranges::count(part, p));
            EXPECT_GT(count, 0.5 * share) << parts;
            EXPECT_LT(count, 1.5 * share) << parts;
        }
    }
}

TEST(Partition, OfOnePartIsTheWholeBody) {
    const auto mesh = box_case(2, false).mesh;
    EXPECT_EQ(partition_cells(mesh, MPI_COMM_WORLD, 1), std::vector<int>(8, 0));
}

}  // namespace
}  // namespace soft::fem
