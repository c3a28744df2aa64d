#include <gtest/gtest.h>

#include <vector>

#include "geometry/bellows_shape.hpp"
#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

/// Closed form of the volume swept by a meridian of lines and arcs: V = pi (integral of r^2 dx). Lengths in mm.
/// Independent of the code: the tangent follows from angles here, from projections in the code.
struct Meridian {
    double pitch = 9.25, crest = 19, bore = 2.5, wall = 3, fillet = 0.25;
    double crest_land = 0, trough_land = 0, last_crest = 19;
    double disc_length = 6, disc_radius = 14.5, neck_length = 1, neck_radius = 7;
    int convolutions = 10;

    /// Volume enclosed by the inner face of the wall from the first to the last trough, and by the bore through the inlet disc.
    [[nodiscard]] double cavity() const {
        double sum = pi * bore * bore * (disc_length + (convolutions - 1) * trough_land);
        for (int i = 0; i < convolutions; ++i) {
            const Meridian m = with_crest(i);
            sum += 2 * m.half(fillet + wall, fillet, m.bend()) + pi * (m.crest - wall) * (m.crest - wall) * crest_land;
        }
        return sum;
    }

    /// The outer envelope minus the cavity.
    [[nodiscard]] double rubber() const {
        double walls = pi * (bore + wall) * (bore + wall) * (convolutions - 1) * trough_land;
        for (int i = 0; i < convolutions; ++i) {
            const Meridian m = with_crest(i);
            walls += 2 * m.half(fillet, fillet + wall, m.bend()) + pi * m.crest * m.crest * crest_land;
        }
        return walls + end() + with_crest(convolutions - 1).end() - cavity();
    }

    /// x of the point where the outer wall meets the neck, from the trough.
    [[nodiscard]] double neck_corner() const {
        const double b = bend(), foot_x = fillet * std::sin(b), foot_r = trough() - fillet * std::cos(b);
        return foot_x + (neck_radius - foot_r) * std::cos(b) / std::sin(b);
    }

    // Parts of the sums.
    [[nodiscard]] Meridian with_crest(int convolution) const {
        Meridian m = *this;
        if (convolutions > 1) m.crest += (last_crest - crest) * convolution / (convolutions - 1);
        return m;
    }
    /// Volume of disc and neck outside the wall, between its corner and the trough.
    [[nodiscard]] double end() const {
        return pi * disc_radius * disc_radius * (disc_length - neck_length + neck_corner()) +
               pi * neck_radius * neck_radius * neck_length - outer_to_neck();
    }
    [[nodiscard]] double half_pitch() const { return 0.5 * (pitch - crest_land - trough_land); }
    [[nodiscard]] double trough() const { return bore + fillet + wall; }
    [[nodiscard]] double rise() const { return crest - bore - 2 * (fillet + wall); }

    /// Angle between the straight wall and the axis: that of the line of centres plus that of the inner tangent.
    [[nodiscard]] double bend() const {
        return std::atan2(rise(), half_pitch()) + std::asin((2 * fillet + wall) / std::hypot(rise(), half_pitch()));
    }

    static double line(double x0, double r0, double x1, double r1) {
        return pi * (x1 - x0) * (r0 * r0 + r0 * r1 + r1 * r1) / 3;
    }

    /// Along r = centre - s radius cos t, x = radius sin t, t = 0 .. angle: s = 1 below the centre, -1 above.
    static double arc(double centre, double radius, double s, double angle) {
        const double c1 = std::sin(angle), c2 = 0.5 * (angle + std::sin(angle) * std::cos(angle));
        const double c3 = std::sin(angle) - std::pow(std::sin(angle), 3) / 3;
        return pi * radius * (centre * centre * c1 - 2 * s * centre * radius * c2 + radius * radius * c3);
    }

    /// Trough arc, straight line and crest arc of half a convolution.
    [[nodiscard]] double half(double trough_radius, double crest_radius, double angle) const {
        const double top = trough() + rise();
        return arc(trough(), trough_radius, 1, angle) +
               line(trough_radius * std::sin(angle), trough() - trough_radius * std::cos(angle),
                    half_pitch() - crest_radius * std::sin(angle), top + crest_radius * std::cos(angle)) +
               arc(top, crest_radius, -1, angle);
    }

    /// Volume below the outer wall, from the trough to the corner of the neck.
    [[nodiscard]] double outer_to_neck() const {
        const double b = bend();
        return arc(trough(), fillet, 1, b) +
               line(fillet * std::sin(b), trough() - fillet * std::cos(b), neck_corner(), neck_radius);
    }
};

TEST(Bellows, ClosedFormGivesThePublishedVolumes) {
    EXPECT_NEAR(Meridian{}.rubber(), 70285.1, 0.25);  // published with six digits, from an outline of chords
    EXPECT_NEAR(Meridian{}.cavity(), 14962.7, 0.15);
}

TEST(Bellows, NeckCornersMatchThePaper) {
    const BellowsShape shape = shape_of(sample::values("bellows", "axisymmetric"));
    EXPECT_NEAR(9 * 9.25 - 1e3 * shape.neck_corner[0], 82.8605, 5e-5);  // the last trough is at 83.25
    EXPECT_NEAR(-9.25 + 1e3 * shape.disc_corner[0], -9.8605, 5e-5);
}

class BellowsModel : public testing::TestWithParam<const char*> {};

TEST_P(BellowsModel, VolumesMatchTheClosedForm) {
    // The default mesh has two quadratic edges in a bend of 84 degrees.
    for (const char* cells : {"auto", "simplices"}) {
        const Solid solid = sample::solid("bellows", GetParam(), {{"mesh.cells", cells}});
        EXPECT_NEAR(1e9 * sample::rubber_m3(solid) / Meridian{}.rubber(), 1, 4e-4) << cells;
        EXPECT_NEAR(1e9 * sample::cavity_m3(solid) / Meridian{}.cavity(), 1, 2e-4) << cells;
    }
}

INSTANTIATE_TEST_SUITE_P(Bellows, BellowsModel, testing::Values("axisymmetric", "solid", "half", "quarter"),
                         [](const auto& test) { return std::string{test.param}; });

TEST(Bellows, VolumesConvergeToTheClosedForm) {
    const Solid fine = sample::solid("bellows", "axisymmetric", {{"mesh.size", "0.2 mm"}});
    EXPECT_NEAR(1e9 * sample::rubber_m3(fine) / Meridian{}.rubber(), 1, 1e-7);
    EXPECT_NEAR(1e9 * sample::cavity_m3(fine) / Meridian{}.cavity(), 1, 1e-7);
}

TEST(Bellows, WallHasConstantThickness) {
    const BellowsShape shape = shape_of(sample::values("bellows", "axisymmetric"));
    const meshing::PlanePoint inner = shape.on_wall(shape.cavity_offset_m(), 0.5 * shape.straight_m);
    const meshing::PlanePoint outer = shape.on_wall(shape.outer_offset_m(), 0.5 * shape.straight_m);
    EXPECT_NEAR(std::hypot(outer[0] - inner[0], outer[1] - inner[1]), 3e-3, 1e-15);
    // The straight part ends at the crest arc, at its radius from the centre.
    const meshing::PlanePoint top = shape.on_wall(shape.cavity_offset_m(), shape.straight_m);
    EXPECT_NEAR(std::hypot(top[0] - 0.5 * shape.pitch_m, top[1] - shape.crest_centre_m), 0.25e-3, 1e-15);
}

TEST(Bellows, StripVolumeIsProportionalToItsAngle) {
    for (const char* model : {"half", "solid"}) {
        const Solid whole = sample::solid("bellows", model, {{"geometry.convolutions", "2"}});
        Solid body =
            sample::solid("bellows", model, {{"geometry.convolutions", "2"}, {"geometry.strip.angle", "72 deg"}});
        ASSERT_EQ(body.mesh.region_names, (std::vector<std::string>{"rubber", "strip"}));
        mesh::Mesh strip = body.mesh;
        strip.cell_types.clear();
        strip.offsets = {0};
        strip.connectivity.clear();
        strip.cell_regions.clear();
        for (mesh::Index cell = 0; cell < body.mesh.cell_count(); ++cell)
            if (body.mesh.cell_regions[static_cast<std::size_t>(cell)] == 1) {
                add_cell(strip, body.mesh.cell_type(cell), body.mesh.cell_nodes(cell), 1);
                double z = 0;
                for (const mesh::Index node : body.mesh.cell_nodes(cell)) z += body.mesh.point(node)[2];
                EXPECT_LT(z, 0);
            }
        EXPECT_NEAR(mesh::measure(strip, mesh::Measure::plain) / mesh::measure(whole.mesh, mesh::Measure::plain), 0.2,
                    1e-12);
    }
}

TEST(Bellows, LandsOfMaximumLengthGiveUprightWalls) {
    const BellowsShape shape = shape_of(sample::values(
        "bellows", "axisymmetric",
        {{"geometry.pitch", "16 mm"}, {"geometry.crest_land", "4.5 mm"}, {"geometry.trough_land", "4.5 mm"}}));
    EXPECT_NEAR(shape.bend_rad, 0.5 * pi, 1e-12);
    EXPECT_NEAR(shape.along[0], 0, 1e-12);
}

TEST(Bellows, FacesHaveTheExpectedAreas) {
    const Solid solid = sample::solid("bellows", "axisymmetric");
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "fixed"), pi * 14.5 * 14.5, 1e-9);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "inlet"), pi * (14.5 * 14.5 - 2.5 * 2.5), 1e-9);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "cavity_end"), pi * 2.5 * 2.5, 1e-9);
    double lowest = 1, highest = -1;
    for (const mesh::Point& p : solid.mesh.points) {
        lowest = std::min(lowest, p[0]);
        highest = std::max(highest, p[0]);
    }
    EXPECT_NEAR(1e3 * lowest, -15.25, 1e-12);
    EXPECT_NEAR(1e3 * highest, 89.25, 1e-12);
}

/// Other proportions within the admissible ranges give valid cells and the correct volume.
TEST(Bellows, OtherShapesHaveValidCellsAndVolumes) {
    struct Other {
        std::map<std::string, std::string> values;  // below geometry
        Meridian meridian;
    };
    std::vector<Other> others{
        {{{"convolutions", "1"}}, {.convolutions = 1}},
        {{{"pitch", "14 mm"}, {"fillet", "1.5 mm"}}, {.pitch = 14, .fillet = 1.5}},
        {{{"neck.radius", "12 mm"}, {"neck.length", "2 mm"}}, {.neck_length = 2, .neck_radius = 12}},
        {{{"neck.radius", "5.8 mm"}, {"neck.length", "0.5 mm"}}, {.neck_length = 0.5, .neck_radius = 5.8}},
        {{{"wall", "1 mm"}, {"bore_radius", "4 mm"}}, {.bore = 4, .wall = 1}},        // overhanging wall
        {{{"pitch", "7 mm"}, {"crest_radius", "12 mm"}}, {.pitch = 7, .crest = 12}},  // overhanging the neck
        // Square convolutions (upright walls), rounded ones (with a short straight wall), a taper, and all combined.
        {{{"pitch", "16 mm"}, {"crest_land", "4.5 mm"}, {"trough_land", "4.5 mm"}, {"convolutions", "3"}},
         {.pitch = 16, .crest_land = 4.5, .trough_land = 4.5, .convolutions = 3}},
        {{{"pitch", "14 mm"},
          {"fillet", "2.5 mm"},
          {"wall", "2 mm"},
          {"crest_radius", "14 mm"},
          {"neck.radius", "8.5 mm"}},
         {.pitch = 14, .crest = 14, .wall = 2, .fillet = 2.5, .neck_radius = 8.5}},
        {{{"last_crest_radius", "12 mm"}}, {.last_crest = 12}},
        {{{"last_crest_radius", "25 mm"}, {"crest_land", "1 mm"}, {"trough_land", "0.5 mm"}, {"pitch", "11 mm"}},
         {.pitch = 11, .crest_land = 1, .trough_land = 0.5, .last_crest = 25}}};
    for (Other& other : others) {
        if (!other.values.contains("last_crest_radius")) other.meridian.last_crest = other.meridian.crest;
        const std::string what = other.values.begin()->first + " " + other.values.begin()->second;
        other.values.insert({{"fillet", "0.25 mm"},
                             {"end_disc.length", "6 mm"},
                             {"end_disc.radius", "14.5 mm"},
                             {"neck.length", "1 mm"},
                             {"neck.radius", "7 mm"}});  // the values of the closed form, unless given
        sample::Changes changes;
        for (const auto& [key, value] : other.values) changes["geometry." + key] = value;
        EXPECT_GT(mesh::quality(sample::solid("bellows", "axisymmetric", changes).mesh).min_scaled_jacobian, 0.05)
            << what;
        EXPECT_GT(mesh::quality(sample::solid("bellows", "quarter", changes).mesh).min_scaled_jacobian, 0.05) << what;
        changes["mesh.size"] = "0.3 mm";
        const Solid fine = sample::solid("bellows", "axisymmetric", changes);
        EXPECT_NEAR(1e9 * sample::rubber_m3(fine) / other.meridian.rubber(), 1, 1e-5) << what;
        EXPECT_NEAR(1e9 * sample::cavity_m3(fine) / other.meridian.cavity(), 1, 1e-5) << what;
    }
}

}  // namespace
}  // namespace soft::geometry
