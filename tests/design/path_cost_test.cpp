// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/path_cost.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/detail/path_text.hpp"
#include "jounce/design/input.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::path_cost_test {
namespace {

using ::testing::HasSubstr;

const std::string two_axes = R"(jounce = 1
kind = "path"
units = { position = "mm", time = "s" }
[[axis]]
name = "x"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }
table = { tolerance = "1 um" }
[[axis]]
name = "y"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }
table = { tolerance = "1 um" }
)";

std::string path_of(const std::string& settings, const std::vector<std::string>& points) {
  std::string text = two_axes + "[path]\nvelocity = 100\n" + settings + "\n";
  for (const std::string& point : points)
    text += "[[command]]\ntype = \"line\"\nto = [" + point + "]\n";
  return text;
}

std::vector<Input> inputs(const std::string& text) {
  return inputs_of(parse_spec(text, "path.toml"), "path.toml");
}

PathSummary summary(const std::string& text) {
  const std::vector<Input> all = inputs(text);
  return summary_of(*all.front().spec, *all.front().plan);
}

const std::vector<std::string> square{"100, 0", "100, 100", "0, 100", "0, 0"};

double sum_of(const PathCost& cost) {
  double sum = cost.at_full_speed;
  for (const SpeedLoss& loss : cost.losses) sum += loss.loss;
  return sum;
}

TEST(PathCost, IsTheDurationAsASum) {
  for (const char* corner :
       {"\"stop\"", "{ deviation = 1 }", "{ deviation = 4 }", "{ velocity = 50 }"}) {
    const PathSummary s = summary(path_of(std::string("corner = ") + corner, square));
    EXPECT_NEAR(sum_of(s.cost), s.duration, 1e-9 * s.duration) << corner;
    EXPECT_NEAR(s.cost.at_full_speed, 4, 1e-9);
  }
}

TEST(PathCost, OfAStopIsARampDownAndUp) {
  // A ramp of 100 mm/s takes 0.2 s and 10 mm, which take 0.1 s at full speed.
  const PathSummary s = summary(path_of("corner = \"stop\"", square));
  EXPECT_NEAR(s.duration, 4.8, 1e-12);
  EXPECT_NEAR(s.stop_duration, 4.8, 1e-12);
  ASSERT_EQ(s.cost.losses.size(), 5U);
  EXPECT_NEAR(s.cost.of(LossCause::start), 0.1, 1e-12);
  EXPECT_NEAR(s.cost.of(LossCause::end), 0.1, 1e-12);
  EXPECT_NEAR(s.cost.of(LossCause::stop), 0.6, 1e-12);
  EXPECT_EQ(s.cost.losses[1].line, 18);  // the command behind the corner
}

TEST(PathCost, OfARoundedCornerIsLessThanOfAStop) {
  const PathSummary s = summary(path_of("corner = { deviation = 1 }", square));
  EXPECT_EQ(s.cost.of(LossCause::stop), 0);
  EXPECT_GT(s.cost.of(LossCause::corner), 0);
  EXPECT_LT(s.cost.of(LossCause::corner), 0.6);
  for (const CornerRecord& corner : s.corners) {
    EXPECT_LE(corner.deviation, 1 + 1e-12);
    EXPECT_NEAR(corner.angle, std::acos(0), 1e-9);
  }
}

TEST(PathCost, CountsADwellByItself) {
  std::string text = path_of("corner = \"stop\"", {"100, 0"});
  text += "[[command]]\ntype = \"dwell\"\ntime = 0.25\n[[command]]\ntype = \"line\"\nto = [0, 0]\n";
  const PathSummary s = summary(text);
  EXPECT_NEAR(s.cost.of(LossCause::dwell), 0.25, 1e-12);
  // It has the line of its own command, not of the line before or after it.
  const Spec spec = parse_spec(text, "dwell.toml");
  const auto commands = std::get<PathSpec>(spec.subject).program.commands();
  ASSERT_EQ(commands[1].kind, Program::Kind::dwell);
  for (const SpeedLoss& loss : s.cost.losses)
    EXPECT_TRUE(loss.cause != LossCause::dwell || loss.line == commands[1].line) << loss.line;
  EXPECT_NEAR(sum_of(s.cost), s.duration, 1e-9);
}

TEST(PathCost, NamesAnAxisThatIsSlow) {
  // y permits 200 mm/s, the feed 500: the line along y is the slower one of two in one direction.
  std::string text = two_axes + "[path]\nvelocity = 150\n";
  text +=
      "[[command]]\ntype = \"line\"\nto = [100, 0]\n[[command]]\ntype = \"line\"\nvelocity = "
      "40\nto = [150, 0]\n";
  text += "[[command]]\ntype = \"line\"\nvelocity = 150\nto = [250, 0]\n";
  const PathSummary s = summary(text);
  EXPECT_GT(s.cost.of(LossCause::limit), 0);
  EXPECT_NEAR(s.cost.at_full_speed, 200.0 / 150 + 50.0 / 40, 1e-9);
  EXPECT_NEAR(sum_of(s.cost), s.duration, 1e-9);
}

TEST(PathMotion, GivesEachAxisItsTableAndLabels) {
  const std::vector<Input> all = inputs(path_of("corner = { deviation = 1 }", square));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].axis, "y");
  EXPECT_TRUE(check_all(all[0]).ok());
  const auto& labels = all[0].labels.segments;
  EXPECT_EQ(labels.front(), "line 15");
  EXPECT_NE(std::find(labels.begin(), labels.end(), "corner 18"), labels.end());
  EXPECT_EQ(labels.size(), std::get<Trajectory>(*all[0].curve).segments().size());
}

TEST(PathMotion, PlacesErrorsOfThePlan) {
  try {
    (void)inputs(two_axes + "[path]\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("command: is missing"));
  }
  try {
    std::string text = path_of("", {"100, 0"});
    text.replace(text.find("limits = { velocity = 200"), 25,
                 "limits = { position_max = 50, velocity = 200");
    (void)inputs(text);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("path.toml:15: to[1] (x) = 100 mm"));
  }
}

TEST(PathEvents, HaveAPlaceAndATime) {
  Spec spec = parse_spec(two_axes + "[path]\n", "machine.toml");
  set_gcode(std::get<PathSpec>(spec.subject), "T1\nG1 X100 F6000\nM8\nG4 P0.5\nM9\nX200 H2\nM30\n",
            "part.ngc");
  const std::vector<Input> all = inputs_of(spec, "part.ngc");
  const PathSummary s = summary_of(spec, *all.front().plan);
  ASSERT_EQ(s.events.size(), 5U);
  EXPECT_EQ(s.events[0].time, 0);
  const double first = 1.2;  // 100 mm: two ramps of 0.2 s and 10 mm, 80 mm at 100 mm/s
  EXPECT_NEAR(s.events[1].time, first, 1e-9);
  EXPECT_NEAR(s.events[2].time, first + 0.5, 1e-9);
  EXPECT_NEAR(s.events[3].time, first + 0.5, 1e-9);
  EXPECT_NEAR(s.events[3].position[0], 100, 1e-9);
  EXPECT_NEAR(s.events[4].time, s.duration, 1e-9);
  // Lines in one direction are one piece of the path; an event between them keeps its place.
  Spec other = parse_spec(two_axes + "[path]\n", "machine.toml");
  set_gcode(std::get<PathSpec>(other.subject), "G1 X100 F6000\nM8\nX200\n", "part.ngc");
  const PathSummary straight = summary_of(other, *inputs_of(other, "part.ngc").front().plan);
  EXPECT_NEAR(straight.events[0].where, 100, 1e-9);
  EXPECT_NEAR(straight.events[0].position[0], 100, 1e-6);
  EXPECT_THAT(path_text(spec, s), HasSubstr("5 events"));
  EXPECT_THAT(path_json(spec, s), HasSubstr("\"word\":\"M8\""));
}

}  // namespace
}  // namespace jounce::path_cost_test
