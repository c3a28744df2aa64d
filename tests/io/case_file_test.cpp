#include "io/case_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/hash.hpp"
#include "example_case.hpp"
#include "io/image.hpp"
#include "tamper.hpp"

namespace soft::io {
namespace {

using namespace test;

TEST(CaseFile, SectionReadsBackEqualInEveryField) {
    const CaseFile file = read_case_file(section_image(), "case.h5");
    expect_stored(section_image(), section_case());
    EXPECT_EQ(file.design, example_design());
    EXPECT_EQ(file.provenance, std::vector{example_provenance("mesh-gen")});
}

TEST(CaseFile, SolidReadsBackEqualInEveryField) {
    const auto image = write_case(solid_case(), example_design(), example_provenance("mesh-gen"));
    expect_stored(image, solid_case());
}

TEST(CaseFile, EmptyTextsAndListsReadBackEmpty) {
    model::Case model = solid_case();
    model.supports.clear();
    const auto image = write_case(model, {"", {}}, {"mesh-gen", "", "", {}, ""});
    const CaseFile file = read_case_file(image, "case.h5");
    expect_stored(image, model);
    EXPECT_EQ(file.design, (DesignText{"", {}}));
    EXPECT_EQ(file.provenance, (std::vector<Provenance>{{"mesh-gen", "", "", {}, ""}}));
}

TEST(CaseFile, VariationsReadBackWithTheirMeshesAndDesigns) {
    const model::Case model = section_case();
    model::Variation varied{{"geometry.wall", "mm", 1e-3, 3e-3, 2.9e-3, 3.1e-3}, {}, {}};
    for (auto* side : {&varied.lower, &varied.higher}) {
        side->points = model.mesh.points;
        side->points[3][1] += side == &varied.lower ? -1e-4 : 2e-4;
        side->shape = shape_of(model);
        side->effective_yaml = side == &varied.lower ? "low" : "high";
    }
    const auto image =
        io::write_case(model.mesh, shape_of(model), example_design(), example_provenance("mesh-gen"), {&varied, 1});
    std::vector<std::string> designs;
    const CaseFile file = io::read_case_file(
        image, "case.h5", [&](mesh::Mesh mesh, const model::Shape&, std::string_view yaml, std::string_view) {
            designs.emplace_back(yaml);
            model::Case built = model;
            built.mesh = std::move(mesh);
            return built;
        });
    ASSERT_EQ(file.model.parameters.size(), 1u);
    EXPECT_EQ(file.model.parameters[0].key, "geometry.wall");
    EXPECT_EQ(file.model.parameters[0].higher, 3.1e-3);
    ASSERT_EQ(file.variations.size(), 1u);
    EXPECT_EQ(file.variations[0][0].mesh.points, varied.lower.points);
    EXPECT_EQ(file.variations[0][1].mesh.points, varied.higher.points);
    EXPECT_EQ(designs, (std::vector<std::string>{"low", "high", example_design().effective_yaml}));
}

TEST(CaseFile, EqualInputGivesEqualBytes) { EXPECT_EQ(section_image(), section_image()); }

TEST(CaseFile, LargeMeshReadsBackFromCompressedChunks) {
    model::Case model = solid_case();
    const auto points = model.mesh.points;
    for (int copy = 0; copy < 3000; ++copy)  // 135,000 points, 3 MB: several chunks
        for (auto point : points) {
            point[2] += 1e-3 * copy;
            model.mesh.points.push_back(point);
        }
    const auto image = write_case(model, example_design(), example_provenance("mesh-gen"));
    EXPECT_LT(image.size(), model.mesh.points.size() * sizeof(mesh::Point));
    expect_stored(image, model);
}

/// The objects that ParaView's reader requires, read with plain HDF5 calls (format of VTK 9.1, vtkHDFReader).
TEST(CaseFile, ContainsTheObjectsThatTheVtkHdfReaderRequires) {
    static_cast<void>(tampered(section_image(), [](hid_t file) {
        const GroupHandle group{H5Gopen2(file, "VTKHDF", H5P_DEFAULT)};
        const AttributeHandle type{H5Aopen(group.get(), "Type", H5P_DEFAULT)};
        const TypeHandle text{H5Aget_type(type.get())};
        EXPECT_EQ(H5Tget_class(text.get()), H5T_STRING);
        EXPECT_EQ(H5Tget_cset(text.get()), H5T_CSET_ASCII);
        EXPECT_EQ(H5Tis_variable_str(text.get()), 0);
        ASSERT_EQ(H5Tget_size(text.get()), 16U);
        char word[17] = {};
        H5Aread(type.get(), text.get(), word);
        EXPECT_STREQ(word, "UnstructuredGrid");
        long long version[2] = {};
        const AttributeHandle numbers{H5Aopen(group.get(), "Version", H5P_DEFAULT)};
        H5Aread(numbers.get(), H5T_NATIVE_LLONG, version);
        EXPECT_EQ(version[0], 1);
        EXPECT_EQ(version[1], 0);
        for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds", "Points", "Connectivity",
                                 "Offsets", "Types"})
            EXPECT_GT(H5Lexists(group.get(), name, H5P_DEFAULT), 0) << name;
    }));
}

TEST(CaseFile, EveryDatasetHasUnitsAndDescriptionButNoTimeStamp) {
    static_cast<void>(tampered(section_image(), [](hid_t file) {
        int datasets = 0;
        const auto visit = [](hid_t root, const char* name, const H5O_info_t* info, void* count) -> herr_t {
            EXPECT_EQ(info->mtime, 0) << name;
            if (info->type != H5O_TYPE_DATASET) return 0;
            ++*static_cast<int*>(count);
            EXPECT_GT(H5Aexists_by_name(root, name, "units", H5P_DEFAULT), 0) << name;
            EXPECT_GT(H5Aexists_by_name(root, name, "description", H5P_DEFAULT), 0) << name;
            return 0;
        };
        H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, visit, &datasets, H5O_INFO_ALL);
        EXPECT_GT(datasets, 30);
    }));
}

TEST(CaseFile, ReadsAFileWithoutSealThatAnotherProgramChanged) {
    const auto image = tampered(section_image(), [](hid_t file) {
        replace_text(file, "/design", "effective_yaml", "family: rod");
        overwrite(file, "/shape/cavities/openings/area", 0, std::vector{12345.0});
    });
    const auto build = [](const mesh::Mesh&, const model::Shape& shape, std::string_view yaml,
                          std::string_view source) {
        EXPECT_EQ(yaml, "family: rod");
        EXPECT_EQ(source, "case.h5:/design/effective_yaml");
        EXPECT_EQ(shape.cavities.at(0).openings.at(0).area_m2, 12345.0);
        return section_case();
    };
    static_cast<void>(io::read_case_file(image, "case.h5", build));
}

TEST(CaseFile, WriterRejectsACaseThatTheReaderWouldReject) {
    model::Case model = section_case();
    model.mesh.connectivity[3] = 9000;
    try {
        static_cast<void>(write_case(model, example_design(), example_provenance("mesh-gen")));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::internal);
        EXPECT_NE(std::string{error.what()}.find("/VTKHDF/Connectivity[3]"), std::string::npos) << error.what();
    }
}

TEST(CaseFile, RestoresTheHdf5ErrorHandler) {
    H5E_auto2_t before = nullptr;
    H5E_auto2_t after = nullptr;
    void* data = nullptr;
    H5Eget_auto2(H5E_DEFAULT, &before, &data);
    static_cast<void>(read_case_file(section_image(), "case.h5"));
    H5Eget_auto2(H5E_DEFAULT, &after, &data);
    EXPECT_NE(before, nullptr);
    EXPECT_EQ(before, after);
}

}  // namespace
}  // namespace soft::io
