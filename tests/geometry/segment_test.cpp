// The body with several chambers: volumes in closed form, positions of the chambers, jacket, rejected values; hollowed blocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "dice.hpp"
#include "mesh/quality.hpp"
#include "meshing/capped.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

struct Module {
    int chambers = 3;
    double length = 40, outer = 12, bore = 3, core = 2, wall = 2, web_deg = 30, cap = 3, jacket = 0;  // mm

    [[nodiscard]] double chamber_rad() const { return 2 * pi / chambers - web_deg * pi / 180; }
    [[nodiscard]] double inside() const { return bore + core; }
    [[nodiscard]] double outside() const { return outer - wall; }
    [[nodiscard]] double chamber_mm3() const {
        return 0.5 * chamber_rad() * (outside() * outside() - inside() * inside()) * (length - 2 * cap);
    }
    [[nodiscard]] double rubber_mm3() const {
        return pi * (outer * outer - bore * bore) * length - chambers * chamber_mm3();
    }
    [[nodiscard]] double chamber_mm2() const {  // two curved and two plane sides, two ends
        return (chamber_rad() * (inside() + outside()) + 2 * (outside() - inside())) * (length - 2 * cap) +
               chamber_rad() * (outside() * outside() - inside() * inside());
    }
};

sample::Changes changes_of(const Module& m) {
    const auto mm = [](double value) { return core::number_text(value) + " mm"; };
    return {{"geometry.chambers", std::to_string(m.chambers)},
            {"geometry.length", mm(m.length)},
            {"geometry.outer_radius", mm(m.outer)},
            {"geometry.bore_radius", mm(m.bore)},
            {"geometry.core", mm(m.core)},
            {"geometry.wall", mm(m.wall)},
            {"geometry.web", core::number_text(m.web_deg) + " deg"},
            {"geometry.cap", mm(m.cap)},
            {"geometry.jacket.thickness", mm(m.jacket)}};
}

std::string chamber(int k) { return "chamber_" + std::to_string(k + 1); }

void expect_closed_forms(const Module& m, const Solid& solid, double tolerance) {
    EXPECT_NEAR(1e9 * sample::rubber_m3(solid) / m.rubber_mm3(), 1, tolerance);
    for (int k = 0; k < m.chambers; ++k) {
        EXPECT_NEAR(1e9 * sample::cavity_m3(solid, 0, chamber(k)) / m.chamber_mm3(), 1, tolerance) << k;
        EXPECT_NEAR(1e6 * sample::area_m2(solid, chamber(k)) / m.chamber_mm2(), 1, tolerance) << k;
    }
    for (const char* face : {"fixed", "end"})
        EXPECT_NEAR(1e6 * sample::area_m2(solid, face) / (pi * (m.outer * m.outer - m.bore * m.bore)), 1, tolerance);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "outer") / (2 * pi * m.outer * m.length), 1, tolerance);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "bore") / (2 * pi * m.bore * m.length), 1, tolerance);
}

TEST(Segment, VolumesAndAreasMatch) {
    for (const int chambers : {2, 3, 4}) {
        Module module;
        module.chambers = chambers;
        for (const double jacket : {0.0, 0.5}) {
            module.jacket = jacket;
            expect_closed_forms(module, sample::solid("segment", "solid", changes_of(module)), curved);
        }
        sample::Changes split = changes_of(module);
        split["mesh.cells"] = "simplices";
        expect_closed_forms(module, sample::solid("segment", "solid", split), curved);
    }
}

TEST(Segment, HalfHasTheVolumesAndAreasOfTheWhole) {
    for (const int chambers : {2, 3, 4}) {
        Module module;
        module.chambers = chambers;
        const Solid whole = sample::solid("segment", "solid", changes_of(module)),
                    half = sample::solid("segment", "half", changes_of(module));
        EXPECT_EQ(2 * half.mesh.cell_count(), whole.mesh.cell_count());
        EXPECT_NEAR(sample::rubber_m3(half) / sample::rubber_m3(whole), 1, 1e-12);
        std::vector<std::string> faces{"fixed", "end", "outer", "bore", chamber(0)};
        if (chambers % 2 == 0) faces.push_back(chamber(chambers / 2));
        for (const std::string& face : faces)
            EXPECT_NEAR(sample::area_m2(half, face) / sample::area_m2(whole, face), 1, 1e-12) << face;
        for (int k = 0; k < chambers; ++k)
            EXPECT_EQ(half.mesh.facet_sets.contains(chamber(k)), std::ranges::find(faces, chamber(k)) != faces.end());
        EXPECT_NEAR(sample::cavity_m3(half, 0, chamber(0)) / sample::cavity_m3(whole, 0, chamber(0)), 1, 1e-12);
        for (const mesh::Facet& facet : half.mesh.facet_sets.at("symmetry_y"))
            for (const mesh::Index n : facet_nodes(half.mesh, facet)) EXPECT_EQ(half.mesh.point(n)[1], 0);
    }
}

TEST(Segment, IsCutWhereNothingBreaksTheSymmetry) {
    const auto is_half = [](const std::string& more,
                            const std::string& loads = "cavities: {chamber_1: {pressure: 5 kPa}}", int chambers = 3) {
        const std::string text = "family: segment\ngeometry: {chambers: " + std::to_string(chambers) +
                                 ", jacket: {thickness: 0.5 mm}}\nmaterial: {law: neo-hookean, mu: 0.1 MPa, density: "
                                 "1000 kg/m^3}\nloads: {" +
                                 loads + "}\n" + more;
        return build_case(design::read_design(text, "s.yaml", catalogue_keys(), {})).symmetry_planes[1];
    };
    const std::string one = "cavities: {chamber_1: {pressure: 5 kPa}}";
    EXPECT_TRUE(is_half(""));
    EXPECT_FALSE(is_half("model: solid\n"));
    EXPECT_FALSE(is_half("", "cavities: {chamber_2: {pressure: 5 kPa}}"));
    EXPECT_TRUE(is_half("", "cavities: {chamber_2: {pressure: 5 kPa}}", 2));
    EXPECT_TRUE(is_half("", "cavities: {chamber_1: {pressure: 5 kPa}, chamber_3: {pressure: 3 kPa}}", 4));
    EXPECT_FALSE(is_half("", "cavities: {chamber_1: {pressure: 5 kPa}, chamber_2: {pressure: 5 kPa}}", 4));
    EXPECT_TRUE(is_half("", one + ", gravity: {acceleration: 9.81 m/s^2, along: -z}"));
    EXPECT_FALSE(is_half("", one + ", gravity: {acceleration: 9.81 m/s^2, along: -y}"));
    EXPECT_TRUE(is_half("", one + ", end: {force: 0.1 N, along: z}"));
    EXPECT_FALSE(is_half("", one + ", end: {force: 0.1 N, along: y}"));
    EXPECT_FALSE(is_half("", one + ", end: {displacement: 1 mm, along: y}"));
    EXPECT_FALSE(is_half("obstacles: {table: {plane: {point: [0 mm, 0 mm, -20 mm], normal: [0, 0, 1]}}}\n"));
    EXPECT_FALSE(is_half("outputs: {left: {face: chamber_2, along: x}}\n"));
    EXPECT_FALSE(is_half("outputs: {left: {point: [20 mm, -12 mm, 0 mm], along: x}}\n"));
    EXPECT_FALSE(is_half("supports: {fixed: [fixed, chamber_2]}\n"));
    EXPECT_FALSE(is_half("path: {frequencies: 2}\n"));
    EXPECT_FALSE(is_half("path: {branch: follow}\n"));
    const auto of_fibers = [&](const std::string& families) {
        const design::Override more[] = {{"geometry.jacket.fibers.k1", "1 MPa"},
                                         {"geometry.jacket.fibers.families", families}};
        return build_case(
                   design::read_design("family: segment\ngeometry: {jacket: {thickness: 0.5 mm}}\nmaterial: {law: "
                                       "neo-hookean, mu: 0.1 MPa}\nloads: {" +
                                           one + "}\n",
                                       "s.yaml", catalogue_keys(), more))
            .symmetry_planes[1];
    };
    EXPECT_TRUE(of_fibers("2"));
    EXPECT_FALSE(of_fibers("1"));
}

TEST(Segment, ChambersBesideThePlaneOfAHalfAreNotLoaded) {
    const auto refused = [](const std::string& load) {
        return sample::refusal(
            design::read_design("family: segment\nmodel: half\nmaterial: {law: neo-hookean, mu: 0.1 "
                                "MPa}\nloads: {cavities: {" +
                                    load + ": {pressure: 5 kPa}}}\n",
                                "s.yaml", catalogue_keys(), {}));
    };
    EXPECT_EQ(refused("chamber_1"), "accepted");
    for (const char* beside : {"chamber_2", "chamber_3"})
        EXPECT_NE(refused(beside).find("this model has no face '" + std::string{beside}), std::string::npos);
}

/// The first is centred on z; the others follow at equal angles, in the direction from y toward z.
TEST(Segment, ChambersLieAtTheirAngles) {
    for (const int chambers : {2, 3, 4}) {
        Module module;
        module.chambers = chambers;
        const Solid solid = sample::solid("segment", "solid", changes_of(module));
        for (int k = 0; k < chambers; ++k) {
            const double middle = 0.5 * pi + 2 * pi * k / chambers, half = 0.5 * module.chamber_rad() + 1e-9;
            for (const mesh::Facet& facet : solid.mesh.facet_sets.at(chamber(k)))
                for (const mesh::Index n : facet_nodes(solid.mesh, facet)) {
                    const mesh::Point& p = solid.mesh.point(n);
                    const double along = p[1] * std::cos(middle) + p[2] * std::sin(middle);
                    const double across = -p[1] * std::sin(middle) + p[2] * std::cos(middle);
                    EXPECT_LE(std::abs(std::atan2(across, along)), half);
                    EXPECT_GE(p[0], 3e-3 * (1 - 1e-12));
                    EXPECT_LE(p[0], 37e-3 * (1 + 1e-12));
                }
        }
        EXPECT_FALSE(solid.mesh.facet_sets.contains(chamber(chambers)));
    }
}

TEST(Segment, JacketMayHaveAnotherMaterial) {
    const auto built = [](const std::string& jacket) {
        return build_case(
            design::read_design("family: segment\nmaterial: {law: neo-hookean, mu: 0.1 MPa}\n"
                                "materials: {cloth: {law: neo-hookean, mu: 5 MPa}}\n"
                                "loads: {cavities: {chamber_2: {pressure: 5 kPa}}}\ngeometry: {jacket: " +
                                    jacket + "}\n",
                                "s.yaml", catalogue_keys(), {}));
    };
    const model::Case dressed = built("{thickness: 0.5 mm, material: cloth}");
    ASSERT_EQ(dressed.materials.size(), 2u);
    for (const model::Material& material : dressed.materials)
        EXPECT_EQ(material.constants.at("mu").at(0), material.name == "jacket" ? 5e6 : 0.1e6);
    const double outer_m = 12e-3, inner_m = 11.5e-3;
    double volume_m3 = 0;
    const mesh::Mesh& mesh = dressed.mesh;
    for (mesh::Index c = 0; c < mesh.cell_count(); ++c)
        if (mesh.region_names[static_cast<std::size_t>(mesh.cell_regions[static_cast<std::size_t>(c)])] == "jacket")
            for (const mesh::QuadraturePoint& point : mesh::volume_rule(mesh.cell_type(c)))
                volume_m3 +=
                    point.weight * mesh::map_cell(mesh, c, mesh::shape_values(mesh.cell_type(c), point.xi)).determinant;
    EXPECT_NEAR(volume_m3 / (pi * (outer_m * outer_m - inner_m * inner_m) * 40e-3), 1, curved);
    EXPECT_THROW((void)built("{thickness: 0 mm, material: rubber}"), Error);  // cloth is unused
}

TEST(Segment, FibresLieOnlyInTheJacket) {
    const auto design = [](const std::string& jacket) {
        return design::read_design(
            "family: segment\nmaterial: {law: neo-hookean, mu: 0.1 MPa}\n"
            "loads: {cavities: {chamber_2: {pressure: 5 kPa}}}\ngeometry: {jacket: " +
                jacket + "}\n",
            "s.yaml", catalogue_keys(), {});
    };
    const model::Case wound = build_case(design("{thickness: 0.5 mm, fibers: {angle: 80 deg, k1: 2 MPa, k2: 3}}"));
    for (const model::Material& material : wound.materials) {
        ASSERT_EQ(material.fibers.has_value(), material.name == "jacket");
        if (!material.fibers) continue;
        EXPECT_EQ(*material.fibers, (model::Fibers{pi * 80 / 180, 2e6, 3, 2}));
        EXPECT_EQ(material.fiber_frame, model::FiberFrame::cylindrical);
    }
    for (const model::Material& material : build_case(design("{thickness: 0.5 mm}")).materials)
        EXPECT_FALSE(material.fibers);
    EXPECT_EQ(sample::refusal(design("{fibers: {k1: 2 MPa}}")),
              "s.yaml:4:34: geometry.jacket.fibers.k1: the fibres need a jacket; use jacket.thickness above 0");
}

TEST(Segment, UnknownChamberIsRejected) {
    const auto refused = [](const std::string& chambers, const std::string& load) {
        return sample::refusal(
            design::read_design("family: segment\nmaterial: {law: neo-hookean, mu: 0.1 MPa}\n"
                                "geometry: {chambers: " +
                                    chambers +
                                    "}\n"
                                    "loads: {cavities: {" +
                                    load + ": {pressure: 5 kPa}}}\n",
                                "s.yaml", catalogue_keys(), {}));
    };
    EXPECT_EQ(refused("4", "chamber_4"), "accepted");
    EXPECT_NE(refused("3", "chamber_4").find("this model has no face 'chamber_4'"), std::string::npos);
}

TEST(Segment, RandomSegmentsHaveValidCells) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Dice draw{seed};
        Module m;
        m.chambers = 2 + static_cast<int>(seed % 3);
        m.bore = draw(0.5, 8);
        m.core = draw(0.3, 4);
        const double depth = draw(0.5, 8);
        m.wall = draw(0.3, 4);
        m.outer = std::round(1000 * (m.bore + m.core + depth + m.wall)) / 1000;
        m.web_deg = draw(3, 360.0 / m.chambers - 10);
        m.cap = draw(0.5, 8);
        m.length = 2 * m.cap + draw(2, 60);
        m.jacket = seed % 2 == 0 ? 0 : draw(0.1, 0.9) * m.wall;
        const Solid solid = sample::solid("segment", "solid", changes_of(m));
        expect_closed_forms(m, solid, 1e-3);  // arcs of up to 60 degrees per cell
        EXPECT_GT(mesh::quality(solid.mesh).min_scaled_jacobian, 0.1) << seed;
    }
}

TEST(Segment, InconsistentValuesAreRejectedWithTheirBound) {
    sample::expect_refusals(
        "segment", "solid",
        {{"wall", "7 mm",
          "7 mm leaves no chamber between core and wall; use a value below 7 mm = outer_radius - bore_radius - core"},
         {"cap", "20 mm", "20 mm is not smaller than half the length (20 mm); use a value below 20 mm"},
         {"jacket.thickness", "2 mm", "2 mm is not smaller than wall (2 mm); use a value below 2 mm"},
         {"web", "120 deg", "it leaves no angle for the chambers; use a value below 120 deg"}});
}

TEST(Hollowed, RemovesCellsAndNamesTheExposedFacets) {
    const Solid bar =
        sample::solid("rod", "solid", {{"mesh.size", "10 mm"}, {"geometry.length", "30 mm"}});  // three cells in a row
    ASSERT_EQ(bar.mesh.cell_count(), 3);
    const auto middle = [&](mesh::Index cell) {
        double x = 0;
        for (const mesh::Index n : bar.mesh.cell_nodes(cell)) x += bar.mesh.point(n)[0] / 27;
        return std::abs(x - 15e-3) < 1e-9 ? std::string{"hole"} : std::string{};
    };
    const mesh::Mesh rest = meshing::hollowed(bar.mesh, middle);
    EXPECT_EQ(rest.cell_count(), 2);
    EXPECT_EQ(rest.points.size(), std::size_t{2 * 27});
    EXPECT_NEAR(mesh::measure(rest, mesh::Measure::plain), 2e-6, 1e-18);
    EXPECT_EQ(rest.facet_sets.at("hole").size(), 2u);
    EXPECT_EQ(rest.facet_sets.at("top").size(), 2u);
    EXPECT_EQ(rest.facet_sets.at("fixed").size(), 1u);
    const auto boundary = mesh::boundary_facets(rest);
    EXPECT_EQ(boundary.size(), 12u);
    for (const mesh::Facet& facet : rest.facet_sets.at("hole"))
        for (const mesh::Index n : facet_nodes(rest, facet))
            EXPECT_NEAR(std::abs(rest.point(n)[0] - 15e-3), 5e-3, 1e-12);
}

}  // namespace
}  // namespace soft::geometry
