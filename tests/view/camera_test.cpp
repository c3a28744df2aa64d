#include "view/camera.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace soft::view {
namespace {

void expect_vector(const Vector3& found, const Vector3& expected) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-15);
}

TEST(Camera, TheFrontViewHasXToTheRightAndYUp) {
    const Screen screen = screen_of(camera_from_text("front"));
    expect_vector(screen.right, {1, 0, 0});
    expect_vector(screen.up, {0, 1, 0});
    expect_vector(screen.eye, {0, 0, 1});
}

TEST(Camera, TheSideViewLooksAlongTheAxisAndTheTopViewFromAbove) {
    expect_vector(screen_of(camera_from_text("side")).eye, {1, 0, 0});
    expect_vector(screen_of(camera_from_text("side")).up, {0, 1, 0});
    expect_vector(screen_of(camera_from_text("top")).eye, {0, 1, 0});
    expect_vector(screen_of(camera_from_text("top")).right, {1, 0, 0});
}

TEST(Camera, TheViewAcrossHasXToTheRightAndZUp) {
    const Screen screen = screen_of(camera_from_text("across"));
    expect_vector(screen.right, {1, 0, 0});
    expect_vector(screen.up, {0, 0, 1});
    expect_vector(screen.eye, {0, -1, 0});
}

TEST(Camera, EveryViewHasARightHandedScreen) {
    for (const char* text : {"iso", "30,40", "-120, -75", "200.5,90"}) {
        const Screen screen = screen_of(camera_from_text(text));
        expect_vector(cross(screen.right, screen.up), screen.eye);
        EXPECT_NEAR(dot(screen.right, screen.right), 1.0, 1e-15);
    }
}

TEST(Camera, AnInvalidViewIsRefusedWithTheValidNames) {
    for (const char* text : {"behind", "", "30", "30,40,50", "a,b", "0,91", "nan,0"}) {
        try {
            static_cast<void>(camera_from_text(text));
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            EXPECT_NE(std::string(error.what()).find("front, side, top, across, iso, or AZIMUTH,ELEVATION"),
                      std::string::npos);
        }
    }
}

}  // namespace
}  // namespace soft::view
