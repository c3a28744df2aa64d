#include "view/skin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "../fem/block_mesh.hpp"
#include "core/error.hpp"
#include "math/tensor.hpp"
#include "view/creases.hpp"

namespace soft::view {
namespace {

using mesh::CellType;
using model::Formulation;
using model::Kinematics;
using std::numbers::pi;

struct Sample {
    model::Case model;
    post::RegionPoints region_points;
    Skin skin;
    std::vector<Point> positions;
};

Sample sample(model::Case model, const SkinOptions& options) {
    Sample made{std::move(model), {}, {}, {}};
    made.region_points = post::make_region_points(made.model.mesh);
    made.skin = make_skin(made.model, made.region_points, options);
    made.positions = vertex_positions(made.skin, base_positions(made.skin, made.model, made.region_points, {}));
    return made;
}

model::Case block(CellType type, Kinematics kinematics, int n = 2) {
    return block_case(type, kinematics, Formulation::displacement, {.n = n, .shake = 0.2});
}

/// Divergence theorem: positive if the faces point outwards.
double volume(const Sample& s) {
    double sum = 0;
    for (const auto& [a, b, c] : triangles(s.skin))
        sum += dot(s.positions[static_cast<std::size_t>(a)],
                   cross(s.positions[static_cast<std::size_t>(b)], s.positions[static_cast<std::size_t>(c)])) /
               6;
    return sum;
}

/// Each edge is used once in each direction.
bool is_closed(const Sample& s) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : triangles(s.skin))
        for (std::size_t i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : uses) {
        const auto back = uses.find({edge.second, edge.first});
        if (count != 1 || back == uses.end() || back->second != 1) return false;
    }
    return !uses.empty();
}

constexpr std::array<CellType, 6> solids{CellType::hex8,  CellType::hex27,  CellType::tet4,
                                         CellType::tet10, CellType::wedge6, CellType::wedge18};
constexpr std::array<CellType, 4> sections{CellType::quad4, CellType::quad9, CellType::triangle3, CellType::triangle6};

TEST(Skin, OfASolidIsClosedAndOrientedOutwards) {
    for (const CellType type : solids) {
        const Sample s = sample(block(type, Kinematics::solid), {});
        EXPECT_TRUE(is_closed(s)) << mesh::topology(type).name;
        EXPECT_NEAR(volume(s), 1.0, 1e-12) << mesh::topology(type).name;
    }
}

TEST(Skin, OfACutBodyOfRevolutionIsClosedByItsCuts) {
    // 0 < x < 1, 1 < r < 2, revolved by 270 degrees; chords reduce the area of the circle by the factor sin(d)/d
    const double d = 2 * pi / 72, exact = 0.75 * pi * 3 * std::sin(d) / d;
    for (const CellType type : sections) {
        const Sample s = sample(block(type, Kinematics::axisymmetric), {});
        EXPECT_TRUE(is_closed(s)) << mesh::topology(type).name;
        EXPECT_NEAR(volume(s), exact, 1e-12) << mesh::topology(type).name;
    }
}

TEST(Skin, TheGapOfACutBodyIsBetweenPositiveYAndPositiveZ) {
    const Sample s = sample(block(CellType::quad9, Kinematics::axisymmetric), {});
    for (const Point& x : s.positions) EXPECT_FALSE(x[1] > 1e-9 && x[2] > 1e-9);
}

TEST(Skin, AFullTurnClosesWithoutASeam) {
    const double d = 2 * pi / 60;
    for (const CellType type : sections) {
        const Sample s = sample(block(type, Kinematics::axisymmetric), {.extent = Extent::whole, .sectors = 60});
        EXPECT_TRUE(is_closed(s)) << mesh::topology(type).name;
        EXPECT_NEAR(volume(s), pi * 3 * std::sin(d) / d, 1e-12) << mesh::topology(type).name;
    }
}

TEST(Skin, RevolvedEdgesShareOneVertexOnTheAxis) {
    auto model = block(CellType::quad9, Kinematics::axisymmetric);
    for (Point& X : model.mesh.points) X[1] -= 1.0;  // a full cylinder of radius 1
    const double d = 2 * pi / 72;
    for (const Extent extent : {Extent::whole, Extent::opened}) {
        const Sample s = sample(model, {.extent = extent});
        EXPECT_NEAR(volume(s), (extent == Extent::whole ? 1.0 : 0.75) * pi * std::sin(d) / d, 1e-12);
        if (extent == Extent::whole) {
            EXPECT_TRUE(is_closed(s));
        }
    }
}

TEST(Skin, TheWholeOfAQuarterModelHasFourTimesItsVolumeWithoutASeam) {
    for (const CellType type : solids) {
        auto model = block(type, Kinematics::solid);
        model.symmetry_planes = {false, true, true};
        const Sample quarter = sample(model, {.extent = Extent::modelled}),
                     opened = sample(model, {.extent = Extent::opened}),
                     whole = sample(model, {.extent = Extent::whole});
        EXPECT_NEAR(volume(quarter), 1.0, 1e-12);
        EXPECT_TRUE(is_closed(quarter) && is_closed(opened)) << mesh::topology(type).name;
        EXPECT_NEAR(volume(opened), 3.0, 1e-12) << mesh::topology(type).name;
        for (const Point& x : opened.positions) EXPECT_FALSE(x[1] > 1e-9 && x[2] > 1e-9);
        EXPECT_TRUE(is_closed(whole)) << mesh::topology(type).name;
        EXPECT_NEAR(volume(whole), 4.0, 1e-12) << mesh::topology(type).name;
    }
}

TEST(Skin, AHalfModelIsOpenedAtItsPlane) {
    auto model = block(CellType::hex27, Kinematics::solid);
    model.symmetry_planes = {true, true, false};
    const Sample s = sample(model, {.extent = Extent::opened});  // mirrored at x = 0, below y = 0
    EXPECT_TRUE(is_closed(s));
    EXPECT_NEAR(volume(s), 2.0, 1e-12);
    for (const Point& x : s.positions) EXPECT_LT(x[1], 1e-9);
}

TEST(Skin, AHalfSectionIsRevolvedAndMirrored) {
    auto model = block(CellType::quad9, Kinematics::axisymmetric);
    model.symmetry_planes = {true, false, false};
    const double d = 2 * pi / 72, half = pi * 3 * std::sin(d) / d;
    for (const auto& [extent, share] :
         {std::pair{Extent::whole, 2.0}, {Extent::opened, 1.5}, {Extent::modelled, 0.75}}) {
        const Sample s = sample(model, {.extent = extent});
        EXPECT_TRUE(is_closed(s));
        EXPECT_NEAR(volume(s), share * half, 1e-12);
    }
}

TEST(Skin, AFlatSectionHasItsArea) {
    for (const CellType type : sections) {
        const Sample s = sample(block(type, Kinematics::axisymmetric), {.extent = Extent::flat});
        double area = 0;
        for (const Face& face : s.skin.faces) area += 0.5 * face_normal(face, s.positions)[2];
        EXPECT_NEAR(area, 1.0, 1e-12);
    }
}

TEST(Skin, APlaneSectionIsMirroredOnlyIfShownAsAWhole) {
    auto model = block(CellType::quad9, Kinematics::plane_strain);
    model.symmetry_planes = {true, true, false};
    for (const auto& [extent, expected] : {std::pair{Extent::whole, 4.0}, {Extent::opened, 1.0}}) {
        const Sample s = sample(model, {.extent = extent});
        double area = 0;
        for (const Face& face : s.skin.faces) area += 0.5 * face_normal(face, s.positions)[2];
        EXPECT_NEAR(area, expected, 1e-12);
    }
}

TEST(Skin, FollowsCurvedSecondOrderFacets) {
    // every base moves by the exact quadratic displacement, not by its chord
    const auto model = block(CellType::hex27, Kinematics::solid);
    const auto region_points = post::make_region_points(model.mesh);
    const Skin skin = make_skin(model, region_points, {.segments = 5});
    const auto bend = [](const Point& X) { return Point{0, 0.3 * X[0] * X[0], 0.1 * X[0] * X[1]}; };
    auto straight = block_case(CellType::hex27, Kinematics::solid, Formulation::displacement, {.n = 2, .shake = 0});
    const auto straight_points = post::make_region_points(straight.mesh);
    const Skin fine = make_skin(straight, straight_points, {.segments = 5});
    std::vector<double> u;
    for (const Point& X : straight.mesh.points)
        for (const double component : bend(X)) u.push_back(component);
    const auto before = base_positions(fine, straight, straight_points, {}),
               after = base_positions(fine, straight, straight_points, u);
    EXPECT_EQ(fine.base_count(), skin.base_count());
    EXPECT_EQ(fine.base_count(), 6U * 10 * 10 + 2);  // 10 x 10 pieces on each side of a closed box
    for (std::size_t b = 0; b < before.size(); ++b)
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after[b][i], before[b][i] + bend(before[b])[i], 1e-12);
}

TEST(Skin, InterpolatesAFieldWithTheShapeFunctions) {
    const auto model = block(CellType::hex27, Kinematics::solid);
    const auto region_points = post::make_region_points(model.mesh);
    const Skin skin = make_skin(model, region_points, {});
    std::vector<double> nodal;
    for (const mesh::Index node : region_points.node)
        nodal.push_back(2 + model.mesh.point(node)[0] - 3 * model.mesh.point(node)[2]);
    const auto values = base_values(skin, nodal);
    const auto bases = base_positions(skin, model, region_points, {});
    for (std::size_t b = 0; b < bases.size(); ++b) EXPECT_NEAR(values[b], 2 + bases[b][0] - 3 * bases[b][2], 1e-12);
}

TEST(Skin, TheCreasesOfABoxAreItsTwelveEdges) {
    const Sample s = sample(block(CellType::hex27, Kinematics::solid), {.segments = 3});
    EXPECT_EQ(s.skin.creases.size(), 12U * 2 * 3);
    double length = 0;
    for (const auto& [a, b] : s.skin.creases) {
        const Point &p = s.positions[static_cast<std::size_t>(a)], &q = s.positions[static_cast<std::size_t>(b)];
        length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    EXPECT_NEAR(length, 12.0, 1e-12);
}

TEST(Skin, ABoundaryBetweenRegionsIsACrease) {
    auto model = block_case(CellType::hex27, Kinematics::solid, Formulation::displacement, {.n = 2, .shake = 0});
    const std::size_t alone = sample(model, {.segments = 1}).skin.creases.size();
    model.mesh.region_names = {"rubber", "stiff"};
    for (mesh::Index cell = 0; cell < model.mesh.cell_count(); ++cell)
        model.mesh.cell_regions[static_cast<std::size_t>(cell)] =
            model.mesh.point(model.mesh.cell_nodes(cell)[26])[0] > 0.5;
    EXPECT_EQ(sample(model, {.segments = 1}).skin.creases.size(), alone + 2 * 8);  // a ring of 8 edges, for each rubber
}

TEST(Skin, TheSilhouetteOfABoxIsItsOutline) {
    const Sample s = sample(block(CellType::hex8, Kinematics::solid), {});
    const auto rim = silhouette(s.skin.faces, s.positions, {0.1, 0.2, 1});
    double length = 0;
    for (const auto& [a, b] : rim) {
        const Point &p = s.positions[static_cast<std::size_t>(a)], &q = s.positions[static_cast<std::size_t>(b)];
        length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    EXPECT_NEAR(length, 6.0, 1e-12);  // the hexagon of a cube's outline
}

TEST(Skin, OptionsOutOfRangeAreRefused) {
    const auto model = block(CellType::hex8, Kinematics::solid);
    const auto region_points = post::make_region_points(model.mesh);
    EXPECT_THROW(static_cast<void>(make_skin(model, region_points, {.segments = 0})), Error);
    EXPECT_THROW(static_cast<void>(make_skin(model, region_points, {.sectors = 2})), Error);
    EXPECT_THROW(static_cast<void>(make_skin(model, region_points, {.turn_rad = 7})), Error);
}

}  // namespace
}  // namespace soft::view
