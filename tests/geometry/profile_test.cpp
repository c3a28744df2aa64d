/// Tables of outlines and their errors.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "geometry/profile.hpp"

namespace soft::geometry {
namespace {

using Shape = meshing::OutlineEdge::Shape;
using std::numbers::pi;

std::string profile_refusal(const std::string& text, Across across = Across::r) {
    try {
        (void)outline_from(text, "part.csv", across);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "accepted";
}

const std::string disc = "x_mm,r_mm,tag\n0,0,axis\n5,0,end\n5,10,outer\n0,10,fixed\n";

TEST(Profile, RowsAreStartsOfEdges) {
    const meshing::Outline outline = outline_from(disc, "part.csv", Across::r);
    ASSERT_EQ(outline.loops.size(), 1u);
    ASSERT_EQ(outline.loops[0].size(), 4u);
    const meshing::OutlineEdge& end = outline.loops[0][1];
    EXPECT_EQ(end.faces, std::vector<std::string>{"end"});
    EXPECT_EQ(end.row, 3u);
    EXPECT_EQ(end.points, (std::vector<meshing::PlanePoint>{{5e-3, 0}, {5e-3, 10e-3}}));
    EXPECT_EQ(tags_of(outline), (std::vector<std::string>{"axis", "end", "outer", "fixed"}));
}

TEST(Profile, UnitsDelimitersCommentsAndAClosingRowAreSupported) {
    const meshing::Outline same = outline_from(disc, "part.csv", Across::r);
    for (const char* text : {"# a disc\nx_m;r_m;tag\n0;0;axis\n0.005;0;end\n0.005;0.01;outer\n0;0.01;fixed\n",
                             "x (cm),r (cm),tag\n0,0,axis\n0.5,0,end\n0.5,1,outer\n0,1,fixed\n",
                             "tag,r_mm,x_mm\naxis,0,0\nend,0,5\nouter,10,5\nfixed,10,0\n,0,0\n"}) {
        const meshing::Outline other = outline_from(text, "part.csv", Across::r);
        ASSERT_EQ(other.loops.size(), 1u) << text;
        ASSERT_EQ(other.loops[0].size(), 4u) << text;
        for (std::size_t e = 0; e < 4; ++e) EXPECT_EQ(other.loops[0][e].points, same.loops[0][e].points) << text;
    }
}

TEST(Profile, ArcsAndSplinesStartAtTheirRow) {
    const meshing::Outline outline = outline_from(
        "x_mm,r_mm,tag,curve,via_x_mm,via_r_mm\n0,0,axis,,,\n10,0,dome,arc,7.0710678,7.0710678\n0,10,back,spline,,\n"
        "-1,8,back,spline,,\n-2,5,back,spline,,\n-1,2,back,spline,,\n",
        "part.csv", Across::r);
    ASSERT_EQ(outline.loops[0].size(), 3u);
    EXPECT_EQ(outline.loops[0][1].shape, Shape::arc);
    EXPECT_NEAR(arc_of(outline.loops[0][1]).radius_m, 10e-3, 1e-10);
    const meshing::OutlineEdge& back = outline.loops[0][2];
    EXPECT_EQ(back.shape, Shape::spline);
    EXPECT_EQ(back.points.size(), 5u);
    EXPECT_EQ(back.points.back(), (meshing::PlanePoint{0, 0}));
}

TEST(Profile, ErrorsNameTheirRow) {
    EXPECT_EQ(profile_refusal("0,0,axis\n5,0,end\n5,10,outer\n"),
              "part.csv:1: the header line is missing; begin with x_mm,r_mm,tag");
    EXPECT_EQ(profile_refusal("x,r_mm,tag\n0,0,axis\n5,0,end\n5,10,outer\n"),
              "part.csv:1: column 'x' has no unit of length; write x_mm");
    EXPECT_EQ(profile_refusal("x_mm,tag\n0,axis\n5,end\n5,outer\n"), "part.csv:1: there is no column 'r_mm'");
    EXPECT_EQ(profile_refusal("x_mm,r_mm\n0,0\n5,0\n5,10\n"),
              "part.csv:1: there is no column 'tag'; name the face of the edge that starts at each row");
    EXPECT_EQ(
        profile_refusal("x_mm,r_mm,tag,radius\n0,0,axis,1\n5,0,end,1\n5,10,outer,1\n"),
        "part.csv:1: unknown column 'radius'; use x, r, tag, curve, via_x, via_r, loop, lengths with a unit as in x_mm");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag\n0,0,axis\n5,nan,end\n5,10,outer\n"),
              "part.csv:3: column 2 'r_mm': 'nan' is not a number; put # before lines that are not data");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag\n0,0,axis\n5,0,\n5,10,outer\n"),
              "part.csv:3: the tag is missing; name the face of the edge that starts here, for example free");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag\n0,0,axis\n5,0,the end\n5,10,outer\n"),
              "part.csv:3: 'the end' is not a valid face name; use letters, digits, _ and -, starting with a letter");
    EXPECT_EQ(
        profile_refusal("x_mm,r_mm,tag\n0,0,axis\n5,0,end\n5,0,end\n5,10,outer\n"),
        "part.csv:3: the point (5, 0) mm appears twice in a row; remove one; the last point is connected to the first automatically");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag\n0,-1,inner\n5,-1,end\n5,10,outer\n0,10,fixed\n"),
              "part.csv:2: r reaches -1 mm; draw the half section at r >= 0; the axis of revolution is x");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag\n0,0,inner\n5,0,end\n5,10,outer\n"),
              "part.csv:2: the edge lies on the axis r = 0 but is tagged 'inner'; tag it axis");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag\n0,1,axis\n5,1,end\n5,10,outer\n"),
              "part.csv:2: the edge is tagged axis but does not lie on r = 0; use another tag");
    EXPECT_EQ(
        profile_refusal("x_mm,r_mm,tag\n0,0,fixed\n0,10,outer\n5,10,end\n5,0,axis\n"),
        "part.csv:2: the outline is clockwise: the solid would lie outside it; reverse the order of its points (each tag moves to the "
        "row where its edge now starts)");
    EXPECT_EQ(
        profile_refusal("x_mm,r_mm,tag\n0,1,a\n5,1,b\n0,4,c\n5,4,d\n"),
        "part.csv:3: the edge crosses, touches or runs back over the edge of line 5 near (5, 4) mm; an outline must "
        "enclose the solid once");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag,curve\n0,1,a,circle\n5,1,b,\n0,4,c,\n"),
              "part.csv:2: 'circle' is not a curve; use line, arc or spline");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag,curve\n0,1,a,arc\n5,1,b,\n0,4,c,\n"),
              "part.csv:1: there is no column 'via_x_mm'");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag,curve,via_x_mm,via_r_mm\n0,1,a,arc,,\n5,1,b,,,\n0,4,c,,,\n"),
              "part.csv:2: column 5 'via_x_mm': the cell is empty; put # before lines that are not data");
    EXPECT_EQ(profile_refusal("x_mm,r_mm,tag,curve,via_x_mm,via_r_mm\n0,1,a,arc,2,1\n5,1,b,,,\n0,4,c,,,\n"),
              "part.csv:2: the three points of the arc are collinear; use line");
    EXPECT_EQ(profile_refusal("x_mm,y_mm,tag,loop\n0,0,a,1\n9,0,a,1\n9,9,a,1\n4,3,b,2\n3,3,b,2\n3,4,b,2\n0,9,a,1\n",
                              Across::y),
              "part.csv:8: loop '1' continues after another loop; keep its rows together");
    EXPECT_EQ(profile_refusal("x_mm,y_mm,tag\n0,0,axis\n9,0,a\n9,9,a\n", Across::y),
              "part.csv:2: 'axis' is a reserved face name; use another tag");
    EXPECT_EQ(profile_refusal("x_mm,y_mm,tag\n-1,0,a\n9,0,a\n0,9,symmetry_x\n0,3,a\n", Across::y),
              "part.csv:2: x reaches -1 mm; draw the half x >= 0; the tag symmetry_x mirrors the body at x = 0");
}

/// Rounding of an export: a point deviates from the axis by a negligible distance.
TEST(Profile, PointsWithinRoundingOfTheAxisLieOnIt) {
    const meshing::Outline outline =
        outline_from("x_mm,r_mm,tag\n0,1e-9,axis\n5,-1e-9,end\n5,10,outer\n0,10,fixed\n", "part.csv", Across::r);
    EXPECT_EQ(outline.loops[0][0].points[1], (meshing::PlanePoint{5e-3, 0}));
}

/// A square of 20 mm (section x, y) with a round hole of radius 5 mm, given as `edges` straight edges, each row with `curve`.
std::string polygon_hole(int edges, const std::string& curve) {
    std::string text = "x_mm,y_mm,tag,loop,curve\n-10,-10,out,1,\n10,-10,out,1,\n10,10,out,1,\n-10,10,out,1,\n";
    for (int k = 0; k < edges; ++k) {
        const double angle = -2 * pi * k / edges;  // clockwise around a hole
        text +=
            std::to_string(5 * std::cos(angle)) + "," + std::to_string(5 * std::sin(angle)) + ",hole,2," + curve + "\n";
    }
    return text;
}

TEST(Profile, ManyShortEdgesOnASmoothCurveBecomeASpline) {
    for (const int edges : {26, 60, 500}) {
        const meshing::Outline outline = outline_from(polygon_hole(edges, ""), "part.csv", Across::y);
        ASSERT_EQ(outline.loops[1].size(), 1u) << edges;
        const meshing::OutlineEdge& hole = outline.loops[1][0];
        EXPECT_EQ(hole.shape, Shape::spline);
        EXPECT_EQ(hole.points.size(), static_cast<std::size_t>(edges) + 1);
        EXPECT_NEAR(area_m2(outline.loops[1]) / (-pi * 25e-6), 1,
                    4e-4);  // the area error of the polygon with 26 edges is 1 %
        ASSERT_EQ(outline.notes.size(), 1u);
        EXPECT_NE(outline.notes[0].find(std::to_string(edges) + " straight edges (the first in line 6)"),
                  std::string::npos)
            << outline.notes[0];
        EXPECT_EQ(outline.loops[0].size(), 4u);  // the square is unchanged
    }
}

TEST(Profile, IntendedStraightEdgesStayStraight) {
    for (const auto& [edges, curve] : {std::pair{16, ""}, {60, "line"}}) {  // turns of 22.5 degrees; curve stated
        const meshing::Outline outline = outline_from(polygon_hole(edges, curve), "part.csv", Across::y);
        EXPECT_EQ(outline.loops[1].size(), static_cast<std::size_t>(edges));
        ASSERT_EQ(outline.notes.size(), edges == 16 ? 1u : 0u);
        if (edges == 16) {
            EXPECT_NE(outline.notes[0].find("16 straight edges (the first in line 6)"), std::string::npos);
            EXPECT_NE(outline.notes[0].find("write spline in the column curve"), std::string::npos);
        }
    }
}

/// A half circle on a straight base with one tag for both: the corners at its ends remain corners.
TEST(Profile, RecognisedCurvesEndAtCorners) {
    constexpr int edges = 40;
    std::string text = "x_mm,y_mm,tag\n";
    for (int k = 0; k <= edges; ++k)
        text += std::to_string(10 * std::cos(pi * k / edges)) + "," + std::to_string(10 * std::sin(pi * k / edges)) +
                ",skin\n";
    const meshing::Outline outline = outline_from(text, "part.csv", Across::y);
    ASSERT_EQ(outline.loops[0].size(), 2u);
    EXPECT_EQ(outline.loops[0][0].shape, Shape::spline);
    EXPECT_EQ(outline.loops[0][1].shape, Shape::line);
    EXPECT_NEAR(area_m2(outline.loops[0]) / (pi * 50e-6), 1, 4e-4);
    // A drop: one corner; the rest of the outline is one smooth curve.
    text = "x_mm,y_mm,tag\n0,0,skin\n";
    for (int k = 0; k <= edges; ++k) {
        const double angle = -0.75 * pi + 1.5 * pi * k / edges;
        text += std::to_string(7 * std::sqrt(2.0) + 7 * std::cos(angle)) + "," + std::to_string(7 * std::sin(angle)) +
                ",skin\n";
    }
    const meshing::Outline drop = outline_from(text, "part.csv", Across::y);
    for (const meshing::OutlineEdge& edge : drop.loops[0]) EXPECT_NE(edge.points.front(), edge.points.back());
}

}  // namespace
}  // namespace soft::geometry
