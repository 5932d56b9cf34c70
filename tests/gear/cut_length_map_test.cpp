// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/cut_length_map.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/gear/rotary_knife.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::cut_length_map_test {
namespace {

constexpr double pi = std::numbers::pi;

RotaryKnifeSpec case_y(double length) {
  return {.diameter = 3, .cut_length = length, .sync_angle = 10 * pi / 180, .dwell = true};
}

/// The knives of case Y, which have none up to the web in step.
std::optional<Cam> knife(double length) {
  if (!(length > figures(case_y(10)).sync_length)) return std::nullopt;
  return rotary_knife(case_y(length)).cam;
}

std::optional<Cam> horizontal(double length) {
  RotaryKnifeSpec spec = case_y(length);
  spec.matching = KnifeMatching::horizontal;
  spec.sync_angle = 40 * pi / 180;
  spec.law = Law::poly4567;
  if (!(length >
        figures({.diameter = 3, .cut_length = 10, .sync_angle = 40 * pi / 180}).sync_length))
    return std::nullopt;
  return rotary_knife(spec).cam;
}

const CutLimits limits{{.velocity = 40, .acceleration = 400, .jerk = 12000}, 30};

const nlohmann::json& oracle() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/knife.json"));
  return all.at("shortest");
}

/// True if the slave keeps the limits behind a line that runs at `speed`: the exact motion over
/// time.
bool keeps(const Cam& cam, double speed) {
  const Trajectory line_motion({line(cam.length() / speed, cam.start(), cam.end())});
  double size = 0;
  for (const Segment& each : cam.segments()) size = std::max(size, magnitude(each));
  return check(composed_within(cam, line_motion, 1e-13 * size).curve, limits.slave).ok();
}

TEST(CutLengthMap, AgreesWithBisectionOverTheMotion) {
  for (const CamOfLength& cams : {CamOfLength(knife), CamOfLength(horizontal)})
    for (const double length : {1.5, 3.0, 4.71, 8.0, 9.42, 12.0, 19.0, 25.0, 60.0}) {
      const CutSpeed fastest = fastest_cut(cams, length, limits);
      double slow = 1e-3;
      double fast = 1e3;
      for (int i = 0; i < 60; ++i) {
        const double speed = std::sqrt(slow * fast);
        (keeps(*cams(length), speed) ? slow : fast) = speed;
      }
      EXPECT_NEAR(fastest.speed, std::min(limits.line_speed, slow), 1e-9 * fastest.speed) << length;
    }
}

TEST(CutLengthMap, NamesTheLimitThatIsMet) {
  for (const double length : {0.5, 1.0, 2.0, 4.0, 9.0, 9.6, 15.0, 40.0}) {
    const CutSpeed fastest = fastest_cut(knife, length, limits);
    const Cam cam = *knife(length);
    const Jet f = cam.jet(fastest.where);
    const Jet left = cam.jet(fastest.where, Side::left);
    const double v = fastest.speed;
    if (fastest.limit == "velocity") {
      EXPECT_NEAR(std::abs(f[1]) * v, 40, 1e-9);
    } else if (fastest.limit == "acceleration") {
      EXPECT_NEAR(std::abs(f[2]) * v * v, 400, 1e-8);
    } else if (fastest.limit == "jerk") {
      EXPECT_NEAR(std::max(std::abs(f[3]), std::abs(left[3])) * v * v * v, 12000, 1e-6);
    } else {
      EXPECT_EQ(fastest.limit, "line");
      EXPECT_EQ(fastest.speed, 30);
    }
  }
}

TEST(CutLengthMap, FindsTheShortestCutOfEachLimit) {
  const double speed = oracle()["speed"];
  const double far = figures(case_y(10)).synchronous;
  const auto least = [&](const Limits& slave) {
    return shortest_length(knife, {slave}, speed, 0.27, far).value();
  };
  const auto expect = [](double value, const nlohmann::json& of) {
    EXPECT_NEAR(value, of[1].get<double>(), 1e-11);
  };
  expect(least({.velocity = oracle()["velocity"][0]}), oracle()["velocity"]);
  expect(least({.acceleration = oracle()["acceleration"][0]}), oracle()["acceleration"]);
  expect(least({.jerk = oracle()["jerk"][0]}), oracle()["jerk"]);
}

TEST(CutLengthMap, ShortestCutIsTheEdgeOfTheMap) {
  const auto shortest = shortest_length(knife, limits, 20, 0.1, 3 * pi);
  ASSERT_TRUE(shortest);
  EXPECT_GE(fastest_cut(knife, *shortest, limits).speed, 20);
  EXPECT_LT(fastest_cut(knife, *shortest * (1 - 1e-12), limits).speed, 20);
  EXPECT_FALSE(shortest_length(knife, limits, 31, 0.1, 3 * pi));  // the line's own speed is 30
}

TEST(CutLengthMap, FindsWhereTheLimitChanges) {
  std::vector<double> lengths;
  for (int i = 1; i <= 120; ++i) lengths.push_back(0.2 * i);
  const auto map = cut_length_map(knife, lengths, limits);
  ASSERT_EQ(map.size(), lengths.size());
  EXPECT_EQ(map.front().limit, "length");
  EXPECT_EQ(map.front().speed, 0);
  const auto changes = limit_changes(knife, map, limits);
  ASSERT_GE(changes.size(), 2U);
  EXPECT_EQ(changes.front().before, "length");
  EXPECT_NEAR(changes.front().length, figures(case_y(10)).sync_length, 1e-12);
  for (const LimitChange& change : changes) {
    EXPECT_EQ(fastest_cut(knife, change.length * (1 - 1e-11), limits).limit, change.before);
    EXPECT_EQ(fastest_cut(knife, change.length * (1 + 1e-11), limits).limit, change.after);
  }
}

TEST(CutLengthMap, IsSlowestAtTwiceTheSynchronousRecovery) {
  // Between the gear and the stop the acceleration (h - b / R) Ca / b^2 is greatest at b = 2 R h.
  const RotaryKnifeFigures f = figures(case_y(10));
  const double slowest = f.sync_length + 2 * 1.5 * f.recovery_angle;
  const CutLimits acceleration{{.acceleration = 50}};
  const auto at = [&](double length) { return fastest_cut(knife, length, acceleration).speed; };
  EXPECT_GT(at(slowest * 0.99), at(slowest));
  EXPECT_GT(at(slowest * 1.01), at(slowest));
  EXPECT_NEAR(at(f.longest * 2), at(f.longest), 1e-9);  // beyond, it only stands longer
  EXPECT_EQ(fastest_cut(knife, f.synchronous, acceleration).limit, "");  // the gear has no limit
}

TEST(CutLengthMap, RejectsALengthOrASpeedThatIsNone) {
  EXPECT_THROW(fastest_cut(knife, 0, limits), InputError);
  EXPECT_THROW(fastest_cut(knife, 4, {{}, 0}), InputError);
  EXPECT_THROW(shortest_length(knife, limits, -1, 1, 2), InputError);
}

}  // namespace
}  // namespace jounce::cut_length_map_test
