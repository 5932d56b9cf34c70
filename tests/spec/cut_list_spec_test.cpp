// SPDX-License-Identifier: Apache-2.0
// Lists of pieces in the specs of cutters, and cams made from synchronous slaves.
#include <cmath>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/detail/sync_check.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::cut_list_spec_test {
namespace {

using ::testing::HasSubstr;

std::string shear(const std::string& keys) {
  return "jounce = 1\nkind = \"shear\"\nunits = { position = \"mm\", master = \"mm\" }\n[shear]\n" +
         keys +
         "\nline_speed = 1000\nsync_time = 0.15\n[limits.slave]\nvelocity = 2000\n"
         "acceleration = 10000\n";
}

std::string knife(const std::string& keys) {
  return "jounce = 1\nkind = \"knife\"\nunits = { position = \"deg\", master = \"mm\" }\n[knife]\n"
         "diameter = 95.5\nsync_angle = 20\n" +
         keys + "\n[master]\nvelocity = 1000\n";
}

std::string refusal(const std::string& text) {
  return test::error_of([&] { (void)make(parse_spec(text, "s.toml")); });
}

const Cam& cam_of(const Made& made) {
  return std::get<Cam>(*made.curve);
}

TEST(CutListSpec, IsOneCamOfAllPieces) {
  const Spec read = parse_spec(knife("lengths = [250, \"0.3 m\"]\nwaste = 120\ndwell = true"), "s");
  const Made made = make(read);
  EXPECT_EQ(read.master_period(), 670);
  EXPECT_EQ(cam_of(made).end(), 670);
  EXPECT_EQ(cam_of(made).advance(), 3 * 360);
  EXPECT_EQ(made.zones.size(), 4U) << "three cuts, and the half of one at the end";
}

TEST(CutListSpec, OfOneLengthIsThePieceItself) {
  const Made list = make(parse_spec(shear("lengths = [1000]"), "s"));
  const Made one = make(parse_spec(shear("cut_length = 1000"), "s"));
  for (double x = 0; x < 1000; x += 13)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(cam_of(list).jet(x)[k], cam_of(one).jet(x)[k],
                  1e-9 * std::pow(10, -2.0 * double(k)));
  EXPECT_EQ(cam_of(list).outside(), cam_of(one).outside());
}

TEST(CutListSpec, WithAFirstCutRunsOnce) {
  const Spec read = parse_spec(shear("lengths = [1000, 1200]\nfirst = 500"), "s");
  EXPECT_FALSE(read.master_period());
  EXPECT_EQ(cam_of(make(read)).outside(), Extrapolation::hold);
  ASSERT_TRUE(read.master);
  EXPECT_NEAR(read.master->distance, cam_of(make(read)).length(), 1e-9);
}

TEST(CutListSpec, ReportsTheSlowestPiece) {
  const Spec read = parse_spec(
      knife("lengths = [250, 100]\ndwell = true") + "[limits.slave]\nvelocity = 4800\n", "s");
  const auto figures = sync_figures(read);
  EXPECT_EQ(figures.at(0).name, "one pass");
  EXPECT_EQ(figures.at(0).value, 350);
  EXPECT_EQ(figures.back().name, "fastest line");
  EXPECT_THAT(figures.back().meaning, HasSubstr("for the piece of 100 mm, limited by the slave's "
                                                "velocity"));
}

TEST(CutListSpec, RejectsWrongLists) {
  EXPECT_THAT(refusal(shear("lengths = [1000, 500]")),
              HasSubstr("s.toml:5:11: shear.lengths[2] = 500 mm: must be at least 966.425 mm"));
  EXPECT_THAT(refusal(knife("lengths = [250, 900]")),
              HasSubstr("knife.lengths[2] = 900 mm: must be at most"));
  EXPECT_THAT(refusal(knife("lengths = []")), HasSubstr("must have at least one length"));
  EXPECT_THAT(refusal(knife("lengths = [250]\ncut_length = 250")),
              HasSubstr("cannot be combined with cut_length"));
  EXPECT_THAT(refusal(shear("lengths = [1000]\nfirst = 100")),
              HasSubstr("shear.first = 100 mm: must be at least 187.5 mm"));
  EXPECT_THAT(refusal(shear("lengths = [1000]\nfirst = 0")), HasSubstr("must be greater than 0"));
}

// ---- cams from synchronous slaves ------------------------------------------------------------------

struct Folder : test::TemporaryFolder {
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(*this / name) << text;
  }
  Made cam(const std::string& keys) const {
    return make(parse_spec("jounce = 1\nkind = \"cam\"\n" + keys, (*this / "cam.toml").string()));
  }
};

TEST(CamFrom, AnySpecOverAMaster) {
  const Folder folder;
  folder.write("shear.toml", shear("cut_length = 1000"));
  folder.write("knife.toml", knife("cut_length = 250"));
  folder.write("gear.toml",
               "jounce = 1\nkind = \"gear\"\nunits = { position = \"deg\", master = \"mm\" }\n"
               "[gear]\nnumerator = 3\ndenominator = 2\nmaster_period = 100\n");
  const Made later =
      folder.cam("from = \"shear.toml\"\nthen = [{ operator = \"phase\", master = 100 }]\n");
  const Cam of_shear = cam_of(make(parse_spec(shear("cut_length = 1000"), "s")));
  for (double x = 150; x < 1000; x += 50)
    EXPECT_NEAR(cam_of(later).jet(x)[0], of_shear.jet(x - 100)[0], 1e-9);
  EXPECT_EQ(cam_of(folder.cam("from = \"knife.toml\"\n")).advance(), 360);
  EXPECT_NEAR(cam_of(folder.cam("from = \"gear.toml\"\n")).jet(10)[0], 15, 1e-12);
}

TEST(CamThen, InverseLeavesOutTheRestsAtItsEnds) {
  const Folder folder;
  folder.write("rise.toml",
               "jounce = 1\nkind = \"cam\"\nunits = { position = \"mm\", master = \"deg\" }\n"
               "start = { master = 0, slave = 10 }\n[[segment]]\nlaw = \"345\"\n"
               "end = { master = 90, slave = 50 }\n");
  const Cam inverse = cam_of(
      folder.cam("from = \"rise.toml\"\nthen = [{ operator = \"inverse\", tolerance = 1e-6 }]\n"));
  EXPECT_NEAR(inverse.start(), 10.4, 1e-12);  // 1 % of 40 mm
  EXPECT_NEAR(inverse.end(), 49.6, 1e-12);
  EXPECT_NEAR(inverse.jet(30)[0], 45, 1e-6);
}

}  // namespace
}  // namespace jounce::cut_list_spec_test
