// The bending finger: volumes and areas in closed form, symmetry planes, layer, rejected values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "dice.hpp"
#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

/// Keys without "geometry."; lengths in mm.
using Finger = std::map<std::string, double>;

const Finger defaults{{"chambers", 4},      {"chamber_length", 8}, {"gap", 1},
                      {"width", 16},        {"height", 16},        {"wall", 1.5},
                      {"side", 2},          {"roof", 2},           {"base", 3},
                      {"bridge", 4},        {"root", 8},           {"tip", 3},
                      {"channel.width", 4}, {"channel.height", 2}, {"layer.thickness", 0}};

sample::Changes changes_of(const Finger& finger) {
    sample::Changes changes;
    for (const auto& [key, value] : finger)
        changes["geometry." + key] = core::number_text(value) + (key == "chambers" ? "" : " mm");
    return changes;
}

double length_mm(const Finger& f) {
    return f.at("root") + f.at("chambers") * f.at("chamber_length") + (f.at("chambers") - 1) * f.at("gap") +
           f.at("tip");
}

/// Boxes of the cavities, and of the channel where it crosses two walls and a slot.
double cavity_mm3(const Finger& f) {
    const double chamber = (f.at("chamber_length") - 2 * f.at("wall")) * (f.at("width") - 2 * f.at("side")) *
                           (f.at("height") - f.at("roof"));
    const double crossing = (f.at("gap") + 2 * f.at("wall")) * f.at("channel.width") * f.at("channel.height");
    return f.at("chambers") * chamber + (f.at("chambers") - 1) * crossing;
}

/// A slab of the height of base and bridge, and the chambers above it, minus the cavity.
double rubber_mm3(const Finger& f) {
    return length_mm(f) * f.at("width") * (f.at("base") + f.at("bridge")) +
           f.at("chambers") * f.at("chamber_length") * f.at("width") * (f.at("height") - f.at("bridge")) -
           cavity_mm3(f);
}

double cavity_area_mm2(const Finger& f) {
    const double a = f.at("chamber_length") - 2 * f.at("wall"), b = f.at("width") - 2 * f.at("side"),
                 c = f.at("height") - f.at("roof");
    const double w = f.at("channel.width"), h = f.at("channel.height"), crossing = f.at("gap") + 2 * f.at("wall");
    return f.at("chambers") * 2 * (a * b + b * c + c * a) +
           (f.at("chambers") - 1) * (crossing * 2 * (w + h) - 2 * w * h);
}

constexpr double rounding = 1e-11;

void expect_closed_forms(const Finger& finger, const Solid& solid) {
    const double face_mm2 = finger.at("width") * (finger.at("base") + finger.at("bridge"));
    EXPECT_NEAR(1e9 * sample::rubber_m3(solid) / rubber_mm3(finger), 1, rounding);
    EXPECT_NEAR(1e9 * sample::cavity_m3(solid) / cavity_mm3(finger), 1, rounding);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "cavity") / cavity_area_mm2(finger), 1, rounding);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "fixed") / face_mm2, 1, rounding);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "tip") / face_mm2, 1, rounding);
    EXPECT_NEAR(1e6 * sample::area_m2(solid, "bottom") / (length_mm(finger) * finger.at("width")), 1, rounding);
}

TEST(Pneunet, VolumesAndAreasMatch) {
    for (const char* model : {"half", "solid"})
        for (const char* cells : {"auto", "simplices"}) {
            Finger finger = defaults;
            sample::Changes changes = changes_of(finger);
            changes["mesh.cells"] = cells;
            expect_closed_forms(finger, sample::solid("pneunet", model, changes));
            finger["chambers"] = 1;
            finger["layer.thickness"] = 0.5;
            changes = changes_of(finger);
            changes["mesh.cells"] = cells;
            expect_closed_forms(finger, sample::solid("pneunet", model, changes));
        }
}

TEST(Pneunet, ChannelMayBeAsWideAndHighAsTheCavities) {
    Finger finger = defaults;
    finger["channel.width"] = 12;
    finger["height"] = 10;
    finger["roof"] = 3;
    finger["bridge"] = 9;
    finger["channel.height"] = 7;
    expect_closed_forms(finger, sample::solid("pneunet", "half", changes_of(finger)));
}

TEST(Pneunet, SolidModelIsTheHalfAndItsMirrorImage) {
    const Solid half = sample::solid("pneunet", "half"), whole = sample::solid("pneunet", "solid");
    EXPECT_EQ(half.fraction, 0.5);
    EXPECT_EQ(half.symmetry_planes, (std::array<bool, 3>{false, true, false}));
    EXPECT_EQ(whole.fraction, 1.0);
    EXPECT_EQ(whole.mesh.cell_count(), 2 * half.mesh.cell_count());
    EXPECT_FALSE(whole.mesh.facet_sets.contains(meshing::symmetry_y_face));
    for (const mesh::Facet& facet : half.mesh.facet_sets.at(meshing::symmetry_y_face))
        for (const mesh::Index n : mesh::facet_nodes(half.mesh, facet)) EXPECT_EQ(half.mesh.point(n)[1], 0);
    // Only corners: mid nodes are means, and the order of summation differs between the two halves.
    const auto corners = [](const mesh::Mesh& mesh) {
        std::set<mesh::Point> all;
        for (mesh::Index c = 0; c < mesh.cell_count(); ++c)
            for (const mesh::Index node : mesh.cell_nodes(c).first(8)) all.insert(mesh.point(node));
        return all;
    };
    const std::set<mesh::Point> positions = corners(whole.mesh);
    for (const mesh::Point& p : corners(half.mesh)) {
        EXPECT_TRUE(positions.contains(p));
        EXPECT_TRUE(positions.contains({p[0], -p[1], p[2]}));
    }
}

TEST(Pneunet, LayerIsTheLowestPartOfTheBase) {
    const Solid plain = sample::solid("pneunet", "half");
    const Solid layered = sample::solid("pneunet", "half", {{"geometry.layer.thickness", "0.5 mm"}});
    EXPECT_EQ(plain.mesh.region_names, std::vector<std::string>{"rubber"});
    ASSERT_EQ(layered.mesh.region_names.size(), 2u);
    const mesh::Mesh& layer = layered.mesh;
    double volume_m3 = 0;
    for (mesh::Index c = 0; c < layer.cell_count(); ++c) {
        if (layer.region_names[static_cast<std::size_t>(layer.cell_regions[static_cast<std::size_t>(c)])] != "layer")
            continue;
        for (const mesh::QuadraturePoint& point : mesh::volume_rule(layer.cell_type(c)))
            volume_m3 +=
                point.weight * mesh::map_cell(layer, c, mesh::shape_values(layer.cell_type(c), point.xi)).determinant;
        for (const mesh::Index n : layer.cell_nodes(c)) EXPECT_LE(layer.point(n)[2], 0.5e-3 * (1 + rounding));
    }
    EXPECT_NEAR(volume_m3 / (0.5 * 46e-3 * 16e-3 * 0.5e-3), 1, rounding);
}

design::Design finger_design(const std::string& geometry, const std::string& more = "") {
    return design::read_design(
        "family: pneunet\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\n"
        "loads: {cavity: {pressure: 5 kPa}}\ngeometry: " +
            geometry + "\n" + more,
        "p.yaml", catalogue_keys(), {});
}

TEST(Pneunet, LayerIsOfPaperByDefault) {
    const model::Case paper = build_case(finger_design("{layer: {thickness: 0.5 mm}}"));
    ASSERT_EQ(paper.materials.size(), 2u);
    const auto of = [](const model::Case& c, const std::string& region) {
        return *std::ranges::find(c.materials, region, &model::Material::name);
    };
    // Young's modulus 6.5 GPa and Poisson's ratio 0.2: mu = E / (2 (1 + nu)), kappa = E / (3 (1 - 2 nu)).
    EXPECT_NEAR(of(paper, "layer").constants.at("mu").at(0) / (6.5e9 / 2.4), 1, 1e-3);
    EXPECT_NEAR(of(paper, "layer").bulk_modulus_Pa.value() / (6.5e9 / 1.8), 1, 1e-3);
    EXPECT_EQ(of(paper, "rubber").constants.at("mu").at(0), 0.1644e6);
    const model::Case same = build_case(finger_design("{layer: {thickness: 0.5 mm, material: rubber}}"));
    EXPECT_EQ(of(same, "layer").constants, of(same, "rubber").constants);
    const model::Case felt =
        build_case(finger_design("{layer: {thickness: 0.5 mm, material: felt}}",
                                 "materials: {felt: {law: neo-hookean, mu: 3 MPa, kappa: 4 MPa}}"));
    EXPECT_EQ(of(felt, "layer").constants.at("mu").at(0), 3e6);
    EXPECT_EQ(build_case(finger_design("{}")).materials.size(), 1u);
}

TEST(Pneunet, WeightRequiresNoDensityOfAnAbsentLayer) {
    EXPECT_NO_THROW((void)build_case(
        design::read_design("family: pneunet\nmaterial: {law: neo-hookean, mu: 0.1644 MPa, density: 1080 kg/m^3}\n"
                            "loads: {cavity: {pressure: 5 kPa}, gravity: {acceleration: 9.81 m/s^2, along: -z}}\n",
                            "p.yaml", catalogue_keys(), {})));
}

TEST(Pneunet, DefaultMeshIsNotReportedAsCoarse) { EXPECT_TRUE(finger_design("{}").warnings.empty()); }

TEST(Pneunet, EveryWallHasTheRequestedNumberOfCells) {
    const auto cells = [](const sample::Changes& changes) {
        return sample::solid("pneunet", "half", changes).mesh.cell_count();
    };
    EXPECT_EQ(cells({{"mesh.size", "50 mm"}, {"mesh.grading", "1"}, {"mesh.through_wall", "2"}}),
              4 * cells({{"mesh.size", "50 mm"}, {"mesh.grading", "1"}, {"mesh.through_wall", "1"}}));
}

TEST(Pneunet, RandomFingersHaveValidCells) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Dice draw{seed};
        Finger f;
        f["chambers"] = std::floor(draw(1, 6.999));
        f["chamber_length"] = draw(4, 15);
        f["gap"] = draw(0.3, 4);
        f["width"] = draw(8, 30);
        f["height"] = draw(6, 30);
        f["wall"] = draw(0.1, 0.45) * f["chamber_length"];
        f["side"] = draw(0.05, 0.4) * f["width"];
        f["roof"] = draw(0.05, 0.5) * f["height"];
        f["base"] = draw(1, 6);
        f["bridge"] = draw(0.1, 0.95) * f["height"];
        f["channel.width"] = draw(0.1, 1) * (f["width"] - 2 * f["side"]);
        f["channel.height"] = draw(0.1, 0.9) * std::min(f["bridge"], f["height"] - f["roof"]);
        f["root"] = draw(1, 15);
        f["tip"] = draw(0.5, 8);
        f["layer.thickness"] = draw(-0.5, 0.9) * f["base"];
        if (f["layer.thickness"] < 0) f["layer.thickness"] = 0;
        sample::Changes changes = changes_of(f);
        changes["mesh.through_wall"] = seed % 2 == 0 ? "1" : "2";
        changes["mesh.grading"] = "3";
        changes["mesh.size"] = "5 mm";
        const Solid solid = sample::solid("pneunet", "half", changes);
        expect_closed_forms(f, solid);
        EXPECT_GT(mesh::quality(solid.mesh).min_scaled_jacobian, 0.999) << seed;
    }
}

TEST(Pneunet, InconsistentValuesAreRejectedWithTheirBound) {
    sample::expect_refusals(
        "pneunet", "half",
        {{"wall", "4 mm", "4 mm is not smaller than half the chamber_length (4 mm); use a value below 4 mm"},
         {"side", "8 mm", "8 mm is not smaller than half the width (8 mm); use a value below 8 mm"},
         {"roof", "16 mm", "16 mm is not smaller than the height (16 mm); use a value below 16 mm"},
         {"bridge", "16 mm", "16 mm is not smaller than the height of the chambers (16 mm); use a value below 16 mm"},
         {"channel.height", "4 mm",
          "4 mm is not smaller than the bridge that covers it (4 mm); use a value below 4 mm"},
         {"channel.width", "13 mm", "13 mm exceeds the width of the cavities (12 mm); use at most 12 mm"},
         {"layer.thickness", "3 mm", "3 mm is not smaller than the base (3 mm); use a value below 3 mm"}});
    try {
        (void)sample::solid("pneunet", "half", {{"geometry.roof", "15 mm"}, {"geometry.channel.height", "2 mm"}});
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(std::string{error.what()},
                  "test: geometry.channel.height: 2 mm exceeds the height of the cavities (1 mm); use at most 1 mm");
    }
    EXPECT_THROW((void)sample::solid("pneunet", "solid", {{"mesh.size", "0.01 mm"}}), Error);
}

}  // namespace
}  // namespace soft::geometry
