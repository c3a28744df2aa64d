#include "meshing/body_surface.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/files.hpp"
#include "meshing/surface_file.hpp"
#include "soups.hpp"

namespace soft::meshing {
namespace {

using test::ball_soup;
using test::box_soup;
using test::joined;
using test::made;

std::string refusal(const FacetSoup& soup) {
    try {
        static_cast<void>(made(soup));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "accepted";
}

const FacetSoup cube = box_soup({0, 0, 0}, {10, 10, 10});

TEST(BodySurface, AValidCubeNeedsNoRepair) {
    const BodySurface surface = made(cube);
    EXPECT_TRUE(surface.repairs.empty());
    EXPECT_EQ(surface.triangles.size(), 12u);
    ASSERT_EQ(surface.shells.size(), 1u);
    EXPECT_EQ(surface.shells[0].name, "outer");
    EXPECT_NEAR(surface.volume_m3(), 1e-6, 1e-18);
    EXPECT_NEAR(surface.area_m2(), 6e-4, 1e-15);
    EXPECT_NEAR(surface.extent_m(), 1e-2, 1e-15);
}

TEST(BodySurface, DuplicatePointsThatDifferByRoundingAreMerged) {
    FacetSoup soup = test::torn(cube);
    for (std::size_t n = 0; n < soup.points.size(); ++n) soup.points[n][n % 3] += 3e-7 * (n % 2 == 0 ? 1 : -1);
    const BodySurface surface = made(soup);
    EXPECT_EQ(surface.points.size(), 8u);
    EXPECT_EQ(surface.repairs, std::vector<std::string>{"28 duplicate points merged"});
    EXPECT_NEAR(surface.volume_m3(), 1e-6, 1e-12);
}

TEST(BodySurface, FlippedFacetsAreReoriented) {
    FacetSoup soup = cube;
    std::swap(soup.facets[3][0], soup.facets[3][1]);
    EXPECT_EQ(made(soup).repairs, std::vector<std::string>{"1 facet reoriented"});
    EXPECT_NEAR(made(soup).volume_m3(), 1e-6, 1e-18);
    for (auto& facet : soup.facets) std::swap(facet[0], facet[1]);  // now eleven have the wrong orientation
    EXPECT_EQ(made(soup).repairs, std::vector<std::string>{"11 facets reoriented"});
    EXPECT_NEAR(made(soup).volume_m3(), 1e-6, 1e-18);
}

TEST(BodySurface, DuplicateAndDegenerateFacetsAreRemoved) {
    FacetSoup soup = cube;
    soup.facets.push_back({3, 2, 0});
    soup.facets.push_back({1, 1, 2});
    EXPECT_EQ(made(soup).repairs, std::vector<std::string>{"2 degenerate or duplicate facets removed"});
    EXPECT_EQ(made(soup).triangles.size(), 12u);
}

TEST(BodySurface, AZeroAreaFacetAlongAnEdgeIsRemoved) {
    FacetSoup soup =
        cube;  // the edge 0-1 gets a point in its middle for one of its facets, and a zero-area facet beside it
    soup.points.push_back({5, 0, 0});
    soup.facets[1] = {0, 3, 8};
    soup.facets.push_back({8, 3, 1});
    soup.facets.push_back({0, 8, 1});
    const BodySurface surface = made(soup);
    EXPECT_EQ(surface.repairs, std::vector<std::string>{"1 zero-area facet removed"});
    EXPECT_NEAR(surface.volume_m3(), 1e-6, 1e-18);
}

TEST(BodySurface, UnusedPointsAreIgnored) {
    FacetSoup soup = cube;
    soup.points.insert(soup.points.begin() + 3, {-100, 5, 5});
    for (auto& facet : soup.facets)
        for (std::size_t& node : facet) node += node >= 3 ? 1 : 0;
    const BodySurface surface = made(soup);
    EXPECT_EQ(surface.points.size(), 8u);
    EXPECT_NEAR(surface.volume_m3(), 1e-6, 1e-15);
}

TEST(BodySurface, AFlatSurfaceIsRefused) {
    const FacetSoup flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};
    EXPECT_NE(refusal(flat).find("encloses no volume"), std::string::npos) << refusal(flat);
}

TEST(BodySurface, AHoleIsRefusedWithItsLocationAndRimLength) {
    FacetSoup soup = cube;
    soup.facets.erase(soup.facets.begin() + 2, soup.facets.begin() + 4);  // the side z = 10
    EXPECT_EQ(
        refusal(soup),
        "part.stl: 1 hole in the surface, near x = 5 mm, y = 5 mm, z = 10 mm with a rim of length 40 mm; close the surface "
        "in the CAD program: a part is a solid, and an opening is a channel through its wall");
}

TEST(BodySurface, AnEdgeWithThreeFacetsIsRefused) {
    FacetSoup soup = cube;
    soup.points.push_back({5, 5, 20});
    soup.facets.push_back({4, 5, 8});
    EXPECT_EQ(
        refusal(soup),
        "part.stl: 1 edge is shared by more than two facets, the first by 3 near x = 5 mm, y = 0 mm, z = 10 mm; unite the "
        "parts into one body or separate them");
}

TEST(BodySurface, IntersectingFacetsAreRefusedWithLocationAndCount) {
    FacetSoup soup = cube;  // the corner (10, 10, 10) pushed through the side z = 0
    soup.points[7] = {10, 10, -2};
    const std::string what = refusal(soup);
    EXPECT_TRUE(what.starts_with("part.stl: ") && what.find("intersect, the first near x = ") != std::string::npos)
        << what;
    const std::string two = refusal(joined(cube, box_soup({5, 5, 5}, {15, 15, 15})));
    EXPECT_TRUE(two.find("pairs of facets intersect, the first near x = ") != std::string::npos) << two;
}

TEST(BodySurface, ACubeInACubeIsACavity) {
    const FacetSoup inner = box_soup({2, 3, 4}, {4, 6, 8});  // oriented as a body: reoriented by the repair
    const BodySurface surface = made(joined(inner, cube));
    ASSERT_EQ(surface.shells.size(), 2u);
    EXPECT_EQ(surface.shells[0].name, "outer");
    EXPECT_EQ(surface.shells[1].name, "cavity");
    EXPECT_NEAR(surface.shells[1].volume_m3, 24e-9, 1e-21);
    EXPECT_NEAR(surface.volume_m3(), 976e-9, 1e-18);
    EXPECT_EQ(surface.repairs, std::vector<std::string>{"12 facets reoriented"});
}

TEST(BodySurface, SeveralCavitiesAreNumberedAlongX) {
    const BodySurface surface = made(joined(joined(cube, ball_soup({7, 5, 5}, 1)), ball_soup({3, 5, 5}, 2)));
    ASSERT_EQ(surface.shells.size(), 3u);
    EXPECT_EQ(surface.shells[1].name, "cavity_1");
    EXPECT_NEAR(surface.shells[1].inside[0], 3e-3, 1e-9);
    EXPECT_NEAR(surface.shells[1].volume_m3 / surface.shells[2].volume_m3, 8, 1e-9);
}

TEST(BodySurface, SeveralBodiesAreRefused) {
    const std::string what = refusal(joined(cube, box_soup({20, 0, 0}, {22, 2, 2})));
    EXPECT_EQ(
        what,
        "part.stl: 2 bodies in one file, the second around x = 21 mm, y = 1 mm, z = 1 mm; unite them or put each into its own file");
    const FacetSoup floating = joined(joined(cube, box_soup({2, 2, 2}, {8, 8, 8})), box_soup({4, 4, 4}, {6, 6, 6}));
    EXPECT_TRUE(refusal(floating).starts_with("part.stl: 2 bodies in one file")) << refusal(floating);
}

/// A temporary file that is removed at the end of the test.
struct File {
    std::filesystem::path path;
    explicit File(const std::string& name) : path(std::filesystem::temp_directory_path() / ("body_surface_" + name)) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { std::filesystem::remove(path); }
    void write(const core::Bytes& bytes) const {
        std::ofstream stream(path, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
};

TEST(SurfaceFile, ReadsBackWhatWasWritten) {
    const BodySurface surface = made(cube);
    const surface::Triangles triangles{surface.points, surface.triangles, std::vector<int>(12), surface.points, {}};
    for (const char* name : {"a.stl", "a.STL", "a.obj"}) {
        const File file(name);
        file.write(surface_file(triangles, file.path));
        const BodySurface back = body_surface(read_soup(file.path), {name, "mm", 1e-3});
        EXPECT_EQ(back.triangles.size(), 12u) << name;
        EXPECT_NEAR(back.volume_m3(), 1e-6, 1e-15) << name;
    }
}

TEST(SurfaceFile, ReadsAsciiStlAndObjQuadrilaterals) {
    const File ascii("text.stl"), quads("quads.obj");
    {
        std::ofstream stream(ascii.path);
        stream << "solid cube\n";
        for (const auto& facet : cube.facets) {
            stream << "facet normal 0 0 0\n outer loop\n";
            for (const std::size_t n : facet)
                stream << "  vertex " << cube.points[n][0] << " " << cube.points[n][1] << " " << cube.points[n][2]
                       << "\n";
            stream << " endloop\nendfacet\n";
        }
        stream << "endsolid cube\n";
        std::ofstream other(quads.path);
        for (const mesh::Point& p : cube.points) other << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
        other << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    }
    EXPECT_NEAR(made(read_soup(ascii.path)).volume_m3(), 1e-6, 1e-15);
    EXPECT_NEAR(made(read_soup(quads.path)).volume_m3(), 1e-6, 1e-15);
}

TEST(SurfaceFile, RefusesFilesThatAreNotSurfaces) {
    const File file("words.stl");
    std::ofstream(file.path) << "these are words\n";
    EXPECT_THROW(static_cast<void>(read_soup(file.path)), Error);
    EXPECT_THROW(static_cast<void>(read_soup("/nowhere/part.stl")), Error);
    EXPECT_FALSE(is_surface_file("part.msh"));
}

}  // namespace
}  // namespace soft::meshing
