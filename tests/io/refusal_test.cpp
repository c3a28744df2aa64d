/// Valid HDF5 files with invalid content: a valid case is modified with plain HDF5 calls.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "example_case.hpp"
#include "io/case_file.hpp"
#include "io/hdf5_write.hpp"
#include "tamper.hpp"

namespace soft::io {
namespace {

using namespace test;

/// Creates a dataset with the given creation properties, without data.
void declare(hid_t file, const char* name, hid_t type, hsize_t count, hid_t properties) {
    unlink(file, name);
    const hsize_t limit = H5Pget_layout(properties) == H5D_CHUNKED ? H5S_UNLIMITED : count;
    const SpaceHandle space{H5Screate_simple(1, &count, &limit)};
    const DatasetHandle dataset{H5Dcreate2(file, name, type, space.get(), H5P_DEFAULT, properties, H5P_DEFAULT)};
    ASSERT_TRUE(dataset) << name;
}

void declare_chunked(hid_t file, const char* name, hsize_t count, hsize_t chunk) {
    const PropertiesHandle properties{H5Pcreate(H5P_DATASET_CREATE)};
    H5Pset_chunk(properties.get(), 1, &chunk);
    H5Pset_deflate(properties.get(), 1);
    declare(file, name, H5T_STD_I64LE, count, properties.get());
}

void declare_external(hid_t file) {
    const PropertiesHandle properties{H5Pcreate(H5P_DATASET_CREATE)};
    H5Pset_external(properties.get(), "/etc/passwd", 0, 16);
    declare(file, "/shape/cavities/openings/area", H5T_IEEE_F64LE, 1, properties.get());
}

void declare_virtual(hid_t file) {
    const PropertiesHandle properties{H5Pcreate(H5P_DATASET_CREATE)};
    const hsize_t count = 1;
    const SpaceHandle space{H5Screate_simple(1, &count, nullptr)};
    H5Pset_virtual(properties.get(), space.get(), "other.h5", "/secret", space.get());
    declare(file, "/shape/cavities/openings/area", H5T_IEEE_F64LE, 1, properties.get());
}

void declare_variable_text(hid_t file) {
    unlink(file, "/design/effective_yaml");
    const TypeHandle type{H5Tcopy(H5T_C_S1)};
    H5Tset_size(type.get(), H5T_VARIABLE);
    const SpaceHandle space{H5Screate(H5S_SCALAR)};
    const DatasetHandle dataset{
        H5Dcreate2(file, "/design/effective_yaml", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)};
    const char* text = "tube";
    H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
}

void set_version(hid_t file, std::int64_t version) {
    H5Adelete(file, "format_version");
    write_attribute(file, "format_version", version);
}

using Integers = std::vector<std::int64_t>;
using Numbers = std::vector<double>;
using Words = std::vector<std::string>;

const std::vector<Corruption>& corruptions() {
    static const std::vector<Corruption> list{
        {"FacetOfNoCell", [](hid_t f) { overwrite(f, "/mesh/facets/cavity", 2, Integers{9000}); },
         "case.h5:/mesh/facets/cavity[1]: cell 9000 does not exist; rebuild the case with mesh-gen"},
        {"NegativeCell", [](hid_t f) { overwrite(f, "/mesh/facets/cavity", 0, Integers{-1}); },
         "/mesh/facets/cavity[0]"},
        {"NoSuchLocalFacet", [](hid_t f) { overwrite(f, "/mesh/facets/cavity", 1, Integers{4}); },
         "/mesh/facets/cavity[0]"},
        {"HugeLocalFacet", [](hid_t f) { overwrite(f, "/mesh/facets/cavity", 1, Integers{1LL << 40}); },
         "/mesh/facets/cavity[0]"},
        {"FacetsOfThreeColumns",
         [](hid_t f) {
             replace<std::int64_t>(f, "/mesh/facets", "cavity", {0, 0, 0}, {1, 3});
         },
         "/mesh/facets/cavity"},
        {"PointOfNoPoint", [](hid_t f) { overwrite(f, "/mesh/points/tip", 1, Integers{15}); }, "/mesh/points/tip[1]"},
        {"ConnectivityTooLarge", [](hid_t f) { overwrite(f, "/VTKHDF/Connectivity", 5, Integers{15}); },
         "/VTKHDF/Connectivity[5]"},
        {"ConnectivityNegative", [](hid_t f) { overwrite(f, "/VTKHDF/Connectivity", 5, Integers{-1}); },
         "/VTKHDF/Connectivity[5]"},
        {"OffsetsFallBack", [](hid_t f) { overwrite(f, "/VTKHDF/Offsets", 1, Integers{-9}); }, "/VTKHDF/Offsets[1]"},
        {"OffsetsOverflow",
         [](hid_t f) { overwrite(f, "/VTKHDF/Offsets", 1, Integers{std::numeric_limits<std::int64_t>::max()}); },
         "/VTKHDF/Offsets[1]"},
        {"UnknownCellType",
         [](hid_t f) {
             replace<std::uint8_t>(f, "/VTKHDF", "Types", {28, 77});
         },
         "/VTKHDF/Types[1]"},
        {"CellOfAnotherDimension",
         [](hid_t f) {
             replace<std::uint8_t>(f, "/VTKHDF", "Types", {28, 29});
         },
         "/VTKHDF/Types[1]"},
        {"CellOfFewerNodes",
         [](hid_t f) {
             replace<std::uint8_t>(f, "/VTKHDF", "Types", {28, 9});
         },
         "/VTKHDF/Offsets[2]"},
        {"NoCells", [](hid_t f) { replace<std::int64_t>(f, "/VTKHDF", "NumberOfCells", {0}); },
         "/VTKHDF/NumberOfCells"},
        {"MorePointsThanThereAre", [](hid_t f) { replace<std::int64_t>(f, "/VTKHDF", "NumberOfPoints", {1LL << 36}); },
         "/VTKHDF/Points"},
        {"PointNotFinite", [](hid_t f) { overwrite(f, "/VTKHDF/Points", 4, Numbers{nan}); }, "/VTKHDF/Points[4]"},
        {"NegativeRadius", [](hid_t f) { overwrite(f, "/VTKHDF/Points", 1, Numbers{-0.1}); }, "/VTKHDF/Points"},
        {"RegionOfNoName",
         [](hid_t f) {
             replace<std::int32_t>(f, "/mesh", "cell_regions", {0, 2});
         },
         "/mesh/cell_regions[1]"},
        {"RegionsOfAnotherType",
         [](hid_t f) {
             replace<std::int64_t>(f, "/mesh", "cell_regions", {0, 1});
         },
         "/mesh/cell_regions"},
        {"UnknownKinematics", [](hid_t f) { replace_text(f, "/shape", "kinematics", "quantum"); },
         "/shape/kinematics: 'quantum'"},
        {"EscapeSequenceInAWord", [](hid_t f) { replace_text(f, "/shape", "kinematics", "\x1b[2J"); },
         "/shape/kinematics: '?[2J'"},
        {"KinematicsOfAnotherDimension", [](hid_t f) { replace_text(f, "/shape", "kinematics", "solid"); },
         "/VTKHDF/Types[0]"},
        {"FractionBeyondOne", [](hid_t f) { overwrite(f, "/shape/model_fraction", 0, Numbers{1.5}); },
         "/shape/model_fraction"},
        {"FlagOfTwo",
         [](hid_t f) {
             replace<std::uint8_t>(f, "/shape", "symmetry_planes", {0, 2, 0});
         },
         "/shape/symmetry_planes"},
        {"SupportOfNoFace",
         [](hid_t f) {
             unlink(f, "/shape/supports/face");
             write_texts(f, {"/shape/supports/face", "1", ""}, Words{"cavity", "no"});
         },
         "/shape/supports/face[1]: there is no face named 'no'"},
        {"SupportOfNoComponent",
         [](hid_t f) {
             replace<std::uint8_t>(f, "/shape/supports", "fixed", {0, 0, 0, 1, 1, 0}, {2, 3});
         },
         "/shape/supports/fixed[0]: fixes no component"},
        {"AxisNotUnit", [](hid_t f) { overwrite(f, "/shape/axis", 0, Numbers{2}); },
         "/shape/axis: is not a unit vector"},
        {"OpeningWithoutArea", [](hid_t f) { overwrite(f, "/shape/cavities/openings/area", 0, Numbers{0}); },
         "/shape/cavities/openings/area"},
        {"OpeningOfNoCavity", [](hid_t f) { overwrite(f, "/shape/cavities/openings/cavity", 0, Integers{2}); },
         "/shape/cavities/openings/cavity[0]: there is no cavity 2"},
        {"OpeningDirectionNotUnit", [](hid_t f) { overwrite(f, "/shape/cavities/openings/direction", 0, Numbers{0}); },
         "/shape/cavities/openings/direction"},
        {"InnerFaceOfNoCavity", [](hid_t f) { overwrite(f, "/shape/cavities/inner_faces/cavity", 0, Integers{-1}); },
         "/shape/cavities/inner_faces/cavity[0]"},
        {"TwoCavitiesOfOneName",
         [](hid_t f) {
             replace_texts(f, "/shape/cavities", "name", {"main", "main"});
         },
         "/shape/cavities/name[1]: 'main' occurs twice"},
        {"WallOfNoFace",
         [](hid_t f) {
             replace_texts(f, "/shape/cavities", "wall", {"cavity", "nowhere"});
         },
         "/shape/cavities/wall[1]: there is no face named 'nowhere'"},
        {"WallOfAnEmptyFace",
         [](hid_t f) {
             replace_texts(f, "/shape/cavities", "wall", {"unused", "cavity"});
         },
         "/shape/cavities/wall[0]: the face 'unused' is empty"},
        {"FibersWithoutStiffness", [](hid_t f) { overwrite(f, "/shape/fibers/k1", 0, Numbers{0}); },
         "/shape/fibers/k1"},
        {"ThreeFamiliesOfFibers", [](hid_t f) { overwrite(f, "/shape/fibers/families", 0, Integers{3}); },
         "/shape/fibers/families: must be 1 or 2"},
        {"UnknownFrame", [](hid_t f) { replace_texts(f, "/shape/fibers", "frame", {"hyperbolic"}); },
         "/shape/fibers/frame[0]: 'hyperbolic'"},
        {"FamiliesBeyondInt", [](hid_t f) { overwrite(f, "/shape/fibers/families", 0, Integers{1LL << 32}); },
         "/shape/fibers/families"},
        {"ObstacleWithoutFacets",
         [](hid_t f) {
             replace<std::int64_t>(f, "/shape/obstacles/die", "facets", {}, {0, 3});
         },
         "/shape/obstacles/die/facets: there are no facets"},
        {"ObstacleOfAnUnknownPoint", [](hid_t f) { overwrite(f, "/shape/obstacles/die/facets", 1, Integers{3}); },
         "/shape/obstacles/die/facets[0]: names a point that does not exist"},
        {"TriangleInASection", [](hid_t f) { overwrite(f, "/shape/obstacles/die/facets", 2, Integers{2}); },
         "/shape/obstacles/die/facets[0]: names a point that does not exist"},
        {"DegenerateFacet", [](hid_t f) { overwrite(f, "/shape/obstacles/die/facets", 1, Integers{0}); },
         "/shape/obstacles/die/facets[0]: is degenerate"},
        {"ObstacleBesideTheSection", [](hid_t f) { overwrite(f, "/shape/obstacles/die/points", 2, Numbers{0.1}); },
         "/shape/obstacles/die/points[0]: is not a point of the model"},
        {"ListsOfDifferentLength",
         [](hid_t f) {
             replace<double>(f, "/shape/cavities/openings", "area", {1, 2, 3});
         },
         "/shape/cavities/openings/area"},
        {"MissingGroup", [](hid_t f) { unlink(f, "/shape/supports"); }, "case.h5:/shape/supports: is missing"},
        {"MissingDataset", [](hid_t f) { unlink(f, "/shape/axis"); }, "case.h5:/shape/axis: is missing"},
        {"MissingFormat", [](hid_t f) { H5Adelete(f, "format"); }, "not a soft-actuator file"},
        {"OlderVersion", [](hid_t f) { set_version(f, 1); },
         "case.h5: an older release wrote it (format 1, this program reads 2); generate the case again with mesh-gen"},
        {"NewerVersion", [](hid_t f) { set_version(f, 3); }, "case.h5: a newer release wrote it (format 3"},
        {"GroupForADataset",
         [](hid_t f) {
             unlink(f, "/shape/cavities/openings/area");
             static_cast<void>(create_group(f, "/shape/cavities/openings/area", ""));
         },
         "/shape/cavities/openings/area"},
        {"DatasetForAGroup",
         [](hid_t f) {
             unlink(f, "/shape/supports");
             write_number(f, {"/shape/supports", "1", ""}, 1);
         },
         "/shape/supports"},
        {"ExternalLink",
         [](hid_t f) {
             unlink(f, "/shape/supports");
             H5Lcreate_external("other.h5", "/x", f, "/shape/supports", H5P_DEFAULT, H5P_DEFAULT);
         },
         "case.h5:/shape/supports: is a soft or external link"},
        {"SoftLink",
         [](hid_t f) {
             unlink(f, "/shape/cavities/openings/area");
             H5Lcreate_soft("/shape/axis", f, "/shape/cavities/openings/area", H5P_DEFAULT, H5P_DEFAULT);
         },
         "case.h5:/shape/cavities/openings/area: is a soft or external link"},
        {"DanglingSoftLinkAmongFaces",
         [](hid_t f) { H5Lcreate_soft("/nowhere", f, "/mesh/facets/x", H5P_DEFAULT, H5P_DEFAULT); }, "/mesh/facets/x"},
        {"ExternalStorage", declare_external, "/shape/cavities/openings/area: stores its data in another file"},
        {"VirtualStorage", declare_virtual, "/shape/cavities/openings/area: uses an unsupported storage layout"},
        {"VariableLengthText", declare_variable_text, "/design/effective_yaml: is not text of fixed length"},
        {"DeclaredButNotStored", [](hid_t f) { declare_chunked(f, "/mesh/points/tip", 1ULL << 28, 1024); },
         "/mesh/points/tip: is declared larger than its stored data can be"},
        {"DeclaredBeyondReason", [](hid_t f) { declare_chunked(f, "/mesh/points/tip", 1ULL << 62, 1024); },
         "/mesh/points/tip: is declared too large"},
        {"ChunkBeyondReason", [](hid_t f) { declare_chunked(f, "/mesh/points/tip", 2, 1ULL << 27); },
         "/mesh/points/tip: has chunks that are too large"},
        {"NameThatIsNone", [](hid_t f) { static_cast<void>(create_group(f, "/mesh/facets/a b", "")); },
         "'a b' is not a valid name"},
    };
    return list;
}

class CorruptedFile : public testing::TestWithParam<std::size_t> {};

TEST_P(CorruptedFile, IsRejectedWithItsLocation) {
    const Corruption& corruption = corruptions()[GetParam()];
    const std::string message = refusal(tampered(section_image(), corruption.change));
    EXPECT_NE(message.find(corruption.location), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Refusal, CorruptedFile, testing::Range(std::size_t{0}, corruptions().size()),
                         [](const auto& corruption) { return std::string{corruptions()[corruption.param].what}; });

}  // namespace
}  // namespace soft::io
