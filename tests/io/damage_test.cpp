/// Truncated and damaged files, and files that are not HDF5.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "example_case.hpp"
#include "io/case_file.hpp"
#include "io/image.hpp"

/// HDF5 requests as much memory as damaged metadata declare and handles a failed allocation. The address sanitizer would abort.
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }

namespace soft::io {
namespace {

using namespace test;
using Image = std::vector<std::byte>;

Image bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span{text});
    return {bytes.begin(), bytes.end()};
}

Image result_image() {
    ResultWriter writer{{section_image(), "case.h5", section_case()}, example_provenance("solve"), {}};
    for (int i = 0; i < 4; ++i) writer.append(example_step(i), example_displacement(i), example_pressure(i));
    return writer.finish(example_end());
}

TEST(Damage, EmptyInputPointsToThePreviousProgram) {
    EXPECT_EQ(refusal({}, "<stdin>"), "<stdin>: empty input; check whether the previous program failed");
}

TEST(Damage, RejectsFilesThatAreNotHdf5) {
    for (const char* text : {"x", "family: tube\n", "\x89PNG\r\n\x1a\n and so on", "<html>"})
        EXPECT_NE(refusal(bytes_of(text)).find("not an HDF5 file"), std::string::npos) << text;
    EXPECT_EQ(refusal(bytes_of("a\x1b[2J\nb")).find('\x1b'), std::string::npos);
}

TEST(Damage, RejectsEveryTruncation) {
    for (const Image& whole : {section_image(), result_image()})
        for (std::size_t part = 0; part < 16; ++part) {
            const Image cut{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * part / 16)};
            const std::string message = refusal(cut);
            EXPECT_NE(message.find(part == 0 ? "empty input" : "truncated"), std::string::npos) << message;
        }
}

TEST(Damage, RejectsATruncatedSeal) {
    const Image whole = section_image();
    for (std::size_t missing = 1; missing < 100; missing += 7) {
        const Image cut{whole.begin(), whole.end() - static_cast<std::ptrdiff_t>(missing)};
        EXPECT_NE(refusal(cut).find("truncated"), std::string::npos) << missing;
    }
}

TEST(Damage, RejectsTruncatedHdf5WithoutSeal) {
    const auto whole = split_image(section_image(), "").hdf5.size();
    const Image image = section_image();
    for (std::size_t part = 1; part < 16; ++part) {
        const Image cut{image.begin(), image.begin() + static_cast<std::ptrdiff_t>(whole * part / 16)};
        EXPECT_NE(refusal(cut).find("truncated"), std::string::npos);
    }
}

TEST(Damage, RejectsTrailingBytes) {
    Image image = section_image();
    image.push_back(std::byte{0});
    EXPECT_NE(refusal(image).find("unknown bytes after the end"), std::string::npos);
}

/// The seal detects every flipped byte before the HDF5 library reads the file.
TEST(Damage, RejectsEveryFlippedByteInASealedFile) {
    const Image whole = result_image();
    const std::size_t stride = whole.size() / 397;
    for (std::size_t offset = 0; offset < whole.size(); offset += offset < 100 ? 1 : stride) {
        Image damaged = whole;
        damaged[offset] ^= std::byte{offset % 2 == 0 ? std::uint8_t{0x01} : std::uint8_t{0xff}};
        EXPECT_THROW(static_cast<void>(read_result(damaged, "case.h5")), Error) << offset;
    }
}

/// Without a seal a changed value may be accepted, but reading must give a result or an Error. The test is divided into parts because
/// it is slow.
class FlippedByte : public testing::TestWithParam<std::size_t> {
public:
    static constexpr std::size_t parts = 4;
};

TEST_P(FlippedByte, WithoutSealGivesAResultOrAnError) {
    const Image image = result_image();
    const auto hdf5 = split_image(image, "").hdf5;
    int refused = 0;
    for (std::size_t offset = 263 * GetParam(); offset < hdf5.size(); offset += 263 * parts) {
        Image damaged{hdf5.begin(), hdf5.end()};
        damaged[offset] ^= std::byte{0xff};
        try {
            const Result result = read_result(damaged, "case.h5");
            for (const std::int64_t step : result.fields.steps()) static_cast<void>(result.fields.read(step));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input) << offset << ": " << error.what();
            ++refused;
        }
    }
    EXPECT_GT(refused, 50 / static_cast<int>(parts));
}

INSTANTIATE_TEST_SUITE_P(Damage, FlippedByte, testing::Range<std::size_t>(0, FlippedByte::parts));

/// HDF5 1.10.8 follows the free list of a local heap without a limit ("Disk Format: Level 1D - Local Heaps" of the file format
/// specification: signature, version, size of data, head of the free list, address of data). A block that links to itself
/// exhausts the memory. Reading in a subprocess stops this and reports the location.
TEST(Damage, StopsAndReportsACyclicFreeList) {
    const Image whole = section_image();
    const auto hdf5 = split_image(whole, "").hdf5;
    Image damaged{hdf5.begin(), hdf5.end()};
    const auto signature = std::as_bytes(std::span{std::string_view{"HEAP"}});
    const auto number = [&](std::size_t offset) {
        std::uint64_t value = 0;
        std::memcpy(&value, damaged.data() + offset, sizeof value);
        return value;
    };
    int circles = 0;
    for (auto heap = damaged.begin();; ++heap) {
        heap = std::search(heap, damaged.end(), signature.begin(), signature.end());
        if (heap == damaged.end()) break;
        const auto at = static_cast<std::size_t>(heap - damaged.begin());
        const std::uint64_t size = number(at + 8), free_head = number(at + 16), address = number(at + 24);
        if (free_head + sizeof free_head > size) continue;  // no free block
        std::memcpy(damaged.data() + address + free_head, &free_head, sizeof free_head);
        ++circles;
    }
    ASSERT_GT(circles, 0);
    const std::string message = refusal(damaged);
    EXPECT_TRUE(message.starts_with("case.h5")) << message;
}

/// Files with a seal are read without a subprocess. Files without a seal must give the same case.
TEST(Damage, ReadsAValidFileWithoutSeal) {
    const Image whole = section_image();
    const auto hdf5 = split_image(whole, "").hdf5;
    expect_stored(Image{hdf5.begin(), hdf5.end()}, section_case());
    EXPECT_TRUE(split_image(whole, "").sealed);
    EXPECT_FALSE(split_image(hdf5, "").sealed);
}

}  // namespace
}  // namespace soft::io
