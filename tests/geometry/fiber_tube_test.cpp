#include <gtest/gtest.h>

#include "core/text.hpp"
#include "dice.hpp"
#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

design::Design fiber_design(const std::string& geometry, const std::string& rest = "") {
    const bool own = rest.find("material:") != std::string::npos;
    const std::string text = "family: fiber-tube\ngeometry: {" + geometry + "}\n" +
                             (own ? "" : "material: {law: neo-hookean, mu: 0.1644 MPa}\n") + rest +
                             "loads: {cavity: {pressure: 30 kPa}}\n";
    return design::read_design(text, "d.yaml", catalogue_keys(), {});
}

/// The error message for a design, from its text or its values; or "accepted".
std::string refusal_of(const std::string& geometry, const std::string& rest = "") {
    try {
        return sample::refusal(fiber_design(geometry, rest));
    } catch (const Error& error) {
        return error.what();
    }
}

/// Volume of a region, whole actuator.
double region_m3(const model::Case& c, const std::string& region) {
    mesh::Mesh part;
    part.dimension = c.mesh.dimension;
    part.points = c.mesh.points;
    for (mesh::Index cell = 0; cell < c.mesh.cell_count(); ++cell) {
        const std::int32_t own = c.mesh.cell_regions[static_cast<std::size_t>(cell)];
        if (c.mesh.region_names[static_cast<std::size_t>(own)] == region)
            mesh::add_cell(part, c.mesh.cell_type(cell), c.mesh.cell_nodes(cell), own);
    }
    const bool turned = c.kinematics == model::Kinematics::axisymmetric;
    return mesh::measure(part, turned ? mesh::Measure::revolved : mesh::Measure::plain) / c.model_fraction;
}

const model::Material& material_of(const model::Case& c, const std::string& region) {
    return *std::ranges::find(c.materials, region, &model::Material::name);
}

/// Wall from 7 to 10 mm, 100 mm long.
TEST(FiberTube, LayerVolumeMatchesItsPartOfTheWall) {
    constexpr double curved = 1.5e-4;  // error of quadratic edges on a circle: fourth power of their angle
    for (const char* model : {"axisymmetric", "quarter"})
        for (const auto& [layer, inner_mm, outer_mm] : {std::tuple{"[0, 1]", 7.0, 10.0},
                                                        {"[0.25, 0.5]", 7.75, 8.5},
                                                        {"[0, 0.3]", 7.0, 7.9},
                                                        {"[0.9, 1]", 9.7, 10.0}}) {
            const auto c = build_case(
                fiber_design(std::string{"fibers: {layer: "} + layer + "}", std::string{"model: "} + model + "\n"));
            const double ring_m3 = 1e-6 * pi * (outer_mm * outer_mm - inner_mm * inner_mm) * 0.1;
            EXPECT_NEAR(region_m3(c, "fibers") / ring_m3, 1, curved) << model << layer;
            const double rubber_m3 = pi * (1e-4 * 0.1 - 0.49e-4 * 0.09);
            EXPECT_NEAR((region_m3(c, "fibers") + region_m3(c, "rubber")) / rubber_m3, 1, curved) << model << layer;
        }
}

/// Wall from 7 to 10 mm, 100 mm long, caps of 5 mm: between the caps the layer is 90 mm long, in round and half-round tubes.
TEST(FiberTube, PlainCapsContainNoFibres) {
    constexpr double curved = 1.5e-4;
    for (const char* model : {"axisymmetric", "quarter"}) {
        const auto c = build_case(fiber_design("fibers: {caps: false}", std::string{"model: "} + model + "\n"));
        EXPECT_NEAR(region_m3(c, "fibers") / (1e-6 * pi * (100 - 49) * 0.09), 1, curved) << model;
    }
    const auto whole = build_case(fiber_design("flat: 2 mm", "model: half\n"));
    const auto plain = build_case(fiber_design("flat: 2 mm, fibers: {caps: false}", "model: half\n"));
    for (const char* region : {"fibers", "fibers_flat"})
        EXPECT_NEAR(region_m3(plain, region) / region_m3(whole, region), 0.9, 1e-12) << region;
}

TEST(FiberTube, FibresLieOnlyInTheLayer) {
    const auto c =
        build_case(fiber_design("fibers: {angle: 60 deg, families: 2, k1: 0.2 MPa, k2: 1.5, layer: [0.2, 0.8]}",
                                "materials: {fibers: {law: yeoh, c1: 30 kPa}}\n"));
    const model::Material& layer = material_of(c, "fibers");
    ASSERT_TRUE(layer.fibers.has_value());
    EXPECT_NEAR(layer.fibers->angle_rad, pi / 3, 1e-15);
    EXPECT_EQ(layer.fibers->k1_Pa, 2e5);
    EXPECT_EQ(layer.fibers->k2, 1.5);
    EXPECT_EQ(layer.fibers->families, 2);
    EXPECT_EQ(layer.fiber_frame, model::FiberFrame::cylindrical);
    EXPECT_EQ(layer.law, "yeoh");
    EXPECT_FALSE(material_of(c, "rubber").fibers.has_value());
    EXPECT_EQ(material_of(c, "rubber").law, "neo-hookean");
}

TEST(FiberTube, OneFamilyRequiresTheWholeSolid) {
    const std::string one = "fibers: {families: 1}";
    EXPECT_EQ(refusal_of(one),
              "d.yaml:2:31: geometry.fibers.families: one family of fibres twists the actuator, which "
              "model: axisymmetric cannot represent; use families: 2 or model: solid");
    for (const char* cut : {"half", "quarter"})
        EXPECT_EQ(
            refusal_of(one, std::string{"model: "} + cut + "\n"),
            "d.yaml:2:31: geometry.fibers.families: one family of fibres has no mirror symmetry, but the model is cut "
            "at symmetry planes; use families: 2 or model: solid");
    EXPECT_EQ(refusal_of(one, "model: solid\n"), "accepted");
    for (const char* straight : {"0 deg", "90 deg"})  // along the axis, or hoops
        EXPECT_EQ(refusal_of(std::string{"fibers: {families: 1, angle: "} + straight + "}"), "accepted");
}

TEST(FiberTube, RejectsValuesOutOfRange) {
    const auto begins = [](const std::string& text, const std::string& start) {
        EXPECT_TRUE(text.starts_with(start)) << text;
    };
    begins(refusal_of("fibers: {angle: 91 deg}"), "d.yaml:2:28: geometry.fibers.angle: 91 deg is ");
    begins(refusal_of("fibers: {angle: -1 deg}"), "d.yaml:2:28: geometry.fibers.angle: -1 deg is ");
    begins(refusal_of("fibers: {angle: 30}"), "d.yaml:2:28: geometry.fibers.angle: ");
    begins(refusal_of("fibers: {families: 3}"), "d.yaml:2:31: geometry.fibers.families: 3 is ");
    begins(refusal_of("fibers: {families: 0}"), "d.yaml:2:31: geometry.fibers.families: 0 is ");
    begins(refusal_of("fibers: {k1: 0 MPa}"), "d.yaml:2:25: geometry.fibers.k1: 0 MPa is ");
    begins(refusal_of("fibers: {k2: 0}"), "d.yaml:2:25: geometry.fibers.k2: 0 is ");
    begins(refusal_of("fibers: {layer: [0, 1.2]}"), "d.yaml:2:32: geometry.fibers.layer: 1.2 is ");
    begins(refusal_of("fibers: {layer: [-0.1, 1]}"), "d.yaml:2:29: geometry.fibers.layer: -0.1 is ");
    begins(refusal_of("fibers: {layer: [0, 0.5, 1]}"), "d.yaml:2:28: geometry.fibers.layer: 3 values are too many");
    begins(refusal_of("fibers: {pitch: 5 mm}"), "d.yaml:2:21: geometry.fibers.pitch: unknown key");
}

TEST(FiberTube, RejectsEmptyLayers) {
    const std::string location = "d.yaml:2:28: geometry.fibers.layer: ",
                      pair = "; use [inner, outer] with inner below outer";
    EXPECT_EQ(refusal_of("fibers: {layer: 0.5}"),
              location + "1 value, but two are needed; use [inner, outer], such as [0, 1]");
    EXPECT_EQ(refusal_of("fibers: {layer: [0.7, 0.3]}"),
              location + "the layer from 0.7 to 0.3 is empty or runs inwards" + pair);
    EXPECT_EQ(refusal_of("fibers: {layer: [0.5, 0.5]}"),
              location + "the layer from 0.5 to 0.5 is empty or runs inwards" + pair);
    EXPECT_EQ(refusal_of("fibers: {layer: [0.001, 1]}"),
              location + "a part of the wall has 0.001 of its thickness; use 0, or at least 0.01");
}

TEST(FiberTube, RejectsLawsThatCannotBeCombinedWithFibres) {
    EXPECT_EQ(
        refusal_of("", "material: {law: kraken, mu: 0.1 MPa, kappa: 10 MPa}\nmesh: {formulation: displacement}\n"),
        "d.yaml:3:17: material.law: fibers: the law kraken has no finite-strain energy to which fibres can be added; "
        "use neo-hookean, for example");
    EXPECT_EQ(
        refusal_of("",
                   "materials: {fibers: {law: holzapfel-gasser-ogden, mu: 0.1 MPa, k1: 1 MPa, k2: 1, angle: 1 deg}}\n"),
        "d.yaml:4:27: materials.fibers.law: fibers: the law holzapfel-gasser-ogden already has fibres; "
        "use a law without fibres");
}

/// Outer radius 10 mm, inner 7 mm, 100 mm long with caps of 5 mm, the flat wall 4 mm thick.
constexpr double half_disc_mm2 = 0.5 * pi * 100, hole_mm2 = 0.5 * pi * 49, slab_mm2 = 20 * 4;

TEST(FiberTube, HalfRoundTubeHasTheVolumesAndAreasOfItsSection) {
    for (const char* model : {"half", "solid"})
        for (const auto& [layer, begin, end] :
             {std::tuple{"[0, 1]", 0.0, 1.0}, {"[0.25, 0.5]", 0.25, 0.5}, {"[0.5, 1]", 0.5, 1.0}}) {
            const design::Design d = fiber_design(std::string{"flat: 4 mm, fibers: {layer: "} + layer + "}",
                                                  std::string{"model: "} + model + "\n");
            const auto c = build_case(d);
            const Solid solid{c.mesh, c.kinematics, c.symmetry_planes, c.model_fraction};
            constexpr double curved = 2e-5;
            EXPECT_NEAR(1e9 * sample::rubber_m3(solid) / ((half_disc_mm2 + slab_mm2) * 100 - hole_mm2 * 90), 1, curved);
            EXPECT_NEAR(1e9 * sample::cavity_m3(solid) / (hole_mm2 * 90), 1, curved);
            EXPECT_NEAR(1e6 * sample::area_m2(solid, "cavity") / ((7 * pi + 14) * 90 + 2 * hole_mm2), 1, curved);
            EXPECT_NEAR(1e6 * sample::area_m2(solid, "outer") / ((10 * pi + 2 * 4) * 100), 1, curved);
            EXPECT_NEAR(1e6 * sample::area_m2(solid, "bottom") / (20 * 100), 1, 1e-12);
            for (const char* face : {"fixed", "inlet"})
                EXPECT_NEAR(1e6 * sample::area_m2(solid, face) / (half_disc_mm2 + slab_mm2), 1, curved);
            // The layer: half a ring, two legs down into the flat wall, and the part that crosses the flat wall.
            const double from = 7 + 3 * begin, to = 7 + 3 * end;
            const double ring_mm2 = 0.5 * pi * (to * to - from * from), legs_mm2 = 2 * (to - from) * 4 * begin;
            EXPECT_NEAR(1e9 * region_m3(c, "fibers") / ((ring_mm2 + legs_mm2) * 100), 1, curved) << layer;
            EXPECT_NEAR(1e9 * region_m3(c, "fibers_flat") / (2 * to * 4 * (end - begin) * 100), 1, curved) << layer;
            EXPECT_EQ(material_of(c, "fibers").fiber_frame, model::FiberFrame::cylindrical);
            EXPECT_EQ(material_of(c, "fibers_flat").fiber_frame, model::FiberFrame::cartesian);
            EXPECT_EQ(material_of(c, "fibers_flat").fibers, material_of(c, "fibers").fibers);
            EXPECT_GT(mesh::quality(c.mesh).min_scaled_jacobian, 0.1);
        }
}

TEST(FiberTube, StripKeepsItsFibres) {
    const std::string materials =
        "materials: {cloth: {law: neo-hookean, mu: 5 MPa}, fibers: {law: yeoh, c1: 30 kPa}}\n";
    const auto strip_m3 = [](const model::Case& c) {
        double sum = 0;
        for (const std::string& region : c.mesh.region_names)
            if (region.ends_with("strip")) {
                sum += region_m3(c, region);
                EXPECT_EQ(material_of(c, region).constants.at("mu").front(), 5e6) << region;
                EXPECT_EQ(material_of(c, region).fibers.has_value(), region != "strip") << region;
            }
        return sum;
    };
    const auto half =
        build_case(fiber_design("flat: 4 mm, strip: {thickness: 1 mm, material: cloth}, fibers: {layer: [0.5, 1]}",
                                "model: half\n" + materials));
    EXPECT_NEAR(1e9 * strip_m3(half) / (20 * 1 * 100), 1, 1e-12);
    const auto inner =
        build_case(fiber_design("flat: 4 mm, strip: {thickness: 1 mm, material: cloth}, fibers: {layer: [0, 0.9]}",
                                "model: half\n" + materials));
    EXPECT_NEAR(1e9 * strip_m3(inner) / (20 * 1 * 100), 1, 1e-12);
    EXPECT_EQ(material_of(inner, "fibers_flat").law, "yeoh");
    // The share of the strip is exact up to the area errors of curved cells, which are equal where all cells turn by the same angle.
    for (const auto& [sectors, rounding] : {std::pair{"5", 1e-12}, std::pair{"auto", 2e-5}})
        for (const char* model : {"half", "solid"}) {
            const auto round = build_case(
                fiber_design("strip: {angle: 72 deg, material: cloth}, fibers: {layer: [0.5, 1]}",
                             std::string{"mesh: {sectors: "} + sectors + "}\nmodel: " + model + "\n" + materials));
            double rubber_m3 = 0;
            for (const std::string& region : round.mesh.region_names) rubber_m3 += region_m3(round, region);
            EXPECT_NEAR(strip_m3(round) / rubber_m3, 0.2, rounding) << model;
            EXPECT_EQ(material_of(round, "fibers").law, "yeoh");
        }
}

TEST(FiberTube, RejectsUnsuitableStripsAndFlatWalls) {
    EXPECT_EQ(
        refusal_of("flat: 4 mm"),
        "d.yaml:2:18: geometry.flat: model 'axisymmetric' assumes a symmetry that a flat wall breaks; use model: solid or half");
    EXPECT_EQ(
        refusal_of("strip: {thickness: 1 mm}", "model: half\n"),
        "d.yaml:2:31: geometry.strip.thickness: a round tube has no flat wall; use geometry.strip.angle, or geometry.flat above 0");
    EXPECT_EQ(refusal_of("flat: 4 mm, strip: {thickness: 4 mm}", "model: half\n"),
              "d.yaml:2:43: geometry.strip.thickness: 4 mm is not smaller than flat (4 mm); use a value below 4 mm");
    EXPECT_EQ(
        refusal_of("flat: 4 mm, strip: {angle: 72 deg}", "model: half\n"),
        "d.yaml:2:39: geometry.strip.angle: the strip of a half-round tube lies in its flat wall; use geometry.strip.thickness");
    EXPECT_EQ(
        refusal_of("strip: {angle: 72 deg}"),
        "d.yaml:2:27: geometry.strip.angle: model 'axisymmetric' assumes a symmetry that a strip breaks; use model: solid or half");
    EXPECT_EQ(
        refusal_of("flat: 4 mm, fibers: {families: 1}", "model: half\n"),
        "d.yaml:2:43: geometry.fibers.families: one family of fibres has no mirror symmetry, but the model is cut at symmetry "
        "planes; use families: 2 or model: solid");
}

/// Twenty tubes within the ranges, in all models; reproducible on every machine.
TEST(FiberTube, RandomDesignsHaveNoInvertedCell) {
    Dice dice{8};
    const auto between = [&](double low, double high) { return dice.between(low, high); };
    const auto mm = [](double value) { return core::number_text(value) + " mm"; };
    const std::array<const char*, 4> models{"axisymmetric", "solid", "half", "quarter"};
    for (int k = 0; k < 20; ++k) {
        const double outer = between(3, 30), wall = between(0.05, 0.8) * outer, length = between(1, 10) * outer;
        const double begin = k % 3 == 0 ? 0 : between(0.02, 0.45), end = k % 5 == 0 ? 1 : between(0.55, 0.98);
        const std::string geometry =
            "length: " + mm(length) + ", outer_radius: " + mm(outer) + ", inner_radius: " + mm(outer - wall) +
            ", cap: " + mm(between(0.02, 0.45) * length) + ", fibers: {angle: " + core::number_text(between(0, 90)) +
            " deg, k1: " + core::number_text(between(0.01, 5)) + " MPa, layer: [" + core::number_text(begin) + ", " +
            core::number_text(end) + "]}";
        const std::string model = models[static_cast<std::size_t>(k) % 4];
        const auto c = build_case(
            fiber_design(geometry, "model: " + model + "\nmesh: {size: " + mm(between(0.1, 0.5) * outer) + "}\n"));
        EXPECT_GT(mesh::quality(c.mesh).min_scaled_jacobian, 0.1) << model << ": " << geometry;
    }
}

}  // namespace
}  // namespace soft::geometry
