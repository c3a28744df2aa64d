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
    declare(file, "/loads/exponent", H5T_IEEE_F64LE, 2, properties.get());
}

void declare_virtual(hid_t file) {
    const PropertiesHandle properties{H5Pcreate(H5P_DATASET_CREATE)};
    const hsize_t count = 2;
    const SpaceHandle space{H5Screate_simple(1, &count, nullptr)};
    H5Pset_virtual(properties.get(), space.get(), "other.h5", "/secret", space.get());
    declare(file, "/loads/exponent", H5T_IEEE_F64LE, 2, properties.get());
}

void declare_variable_text(hid_t file) {
    unlink(file, "/design/family");
    const TypeHandle type{H5Tcopy(H5T_C_S1)};
    H5Tset_size(type.get(), H5T_VARIABLE);
    const SpaceHandle space{H5Screate(H5S_SCALAR)};
    const DatasetHandle dataset{
        H5Dcreate2(file, "/design/family", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)};
    const char* text = "tube";
    H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
}

void set_version(hid_t file) {
    H5Adelete(file, "format_version");
    write_attribute(file, "format_version", std::int64_t{2});
}

using Integers = std::vector<std::int64_t>;
using Numbers = std::vector<double>;
using Words = std::vector<std::string>;
constexpr double infinity = std::numeric_limits<double>::infinity();

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
        {"UnknownKinematics", [](hid_t f) { replace_text(f, "/mesh", "kinematics", "quantum"); },
         "/mesh/kinematics: 'quantum'"},
        {"EscapeSequenceInAWord", [](hid_t f) { replace_text(f, "/mesh", "kinematics", "\x1b[2J"); },
         "/mesh/kinematics: '?[2J'"},
        {"KinematicsOfAnotherDimension", [](hid_t f) { replace_text(f, "/mesh", "kinematics", "solid"); },
         "/mesh/dimension"},
        {"FractionBeyondOne", [](hid_t f) { overwrite(f, "/mesh/model_fraction", 0, Numbers{1.5}); },
         "/mesh/model_fraction"},
        {"FlagOfTwo",
         [](hid_t f) {
             replace<std::uint8_t>(f, "/mesh", "symmetry_planes", {0, 2, 0});
         },
         "/mesh/symmetry_planes"},
        {"ConstantInfinite", [](hid_t f) { overwrite(f, "/materials/rubber/constants/mu", 0, Numbers{infinity}); },
         "/materials/rubber/constants/mu[0]"},
        {"BulkModulusNegative", [](hid_t f) { overwrite(f, "/materials/rubber/bulk_modulus", 0, Numbers{-1}); },
         "/materials/rubber/bulk_modulus"},
        {"RegionWithoutMaterial", [](hid_t f) { unlink(f, "/materials/collar"); }, "/materials"},
        {"TwoMaterialsOfOneOrder", [](hid_t f) { overwrite(f, "/materials/rubber/order", 0, Integers{1}); },
         "/materials/"},
        {"TractionNotFinite", [](hid_t f) { overwrite(f, "/loads/tractions/traction", 4, Numbers{nan}); },
         "/loads/tractions/traction"},
        {"TractionOnNoFace", [](hid_t f) { replace_text(f, "/loads/tractions", "face", "nowhere"); },
         "/loads/tractions/face"},
        {"TargetThatIsNothing",
         [](hid_t f) {
             replace_texts(f, "/loads/targets", "name", {"main", "annex", "nowhere"});
         },
         "/loads/targets/name: there is no cavity or face named 'nowhere'"},
        {"TargetThatIsEmpty",
         [](hid_t f) {
             replace_texts(f, "/loads/targets", "name", {"main", "annex", "unused"});
         },
         "/loads/targets/name: the face 'unused' is empty"},
        {"FaceAmongCavities",
         [](hid_t f) {
             replace_texts(f, "/loads/targets", "name", {"main", "inlet", "inlet"});
         },
         "'inlet' of the load 'supply' is not a cavity"},
        {"CavityLoadedTwice",
         [](hid_t f) {
             replace_texts(f, "/loads/targets", "name", {"main", "main", "inlet"});
         },
         "the cavity 'main' is loaded twice"},
        {"TargetOfNoLoad", [](hid_t f) { overwrite(f, "/loads/targets/load", 2, Integers{2}); },
         "/loads/targets/load[2]"},
        {"LoadWithoutTarget", [](hid_t f) { overwrite(f, "/loads/targets/load", 2, Integers{0}); },
         "/loads/targets/name: "},
        {"TwoLoadsOfOneName",
         [](hid_t f) {
             replace_texts(f, "/loads", "name", {"supply", "supply"});
         },
         "/loads/name[1]: 'supply' occurs twice"},
        {"LoadThatHasNoName",
         [](hid_t f) {
             replace_texts(f, "/loads", "name", {"supply", "a/b"});
         },
         "/loads/name[1]"},
        {"VacuumOutside", [](hid_t f) { overwrite(f, "/loads/ambient_pressure", 1, Numbers{0}); },
         "/loads/ambient_pressure[1]"},
        {"GasWithoutDensity", [](hid_t f) { overwrite(f, "/loads/ambient_density", 0, Numbers{-1}); },
         "/loads/ambient_density[0]"},
        {"GasWithoutExponent", [](hid_t f) { overwrite(f, "/loads/exponent", 0, Numbers{0}); }, "/loads/exponent[0]"},
        {"NegativeTubing", [](hid_t f) { overwrite(f, "/loads/dead_volume", 0, Numbers{-1e-9}); },
         "/loads/dead_volume[0]"},
        {"BodyForceAcrossTheAxis", [](hid_t f) { overwrite(f, "/loads/body_forces/acceleration", 1, Numbers{1}); },
         "/loads/body_forces/acceleration[0]: does not point along the axis"},
        {"BodyForceWithoutDensity", [](hid_t f) { unlink(f, "/materials/collar/density"); },
         "/materials/collar/density: is missing, but a body force requires it"},
        {"DensityZero", [](hid_t f) { overwrite(f, "/materials/rubber/density", 0, Numbers{0}); },
         "/materials/rubber/density"},
        {"MotionOfNoFace",
         [](hid_t f) {
             replace_texts(f, "/loads/motions", "face", {"inlet", "no"});
         },
         "/loads/motions/face[1]"},
        {"MotionOfNoComponent",
         [](hid_t f) {
             replace<std::uint8_t>(f, "/loads/motions", "moved", {0, 0, 0, 1, 1, 0}, {2, 3});
         },
         "/loads/motions/moved[0]: prescribes no component"},
        {"MotionNotFinite", [](hid_t f) { overwrite(f, "/loads/motions/displacement", 0, Numbers{infinity}); },
         "/loads/motions/displacement"},
        {"BendFromNoFace",
         [](hid_t f) {
             replace_texts(f, "/outputs", "reference", {"", ""});
         },
         "/outputs/reference[1]"},
        {"DisplacementFromAFace",
         [](hid_t f) {
             replace_texts(f, "/outputs", "reference", {"inlet", "end_disc"});
         },
         "/outputs/reference[0]"},
        {"UnknownMeasure",
         [](hid_t f) {
             replace_texts(f, "/outputs", "measure", {"displacement", "colour"});
         },
         "/outputs/measure[1]: 'colour'"},
        {"NoStage",
         [](hid_t f) {
             for (const char* name : {"/control/stages/0", "/control/stages/1", "/control/stages/2"}) unlink(f, name);
         },
         "/control/stages: there is no stage"},
        {"StageThatIsMissing", [](hid_t f) { unlink(f, "/control/stages/1"); }, "/control/stages/"},
        {"TwoStagesOfOneName", [](hid_t f) { replace_text(f, "/control/stages/2", "name", "inflate"); },
         "/control/stages[2]: 'inflate' occurs twice"},
        {"StageWithoutAName", [](hid_t f) { replace_text(f, "/control/stages/2", "name", ""); }, "/control/stages[2]"},
        {"UnknownControl", [](hid_t f) { replace_text(f, "/control/stages/0", "control", "hope"); },
         "/control/stages/0/control: 'hope'"},
        {"ControlledByNothing", [](hid_t f) { replace_text(f, "/control/stages/1", "controlled", "bend"); },
         "/control/stages/1/controlled: there is no load named 'bend'"},
        {"ControlledOutputThatIsNone", [](hid_t f) { replace_text(f, "/control/stages/2", "controlled", "supply"); },
         "/control/stages/2/controlled: there is no output named 'supply'"},
        {"UnknownPrescription",
         [](hid_t f) {
             replace_texts(f, "/control/stages/0", "prescription", {"taste", "pressure"});
         },
         "/control/stages/0/prescription[0]: 'taste'"},
        {"GasOnAFace",
         [](hid_t f) {
             replace_texts(f, "/control/stages/0", "prescription", {"pressure", "closed"});
         },
         "/control/stages/0/value[1]: the load 'outside' acts on a face"},
        {"VolumeRatioOfZero", [](hid_t f) { overwrite(f, "/control/stages/0/value", 0, Numbers{0}); },
         "/control/stages/0/value[0]: must be positive"},
        {"FewerSupplies",
         [](hid_t f) {
             replace_texts(f, "/control/stages/0", "prescription", {"pressure"});
             replace<double>(f, "/control/stages/0", "value", {1});
         },
         "/control/stages/0/prescription: must have one entry per load"},
        {"FewerTractions", [](hid_t f) { replace<double>(f, "/control/stages/1", "tractions", {1}); },
         "/control/stages/1/tractions: must have one entry per load"},
        {"MoreBodyForces",
         [](hid_t f) {
             replace<double>(f, "/control/stages/1", "body_forces", {1, 2});
         },
         "/control/stages/1/body_forces"},
        {"MotionLevelNotFinite", [](hid_t f) { overwrite(f, "/control/stages/1/motions", 0, Numbers{nan}); },
         "/control/stages/1/motions"},
        {"UntilOfNoOutput", [](hid_t f) { replace_texts(f, "/control/stages/2/until", "quantity", {"bulge"}); },
         "/control/stages/2/until/quantity[0]: there is no output named 'bulge'"},
        {"UnknownBranch", [](hid_t f) { replace_text(f, "/control", "branch", "saw"); }, "/control/branch: 'saw'"},
        {"UnknownContact", [](hid_t f) { replace_text(f, "/control", "contact", "first"); },
         "/control/contact: 'first'"},
        {"ImperfectionZero", [](hid_t f) { overwrite(f, "/control/imperfection", 0, Numbers{0}); },
         "/control/imperfection"},
        {"StretchLimitOne", [](hid_t f) { overwrite(f, "/control/stretch_limit", 0, Numbers{1}); },
         "/control/stretch_limit"},
        {"TooManyFrequencies", [](hid_t f) { overwrite(f, "/control/frequencies", 0, std::vector<std::int64_t>{51}); },
         "/control/frequencies: must be between 0 and 50"},
        {"SupportOfNoFace",
         [](hid_t f) {
             unlink(f, "/supports/face");
             write_texts(f, {"/supports/face", "1", ""}, Words{"cavity", "no"});
         },
         "/supports/face[1]: there is no face named 'no'"},
        {"OpeningWithoutArea", [](hid_t f) { overwrite(f, "/loads/cavities/main/openings/area", 0, Numbers{0}); },
         "/loads/cavities/main/openings/area[0]"},
        {"WallOfNoFace", [](hid_t f) { replace_text(f, "/loads/cavities/main", "wall", "nowhere"); },
         "/loads/cavities/main/wall: there is no face named 'nowhere'"},
        {"WallOfAnEmptyFace", [](hid_t f) { replace_text(f, "/loads/cavities/main", "wall", "unused"); },
         "/loads/cavities/main/wall"},
        {"DirectionNotUnit", [](hid_t f) { overwrite(f, "/outputs/direction", 0, Numbers{2}); },
         "/outputs/direction[0]"},
        {"UntilNotFinite", [](hid_t f) { overwrite(f, "/control/stages/0/until/value", 0, Numbers{nan}); },
         "/control/stages/0/until/value[0]"},
        {"ToleranceZero", [](hid_t f) { overwrite(f, "/control/solver/residual_tolerance", 0, Numbers{0}); },
         "/control/solver/residual_tolerance"},
        {"LimitBeyondInt", [](hid_t f) { overwrite(f, "/control/solver/newton_limit", 0, Integers{1LL << 32}); },
         "/control/solver/newton_limit"},
        {"ListsOfDifferentLength",
         [](hid_t f) {
             replace<double>(f, "/loads", "exponent", {1, 2, 3});
         },
         "/loads/exponent"},
        {"MissingGroup", [](hid_t f) { unlink(f, "/supports"); }, "case.h5:/supports: is missing"},
        {"MissingDataset", [](hid_t f) { unlink(f, "/mesh/formulation"); }, "case.h5:/mesh/formulation: is missing"},
        {"MissingFormat", [](hid_t f) { H5Adelete(f, "format"); }, "not a soft-actuator file"},
        {"NewerVersion", set_version, "format version 2"},
        {"ChangedDesignText", [](hid_t f) { replace_text(f, "/design", "effective_yaml", "family: rod"); },
         "/design/effective_yaml"},
        {"GroupForADataset",
         [](hid_t f) {
             unlink(f, "/loads/exponent");
             static_cast<void>(create_group(f, "/loads/exponent", ""));
         },
         "/loads/exponent"},
        {"DatasetForAGroup",
         [](hid_t f) {
             unlink(f, "/supports");
             write_count(f, {"supports", "1", ""}, 1);
         },
         "/supports"},
        {"ExternalLink",
         [](hid_t f) {
             unlink(f, "/supports");
             H5Lcreate_external("other.h5", "/x", f, "supports", H5P_DEFAULT, H5P_DEFAULT);
         },
         "case.h5:/supports: is a soft or external link"},
        {"SoftLink",
         [](hid_t f) {
             unlink(f, "/loads/exponent");
             H5Lcreate_soft("/outputs/direction", f, "/loads/exponent", H5P_DEFAULT, H5P_DEFAULT);
         },
         "case.h5:/loads/exponent: is a soft or external link"},
        {"DanglingSoftLinkAmongFaces",
         [](hid_t f) { H5Lcreate_soft("/nowhere", f, "/mesh/facets/x", H5P_DEFAULT, H5P_DEFAULT); }, "/mesh/facets/x"},
        {"ExternalStorage", declare_external, "/loads/exponent: stores its data in another file"},
        {"VirtualStorage", declare_virtual, "/loads/exponent: uses an unsupported storage layout"},
        {"VariableLengthText", declare_variable_text, "/design/family: is not text of fixed length"},
        {"DeclaredButNotStored", [](hid_t f) { declare_chunked(f, "/mesh/points/tip", 1ULL << 28, 1024); },
         "/mesh/points/tip: is declared larger than its stored data can be"},
        {"DeclaredBeyondReason", [](hid_t f) { declare_chunked(f, "/mesh/points/tip", 1ULL << 62, 1024); },
         "/mesh/points/tip: is declared too large"},
        {"ChunkBeyondReason", [](hid_t f) { declare_chunked(f, "/mesh/points/tip", 2, 1ULL << 27); },
         "/mesh/points/tip: has chunks that are too large"},
        {"NameThatIsNone", [](hid_t f) { static_cast<void>(create_group(f, "/materials/a b", "")); },
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
