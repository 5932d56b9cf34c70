// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/controllers/table_target.hpp"
#include "jounce/design/make.hpp"
#include "jounce/io/detail/points_text.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::target_test {
namespace {

using testing::HasSubstr;

std::string cam_with(const std::string& table) {
  return "jounce = 1\nkind = \"cam\"\nperiodic = true\nunits = { position = \"mm\", master = "
         "\"pulse\" "
         "}\n[start]\nmaster = 0\nslave = 0\n"
         "[[segment]]\nlaw = \"modified_sine\"\nend = { master = 5000, slave = 50 }\n"
         "[[segment]]\nlaw = \"modified_sine\"\nend = { master = 10000, slave = 0 }\n[table]\n" +
         table;
}

std::string move_with(const std::string& table) {
  return "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
         "profile = \"trapezoid\"\nto = 50\nvelocity = 10\nacceleration = 21\n[table]\n" +
         table;
}

std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)make(parse_spec(text, "a.toml")); });
}

TEST(TargetSpec, AsksForTheFewestKnots) {
  const std::string cubic = "rule = \"cubic_hermite\"\ntolerance = \"1 um\"\n";
  const Made even = make(parse_spec(cam_with(cubic), "a"));
  const Made fewest = make(parse_spec(cam_with(cubic + "knots = \"fewest\"\n"), "a"));
  EXPECT_EQ(even.sampled.binding, std::nullopt);
  EXPECT_EQ(fewest.sampled.binding, Binding::tolerance);
  EXPECT_LT(fewest.sampled.table.size(), even.sampled.table.size());
  EXPECT_LE(fewest.sampled.error.position, 1e-3);
}

TEST(TargetSpec, ReadsEveryKeyInTheWordsOfItsAxis) {
  const auto target = *parse_spec(cam_with("tolerance = 0.01\ngeo_velocity_tolerance = 1e-4\n"
                                           "most = 400\nspacing = 5\nmaster_resolution = 2\n"
                                           "position_resolution = \"1 um\"\n"
                                           "geo_velocity_resolution = 1e-6\n"),
                                  "a")
                           .table.target;
  EXPECT_EQ(target.velocity_tolerance, 1e-4);
  EXPECT_EQ(target.most, 400U);
  EXPECT_EQ(target.spacing, 5);
  EXPECT_EQ(target.x_step, 2);
  EXPECT_DOUBLE_EQ(target.p_step, 1e-3);
  EXPECT_EQ(target.v_step, 1e-6);
  EXPECT_THAT(complaint(cam_with("velocity_tolerance = 1\n")), HasSubstr("not a key"));
}

TEST(TargetSpec, MakesWhatAControllerHolds) {
  const Made follow = make(parse_spec(cam_with("controller = \"googol_follow\"\n"), "a"));
  const Columns& c = follow.sampled.table.columns();
  EXPECT_EQ(follow.sampled.table.rule(), Interpolation::cubic_hermite);
  EXPECT_LE(c.x.size(), 17U);
  for (const PtPoint& point : points_of(follow.sampled.table))
    EXPECT_EQ(point.type, PtType::normal);
  for (const double x : c.x) EXPECT_EQ(x, std::round(x));
  const Made pt = make(parse_spec(move_with("controller = \"googol_pt\"\ntolerance = 0.1\n"), "a"));
  for (const double x : pt.sampled.table.columns().x) EXPECT_EQ(x, std::round(x * 1000) / 1000);
  EXPECT_LE(pt.sampled.error.position, 0.1);
}

TEST(TargetSpec, TakesThePulseOfAControllerInTheUnitOfTheMaster) {
  std::string text = cam_with("controller = \"googol_follow\"\n");
  text.replace(text.find("\"pulse\""), 7, "\"deg\"");
  EXPECT_THAT(complaint(text),
              HasSubstr("counts in whole pulse, not in deg: "
                        "give the size of one count with master_resolution, such as \"0.01 deg\""));
  const Made made = make(parse_spec(text + "master_resolution = 0.5\n", "a"));
  EXPECT_LE(made.sampled.table.size(), 17U);
  for (const double x : made.sampled.table.columns().x) EXPECT_EQ(2 * x, std::round(2 * x));
}

TEST(TargetSpec, ReportsErrorsInTheDocument) {
  EXPECT_THAT(complaint(cam_with("controller = \"hmpl_pvt\"\n")),
              HasSubstr("is for tables over time"));
  EXPECT_THAT(complaint(cam_with("knots = \"even\"\nmost = 5\n")),
              HasSubstr("needs knots = \"fewest\""));
  EXPECT_THAT(complaint(cam_with("intervals = 9\nmost = 5\n")), HasSubstr("give one of the two"));
  EXPECT_THAT(
      complaint(cam_with("tolerance = 1e-6\nmost = 5\n")),
      HasSubstr("a.toml:16:8: table.most = 5: must be at least 29 for a quintic_hermite table"));
  EXPECT_THAT(complaint(cam_with("tolerance = 1e-3\nmaster_resolution = 3\n")),
              HasSubstr("table.master_resolution = 3 pulse: must divide the"));
}

TEST(ControllerTables, CountInTheirOwnUnits) {
  EXPECT_EQ(target_of(*controller_table("googol_pt"), {"s", "mm"}).x_step, 1e-3);
  EXPECT_EQ(controller_table("nobody"), nullptr);
  EXPECT_THROW(target_of(*controller_table("googol_follow"), {"deg", "mm"}), InputError);
  EXPECT_EQ(target_of(*controller_table("googol_follow"), {"deg", "mm"}, 0.01).x_step, 0.01);
}

}  // namespace
}  // namespace jounce::target_test
