// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cstdint>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

// TwinCAT, Siemens and Rockwell: files as their programs and public generators write them, in the numbers of one cam:
// E, 40 mm by 3-4-5 over 0 to 120 deg, a dwell to 180, back until 300, a dwell to 360.
namespace jounce::exchange_vendors_test {
namespace {

using ::testing::HasSubstr;

TableFile cam_e() {
  return {Table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                {{0, 120, 180, 300, 360}, {0, 40, 40, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}),
          {"deg", "mm"},
          {}};
}

std::string complaint(const std::string& text) {
  return test::error_of([&] { static_cast<void>(parse_exchange(text, "t")); });
}

TEST(ExchangeFormats, EachHasItsNameAndDetectsItsFiles) {
  std::set<std::string> names;
  for (const ExchangeFormat* format : exchange_formats()) {
    SCOPED_TRACE(format->name);
    EXPECT_TRUE(names.insert(format->name).second);
    EXPECT_EQ(exchange_format_named(format->name), format);
    if (*format->extension != '\0') {
      EXPECT_EQ(exchange_format_of_path(std::string("cam") + format->extension), format);
    }
    if (format->axis == Domain::time || format->p != Numbers::of_unit || format->most < 5)
      continue;  // tests/design/controller_files_test.cpp
    TableFile file = cam_e();
    Columns columns = file.table.columns();
    if (rule_of(*format) != Interpolation::quintic_hermite) columns.a.clear();
    if (rule_of(*format) == Interpolation::linear) columns.v.clear();
    file.table = Table(Domain::master, rule_of(*format), Extrapolation::wrap, std::move(columns));
    const std::string text = exchange_text(*format, file);
    EXPECT_EQ(exchange_format_of_text(text), format);
    if (!format->readable) continue;
    const TableFile back = parse_exchange(text, "t");
    EXPECT_EQ(back.table.columns().x, file.table.columns().x);
    EXPECT_EQ(back.table.columns().p, file.table.columns().p);
    EXPECT_EQ(back.units.x, format->keeps_notes ? "deg" : "");
  }
  EXPECT_EQ(exchange_format_of_path("CAM.L5X"), exchange_format_named("rockwell"));
}

// Tc2_MC2_Camming, with the names of a public generator: one assignment a field, the index in a variable.
const std::string assigned =
    "point := 1;\n"
    "  Oven.camPoints[point].MasterPos := 0.0000;\n"
    "  Oven.camPoints[point].SlavePos := 0.0;\n"
    "  Oven.camPoints[point].PointIndex := point;\n"
    "  Oven.camPoints[point].FunctionType := MC_MotionFunctionType.MOTIONFUNCTYPE_POLYNOM5_MM;\n"
    "  Oven.camPoints[point].PointType := MC_MotionPointType.MOTIONPOINTTYPE_ACTIVATION;\n"
    "  Oven.camPoints[point].RelIndexNextPoint := 1;\n"
    "point := 2;\n"
    "  Oven.camPoints[point].MasterPos := 120;\n"
    "  Oven.camPoints[point].SlavePos := 40;\n"
    "  Oven.camPoints[point].SlaveVelo := 0.25;\n"
    "  Oven.camPoints[point].FunctionType := MOTIONFUNCTYPE_POLYNOM1;\n"
    "point := 3;\n"
    "  Oven.camPoints[point].MasterPos := 200;\n"
    "  Oven.camPoints[point].SlavePos := 60;\n"
    "  Oven.camPoints[point].SlaveVelo := 0.25;\n"
    "  Oven.camPoints[point].RelIndexNextPoint := 0;\n";

TEST(TwinCat, ReadsAssignedPoints) {
  const auto cams = parse_exchange_tables(assigned, "t");
  ASSERT_EQ(cams.size(), 1U);
  EXPECT_EQ(cams[0].name, "Oven.camPoints");
  const Columns& c = cams[0].file.table.columns();
  EXPECT_EQ(c.x, (std::vector<double>{0, 120, 200}));
  EXPECT_EQ(c.p, (std::vector<double>{0, 40, 60}));
  EXPECT_EQ(c.v, (std::vector<double>{0, 0.25, 0.25}));
  const Cam cam = cams[0].file.table.curve<OverMaster>();
  EXPECT_NEAR(cam.at(160).position, 50, 1e-12) << "POLYNOM1 is a straight line";
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(TwinCat, RejectsLawsThatAQuinticIsNot) {
  EXPECT_EQ(complaint(assigned), "");
  EXPECT_THAT(complaint(with(assigned, "POLYNOM5_MM", "MODSINUSLINIE")),
              HasSubstr("t:2: FunctionType = motionfunctype_modsinuslinie"));
  EXPECT_THAT(complaint(with(assigned, "MOTIONFUNCTYPE_POLYNOM5_MM", "5")),
              HasSubstr("from rest to rest"));
  EXPECT_THAT(complaint(with(assigned, "SlaveVelo := 0.25", "SlaveVelo := 0.3")),
              HasSubstr("straight line"));
  EXPECT_THAT(complaint(with(assigned, "PointIndex := point", "PointIndex := 4")),
              HasSubstr("without a gap"));
  EXPECT_THAT(complaint(with(assigned, "RelIndexNextPoint := 1", "RelIndexNextPoint := 2")),
              HasSubstr("chain"));
  EXPECT_THAT(complaint(with(assigned, "point := 3", "point := 4")), HasSubstr("[3]: is missing"));
}

TEST(TwinCat, WritesTheMotionFunction) {
  const std::string text = exchange_text(*exchange_format_named("twincat"), cam_e());
  EXPECT_THAT(text, HasSubstr("ARRAY[1..5] OF MC_MotionFunctionPoint"));
  EXPECT_THAT(text, HasSubstr("PointIndex := 2, FunctionType := MOTIONFUNCTYPE_POLYNOM5_MM"));
  EXPECT_THAT(text,
              HasSubstr("MasterPos := 120.0, SlavePos := 40.0, SlaveVelo := 0.0, SlaveAcc := 0.0"));
  EXPECT_THAT(text, HasSubstr("Periodic := TRUE"));
  EXPECT_THAT(text, HasSubstr("NoOfRows := 5, NoOfColumns := 1"));
}

// Tc3_Mc3Camming: three points, a quintic and a line.
const std::string mc3 =
    "camPoints : ARRAY[1..3] OF MotionFunctionPoint := [\n"
    "(FunctionType := EMotionFunctionType.Polynomial5, MasterPosition := 0, SlavePosition := 0,\n"
    " SlaveVelocity := 0, SlaveAcceleration := 0, Ignored := FALSE),\n"
    "(FunctionType := EMotionFunctionType.Linear, MasterPosition := 120, SlavePosition := 40,\n"
    " SlaveVelocity := 0.25, SlaveAcceleration := 0),\n"
    "(FunctionType := 3, MasterPosition := 200, SlavePosition := 60, SlaveVelocity := 0.25,\n"
    " SlaveAcceleration := 0)];\n";

TEST(TwinCatMc3, ReadsPointsWithTheirBoundaryValues) {
  EXPECT_EQ(exchange_format_of_text(mc3), exchange_format_named("twincat-mc3"));
  const auto cams = parse_exchange_tables(mc3, "t");
  ASSERT_EQ(cams.size(), 1U);
  EXPECT_EQ(cams[0].name, "camPoints");
  const Columns& c = cams[0].file.table.columns();
  EXPECT_EQ(c.x, (std::vector<double>{0, 120, 200}));
  EXPECT_EQ(c.v, (std::vector<double>{0, 0.25, 0.25}));
  EXPECT_NEAR(cams[0].file.table.curve<OverMaster>().at(160).position, 50, 1e-12);
  const std::string one_by_one =
      "p[1].FunctionType := EMotionFunctionType.Polynomial5;\np[1].MasterPosition := 0;\n"
      "p[1].SlavePosition := 0;\np[1].SlaveVelocity := 0;\np[1].SlaveAcceleration := 0;\n"
      "p[2].MasterPosition := 90;\np[2].SlavePosition := 7;\np[2].SlaveVelocity := 0;\n"
      "p[2].SlaveAcceleration := 0;\n";
  EXPECT_EQ(exchange_format_of_text(one_by_one), exchange_format_named("twincat-mc3"));
  EXPECT_EQ(parse_exchange(one_by_one, "t").table.columns().p, (std::vector<double>{0, 7}));
}

TEST(TwinCatMc3, RejectsWhatTheControllerComputes) {
  EXPECT_EQ(complaint(mc3), "");
  EXPECT_THAT(complaint(with(mc3, "Polynomial5", "ModifiedSinusoid")),
              HasSubstr("t:2: FunctionType = modifiedsinusoid: is not a polynomial of degree 5"));
  EXPECT_THAT(complaint(with(mc3, "SlavePosition := 60, SlaveVelocity := 0.25",
                             "SlavePosition := 60, SlaveVelocity := 0.3")),
              HasSubstr("straight line"));
  EXPECT_THAT(complaint(with(mc3, ", SlaveAcceleration := 0, Ignored := FALSE", "")),
              HasSubstr("t:2: SlaveAcceleration: is missing: the controller would compute it"));
  EXPECT_THAT(complaint(with(mc3, "Ignored := FALSE", "Ignored := TRUE")),
              HasSubstr("Ignored = true: is not supported"));
  EXPECT_THAT(complaint(with(mc3, "Ignored := FALSE", "SymmetryRatio := 0.4")),
              HasSubstr("SymmetryRatio: is not supported"));
}

TEST(TwinCatMc3, WritesThePoints) {
  const std::string text = exchange_text(*exchange_format_named("twincat-mc3"), cam_e());
  EXPECT_THAT(text, HasSubstr("ARRAY[1..5] OF MotionFunctionPoint"));
  EXPECT_THAT(text, HasSubstr("FunctionType := EMotionFunctionType.Polynomial5"));
  EXPECT_THAT(text, HasSubstr("MasterPosition := 120.0, SlavePosition := 40.0, "
                              "SlaveVelocity := 0.0, SlaveAcceleration := 0.0"));
  EXPECT_THAT(text, HasSubstr("Cam : MC_CAM_REF := (NumberOfPoints := 5)"));
  EXPECT_THAT(text, HasSubstr("couple it periodically"));
}

TEST(Siemens, ReadsAssignmentsOfScl) {
  std::string text =
      "DATA_BLOCK \"Feeder\"\n  STRUCT\n    kn : Array[1..3] of \"LCamHdl_typeBasicPoint\";\n  "
      "END_STRUCT;\n"
      "BEGIN\n  kn[1].leadingValue := 0.0;\n  kn[1].followingValue := 0.0;\n"
      "  kn[2].leadingValue := 120.0; kn[2].followingValue := 40.0; kn[2].velocityRatio := -0.5;\n"
      "  kn[3].leadingValue := 360.0;\n  kn[3].accelerationRatio := 1.0E-5;\nEND_DATA_BLOCK\n";
  const TableFile file = parse_exchange(text, "t");
  EXPECT_EQ(file.table.columns().x, (std::vector<double>{0, 120, 360}));
  EXPECT_EQ(file.table.columns().p, (std::vector<double>{0, 40, 0}));
  EXPECT_EQ(file.table.columns().v, (std::vector<double>{0, -0.5, 0}));
  EXPECT_EQ(file.table.columns().a, (std::vector<double>{0, 0, 1e-5}));
  EXPECT_THAT(complaint(with(text, "kn[2].velocityRatio := -0.5;", "kn[2].velocityRatio := -0.5")),
              HasSubstr("must be `;`"));
}

TEST(Siemens, HoldsFiftyOnePoints) {
  const auto points = [](std::size_t n) {
    Columns c;
    for (std::size_t i = 0; i < n; ++i) {
      c.x.push_back(static_cast<double>(i));
      for (auto* column : {&c.p, &c.v, &c.a}) column->push_back(0);
    }
    return TableFile{
        Table(Domain::master, Interpolation::quintic_hermite, Extrapolation::hold, c), {}, {}};
  };
  const ExchangeFormat& format = *exchange_format_named("siemens");
  EXPECT_NO_THROW(static_cast<void>(exchange_text(format, points(51))));
  EXPECT_THROW(static_cast<void>(exchange_text(format, points(52))), InputError);
}

/// Two DINTs of a double, high word first.
std::string words(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return std::to_string(static_cast<std::int32_t>(bits >> 32U)) + "," +
         std::to_string(static_cast<std::int32_t>(bits & 0xFFFFFFFFU));
}

std::string element(double x, double p, double c1, double c2, double c3, int status = 2) {
  return "[" + std::to_string(status) + "," + words(x) + "," + words(p) + ",1," + words(0) + "," +
         words(c1) + "," + words(c2) + "," + words(c3) + "]";
}

std::string profile(const std::string& elements) {
  return "<?xml version=\"1.0\"?>\n<RSLogix5000Content><Tags>\n"
         "<Tag Name=\"E\" DataType=\"CAM_PROFILE\" Dimensions=\"3\">\n<Data "
         "Format=\"L5K\"><![CDATA[[" +
         elements + "]]]></Data>\n</Tag></Tags></RSLogix5000Content>\n";
}

TEST(Rockwell, ReadsTheCalculatedProfile) {
  // The first row of E as MCCP computes it with slope 0 at both ends: c2 = 1/120, c3 = -1/21600.
  const std::string first = "[2,0,0,0,0,1,0,0,0,0,1065423121,286331153,-1089976888,-1597091543]";
  EXPECT_EQ(first, element(0, 0, 0, 1.0 / 120, -1.0 / 21600)) << "words of the notes";
  const TableFile file =
      parse_exchange(profile(first + "," + element(120, 40, 0, 0, 0) + "," +
                             element(360, 40, 0, 0, 0) + "," + element(360, 40, 0, 0, 0, 0)),
                     "t");
  EXPECT_EQ(file.table.rule(), Interpolation::cubic_hermite);
  EXPECT_EQ(file.table.columns().x, (std::vector<double>{0, 120, 360}));
  EXPECT_EQ(file.table.columns().p, (std::vector<double>{0, 40, 40}));
  const Cam cam = file.table.curve<OverMaster>();
  EXPECT_NEAR(cam.at(60).position, 3600.0 / 120 - 216000.0 / 21600, 1e-12);
  EXPECT_NEAR(cam.at(60).geo_velocity, 0.5, 1e-13);
}

TEST(Rockwell, RejectsAProfileThatJumpsOrIsNotCalculated) {
  const std::string line = element(0, 0, 1, 0, 0), rest = element(100, 100, 0, 0, 0);
  EXPECT_THAT(complaint(profile(line + "," + rest + "," + element(200, 100, 0, 0, 0))),
              HasSubstr("the slope jumps here from 1"));
  EXPECT_THAT(complaint(profile(line + "," + element(100, 90, 1, 0, 0))),
              HasSubstr("ends the segment"));
  EXPECT_THAT(complaint(profile(element(0, 0, 0, 0, 0, 0))), HasSubstr("run MCCP"));
  EXPECT_THAT(complaint("<Tag DataType=\"CAM\" Name=\"E\">\n<Data"), HasSubstr("t:2: is not XML"));
  EXPECT_THAT(
      complaint("<Tag DataType=\"CAM\" Name=\"E\"><Data Format=\"L5K\">[[0.0,0.0]]</Data></Tag>"),
      HasSubstr("an element of a CAM has 3"));
}

TEST(Rockwell, RejectsATagWithoutElements) {
  const std::string empty = "<Tag Name=\"E\" DataType=\"CAM\"><Data Format=\"Decorated\"/></Tag>";
  EXPECT_THAT(complaint(empty), HasSubstr("t:1: E: has no knots"));
  EXPECT_THAT(complaint("<Tags>" + empty + empty + "</Tags>"), HasSubstr("has no knots"));
}

TEST(Rockwell, ReadsACamOfLinesAndOneOfCubics) {
  const auto cam = [](const char* types) {
    return "<Tag Name=\"E\" DataType=\"CAM\"><Data Format=\"Decorated\"><Array>" +
           std::string(types) + "</Array></Data></Tag>";
  };
  const auto member = [](int x, int p, int type) {
    return "<Element><Structure><DataValueMember Name=\"Master\" Value=\"" + std::to_string(x) +
           "\"/><DataValueMember Name=\"Slave\" Value=\"" + std::to_string(p) +
           "\"/><DataValueMember Name=\"SegmentType\" Value=\"" + std::to_string(type) +
           "\"/></Structure></Element>";
  };
  const TableFile lines =
      parse_exchange(cam((member(0, 0, 0) + member(1, 2, 0) + member(2, 3, 0)).c_str()), "t");
  EXPECT_EQ(lines.table.rule(), Interpolation::linear);
  const auto cubics = parse_exchange_tables(
      cam((member(0, 0, 1) + member(1, 1, 1) + member(2, 0, 0)).c_str()), "t");
  // Clamped spline through 0, 1, 0 at unit distance with slopes 0: symmetric, so its slope in the middle is 0.
  EXPECT_NEAR(cubics[0].file.table.columns().v[1], 0, 1e-15);
  EXPECT_THAT(cubics[0].unread, ::testing::ElementsAre(HasSubstr("operands of MCCP")));
  EXPECT_THAT(complaint(cam((member(0, 0, 1) + member(1, 1, 0) + member(2, 0, 0)).c_str())),
              HasSubstr("mixes"));
}

TEST(Rockwell, WritesBothViewsOfATag) {
  const TableFile file{Table(Domain::master, Interpolation::cubic_hermite, Extrapolation::hold,
                             {{0, 120}, {0, 40}, {0.5, -0.25}, {}}),
                       {"deg", "mm"},
                       {}};
  const std::string text = exchange_text(*exchange_format_named("rockwell"), file);
  EXPECT_THAT(text, HasSubstr("<![CDATA[[[0.0,0.0,1],[120.0,40.0,0]]]]>"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "<DataValueMember Name=\"Master\" DataType=\"REAL\" Radix=\"Float\" Value=\"120.0\"/>"));
  EXPECT_THAT(text, HasSubstr("StartSlope 0.5, EndSlope -0.25"));
  EXPECT_EQ(parse_exchange(text, "t").table.columns().v, file.table.columns().v);
}

}  // namespace
}  // namespace jounce::exchange_vendors_test
