#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <set>

#include "gmsh_files.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "mesh/shape.hpp"
#include "meshing/import.hpp"

namespace soft::meshing {
namespace {

using mesh::Index;
using sample::Cells;
using sample::FileKind;
using sample::Sides;
using sample::TemporaryFile;

struct Choice {
    Cells cells;
    FileKind kind;
};

std::string name_of(const Choice& choice) {
    static constexpr std::array<const char*, 5> cells{"triangles", "quadrilaterals", "tetrahedra", "hexahedra",
                                                      "wedges"};
    return std::string{cells[static_cast<std::size_t>(choice.cells)]} + (choice.kind.version == 4.1 ? "41" : "22") +
           (choice.kind.binary ? "binary" : "ascii") + std::to_string(choice.kind.order) +
           (choice.kind.incomplete ? "incomplete" : "");
}

void PrintTo(const Choice& choice, std::ostream* out) { *out << name_of(choice); }

std::vector<Choice> choices() {
    std::vector<Choice> all;
    for (const Cells cells :
         {Cells::triangles, Cells::quadrilaterals, Cells::tetrahedra, Cells::hexahedra, Cells::wedges})
        for (const double version : {2.2, 4.1})
            for (const bool binary : {false, true})
                for (const FileKind& order :
                     {FileKind{0, false, 1, false}, FileKind{0, false, 2, false}, FileKind{0, false, 2, true}})
                    all.push_back({cells, {version, binary, order.order, order.incomplete}});
    return all;
}

bool is_plane(const Choice& choice) {
    return choice.cells == Cells::triangles || choice.cells == Cells::quadrilaterals;
}

mesh::Mesh part(const Choice& choice, Sides sides, double unit_m = 1.0) {
    const TemporaryFile file{name_of(choice) + ".msh"};
    sample::write_part(file.path, choice.cells, sides, choice.kind);
    return import_mesh(file.path, unit_m);
}

class Imported : public testing::TestWithParam<Choice> {};

TEST_P(Imported, HasTheExpectedVolumeGroupsAndBoundary) {
    const mesh::Mesh mesh = part(GetParam(), Sides::straight, 0.0254);
    EXPECT_EQ(mesh.dimension, is_plane(GetParam()) ? 2 : 3);
    EXPECT_NEAR(measure(mesh, mesh::Measure::plain) / (1.5 * std::pow(0.0254, mesh.dimension)), 1, 1e-12);
    EXPECT_EQ(mesh.region_names, std::vector<std::string>{"part"});
    const std::vector<std::string> names = is_plane(GetParam())
                                               ? std::vector<std::string>{"ends", "inner", "outer"}
                                               : std::vector<std::string>{"bottom", "ends", "inner", "outer", "top"};
    std::vector<std::string> found;
    std::vector<mesh::Facet> named;
    for (const auto& [name, facets] : mesh.facet_sets) {
        found.push_back(name);
        named.insert(named.end(), facets.begin(), facets.end());
    }
    EXPECT_EQ(found, names);
    std::sort(named.begin(), named.end());
    EXPECT_EQ(named, boundary_facets(mesh));
    const std::set<Index> used(mesh.connectivity.begin(), mesh.connectivity.end());
    EXPECT_EQ(used.size(), mesh.points.size());
}

/// On straight lines gmsh's mid nodes are the means of their corners; a wrong node order would violate this.
TEST_P(Imported, HasItsNodesInVtkOrder) {
    const mesh::Mesh mesh = part(GetParam(), Sides::straight);
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const mesh::CellTopology& cell = mesh::topology(mesh.cell_type(c));
        EXPECT_EQ(cell.order, GetParam().kind.order);
        const auto nodes = mesh.cell_nodes(c);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const std::vector<double> weights = mesh::vertex_values(cell.type, cell.nodes[n]);
            for (std::size_t d = 0; d < 3; ++d) {
                double mean = 0;
                for (std::size_t v = 0; v < weights.size(); ++v) mean += weights[v] * mesh.point(nodes[v])[d];
                constexpr double gmsh_rounds = 1e-10;  // rounding of gmsh's points on curves of unit length
                ASSERT_NEAR(mesh.point(nodes[n])[d], mean, gmsh_rounds) << "node " << n;
            }
        }
    }
    EXPECT_GT(mesh::quality(mesh).min_scaled_jacobian, 0.2);
}

TEST_P(Imported, FollowsArcsWithTheAccuracyOfItsOrder) {
    const mesh::Mesh mesh = part(GetParam(), Sides::round);
    const bool second = GetParam().kind.order == 2;
    // The area error of the ring is 5 % with chords of 30 degrees, and a thousandth of that with parabolas.
    const double area = 0.75 * std::numbers::pi, chords = 9 * std::sin(std::numbers::pi / 6) / 2;
    const double found = measure(mesh, mesh::Measure::plain);
    if (GetParam().cells == Cells::tetrahedra && !second) {  // the upper arcs have other chords
        EXPECT_GT(found, chords - 1e-10);
        EXPECT_LT(found, area);
    } else {
        EXPECT_NEAR(found / (second ? area : chords), 1, second ? 1e-3 : 1e-10);
    }
    for (const auto& [face, radius] : {std::pair{"inner", 1.0}, std::pair{"outer", 2.0}})
        for (const mesh::Facet& facet : mesh.facet_sets.at(face)) {
            const auto nodes = facet_nodes(mesh, facet);
            const bool whole = !GetParam().kind.incomplete && second;
            const auto exact =
                whole ? nodes.size() : static_cast<std::size_t>(mesh::topology(facet_type(mesh, facet)).vertex_count);
            for (std::size_t n = 0; n < exact; ++n)
                EXPECT_NEAR(std::hypot(mesh.point(nodes[n])[0], mesh.point(nodes[n])[1]), radius, 1e-6) << face;
        }
    EXPECT_GT(mesh::quality(mesh).min_scaled_jacobian, 0.1);
}

TEST_P(Imported, IsTheSameFromEveryVersionAndEncoding) {
    const mesh::Mesh mesh = part(GetParam(), Sides::round);
    Choice plain = GetParam();
    plain.kind.version = 4.1;
    plain.kind.binary = false;
    const mesh::Mesh reference = part(plain, Sides::round);
    EXPECT_EQ(mesh.connectivity, reference.connectivity);
    EXPECT_EQ(mesh.facet_sets, reference.facet_sets);
    ASSERT_EQ(mesh.points.size(), reference.points.size());
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(mesh.points[p][d], reference.points[p][d], 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Import, Imported, testing::ValuesIn(choices()),
                         [](const auto& test) { return name_of(test.param); });

/// Two adjacent squares, the right one clockwise; region names with blanks, one face without a name.
TEST(Import, ReadsRegionsReordersMirroredPartsAndNamesUnnamedFaces) {
    const TemporaryFile file{"two.msh", R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
2 7 "soft part"
2 8 "hard.part"
1 4 "left"
$EndPhysicalNames
$Nodes
7
1 0 0 3
2 1 0 3
30 2 0 3
4 0 1 3
5 1 1 3
6 2 1 3
7 9 9 3
$EndNodes
$Elements
4
1 1 2 4 1 1 4
2 1 2 5 2 30 6
3 3 2 7 1 1 2 5 4
4 3 2 8 2 2 5 6 30
$EndElements
)"};
    const mesh::Mesh mesh = import_mesh(file.path, 1e-3);
    EXPECT_EQ(mesh.points.size(), 6u);  // node 7 has no cell
    EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"soft_part", "hard_part"}));
    EXPECT_EQ(mesh.cell_regions, (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(mesh.facet_sets.at("left").size(), 1u);
    EXPECT_EQ(mesh.facet_sets.at("face_5").size(), 1u);
    EXPECT_NEAR(measure(mesh, mesh::Measure::plain), 2e-6, 1e-20);
    EXPECT_GT(mesh::quality(mesh).min_scaled_jacobian, 0.99);
    EXPECT_EQ(mesh.points[0], (mesh::Point{0, 0, 0}));
}

TEST(Import, MirroredSolidIsRenumbered) {
    for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra, Cells::wedges}) {
        const TemporaryFile file{"mirrored.msh"};
        {
            const sample::Gmsh session;
            sample::draw_part(cells, Sides::round, 3);
            gmsh::option::setNumber("Mesh.MeshSizeMax", 0.5);
            gmsh::option::setNumber("Mesh.ElementOrder", 2);
            gmsh::model::mesh::generate(3);
            sample::move_nodes(-1, 0);
            sample::write(file.path, {});
        }
        const mesh::Mesh mesh = import_mesh(file.path, 1);
        EXPECT_NEAR(measure(mesh, mesh::Measure::plain) / (0.75 * std::numbers::pi), 1, 1e-3);
        EXPECT_GT(mesh::quality(mesh).min_scaled_jacobian, 0.1);
        EXPECT_EQ(mesh.facet_sets.size(), 5u);
    }
}

}  // namespace
}  // namespace soft::meshing
