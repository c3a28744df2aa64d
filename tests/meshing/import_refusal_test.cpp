/// Invalid mesh files: they are rejected with the expected message and have no other effect.
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "gmsh_files.hpp"
#include "meshing/import.hpp"

namespace soft::meshing {
namespace {

using sample::TemporaryFile;

constexpr const char* head =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 \"wall\"\n$EndPhysicalNames\n";
constexpr const char* nodes = "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n";

std::string two_squares(const std::string& more, int count) {
    return std::string{head} + nodes + "$Elements\n" + std::to_string(2 + count) +
           "\n11 3 2 0 1 1 2 5 4\n12 3 2 0 1 2 3 6 5\n" + more + "$EndElements\n";
}

struct Fault {
    std::string name, text, message;  ///< the message without the file's name
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class InvalidFile : public testing::TestWithParam<Fault> {};

TEST_P(InvalidFile, IsRejectedWithTheReason) {
    const TemporaryFile file{GetParam().name + ".msh", GetParam().text};
    try {
        static_cast<void>(import_mesh(file.path, 1));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(std::string{error.what()}, file.path.string() + GetParam().message);
    }
}

const std::string again = "; repair the mesh and export it again",
                  format = "; export the mesh as Gmsh .msh, version 4.1 or 2.2";

INSTANTIATE_TEST_SUITE_P(
    Import, InvalidFile,
    testing::Values(
        Fault{"blank", "\n", ":2: the file is empty" + format},
        Fault{"garbage", "solid cube\n", ":1: not a Gmsh mesh: the file does not begin with $MeshFormat" + format},
        Fault{"old", "$MeshFormat\n4 0 8\n$EndMeshFormat\n",
              ":2: format version 4 is not supported; export version 4.1 or 2.2 (Gmsh: Mesh.MshFileVersion)"},
        Fault{"headonly", head, ":8: there is no $Nodes or no $Elements section; export the mesh again"},
        Fault{"word", std::string{head} + "$Nodes\n1\n1 0 zero 0\n$EndNodes\n",
              ":10: expected a number, found 'zero'; export the mesh again"},
        Fault{"infinite", std::string{head} + "$Nodes\n1\n1 0 inf 0\n$EndNodes\n",
              ":10: a coordinate is not a finite number; export the mesh again"},
        Fault{"manynodes", std::string{head} + "$Nodes\n99999999999\n1 0 0 0\n$EndNodes\n",
              ":9: the file is truncated; export the mesh again"},
        Fault{"nocells", std::string{head} + nodes + "$Elements\n1\n1 1 2 1 1 1 2\n$EndElements\n",
              ": there are no cells; mesh the surface (2D) or the volume (3D) and save all its elements"},
        Fault{
            "pyramid", two_squares("13 7 2 0 1 1 2 3 4 5\n", 1),
            ":21: pyramids are not supported; mesh with triangles, quadrilaterals, tetrahedra, hexahedra or prisms of first or "
            "second order"},
        Fault{
            "third", two_squares("13 21 2 0 1 1 2 3 4 5 6 1 2 3 4\n", 1),
            ":21: elements of Gmsh's type 21 are not supported; mesh with triangles, quadrilaterals, tetrahedra, hexahedra or "
            "prisms of first or second order"},
        Fault{"unknownnode", two_squares("13 3 2 0 1 1 2 77 4\n", 1),
              ": element 13 uses node 77, which the file does not define" + again},
        Fault{
            "inner", two_squares("13 1 2 1 1 2 5\n", 1),
            ": element 13 of the face 'wall' lies inside the body, between two cells; remove inner surfaces from the physical groups"},
        Fault{
            "across", two_squares("13 1 2 1 1 1 5\n", 1),
            ": element 13 of the face 'wall' is not a side of a cell; mesh surface and volume together, so that they share nodes"},
        Fault{"twice", two_squares("13 3 2 0 1 4 1 2 5\n", 1),
              ": element 11 and element 13 are the same cell; put each part in one physical group only"},
        Fault{
            "overlap", two_squares("13 2 2 0 1 2 5 4\n", 1),
            ": element 13 shares a side with element 11 and element 12; the mesh overlaps itself: remove duplicate cells"},
        Fault{"insideout", two_squares("13 3 2 0 1 3 6 2 5\n", 1),
              ": element 13 is inverted or degenerate; remesh with other sizes, or optimise the mesh (Gmsh: Tools, or "
              "Mesh.Optimize, Mesh.HighOrderOptimize)"},
        Fault{"order", two_squares("13 9 2 0 1 1 2 3 4 5 6\n", 1),
              ": element 13 has another order than element 11; mesh all parts with one order"},
        Fault{
            "bent",
            std::string{head} +
                "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0.1\n$EndNodes\n$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n",
            ": the mesh has no cells of dimension 3, and those of dimension 2 do not lie in one plane z = constant; mesh the "
            "volume (and name it as a physical group), or draw the section in the x-y plane"},
        Fault{"names",
              "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"a b\"\n1 2 \"a.b\"\n$EndPhysicalNames\n" +
                  std::string{nodes} + "$Elements\n2\n11 3 2 0 1 1 2 5 4\n12 1 2 1 1 1 2\n$EndElements\n",
              ": two physical groups are both called 'a_b'; rename one of them"}),
    [](const auto& test) { return test.param.name; });

TEST(Import, MissingFileCannotBeOpened) {
    try {
        static_cast<void>(import_mesh("/nowhere/part.msh", 1));
        FAIL() << "opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_open);
        EXPECT_NE(std::string{error.what()}.find("/nowhere/part.msh"), std::string::npos);
    }
}

struct Written {
    double version;
    bool binary;
};

class CorruptedFile : public testing::TestWithParam<Written> {
protected:
    static std::string whole() {
        const TemporaryFile file{"whole.msh"};
        sample::write_part(file.path, sample::Cells::hexahedra, sample::Sides::round,
                           {GetParam().version, GetParam().binary, 2, false}, 1);
        return file.text();
    }
    /// True if accepted; any other exception than Error fails the test.
    static bool accepted(const std::string& text) {
        const TemporaryFile file{"corrupted.msh", text};
        try {
            static_cast<void>(import_mesh(file.path, 1));
        } catch (const Error& error) {
            EXPECT_TRUE(error.code() == ExitCode::bad_input || text.empty()) << error.what();
            return false;
        }
        return true;
    }
};

TEST_P(CorruptedFile, TruncationsAreRejected) {
    const std::string text = whole();
    ASSERT_TRUE(accepted(text));
    const std::size_t needed = text.rfind("$EndElements") + std::string_view{"$EndElements"}.size();
    for (std::size_t size = 1; size < needed; size += size < needed - 400 ? 37 : 1)
        EXPECT_FALSE(accepted(text.substr(0, size))) << size;
}

TEST_P(CorruptedFile, WrongBytesCauseNoCrash) {
    const std::string text = whole();
    std::mt19937 random{7};
    for (int i = 0; i < 500; ++i) {
        std::string corrupted = text;
        for (int k = 0; k < 1 + i % 4; ++k) corrupted[random() % corrupted.size()] = static_cast<char>(random() % 256);
        static_cast<void>(accepted(corrupted));
    }
}

INSTANTIATE_TEST_SUITE_P(Import, CorruptedFile,
                         testing::Values(Written{2.2, false}, Written{2.2, true}, Written{4.1, false},
                                         Written{4.1, true}),
                         [](const auto& test) {
                             return std::string{test.param.version == 4.1 ? "v41" : "v22"} +
                                    (test.param.binary ? "binary" : "ascii");
                         });

}  // namespace
}  // namespace soft::meshing
