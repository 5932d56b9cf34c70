// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/switches/cam_switch.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/fig_6_14.hpp"

namespace jounce::cam_switch_test {
namespace {

Trajectory path(std::vector<Segment> segments) {
  return Trajectory(std::move(segments));
}

/// "+1@0.5 -1@1.25": every edge, times rounded to a nanosecond.
std::string text(const SwitchTimes& times) {
  std::ostringstream out;
  for (const auto& [time, track, on] : times.edges)
    out << (out.str().empty() ? "" : " ") << (on ? '+' : '-') << track << '@'
        << number(std::round(time * 1e9) / 1e9);
  return out.str();
}

std::string edges(const CamSwitchSpec& spec, const Trajectory& motion) {
  return text(switch_times(spec, motion));
}

CamSwitch range(double first, double last, AxisDirection direction = AxisDirection::both) {
  return {.first_on_position = first, .last_on_position = last, .axis_direction = direction};
}

CamSwitch pulse(double first, double duration, AxisDirection direction = AxisDirection::both) {
  return {.first_on_position = first,
          .axis_direction = direction,
          .mode = CamSwitchMode::time,
          .duration = duration};
}

const Trajectory there_and_back = path({line(10, 0, 100), line(10, 100, 0)});

TEST(CamSwitch, IsOnWithinItsRangeBothWays) {
  EXPECT_EQ(edges({.switches = {range(20, 30)}}, there_and_back), "+1@2 -1@3 +1@17 -1@18");
}

TEST(CamSwitch, SwitchesAtTheExactInstantUnderAcceleration) {
  // x = 50 t^2: at 20 after sqrt(0.4) s, at 30 after sqrt(0.6) s.
  Segment f;
  f.degree = 2;
  f.c[2] = 50;
  const auto times = switch_times({.switches = {range(20, 30)}}, path({f}));
  ASSERT_EQ(times.edges.size(), 2U);
  EXPECT_NEAR(times.edges[0].time, std::sqrt(0.4), 1e-12);
  EXPECT_NEAR(times.edges[1].time, std::sqrt(0.6), 1e-12);
}

TEST(CamSwitch, TheExampleOfPLCopenOnAnAxisOf5000) {
  // The four switches that the description of MC_DigitalCamSwitch shows (CODESYS SM3_Basic prints
  // them too), one turn at 1000 u/s forwards, and one back.
  CamSwitchSpec spec{.switches = {range(2000, 3000, AxisDirection::positive),
                                  range(2500, 3000, AxisDirection::negative), range(4000, 1000),
                                  pulse(3000, 1.35)},
                     .period = 5000};
  spec.switches[3].track = 2;
  const Trajectory one_turn = path({line(5, 0, 5000)});
  const auto up = switch_times(spec, one_turn);
  EXPECT_EQ(up.outputs, 1U);
  EXPECT_EQ(text(up), "-1@1 +1@2 +2@3 -1@3 +1@4 -2@4.35");
  EXPECT_EQ(edges(spec, reversed(one_turn)), "-1@1 +1@2 +2@2 -1@2.5 -2@3.35 +1@4");

  // Its second figure: track 1 with -125 ms and +250 ms.
  spec.tracks = {{.track = 1, .on_compensation = -0.125, .off_compensation = 0.25}};
  EXPECT_EQ(edges(spec, one_turn), "-1@1.25 +1@1.875 +2@3 -1@3.25 +1@3.875 -2@4.35");
  EXPECT_EQ(edges(spec, reversed(one_turn)), "-1@1.25 +1@1.875 +2@2 -1@2.75 -2@3.35 +1@3.875");
}

TEST(CamSwitch, AnAxisAtRestOnABoundaryIsInTheRange) {
  const auto stops_at = [](double x) { return path({quintic(1, 0, 0, 0, x, 0, 0)}); };
  for (const double scale : {1e-6, 0.1, 1.0, 1e5}) {
    const CamSwitchSpec spec{.switches = {range(0.3 * scale, 0.7 * scale)}};
    EXPECT_EQ(switch_times(spec, stops_at(0.3 * scale)).edges.size(), 1U) << scale;
    EXPECT_EQ(switch_times(spec, stops_at(0.7 * scale)).edges.size(), 1U) << scale;
    EXPECT_EQ(switch_times(spec, stops_at(0.701 * scale)).edges.size(), 2U) << scale;
    EXPECT_EQ(switch_times(spec, stops_at(0.299 * scale)).edges.size(), 0U) << scale;
  }
}

TEST(CamSwitch, OneDirectionSwitchesWhereTheAxisTurnsRound) {
  // 0 to 25 and back in 5 s, turning at 2.5 s inside the range.
  const Trajectory turn = path({line(2.5, 0, 25), line(2.5, 25, 0)});
  EXPECT_EQ(edges({.switches = {range(20, 30)}}, turn), "+1@2 -1@3");
  EXPECT_EQ(edges({.switches = {range(20, 30, AxisDirection::positive)}}, turn), "+1@2 -1@2.5");
  EXPECT_EQ(edges({.switches = {range(20, 30, AxisDirection::negative)}}, turn), "+1@2.5 -1@3");
  // Under hysteresis the axis has reversed once it is 1 back: at 2.6 s.
  EXPECT_EQ(
      edges({.switches = {range(20, 30, AxisDirection::positive)}, .tracks = {{.hysteresis = 1}}},
            turn),
      "+1@2 -1@2.6");
}

TEST(CamSwitch, TheInitialValueHoldsUntilTheDirectionIsKnown) {
  const Trajectory waits = path({line(1, 25, 25), line(1, 25, 35)});
  CamSwitchSpec spec{.switches = {range(20, 30, AxisDirection::positive)}};
  EXPECT_EQ(switch_times(spec, waits).outputs, 0U);
  EXPECT_EQ(edges(spec, waits), "+1@1 -1@1.5");
  spec.tracks = {{.initial = true}};
  EXPECT_EQ(switch_times(spec, waits).outputs, 1U);
  EXPECT_EQ(edges(spec, waits), "-1@1.5");
  spec.switches[0].axis_direction = AxisDirection::negative;
  EXPECT_EQ(edges(spec, waits), "-1@1");
}

TEST(CamSwitch, InversionAndTheEnableMask) {
  EXPECT_EQ(edges({.switches = {range(20, 30)}, .tracks = {{.inverted = true}}}, there_and_back),
            "-1@2 +1@3 -1@17 +1@18");
  const CamSwitchSpec off{.switches = {range(20, 30)},
                          .tracks = {{.inverted = true, .enabled = false}}};
  EXPECT_EQ(switch_times(off, there_and_back).outputs, 0U);
  EXPECT_EQ(edges(off, there_and_back), "");
}

TEST(CamSwitch, RangesOfATrackAreJoinedWithoutAGlitch) {
  EXPECT_EQ(edges({.switches = {range(20, 30), range(30, 40), range(35, 50)}}, there_and_back),
            "+1@2 -1@5 +1@15 -1@18");
}

TEST(CamSwitch, CompensationIsExactAtConstantVelocity) {
  const auto with = [](double on, double off) {
    return CamSwitchSpec{.switches = {range(20, 30)},
                         .tracks = {{.on_compensation = on, .off_compensation = off}}};
  };
  EXPECT_EQ(edges(with(-0.25, 0.5), there_and_back), "+1@1.75 -1@3.5 +1@16.75 -1@18.5");
  EXPECT_EQ(edges(with(0.25, -0.5), there_and_back), "+1@2.25 -1@2.5 +1@17.25 -1@17.5");
  // Off overtakes on: there is nothing to switch, and nothing gets stuck.
  EXPECT_EQ(edges(with(0.25, -1), there_and_back), "");
}

TEST(CamSwitch, CompensationUsesThePresentVelocity) {
  // x = a t^2 / 2: x - c v = p where t = c + sqrt(c^2 + 2 p / a). The true crossing plus c differs
  // from that by about c^2 a / (2 v).
  const double a = 400;
  Segment f;
  f.degree = 2;
  f.c[2] = a / 2;
  for (const double c : {-0.01, 0.01, 0.05}) {
    const auto times =
        switch_times({.switches = {range(50, 90)}, .tracks = {{.on_compensation = c}}}, path({f}));
    ASSERT_EQ(times.edges.size(), 2U);
    const double expected = c + std::sqrt(c * c + 2 * 50 / a);
    EXPECT_NEAR(times.edges[0].time, expected, 1e-12);
    const double crossing = std::sqrt(2 * 50 / a);
    const double miss = c * c * a / (2 * a * crossing);
    EXPECT_NEAR(times.edges[0].time - (crossing + c), miss, 0.02 * miss);
  }
}

TEST(CamSwitch, ALeadTakesItBackWhereTheAxisStopsShort) {
  // Braking from 100 at 100 u/s^2 the axis stops at 50; the range begins at 60. With 0.5 s of lead
  // y = x + v / 2 = 50 + 50 t - 50 t^2 has its maximum 62.5 at 0.5 s.
  Segment f;
  f.degree = 2;
  f.c = {0, 100, -50};
  const CamSwitchSpec spec{.switches = {range(60, 90)},
                           .tracks = {{.on_compensation = -0.5, .off_compensation = -0.5}}};
  const auto times = switch_times(spec, path({f}));
  ASSERT_EQ(times.edges.size(), 2U);
  EXPECT_NEAR(times.edges[0].time, 0.5 - std::sqrt(0.05), 1e-9);
  EXPECT_NEAR(times.edges[1].time, 0.5 + std::sqrt(0.05), 1e-9);
}

TEST(CamSwitch, AVelocityStepPassesTheBoundariesItLeadsOver) {
  // From rest at 0 at once to 100 u/s: with 0.3 s of lead the axis counts as at 30.
  const Trajectory start = path({line(1, 0, 0), line(1, 0, 100)});
  EXPECT_EQ(edges({.switches = {range(20, 50)}, .tracks = {{.on_compensation = -0.3}}}, start),
            "+1@1 -1@1.5");
  // Both edges at one instant are no pulse.
  EXPECT_EQ(edges({.switches = {range(20, 29)},
                   .tracks = {{.on_compensation = -0.3, .off_compensation = -0.3}}},
                  start),
            "");
}

TEST(CamSwitch, HysteresisMakesGoodWhereTheAxisLeaves) {
  // Over 20 to 20.4, back to 19.8, on to 40: one edge. With less hysteresis, three.
  const Trajectory trembling = path({line(1, 10, 20.4), line(1, 20.4, 19.8), line(1, 19.8, 40)});
  const auto with = [](double h) {
    return CamSwitchSpec{.switches = {range(20, 30)}, .tracks = {{.hysteresis = h}}};
  };
  EXPECT_EQ(switch_times(with(0.5), trembling).edges.size(), 2U);
  EXPECT_NEAR(switch_times(with(0.5), trembling).edges[0].time, 10 / 10.4, 1e-9);
  EXPECT_EQ(switch_times(with(0), trembling).edges.size(), 4U);
  // At 0.3 the axis leaves above and comes back past 20: off. Then 19.8 is too near to count as
  // below, and the second ascent counts where the axis leaves, at 20.3.
  const auto times = switch_times(with(0.3), trembling);
  ASSERT_EQ(times.edges.size(), 4U);
  EXPECT_NEAR(times.edges[1].time, 1 + 0.4 / 0.6, 1e-9);
  EXPECT_NEAR(times.edges[2].time, 2 + 0.5 / 20.2, 1e-9);
}

TEST(CamSwitch, DurationsRunOnAndStartAgain) {
  EXPECT_EQ(edges({.switches = {pulse(90, 1)}}, there_and_back), "+1@9 -1@10 +1@11 -1@12");
  EXPECT_EQ(edges({.switches = {pulse(90, 2.5)}}, there_and_back), "+1@9 -1@13.5");
  EXPECT_EQ(edges({.switches = {pulse(90, 1, AxisDirection::negative)}}, there_and_back),
            "+1@11 -1@12");
  EXPECT_EQ(edges({.switches = {pulse(90, 1, AxisDirection::positive)},
                   .tracks = {{.on_compensation = -0.5, .off_compensation = 0.25}}},
                  there_and_back),
            "+1@8.5 -1@10.25");
}

TEST(CamSwitch, AFullTurnIsAlwaysOn) {
  const CamSwitchSpec spec{.switches = {range(0, 360)}, .period = 360};
  const Trajectory turns = path({line(10, -1000, 1000)});
  EXPECT_EQ(switch_times(spec, turns).outputs, 1U);
  EXPECT_EQ(edges(spec, turns), "");
}

TEST(CamSwitch, RotaryRangesRepeatBothWaysFromAnywhere) {
  const CamSwitchSpec spec{.switches = {range(350, 10)}, .period = 360};
  EXPECT_EQ(edges(spec, path({line(4, 180, 980)})), "+1@0.85 -1@0.95 +1@2.65 -1@2.75");
  EXPECT_EQ(edges(spec, path({line(4, -180, -980)})), "+1@0.85 -1@0.95 +1@2.65 -1@2.75");
  const CamSwitchSpec elsewhere{.switches = {range(350 - 3600, 370 - 3600)}, .period = 360};
  EXPECT_EQ(edges(elsewhere, path({line(4, 180, 980)})), "+1@0.85 -1@0.95 +1@2.65 -1@2.75");
}

TEST(CamSwitch, StandsOnASlaveThatFollowsACam) {
  // PMC600 manual 6.2: from master 75 to 200 the slave of figure 6.14 runs at slope 1, from 100.
  const Cam cam = design(test::fig_6_14()).cam;
  const Trajectory slave = composed(cam, path({line(1.8, 0, 360)}));
  const auto times = switch_times({.switches = {range(120, 150)}}, slave);
  ASSERT_GE(times.edges.size(), 2U);
  EXPECT_NEAR(times.edges[0].time, (75 + 20) / 200.0, 1e-9);
  EXPECT_NEAR(times.edges[1].time, (75 + 50) / 200.0, 1e-9);
}

void expect_refused(const CamSwitchSpec& spec, const std::string& key, const std::string& rule) {
  try {
    require_valid(spec);
    ADD_FAILURE() << key << " was not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), key);
    EXPECT_NE(error.rule().find(rule), std::string::npos) << error.what();
  }
}

TEST(CamSwitch, RejectsInputThatCannotBeMeant) {
  using List = std::vector<CamSwitch>;
  const auto with = [](const List& switches, SwitchTrack track = {}) {
    return CamSwitchSpec{.switches = switches, .tracks = {track}, .period = 360};
  };
  CamSwitch s = range(20, 30);
  expect_refused({.switches = {range(30, 20)}}, "switch[1].last_on_position", "rotary axis");
  expect_refused({.switches = {s, range(30, 30)}}, "switch[2].last_on_position", "above");
  expect_refused(with({range(0, 361)}), "switch[1].last_on_position", "one period");
  expect_refused(with({range(30, 30)}), "switch[1].last_on_position", "one period");
  expect_refused(with({range(0, -361)}), "switch[1].last_on_position", "one period");
  expect_refused(with({range(0, 5)}, {.hysteresis = 5}), "switch[1].last_on_position", "wider");
  expect_refused(with({range(0, 355)}, {.hysteresis = 5}), "switch[1].last_on_position", "rest");
  expect_refused(with({pulse(0, 1)}, {.hysteresis = 180}), "switch[1].track", "half");
  expect_refused(with({s}, {.hysteresis = -1}), "track[1].hysteresis", "");
  expect_refused(with({s}, {.on_compensation = NAN}), "track[1].on_compensation", "finite");
  expect_refused(with({s}, {.track = 2}), "track[1].track", "no switch");
  expect_refused(with({s}, {.track = 33}), "track[1].track", "1 to 32");
  expect_refused({.switches = {s}, .tracks = {{}, {}}}, "track[2].track", "two sets of options");
  expect_refused({.switches = {s}, .period = 0}, "period", "greater than 0");
  s.track = 0;
  expect_refused({.switches = {s}}, "switch[1].track", "1 to 32");
  s = range(20, INFINITY);
  expect_refused({.switches = {s}}, "switch[1].last_on_position", "finite");
  s = range(20, 30);
  s.duration = 1;
  expect_refused({.switches = {s}}, "switch[1].duration",
                 "contradicts last_on_position: leave one of them out");
  s.mode = CamSwitchMode::time;
  expect_refused({.switches = {s}}, "switch[1].last_on_position", "contradicts duration");
  s.mode = CamSwitchMode::position;
  s.last_on_position.reset();
  expect_refused({.switches = {s}}, "switch[1].duration", "mode = \"time\"");
  s.duration.reset();
  s.last_on_position.reset();
  expect_refused({.switches = {s}}, "switch[1].last_on_position", "missing");
  s.mode = CamSwitchMode::time;
  expect_refused({.switches = {s}}, "switch[1].duration", "missing");
  expect_refused({.switches = {pulse(1, 0)}}, "switch[1].duration", "greater than 0");
  expect_refused({.switches = {pulse(1, 1)}, .tracks = {{.on_compensation = 1}}},
                 "switch[1].duration", "must be longer");
}

}  // namespace
}  // namespace jounce::cam_switch_test
