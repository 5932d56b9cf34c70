// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/fill.hpp"

#include "support/errors.hpp"

namespace jounce::knots_test {
namespace {

std::string spec(const std::string& rest) {
  return "jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\", time = \"s\" }\n" + rest;
}

constexpr const char* three_knots =
    "knot = [{ time = 0, position = 0 }, { time = 1, position = 3, velocity = 1 }, { time = 3, "
    "position = 4 }]\n";

std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)parse_spec(text, "t.toml"); });
}

TEST(KnotsSpec, FillsInWhatKnotsLeaveOutAndKeepsWhatTheyGive) {
  const Spec made = parse_spec(spec(std::string("velocities = \"clamped\"\n") + three_knots), "t");
  FillSpec same{.x = {0, 1, 3}, .p = {0, 3, 4}, .v = {{}, 1, {}}, .filling = Filling::clamped};
  EXPECT_EQ(std::get<Table>(made.subject).columns().v, filled(same).table.columns().v);
  EXPECT_EQ(std::get<Table>(made.subject).columns().v[1], 1);
}

TEST(KnotsSpec, FillsInNothingSilently) {
  EXPECT_THAT(complaint(spec(three_knots)),
              ::testing::HasSubstr("knot[1].velocity: is missing: add velocity to each knot, or "
                                   "a rule at the top, such as velocities = \"clamped\""));
}

TEST(KnotsSpec, NamesTheSegmentThatCannotKeepTheLimits) {
  const Spec made =
      parse_spec(spec("velocities = \"within_limits\"\nlimits = { velocity = 30 }\n"
                      "knot = [{ time = 0, position = 0 }, { time = 1, position = 60 }]\n"),
                 "t");
  ASSERT_EQ(made.fill.broken(), 1U);
  EXPECT_NEAR(made.fill.findings[0].limit, 3, 1e-8);
}

TEST(KnotsSpec, RejectsAMethodThatTheRuleCannotKeep) {
  const std::string text = complaint(spec(std::string("velocities = \"monotone\"\n") + three_knots +
                                          "[table]\nrule = \"quintic_hermite\"\n"));
  EXPECT_THAT(text, ::testing::HasSubstr("table.rule = quintic_hermite: monotone velocities need"));
  EXPECT_THAT(complaint(spec(std::string("velocities = \"smooth\"\n") + three_knots)),
              ::testing::HasSubstr("velocities"));
}

TEST(KnotsSpec, ShortestTimesOfTwoKnotsUnderAJerkLimit) {
  // Jerk +J, -J, +J over T / 4, T / 2, T / 4 goes J T^3 / 32.
  for (const char* rule : {"cubic_hermite", "quintic_hermite"}) {
    const Spec made = parse_spec(
        spec(
            std::string("times = \"shortest\"\nlimits = { jerk = 32 }\nknot = [{ position = 0 }, { "
                        "position = 8 }]\ntable = { rule = \"") +
            rule + "\" }\n"),
        "t");
    const Table& table = std::get<Table>(made.subject);
    EXPECT_EQ(table.size(), 4U) << "two virtual knots";
    EXPECT_NEAR(table.length(), 2, 1e-8);
    EXPECT_NEAR(table.columns().p.back(), 8, 1e-12);
    EXPECT_NEAR(table.columns().v.back(), 0, 1e-12);
  }
}

TEST(KnotsSpec, ShortestTimesTakeNoTimesAndNeedALimit) {
  EXPECT_THAT(
      complaint(spec("times = \"shortest\"\noutside = \"hold\"\n"
                     "knot = [{ time = 0, position = 0, velocity = 0 }, { position = 1 }]\n")),
      ::testing::HasSubstr(
          "t.toml:6:18: knot[1].time = 0: times = \"shortest\" computes the times and "
          "velocities of all knots: give each knot a position only, or remove the "
          "line times = \"shortest\""));
  EXPECT_THAT(
      complaint(spec("times = \"shortest\"\nvelocities = \"clamped\"\nlimits = { jerk = 1 }\n"
                     "knot = [{ position = 0 }, { position = 1 }]\n")),
      ::testing::HasSubstr("velocities = \"clamped\": times = \"shortest\" computes"));
  EXPECT_THAT(
      complaint(spec("times = \"shortest\"\nknot = [{ position = 0 }, { position = 1 }]\n")),
      ::testing::HasSubstr(
          "limits.jerk: is missing: the shortest times of splines need a jerk limit"));
}

TEST(KnotsSpec, AxesThroughPointsShareTheBestTimes) {
  const std::string axis = "\nacceleration = 10\njerk = 32\n";
  const Spec both = parse_spec(
      "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\", time = \"s\" }\n"
      "times = \"shortest\"\npoint = [{ position = [0, 0] }, { position = [8, 1] }]\n"
      "[[axis]]\nname = \"x\"\njerk = 32\n[[axis]]\nname = \"y\"" +
          axis,
      "t");
  const std::vector<Made> made = make_axes(both);
  ASSERT_EQ(made.size(), 2U);
  for (const Made& each : made) {
    const Trajectory& f = std::get<Trajectory>(*each.curve);
    EXPECT_NEAR(f.length(), 2, 1e-8);
    EXPECT_EQ(f.segments().size(), 3U);
  }
}

}  // namespace
}  // namespace jounce::knots_test
