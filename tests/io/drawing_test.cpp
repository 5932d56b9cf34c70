// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/drawing.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace jounce::drawing_test {
namespace {

using testing::HasSubstr;

constexpr double pi = std::numbers::pi;

/// Pairs of a DXF file: "0 LINE 8 CAM 10 1 ..." with one group for each two words.
std::string dxf(const std::string& entities, const std::string& units = "4") {
  std::string text = "0 SECTION 2 HEADER 9 $INSUNITS 70 " + units +
                     " 0 ENDSEC 0 SECTION 2 ENTITIES " + entities + (entities.empty() ? "" : " ") +
                     "0 ENDSEC 0 EOF ";
  for (char& c : text)
    if (c == ' ') c = '\n';
  return text;
}
Outline of_dxf(const std::string& entities, const std::string& layer = "") {
  return parse_outline(dxf(entities), "plate.dxf" + layer);
}
Outline of_svg(const std::string& elements, const std::string& root =
                                                "width=\"100mm\" height=\"100mm\" "
                                                "viewBox=\"0 0 100 100\"") {
  return parse_outline(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" " + root + ">" + elements + "</svg>", "plate.svg");
}
std::string complaint(const std::string& text, const std::string& name) {
  return test::error_of([&] { (void)parse_outline(text, name); });
}

struct Measured {
  double length = 0;
  double area = 0;  ///< > 0 if the curve is counterclockwise
};
/// Length and area from vertices and bulges, by the formulas of circle segments.
Measured measured(const Outline& outline) {
  Measured m;
  const Contour& c = outline.pieces;
  for (std::size_t i = 0; i + (outline.closed ? 0 : 1) < c.size(); ++i) {
    const Vertex &a = c[i], &b = c[(i + 1) % c.size()];
    const double chord = std::hypot(b.x - a.x, b.y - a.y), angle = 4 * std::atan(a.bulge);
    m.area += (a.x * b.y - b.x * a.y) / 2;
    if (a.bulge == 0) {
      m.length += chord;
      continue;
    }
    const double radius = chord / (2 * std::sin(angle / 2));
    m.length += radius * angle;
    m.area += radius * radius * (angle - std::sin(angle)) / 2;
  }
  return m;
}

void expect_circle(const Outline& outline, double x, double y, double r, double tolerance = 1e-12) {
  EXPECT_TRUE(outline.closed);
  EXPECT_NEAR(measured(outline).length, 2 * pi * r, tolerance * r);
  EXPECT_NEAR(std::abs(measured(outline).area), pi * r * r, tolerance * r * r);
  for (const Vertex& v : outline.pieces)
    EXPECT_NEAR(std::hypot(v.x - x, v.y - y), r, tolerance * r);
}

TEST(Dxf, AllCurvesOfACircleAreThisCircle) {
  expect_circle(of_dxf("0 CIRCLE 8 CAM 10 3 20 -2 40 30"), 3, -2, 30);
  expect_circle(of_dxf("0 LWPOLYLINE 8 CAM 90 2 70 1 10 33 20 -2 42 1 10 -27 20 -2 42 1"), 3, -2,
                30);
  expect_circle(
      of_dxf("0 POLYLINE 8 CAM 66 1 70 1 0 VERTEX 8 CAM 10 33 20 -2 42 1 0 VERTEX 8 CAM 10 -27 "
             "20 -2 42 1 0 SEQEND"),
      3, -2, 30);
  expect_circle(
      of_dxf("0 ARC 8 CAM 10 3 20 -2 40 30 50 -30 51 100 0 ARC 8 CAM 10 3 20 -2 40 30 50 100 51 "
             "330"),
      3, -2, 30);
  expect_circle(of_dxf("0 ELLIPSE 8 CAM 10 3 20 -2 11 0 21 30 40 1"), 3, -2, 30);
  // Mirrored: an extrusion of -1 turns x around.
  expect_circle(of_dxf("0 CIRCLE 8 CAM 10 -3 20 -2 40 30 230 -1"), 3, -2, 30);
  expect_circle(of_dxf("0 LWPOLYLINE 8 CAM 90 2 70 1 10 -33 20 -2 42 1 10 27 20 -2 42 1 230 -1"), 3,
                -2, 30);
  // A rational spline of degree 2: nine control points around a square, weights 1 and sqrt(1/2).
  std::string spline = "0 SPLINE 8 CAM 70 4 71 2";
  for (const char* knot : {"0", "0", "0", "1", "1", "2", "2", "3", "3", "4", "4", "4"})
    spline += std::string(" 40 ") + knot;
  for (int i = 0; i < 9; ++i)
    spline += std::string(" 41 ") + (i % 2 == 0 ? "1" : "0.70710678118654752440");
  const int square[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                            {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  for (const auto& [x, y] : square)
    spline += " 10 " + std::to_string(3 + 30 * x) + " 20 " + std::to_string(-2 + 30 * y);
  expect_circle(of_dxf(spline), 3, -2, 30, 1e-11);
}

TEST(Dxf, LinesInAnyOrderAndDirectionBecomeOneOutline) {
  const Outline square = of_dxf(
      "0 LINE 8 0 10 0 20 0 11 10 21 0 0 LINE 8 0 10 0 20 10 11 10 21 10 0 LINE 8 0 10 10 20 0 11 "
      "10 21 10 0 "
      "LINE 8 0 10 0 20 10 11 0 21 0 0 TEXT 8 0 10 3 20 3 1 plate");
  EXPECT_TRUE(square.closed);
  EXPECT_EQ(square.unit, "mm");
  ASSERT_EQ(square.pieces.size(), 4U);
  EXPECT_EQ(measured(square).length, 40);
  EXPECT_EQ(std::abs(measured(square).area), 100);
  const Outline open = of_dxf("0 LINE 8 0 10 0 20 0 11 10 21 0 0 LINE 8 0 10 10 20 0 11 10 21 5");
  EXPECT_FALSE(open.closed);
  EXPECT_EQ(open.pieces.size(), 3U);
}

TEST(Dxf, ASplineIsWithinItsTolerance) {
  // A cubic Bezier curve from (0, 0) to (4, 0): y = 3 t (1 - t)^2 2 + 3 t^2 (1 - t) 2, x = 4 t for these
  // control points, so y = 6 t (1 - t) over x.
  const Outline curve = of_dxf(
      "0 SPLINE 8 0 70 0 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 "
      "1.3333333333333333 20 2 10 "
      "2.6666666666666667 20 2 10 4 20 0");
  EXPECT_FALSE(curve.closed);
  EXPECT_GT(curve.pieces.size(), 10U);
  double greatest = 0;
  for (std::size_t i = 0; i + 1 < curve.pieces.size(); ++i) {
    const Vertex &a = curve.pieces[i], &b = curve.pieces[i + 1];
    for (int k = 0; k <= 50; ++k) {  // places on the arc
      const double half = 2 * std::atan(a.bulge), s = k / 50.0;
      const std::complex<double> chord(b.x - a.x, b.y - a.y);
      const auto p =
          std::complex<double>(a.x, a.y) +
          chord * std::polar(half == 0 ? s : std::sin(s * half) / std::sin(half), (s - 1) * half);
      const double t = p.real() / 4;
      greatest = std::max(greatest, std::abs(p.imag() - 6 * t * (1 - t)));
    }
  }
  EXPECT_LT(greatest, 4e-7 * 2);
  EXPECT_GT(greatest, 1e-9) << "not a coincidence";
}

TEST(Dxf, TheOuterCurveOfALayerIsTheOutline) {
  const std::string both =
      "0 CIRCLE 8 HUB 10 0 20 0 40 5 0 CIRCLE 8 CAM 10 0 20 0 40 30 0 CIRCLE 8 CAM 10 15 20 0 "
      "40 2 0 INSERT 8 NOTES 2 TITLE";
  expect_circle(of_dxf(both, "#CAM"), 0, 0, 30);
  expect_circle(of_dxf(both, "#HUB"), 0, 0, 5);
  EXPECT_EQ(complaint(dxf(both), "plate.dxf"),
            "plate.dxf: layer: is missing: name one after #, such as plate.dxf#CAM; the layers are "
            "CAM, HUB, "
            "NOTES");
  EXPECT_EQ(complaint(dxf(both), "plate.dxf#cam"),
            "plate.dxf: layer = cam: is not in the drawing, whose layers are CAM, HUB, NOTES");
  EXPECT_THAT(complaint(dxf(both), "plate.dxf#NOTES"), HasSubstr("INSERT: is not supported"));
  EXPECT_THAT(
      complaint(dxf("0 CIRCLE 8 0 10 0 20 0 40 1 0 CIRCLE 8 0 10 9 20 0 40 1"), "plate.dxf"),
      HasSubstr("plate.dxf: curve: is not the only one: there are 2 separate curves"));
}

TEST(Dxf, NamesWhatIsWrong) {
  EXPECT_THAT(complaint("AutoCAD Binary DXF\r\n", "a.dxf"),
              HasSubstr("a.dxf:1: is a binary DXF file"));
  EXPECT_EQ(complaint("points\n1\n", "a.dxf"),
            "a.dxf:1: group code = points: must be a whole number: is this an ASCII DXF file?");
  EXPECT_THAT(complaint(dxf(""), "a.dxf"), HasSubstr("contains no curve"));
  EXPECT_EQ(complaint("0\nEOF\n", "a.dxf"),
            "a.dxf:1: has no section ENTITIES: is this a DXF file?");
  EXPECT_EQ(complaint(dxf("0 CIRCLE 8 0 10 0 20 0 40 wide"), "a.dxf"),
            "a.dxf:24: CIRCLE = wide: must be a finite number");
  EXPECT_EQ(complaint(dxf("0 CIRCLE 8 0 10 0 20 0 40 0"), "a.dxf"),
            "a.dxf:16: CIRCLE: must have a radius greater than 0");
  EXPECT_EQ(complaint(dxf("0 LINE 8 0 10 0 20 0 11 3"), "a.dxf"),
            "a.dxf:16: LINE: has no group 21");
  EXPECT_THAT(complaint(dxf("0 CIRCLE 8 0 10 0 20 0 40 1 210 1 230 0"), "a.dxf"),
              HasSubstr("CIRCLE: is not in the plane of the drawing"));
  EXPECT_THAT(complaint(dxf("0 SPLINE 8 0 71 3 11 0 21 0 11 1 21 1"), "a.dxf"),
              HasSubstr("fit points only"));
  EXPECT_THAT(complaint(dxf("0 SPLINE 8 0 71 3 40 0 10 0 20 0"), "a.dxf"),
              HasSubstr("must have a degree"));
  EXPECT_THAT(complaint(dxf("0 LINE 8 0 10 0 20 0 11 1 21 0 0 LINE 8 0 10 1 20 0 11 2 21 1 0 LINE "
                            "8 0 10 1 20 0 11 2 "
                            "21 -1"),
                        "a.dxf"),
              HasSubstr("three curves meet at 1, 0"));
  EXPECT_THAT(complaint(dxf("", "2"), "a.dxf"), HasSubstr("$INSUNITS = 2: must be 1 (in)"));
}

TEST(Dxf, EveryTruncationIsReadOrRejected) {
  const std::string whole = dxf(
      "0 CIRCLE 8 CAM 10 0 20 0 40 30 0 LWPOLYLINE 8 CAM 90 2 70 1 10 5 20 0 42 1 10 -5 20 0 42 1");
  std::size_t rejected = 0;
  for (std::size_t n = 0; n < whole.size(); ++n)
    rejected += complaint(whole.substr(0, n), "a.dxf#CAM").empty() ? 0 : 1;
  EXPECT_GT(rejected, 100U);
}

TEST(Svg, AllElementsOfACircleAreThisCircle) {
  // y points downwards in SVG: the center is at 40, -60.
  expect_circle(of_svg("<circle cx='40' cy='60' r='30'/>"), 40, -60, 30);
  expect_circle(of_svg("<ellipse cx='40' cy='60' rx='30' ry='30'/>"), 40, -60, 30);
  expect_circle(of_svg("<path d='M70 60A30 30 0 1 0 10 60A30,30 0 0 0 70,60z'/>"), 40, -60, 30);
  expect_circle(of_svg("<path d='M70 60 a30 30 90 01-60 0 a30 30 -4 1160 0'/>"), 40, -60, 30);
  expect_circle(
      of_svg(
          "<g transform='translate(40 60) rotate(33)'><circle r='15' transform='scale(2)'/></g>"),
      40, -60, 30);
  expect_circle(of_svg("<g transform='matrix(0 30 -30 0 40 60)'><circle r='1'/></g>"), 40, -60, 30);
  expect_circle(of_svg("<circle cx='4' cy='6' r='3' transform='rotate(360 4 6) skewX(0)'/>",
                       "width='10cm' height='10cm' viewBox='0 0 10 10'"),
                40, -60, 30);
}

TEST(Svg, AnEllipseHasItsArea) {
  for (const char* shape : {"<ellipse cx='50' cy='50' rx='40' ry='20'/>",
                            "<circle r='20' transform='translate(50 50) scale(2 1)'/>",
                            "<path d='M90 50A40 20 0 0 1 10 50A40 20 0 0 1 90 50'/>",
                            "<path transform='rotate(-30 50 50)' d='M84.641016151377542 70A40 20 "
                            "30 0 1 15.358983848622458 30A40 20 30 0 1 "
                            "84.641016151377542 70'/>"}) {
    const Outline ellipse = of_svg(shape);
    EXPECT_TRUE(ellipse.closed) << shape;
    EXPECT_NEAR(std::abs(measured(ellipse).area), pi * 800, 1e-3) << shape;
  }
}

TEST(Svg, AllCommandsOfAPathAreUnderstood) {
  const auto area = [](const char* d) {
    return std::abs(measured(of_svg("<path d='" + std::string(d) + "'/>")).area);
  };
  for (const char* square :
       {"M10 10L30 10L30 30L10 30Z", "m10,10 20,0 0,20-20,0z", "M10 10H30V30H10V10",
        "M10,10h20v20h-20z", "M 1e1 10 L 3.e1 +10 30 30 10 30 Z"})
    EXPECT_NEAR(area(square), 400, 1e-12) << square;
  // A parabola over a chord of length b and height h encloses 2/3 b h: three forms of the same curve.
  for (const char* parabola : {"M0 0Q20 40 40 0Z", "M0,0q20 40 40,0z",
                               "M0 0C13.333333333333334 26.666666666666668 "
                               "26.666666666666664 26.666666666666668 40 0Z"})
    EXPECT_NEAR(area(parabola), 2.0 / 3 * 40 * 20, 5e-4) << parabola;
  // T and S continue with the mirrored control point: the two arches cancel in the signed area.
  for (const char* wave : {"M0 0Q10 20 20 0T40 0", "M0 0q10 20 20 0t20 0"})
    EXPECT_NEAR(measured(of_svg("<path d='" + std::string(wave) + "'/>")).area, 0, 1e-4) << wave;
  EXPECT_NEAR(measured(of_svg("<path d='M0 0C0 10 20 10 20 0S40 -10 40 0'/>")).area, 0, 1e-4);
  EXPECT_EQ(area("M0 0L5 0L5 5Z M1 1"), 12.5);
}

TEST(Svg, LinesAndPolygons) {
  EXPECT_EQ(std::abs(measured(of_svg("<polygon points='0,0 10,0 10 10 0 10'/>")).area), 100);
  EXPECT_EQ(std::abs(measured(of_svg("<rect x='5' y='5' width='20' height='10'/>")).area), 200);
  const Outline open =
      of_svg("<polyline points='0,0 10,5 20,0'/><line x1='20' y1='0' x2='30' y2='0'/>");
  EXPECT_FALSE(open.closed);
  ASSERT_EQ(open.pieces.size(), 4U);
  EXPECT_EQ(open.pieces[1].y, -5) << "y upwards";
}

TEST(Svg, TheSizeOfTheDrawingIsItsUnit) {
  const auto radius = [](const char* root) {
    const Outline c = of_svg("<circle r='10'/>", root);
    return measured(c).length / (2 * pi);
  };
  EXPECT_NEAR(radius("width='200mm' height='100mm' viewBox='0 0 100 50'"), 20, 1e-12);
  EXPECT_NEAR(radius("width='1in' viewBox='0 0 96 96'"), 25.4 / 9.6, 1e-12);
  EXPECT_NEAR(radius("width='100mm' height='100mm'"), 10 * 25.4 / 96, 1e-12);
  EXPECT_EQ(of_svg("<circle r='10'/>", "width='1in'").unit, "mm");
  EXPECT_EQ(of_svg("<circle r='10'/>", "width='100' viewBox='0 0 50 50'").unit, "") << "pixels";
  EXPECT_NEAR(radius("width='100' viewBox='0 0 50 50'"), 10, 1e-12);
  EXPECT_THAT(
      complaint("<svg width='100mm' height='100mm' viewBox='0 0 10 20'><circle r='1'/></svg>",
                "a.svg"),
      HasSubstr("has another ratio of width and height"));
}

TEST(Svg, NamesWhatIsWrong) {
  const auto error = [](const std::string& elements) {
    return test::error_of([&] { (void)of_svg(elements); });
  };
  EXPECT_EQ(error("<path d='M0 0\nL1 banana'/>"), "plate.svg:1: d = banana: must be a number");
  EXPECT_EQ(error("<path d='M0 0 K1 1'/>"), "plate.svg:1: d = K: is not a command of a path");
  EXPECT_THAT(error("<path d='1 1'/>"), HasSubstr("must begin with a command"));
  EXPECT_THAT(error("<path d='M0 0A1 1 0 2 1 3 3'/>"),
              HasSubstr("must be 0 or 1, a flag of an arc"));
  EXPECT_THAT(error("<circle r='1' transform='spin(3)'/>"),
              HasSubstr("transform = spin: must be matrix"));
  EXPECT_THAT(error("<circle r='1' transform='scale(3'/>"), HasSubstr("is not complete"));
  EXPECT_THAT(error("<use href='#a'/>"), HasSubstr("use: is not supported"));
  EXPECT_THAT(error("<rect width='5' height='5' rx='1'/>"), HasSubstr("has round corners"));
  EXPECT_THAT(error("<text>plate</text>"), HasSubstr("contains no curve"));
  EXPECT_THAT(complaint("<svg><circle r='1'", "a.svg"), HasSubstr("is not well-formed XML"));
  EXPECT_EQ(complaint("<html/>", "a.svg"), "a.svg:1: is not an SVG drawing");
}

TEST(Drawing, IsRecognizedByItsEnding) {
  for (const char* path : {"a.dxf", "A.DXF", "b.svg#cam", "a.dxf#LAYER 1"})
    EXPECT_TRUE(is_drawing(path)) << path;
  for (const char* path : {"a.csv", "dxf", "a.dxf.csv", "a.xlsx#dxf"})
    EXPECT_FALSE(is_drawing(path)) << path;
}

}  // namespace
}  // namespace jounce::drawing_test
