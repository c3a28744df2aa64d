#include <gtest/gtest.h>

#include <cmath>

#include "contact/potential.hpp"
#include "contact_samples.hpp"

namespace soft::contact {
namespace {

/// A flat surface that becomes a sharp ridge: each side is behind the other, with rubber between them. In a fold that has closed too far they are
/// behind each other too, but each has passed through the other.
TEST(Ridge, ItsSidesDoNotTouchEachOther) {
    for (const auto cells : test::all_cells)
        for (const auto kinematics : {model::Kinematics::plane_strain, model::Kinematics::solid}) {
            const int dimension = kinematics == model::Kinematics::solid ? 3 : 2;
            const auto strip = test::block(dimension, test::box({-1, 1}, {-1, 0}, {0, 1}), {2, 1, 1}, "strip");
            model::Case model = test::make_case(test::as(cells, strip), kinematics);
            model.mesh.region_names = {"rubber"};
            model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
            model.path.contact = model::Contact::solve;
            const auto touches = [&](double width, double deeper, double height) {
                auto positions = model.mesh.points;
                for (mesh::Point& x : positions)
                    x = {x[0] * (width - deeper * x[1]), x[1] + height * std::abs(x[0]), x[2]};
                return Potential(model, std::array{1e6}).touches(positions, {}, [](mesh::Index) { return true; });
            };
            EXPECT_FALSE(touches(0.5, 0, -2)) << test::cells_name(cells);
            EXPECT_FALSE(touches(0.3, 0, -2)) << test::cells_name(cells);
            EXPECT_FALSE(touches(0.3, 0.7, 2)) << test::cells_name(cells);
            EXPECT_TRUE(touches(-0.02, 1.02, 2)) << test::cells_name(cells);
        }
}

}  // namespace
}  // namespace soft::contact
