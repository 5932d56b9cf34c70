// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/disc.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/report_text.hpp"

#include "support/errors.hpp"

namespace jounce::disc_test {
namespace {

using ::testing::HasSubstr;

/// A cam of rise, dwell, return with what is written in [disc] and below.
std::string spec_text(const std::string& disc, const std::string& units = "deg",
                      const std::string& slave = "mm") {
  return "jounce = 1\nkind = \"cam\"\nname = \"valve\"\nperiodic = true\nunits = { master = \"" +
         units + "\", position = \"" + slave + R"(" }
start = { master = 0, slave = 0 }
segment = [ { law = "345", end = { master = "80 deg", slave = 9 } },
            { law = "dwell", end = { master = "100 deg", slave = 9 } },
            { law = "345", end = { master = "180 deg", slave = 0 } },
            { law = "dwell", end = { master = "360 deg", slave = 0 } } ]
[disc]
)" + disc;
}

const char* const usual =
    "base_radius = 18\nroller_radius = 8\noffset = 3\ncutter_radius = 10\n"
    "hub_radius = 7\ntolerance = 0.001\n";

Spec spec_of(const std::string& text) {
  return parse_spec(text, "valve.toml");
}

Cam cam_of(const Spec& spec) {
  return std::get<Cam>(*make(spec).curve);
}

Disc disc_of(const Spec& spec) {
  return make_disc(spec, cam_of(spec));
}

TEST(DiscSpec, ReadsEveryKey) {
  const Spec spec = spec_of(spec_text(
      "follower = \"oscillating\"\nbase_radius = \"2 cm\"\nroller_radius = 8\narm_length = 40\n"
      "center_distance = 50\nrotation = \"clockwise\"\ncutter_radius = 10\nhub_radius = 7\n"
      "tolerance = \"1 um\"\n[disc.limits]\npressure_angle = 30\nprofile_radius = 5\n"));
  ASSERT_TRUE(spec.disc);
  const DiscSpec& g = spec.disc->geometry;
  EXPECT_EQ(g.follower, Follower::oscillating);
  EXPECT_DOUBLE_EQ(g.base_radius, 20);
  EXPECT_EQ(g.arm_length, 40);
  EXPECT_EQ(g.center_distance, 50);
  EXPECT_EQ(g.rotation, Rotation::clockwise);
  EXPECT_FALSE(g.arm_angle);
  EXPECT_DOUBLE_EQ(spec.disc->tolerance, 1e-3);
  EXPECT_DOUBLE_EQ(*spec.disc->limits.pressure_angle, std::numbers::pi / 6);
  EXPECT_EQ(spec.disc->limits.profile_radius, 5);
  EXPECT_EQ(spec.disc->limits.cutter_radius, 10);
}

TEST(DiscSpec, AnAngularSlaveIsTheArmsAngleAndLengthsAreMillimeters) {
  const Spec spec =
      spec_of(spec_text("follower = \"oscillating\"\nbase_radius = 20\narm_length = 40\n"
                        "center_distance = \"5 cm\"\n",
                        "rad", "deg"));
  EXPECT_DOUBLE_EQ(*spec.disc->geometry.arm_angle, std::numbers::pi / 180);
  EXPECT_EQ(spec.disc->geometry.angle, 1);
  EXPECT_EQ(spec.disc->geometry.center_distance, 50);
}

TEST(DiscSpec, ErrorsNameFileLineAndKey) {
  const auto complaint = [](const std::string& text) -> std::string {
    return test::error_of([&] {
      const Spec spec = spec_of(text);
      (void)drawing_of(spec, disc_of(spec));
    });
  };
  EXPECT_THAT(complaint(spec_text("roller_radius = 8\n")), HasSubstr("disc.base_radius"));
  EXPECT_THAT(complaint(spec_text("base_radius = 20\nofset = 3\n")), HasSubstr("offset"));
  EXPECT_THAT(complaint(spec_text("base_radius = 20\noffset = 21\n")),
              HasSubstr("valve.toml:13:10: disc.offset = 21 mm: must be less than 20 mm"));
  EXPECT_THAT(complaint(spec_text("base_radius = 20\ntolerance = 0\n")),
              HasSubstr("disc.tolerance = 0"));
  EXPECT_THAT(complaint(spec_text("base_radius = 20\ntolerance = 1e-12\n")),
              HasSubstr("disc.tolerance = 1e-12"));
  EXPECT_THAT(complaint(spec_text("base_radius = 20\n[disc.limits]\npressure_angle = 90\n")),
              HasSubstr("disc.limits.pressure_angle = 90"));
  EXPECT_THAT(complaint(spec_text("base_radius = 20\n", "deg", "deg")),
              HasSubstr("must be a length"));
  EXPECT_THAT(
      complaint("jounce = 1\nkind = \"cam\"\nunits = { master = \"mm\", position = \"mm\" }\n"
                "start = { master = 0, slave = 0 }\n"
                "segment = [ { law = \"dwell\", end = { master = 360, slave = 0 } } ]\n"
                "[disc]\nbase_radius = 20\n"),
      HasSubstr("units.master = \"mm\": must be an angle"));
  const Spec none = spec_of(spec_text("").substr(0, spec_text("").find("[disc]")));
  EXPECT_THROW(disc_of(none), InputError);
}

TEST(DiscSpec, FindingsAreSentencesWithUnitsAndAdvice) {
  const Spec spec =
      spec_of(spec_text("base_radius = 6\nroller_radius = 8\n[disc.limits]\n"
                        "pressure_angle = 30\nprofile_radius = 5\n"));
  const Report report = check_disc(spec, cam_of(spec));
  ASSERT_FALSE(report.ok());
  const std::string text = full_text(report, {spec.units, true, {}});
  EXPECT_THAT(text, HasSubstr("pressure angle"));
  EXPECT_THAT(text, HasSubstr(" deg at "));
  EXPECT_THAT(text, HasSubstr("exceeds the limit"));
  EXPECT_THAT(text, HasSubstr("-> base_radius = "));
}

/// One entity of a DXF: its kind, then every pair.
struct Entity {
  std::string kind;
  std::multimap<int, std::string> pairs;

  [[nodiscard]] std::string text(int code) const { return pairs.find(code)->second; }
  [[nodiscard]] double real(int code) const {
    const auto found = pairs.find(code);
    return found == pairs.end() ? 0 : std::stod(found->second);
  }
};

/// A reader of its own: pairs of lines, everything between SECTION ENTITIES and its ENDSEC.
std::vector<Entity> entities(const std::string& dxf) {
  std::istringstream lines(dxf);
  std::vector<Entity> all;
  std::string code;
  std::string value;
  bool inside = false;
  while (std::getline(lines, code) && std::getline(lines, value)) {
    if (code == "2" && value == "ENTITIES") inside = true;
    if (!inside || value == "ENTITIES") continue;
    if (code == "0" && value == "ENDSEC") break;
    if (code == "0") all.push_back({value, {}});
    if (code != "0") all.back().pairs.emplace(std::stoi(code), value);
  }
  return all;
}

TEST(Dxf, HoldsTheContourOnItsLayers) {
  const Spec spec = spec_of(spec_text(usual));
  const Disc disc = disc_of(spec);
  const DiscDrawing d = drawing_of(spec, disc);
  const std::string dxf = contour_dxf(d);
  EXPECT_TRUE(dxf.starts_with("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n"));
  EXPECT_TRUE(dxf.ends_with("0\nENDSEC\n0\nEOF\n"));
  EXPECT_THAT(dxf, HasSubstr("9\n$INSUNITS\n70\n4\n"));
  std::map<std::string, std::vector<Vertex>> vertices;
  std::map<std::string, double> circles;
  for (const Entity& e : entities(dxf)) {
    if (e.kind == "VERTEX") vertices[e.text(8)].push_back({e.real(10), e.real(20), e.real(42), 0});
    if (e.kind == "CIRCLE") circles[e.text(8)] = e.real(40);
    if (e.kind == "POLYLINE") {
      EXPECT_EQ(e.text(70), "1") << "closed";
    }
  }
  EXPECT_EQ(circles, (std::map<std::string, double>{{"BASE", 18}, {"HUB", 7}, {"ROLLER", 8}}));
  ASSERT_EQ(vertices.size(), 3U);
  for (const auto& [layer, contour] :
       {std::pair{"CAM", d.profile}, {"PITCH", d.pitch}, {"CUTTER", d.cutter}}) {
    ASSERT_EQ(vertices[layer].size(), contour.size()) << layer;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      EXPECT_NEAR(vertices[layer][i].x, contour[i].x, 1e-9);
      EXPECT_NEAR(vertices[layer][i].y, contour[i].y, 1e-9);
      EXPECT_NEAR(vertices[layer][i].bulge, contour[i].bulge, 1e-14);
    }
  }
}

TEST(Dxf, IsInMillimetersWhateverTheSpecsUnit) {
  const Spec spec = spec_of(spec_text(usual, "deg", "in"));
  const DiscDrawing d = drawing_of(spec, disc_of(spec));
  EXPECT_DOUBLE_EQ(d.base_radius, 18 * 25.4);
  EXPECT_NEAR(std::hypot(d.roller.x, d.roller.y), 26 * 25.4, 1e-9);
  EXPECT_NEAR(std::hypot(d.profile.back().x, d.profile.back().y), 18 * 25.4, 1e-2);
}

TEST(Svg, PrintsOneToOneAndStaysInItsFrame) {
  const Spec spec = spec_of(spec_text(usual));
  const std::string svg = contour_svg(drawing_of(spec, disc_of(spec)));
  double width = 0;
  double height = 0;
  double box[4]{};
  ASSERT_EQ(std::sscanf(svg.substr(svg.find("width=")).c_str(),
                        "width=\"%lfmm\" height=\"%lfmm\" viewBox=\"%lf %lf %lf %lf\"", &width,
                        &height, &box[0], &box[1], &box[2], &box[3]),
            6);
  EXPECT_EQ(width, box[2]);
  EXPECT_EQ(height, box[3]);
  EXPECT_LT(box[0], -26);
  EXPECT_GT(box[0] + box[2], 26);
  EXPECT_THAT(svg, HasSubstr("<title>valve</title>"));
}

TEST(ContourCsv, IsClosed) {
  const Spec spec = spec_of(spec_text(usual));
  std::istringstream csv(contour_csv(spec, disc_of(spec)));
  std::string head;
  std::string first;
  std::string last;
  std::getline(csv, head);
  std::getline(csv, first);
  for (std::string row; std::getline(csv, row);) last = row;
  EXPECT_EQ(head, "master [deg],x [mm],y [mm]");
  EXPECT_EQ(first.substr(first.find(',')), last.substr(last.find(',')));
  EXPECT_EQ(last.substr(0, last.find(',')), "360");
}

}  // namespace
}  // namespace jounce::disc_test
