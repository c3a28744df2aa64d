/// Mesh files that contain a part of a body, cut at its symmetry planes (geometry.symmetry).
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "../meshing/gmsh_files.hpp"
#include "geometry/case_warnings.hpp"
#include "model/cavity_surface.hpp"
#include "sample.hpp"
#include "surface/volume.hpp"

namespace soft::geometry {
namespace {

using meshing::sample::TemporaryFile;

/// The octant of a hollow cube, 4 mm wide with a cavity of 2 mm: seven hexahedra of 1 mm with the lowest corner at `corner_mm`.
void write_octant(const std::filesystem::path& path, double corner_mm) {
    constexpr std::array<std::array<int, 3>, 8> corners{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    const auto node = [](int i, int j, int k) { return 1 + i + 3 * j + 9 * k; };
    std::ofstream file(path);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"wall\"\n3 2 \"body\"\n$EndPhysicalNames\n"
         << "$Nodes\n27\n";
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
                file << node(i, j, k) << " " << corner_mm + i << " " << corner_mm + j << " " << corner_mm + k << "\n";
    file << "$EndNodes\n$Elements\n10\n";
    int element = 0;
    const auto quadrangle = [&](const std::array<std::array<int, 3>, 4>& nodes) {
        file << ++element << " 3 2 1 1";
        for (const auto& [i, j, k] : nodes) file << " " << node(i, j, k);
        file << "\n";
    };
    quadrangle({{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}});
    quadrangle({{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}});
    quadrangle({{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}});
    for (int cell = 1; cell < 8; ++cell) {
        file << ++element << " 5 2 2 2";
        for (const auto& [i, j, k] : corners) file << " " << node(i + cell % 2, j + cell / 2 % 2, k + cell / 4);
        file << "\n";
    }
    file << "$EndElements\n";
}

design::Design octant(const TemporaryFile& file, const std::string& symmetry, const std::string& sealed = {}) {
    return design::read_design("family: imported\ngeometry: {file: " + file.path.string() +
                                   ", cavity: wall, symmetry: " + symmetry +
                                   "}\nmaterial: {law: neo-hookean, mu: 0.1 MPa, kappa: incompressible}\n" +
                                   "mesh: {order: 2}\nloads: {cavity: {pressure: 1 kPa" + sealed + "}}\n",
                               "octant.yaml", catalogue_keys(), {});
}

TEST(CutMesh, RepresentsTheWholeBody) {
    const TemporaryFile file{"octant.msh"};
    write_octant(file.path, 1e-9);  // rounding of a mesher
    const design::Design design = octant(file, "xyz");
    const model::Case built = build_case(design);
    EXPECT_EQ(built.model_fraction, 0.125);
    ASSERT_EQ(built.supports.size(), 3u);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(built.supports[c].fixed[c]);
        const auto& facets = built.mesh.facet_sets.at(built.supports[c].face);
        EXPECT_EQ(facets.size(), 3u);
        for (const mesh::Facet& facet : facets)
            for (const mesh::Index node : facet_nodes(built.mesh, facet)) EXPECT_EQ(built.mesh.point(node)[c], 0.0);
    }
    ASSERT_EQ(built.cavities.size(), 1u);
    EXPECT_TRUE(built.cavities[0].openings.empty());
    const auto facets = model::cavity_facets(built, built.cavities[0]);
    EXPECT_NEAR(surface::enclosed_volume_m3(built, facets, built.mesh.points), 8e-9, 1e-14);
    EXPECT_TRUE(case_warnings(design, built).empty());
}

TEST(CutMesh, WithoutItsPlanesIsReported) {
    const TemporaryFile file{"octant.msh"};
    write_octant(file.path, 0);
    const design::Design design = octant(file, "none");
    const auto warnings = case_warnings(design, build_case(design));
    ASSERT_EQ(warnings.size(), 2u);  // also the opening that is not sealed
    EXPECT_EQ(warnings[1].substr(0, 67),
              "geometry: the rim of cavity is up to 288.675 um off a plane; the vo");  // 0.5/sqrt 3
    const design::Design stated = octant(file, "none", ", sealed: false");
    EXPECT_EQ(case_warnings(stated, build_case(stated)).size(), 1u);
}

TEST(CutMesh, RefusesPlanesAtWhichTheMeshIsNotCut) {
    const TemporaryFile file{"octant.msh"};
    const auto refusal = [&](double corner_mm) -> std::string {
        write_octant(file.path, corner_mm);
        try {
            static_cast<void>(build_case(octant(file, "y")));
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(refusal(1).find("geometry.symmetry: no facet of the mesh lies in the plane y = 0"), std::string::npos);
    EXPECT_NE(refusal(-1).find("geometry.symmetry: the part extends from y = -1 mm to 1 mm and is not cut at 0"),
              std::string::npos);
}

}  // namespace
}  // namespace soft::geometry
