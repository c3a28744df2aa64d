#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>

#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

/// A family, a model and a kind of cells.
struct Variant {
    std::string family, model, cells;
    sample::Changes changes;
};

/// All families that generate their own mesh (imported_test covers the other one).
std::vector<Variant> variants() {
    std::vector<Variant> all;
    for (const Family& family : catalogue())
        for (const std::string& model : family.keys.faces_of_file ? std::vector<std::string>{} : family.keys.models)
            for (const char* cells : {"auto", "simplices"}) {
                Variant v{family.keys.name, model, cells, {{"mesh.cells", cells}}};
                if (v.family == "plate" && model == "axisymmetric") v.changes["geometry.radius"] = "50 mm";
                all.push_back(std::move(v));
            }
    for (const char* model : {"solid", "half", "quarter"})
        all.push_back({"plate", model, "round", {{"geometry.radius", "50 mm"}}});
    for (const char* model : {"plane-strain", "solid"})
        all.push_back({"panel", model, "patch", {{"geometry.loaded_top", "10 mm"}, {"geometry.rise", "-20 mm"}}});
    return all;
}

void PrintTo(const Variant& v, std::ostream* out) { *out << v.family << " " << v.model << " " << v.cells; }

class EveryVariant : public testing::TestWithParam<Variant> {
protected:
    const Solid solid = sample::solid(GetParam().family, GetParam().model, GetParam().changes);
};

TEST_P(EveryVariant, HasPositiveJacobians) { EXPECT_GT(mesh::quality(solid.mesh).min_scaled_jacobian, 0.1); }

TEST_P(EveryVariant, HasTheRequestedKindOfCells) {
    for (const mesh::CellType type : solid.mesh.cell_types) {
        const mesh::Shape shape = mesh::topology(type).shape;
        const bool simplex = shape == mesh::Shape::triangle || shape == mesh::Shape::tetrahedron;
        EXPECT_EQ(simplex, GetParam().cells == "simplices");
    }
}

/// A facet without a face could not be supported, loaded or measured.
TEST_P(EveryVariant, HasAFaceForEveryBoundaryFacet) {
    const auto boundary = mesh::boundary_facets(solid.mesh);
    std::set<mesh::Facet> named;
    for (const auto& [name, facets] : solid.mesh.facet_sets)
        if (!name.starts_with("middle_")) named.insert(facets.begin(), facets.end());
    EXPECT_EQ(named, std::set<mesh::Facet>(boundary.begin(), boundary.end()));
}

TEST_P(EveryVariant, HasOnlyFacesThatTheFamilyDeclares) {
    const auto& faces = sample::family(GetParam().family).keys.faces;
    std::set<std::string> known(faces.begin(), faces.end());
    known.insert({meshing::axis_face, meshing::symmetry_x_face, meshing::symmetry_y_face, meshing::symmetry_z_face,
                  "middle_y", "middle_z"});
    for (const auto& [name, facets] : solid.mesh.facet_sets) EXPECT_TRUE(known.contains(name)) << name;
}

TEST_P(EveryVariant, UsesEveryPoint) {
    const std::set<mesh::Index> used(solid.mesh.connectivity.begin(), solid.mesh.connectivity.end());
    EXPECT_EQ(used.size(), solid.mesh.points.size());
}

INSTANTIATE_TEST_SUITE_P(Family, EveryVariant, testing::ValuesIn(variants()), [](const auto& test) {
    return test_name(test.param.family + "_" + test.param.model + "_" + test.param.cells);
});

struct Volumes {
    std::string family, model;
    double rubber_m3, cavity_m3;
};

void PrintTo(const Volumes& v, std::ostream* out) { *out << v.family << " " << v.model; }

class ClosedForms : public testing::TestWithParam<Volumes> {};

TEST_P(ClosedForms, VolumesMatch) {
    for (const char* cells : {"auto", "simplices"}) {
        const Solid solid = sample::solid(GetParam().family, GetParam().model, {{"mesh.cells", cells}});
        EXPECT_NEAR(sample::rubber_m3(solid) / GetParam().rubber_m3, 1, curved) << cells;
        if (GetParam().cavity_m3 > 0) {
            EXPECT_NEAR(sample::cavity_m3(solid, GetParam().family == "ring" ? 2 : 0) / GetParam().cavity_m3, 1, curved)
                << cells;
        }
    }
}

std::vector<Volumes> closed_forms() {
    std::vector<Volumes> all;
    for (const char* model : {"axisymmetric", "solid", "half", "quarter"}) {
        all.push_back({"sphere", model, 4 * pi / 3 * (8e-6 - 1e-6), 4 * pi / 3 * 1e-6});
        all.push_back({"tube", model, pi * (1e-4 * 0.1 - 0.49e-4 * 0.09), pi * 0.49e-4 * 0.09});
        all.push_back({"fiber-tube", model, pi * (1e-4 * 0.1 - 0.49e-4 * 0.09), pi * 0.49e-4 * 0.09});
        all.push_back(
            {"dome", model, 2 * pi / 3 * (51e-3 * 51e-3 * 51e-3 - 49e-3 * 49e-3 * 49e-3) * (1 - std::cos(pi / 6)), 0});
    }
    for (const char* model : {"solid", "half", "quarter"}) {
        all.push_back({"rod", model, 1e-5, 0});
        all.push_back({"plate", model, 2e-5, 0});
    }
    // Per metre of depth (plane strain), and for a slice of 10 mm.
    all.push_back({"ring", "plane-strain", pi * 3e-4, pi * 1e-4});
    all.push_back({"ring", "solid", pi * 3e-6, pi * 1e-6});
    all.push_back({"panel", "plane-strain", 48e-3 * 44e-3, 0});
    all.push_back({"panel", "solid", 48e-3 * 44e-3 * 10e-3, 0});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Family, ClosedForms, testing::ValuesIn(closed_forms()),
                         [](const auto& test) { return test_name(test.param.family + "_" + test.param.model); });

TEST(Sphere, AreasMatch) {
    const Solid shell = sample::solid("sphere", "quarter");
    EXPECT_NEAR(sample::area_m2(shell, "cavity") / (4 * pi * 1e-4), 1, curved);
    EXPECT_NEAR(sample::area_m2(shell, "outer") / (4 * pi * 4e-4), 1, curved);
    EXPECT_EQ(shell.fraction, 1.0 / 8);
}

TEST(TwoSpheres, AreSeparateAndHaveTheVolumesOfWholeSpheres) {
    const Solid pair =
        sample::solid("two-spheres", "axisymmetric", {{"geometry.gap", "4 mm"}, {"geometry.right_scale", "2"}});
    const double cavity_m3 = 4 * pi / 3 * 1e-6;
    EXPECT_NEAR(sample::cavity_m3(pair, 0, "left") / cavity_m3, 1, curved);
    EXPECT_NEAR(sample::cavity_m3(pair, 0, "right") / cavity_m3, 1, curved);
    EXPECT_NEAR(sample::rubber_m3(pair) / (4 * pi / 3 * (1.331e-6 + 1.728e-6 - 2e-6)), 1,
                curved);  // radii 11 and 12 mm
    EXPECT_NEAR(sample::area_m2(pair, "outer_left") / (4 * pi * 1.21e-4), 1, curved);
    EXPECT_NEAR(sample::area_m2(pair, "outer_right") / (4 * pi * 1.44e-4), 1, curved);
    for (const auto& [face, x_m] : std::map<std::string, double>{{"plane_left", -2e-3}, {"plane_right", 2e-3}})
        for (const mesh::Facet& facet : pair.mesh.facet_sets.at(face))
            for (const mesh::Index n : mesh::facet_nodes(pair.mesh, facet))
                EXPECT_NEAR(pair.mesh.point(n)[0], x_m, 1e-15);
    for (const mesh::Point& p : pair.mesh.points) EXPECT_GE(std::abs(p[0]), 2e-3 - 1e-15);
}

TEST(Dome, FaceAreasMatch) {
    const double angle = pi / 6, inner_m = 49e-3, outer_m = 51e-3;
    const auto cap = [](double radius_m, double at) { return 2 * pi * radius_m * radius_m * (1 - std::cos(at)); };
    for (const char* model : {"axisymmetric", "quarter"}) {
        const Solid dome = sample::solid("dome", model);
        EXPECT_NEAR(sample::area_m2(dome, "inner") / cap(inner_m, angle), 1, curved);
        EXPECT_NEAR(sample::area_m2(dome, "outer") / cap(outer_m, angle), 1, curved);
        EXPECT_NEAR(sample::area_m2(dome, "crown") / cap(inner_m, 0.1 * angle), 1, curved);
        EXPECT_NEAR(sample::area_m2(dome, "rim") / (pi * std::sin(angle) * (outer_m * outer_m - inner_m * inner_m)), 1,
                    curved);
    }
}

TEST(Tube, FaceAreasMatch) {
    for (const char* model : {"axisymmetric", "half"}) {
        const Solid tube = sample::solid("tube", model);
        EXPECT_NEAR(sample::area_m2(tube, "fixed") / (pi * 1e-4), 1, curved);
        EXPECT_NEAR(sample::area_m2(tube, "inlet") / (pi * 1e-4), 1, curved);
        EXPECT_NEAR(sample::area_m2(tube, "outer") / (2 * pi * 1e-2 * 0.1), 1, curved);
        EXPECT_NEAR(sample::area_m2(tube, "cavity") / (2 * pi * 7e-3 * 0.09 + 2 * pi * 0.49e-4), 1, curved);
    }
}

TEST(Plate, RoundVolumeMatchesInEveryModel) {
    for (const char* model : {"axisymmetric", "solid", "half", "quarter"}) {
        const Solid plate = sample::solid("plate", model, {{"geometry.radius", "50 mm"}});
        EXPECT_NEAR(sample::rubber_m3(plate) / (pi * 2.5e-3 * 2e-3), 1, curved) << model;
        EXPECT_EQ(plate.mesh.facet_sets.at("rim"), plate.mesh.facet_sets.at("edges"));
    }
}

TEST(Ring, FaceAreasMatch) {
    const Solid plane = sample::solid("ring", "plane-strain"), slice = sample::solid("ring", "solid");
    EXPECT_NEAR(sample::area_m2(plane, "cavity") / (2 * pi * 1e-2), 1, curved);
    EXPECT_NEAR(sample::area_m2(plane, "outer") / (2 * pi * 2e-2), 1, curved);
    EXPECT_NEAR(sample::area_m2(slice, "outer") / (2 * pi * 2e-2 * 1e-2), 1, curved);
    for (const char* end : {"left", "right"}) EXPECT_NEAR(sample::area_m2(slice, end) / (pi * 3e-4), 1, curved);
    EXPECT_EQ(plane.symmetry_planes, (std::array<bool, 3>{true, true, false}));
    EXPECT_EQ(slice.symmetry_planes, (std::array<bool, 3>{true, true, false}));
}

/// Cook's membrane: a trapezium of 48 x (44 + 16)/2 with sides of 44, 16, |(48, 44)| and |(48, 16)| (mm).
TEST(Panel, TaperedPanelHasTheAreaAndSidesOfATrapezium) {
    const sample::Changes cook{
        {"geometry.end_height", "16 mm"}, {"geometry.rise", "44 mm"}, {"geometry.loaded_top", "12 mm"}};
    for (const char* cells : {"auto", "simplices"})
        for (const char* order : {"1", "2"}) {
            sample::Changes changes = cook;
            changes["mesh.cells"] = cells;
            changes["mesh.order"] = order;
            const Solid plane = sample::solid("panel", "plane-strain", changes);
            EXPECT_NEAR(1e6 * sample::rubber_m3(plane), 48 * 30, 1e-9);
            EXPECT_NEAR(1e3 * sample::area_m2(plane, "fixed"), 44, 1e-11);
            EXPECT_NEAR(1e3 * sample::area_m2(plane, "end"), 16, 1e-11);
            EXPECT_NEAR(1e3 * sample::area_m2(plane, "bottom"), std::hypot(48, 44), 1e-11);
            EXPECT_NEAR(1e3 * sample::area_m2(plane, "top"), std::hypot(48, 16), 1e-11);
            EXPECT_NEAR(1e3 * sample::area_m2(plane, "patch"), 0.25 * std::hypot(48, 16), 1e-11);
            const Solid solid = sample::solid("panel", "solid", changes);
            EXPECT_NEAR(1e9 * sample::rubber_m3(solid), 48 * 30 * 10, 1e-8);
            EXPECT_NEAR(1e6 * sample::area_m2(solid, "end"), 160, 1e-10);
            EXPECT_NEAR(1e6 * sample::area_m2(solid, "left"), 48 * 30, 1e-9);
        }
}

TEST(Panel, PatchStartsAtXZero) {
    EXPECT_FALSE(sample::solid("panel", "plane-strain").mesh.facet_sets.contains("patch"));
    const Solid part = sample::solid("panel", "plane-strain", {{"geometry.loaded_top", "10 mm"}});
    for (const mesh::Facet& facet : part.mesh.facet_sets.at("patch"))
        for (const mesh::Index n : mesh::facet_nodes(part.mesh, facet)) {
            EXPECT_LE(part.mesh.point(n)[0], 10e-3 + 1e-12);
            EXPECT_NEAR(part.mesh.point(n)[1], 44e-3, 1e-12);
        }
    const Solid all = sample::solid("panel", "plane-strain", {{"geometry.loaded_top", "48 mm"}});
    EXPECT_EQ(all.mesh.facet_sets.at("patch"), all.mesh.facet_sets.at("top"));
}

/// Straight edges between the nodes on a circle: a regular polygon of known area.
TEST(FirstOrder, HasStraightEdgesBetweenTheSameCorners) {
    const Solid plane = sample::solid("ring", "plane-strain", {{"mesh.order", "1"}});
    const double edges = 4.0 * static_cast<double>(plane.mesh.facet_sets.at("outer").size());
    const double polygon = 0.5 * edges * std::sin(2 * pi / edges);  // over the radius squared
    EXPECT_NEAR(sample::rubber_m3(plane) / (polygon * 3e-4), 1, 1e-12);
    EXPECT_NEAR(sample::cavity_m3(plane, 2) / (polygon * 1e-4), 1, 1e-12);
}

TEST(FirstOrder, HasValidCellsAndTheFacesOfTheSecondOrderMesh) {
    for (Variant variant : variants()) {
        const Solid second = sample::solid(variant.family, variant.model, variant.changes);
        variant.changes["mesh.order"] = "1";
        const Solid first = sample::solid(variant.family, variant.model, variant.changes);
        EXPECT_EQ(first.mesh.cell_count(), second.mesh.cell_count());
        EXPECT_GT(mesh::quality(first.mesh).min_scaled_jacobian, 0.1) << testing::PrintToString(variant);
        for (const mesh::CellType type : first.mesh.cell_types) ASSERT_EQ(mesh::topology(type).order, 1);
        for (const auto& [name, facets] : second.mesh.facet_sets)
            EXPECT_EQ(first.mesh.facet_sets.at(name), facets) << name;
    }
}

TEST(Boxes, SymmetryPlanesReplaceFaces) {
    const Solid half = sample::solid("rod", "half"), quarter = sample::solid("rod", "quarter");
    EXPECT_FALSE(half.mesh.facet_sets.contains("left"));
    EXPECT_TRUE(half.mesh.facet_sets.contains("bottom"));
    EXPECT_FALSE(quarter.mesh.facet_sets.contains("bottom"));
    EXPECT_EQ(quarter.symmetry_planes, (std::array<bool, 3>{false, true, true}));
    const Solid plate = sample::solid("plate", "quarter");
    EXPECT_EQ(plate.symmetry_planes, (std::array<bool, 3>{true, true, false}));
    EXPECT_FALSE(plate.mesh.facet_sets.contains("edge_x0"));
    EXPECT_TRUE(plate.mesh.facet_sets.contains("bottom"));
}

TEST(Mesh, SectorsAndCellsThroughTheWallMatchTheRequest) {
    const auto cells = [](const sample::Changes& changes) {
        return sample::solid("sphere", "quarter", changes).mesh.cell_count();
    };
    EXPECT_EQ(cells({{"mesh.sectors", "6"}}), 2 * cells({{"mesh.sectors", "3"}}));
    EXPECT_EQ(cells({{"mesh.through_wall", "6"}}), 6 * cells({{"mesh.through_wall", "1"}}));
}

struct Refusal {
    std::string family, model;
    sample::Changes changes;
    std::string message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.message; }

class Rejected : public testing::TestWithParam<Refusal> {};

TEST_P(Rejected, ReportsTheKeyAndTheRange) {
    const Refusal& r = GetParam();
    try {
        (void)sample::solid(r.family, r.model, r.changes);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(std::string{error.what()}, r.message);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Family, Rejected,
    testing::Values(
        Refusal{"tube",
                "axisymmetric",
                {{"geometry.inner_radius", "12 mm"}, {"geometry.outer_radius", "10 mm"}},
                "test: geometry.inner_radius: 12 mm is not smaller than outer_radius (10 mm); use a value below 10 mm"},
        Refusal{"tube",
                "quarter",
                {{"geometry.cap", "50 mm"}},
                "test: geometry.cap: 50 mm is not smaller than half the length (50 mm); use a value below 50 mm"},
        Refusal{"sphere",
                "axisymmetric",
                {{"geometry.inner_radius", "20 mm"}, {"geometry.outer_radius", "20 mm"}},
                "test: geometry.inner_radius: 20 mm is not smaller than outer_radius (20 mm); use a value below 20 mm"},
        Refusal{"two-spheres",
                "axisymmetric",
                {{"geometry.inner_radius", "11 mm"}, {"geometry.outer_radius", "11 mm"}},
                "test: geometry.inner_radius: 11 mm is not smaller than outer_radius (11 mm); use a value below 11 mm"},
        Refusal{"dome",
                "axisymmetric",
                {{"geometry.thickness", "50 mm"}},
                "test: geometry.thickness: 50 mm is not smaller than radius (50 mm); use a value below 50 mm"},
        Refusal{"ring",
                "plane-strain",
                {{"geometry.inner_radius", "20 mm"}, {"geometry.outer_radius", "20 mm"}},
                "test: geometry.inner_radius: 20 mm is not smaller than outer_radius (20 mm); use a value below 20 mm"},
        Refusal{"panel",
                "plane-strain",
                {{"geometry.loaded_top", "50 mm"}},
                "test: geometry.loaded_top: 50 mm is longer than the panel; use at most its length, 48 mm"},
        Refusal{"panel",
                "plane-strain",
                {{"mesh.size", "0.001 mm"}},
                "test: mesh.size: the mesh would have 2.1e+09 cells (limit 5 million); use a larger size"},
        Refusal{
            "plate",
            "axisymmetric",
            {},
            "test: model: a rectangular plate has no axis of revolution; use solid, half or quarter, or a round plate (geometry.radius)"},
        Refusal{
            "bellows",
            "axisymmetric",
            {{"geometry.pitch", "6.5 mm"}},
            "test: geometry.pitch: 6.5 mm lets neighbouring convolutions overlap; use a value above 6.5 mm = 2 (fillet + wall)"},
        Refusal{
            "bellows",
            "axisymmetric",
            {{"geometry.crest_land", "2 mm"}, {"geometry.trough_land", "1 mm"}},
            "test: geometry.pitch: 9.25 mm lets neighbouring convolutions overlap; use a value above 9.5 mm = 2 (fillet + wall) + "
            "crest_land + trough_land"},
        Refusal{
            "bellows",
            "axisymmetric",
            {{"geometry.last_crest_radius", "9 mm"}},
            "test: geometry.last_crest_radius: 9 mm leaves no straight wall between trough and crest; use a value above 9 mm"},
        Refusal{
            "bellows",
            "quarter",
            {{"geometry.strip.angle", "72 deg"}},
            "test: geometry.strip.angle: model 'quarter' assumes a symmetry that a strip breaks; use model: solid or half"},
        Refusal{
            "bellows",
            "half",
            {{"geometry.strip.angle", "179 deg"}},
            "test: geometry.strip.angle: cells of less than 1 deg around the axis; use 0, 180 deg, or between 2 and 178 deg"},
        Refusal{
            "bellows",
            "axisymmetric",
            {{"geometry.crest_radius", "9 mm"}},
            "test: geometry.crest_radius: 9 mm leaves no straight wall between trough and crest; use a value above 9 mm"},
        Refusal{
            "bellows",
            "axisymmetric",
            {{"geometry.neck.radius", "5 mm"}},
            "test: geometry.neck.radius: 5 mm does not meet the straight part of the outer wall; use a value between 5.72257 mm "
            "and 16.1066 mm"},
        Refusal{"bellows",
                "axisymmetric",
                {{"geometry.end_disc.radius", "7 mm"}},
                "test: geometry.end_disc.radius: 7 mm is not larger than neck.radius (7 mm); use a value above 7 mm"},
        Refusal{"bellows",
                "axisymmetric",
                {{"mesh.size", "0.001 mm"}},
                "test: mesh.size: the mesh would have 1e+09 cells (limit 5 million); use a larger size"}));

/// The fibre frame if the design does not state it.
model::FiberFrame default_frame(const std::string& family_and_geometry) {
    const std::string text = family_and_geometry + "loads: {gravity: {acceleration: 1 m/s^2, along: x}}\n" +
                             "material: {law: holzapfel-gasser-ogden, mu: 0.1 MPa, k1: 1 MPa, k2: 1, angle: 30 deg, " +
                             "density: 1000 kg/m^3}\n";
    return design::read_design(text, "d.yaml", catalogue_keys(), {}).material.fiber_frame;
}

TEST(FiberFrame, IsCylindricalOnlyInBodiesOfRevolution) {
    for (const char* round : {"family: tube\n", "family: bellows\nmodel: quarter\n",
                              "family: plate\ngeometry: {radius: 30 mm}\n", "family: dome\nmodel: solid\n"})
        EXPECT_EQ(default_frame(round), model::FiberFrame::cylindrical) << round;
    for (const char* straight : {"family: plate\n", "family: plate\nmodel: quarter\n", "family: rod\n",
                                 "family: pneunet\n", "family: panel\n", "family: ring\n"})
        EXPECT_EQ(default_frame(straight), model::FiberFrame::cartesian) << straight;
}

}  // namespace
}  // namespace soft::geometry
