// SPDX-License-Identifier: Apache-2.0
// A program that is longer than a window of its plans. Without a rest, it moves like one plan of all
// commands, which the test makes itself. The judge of the plotter checks every tick.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/path/arc.hpp"
#include "jounce/stream/sender/operate.hpp"

#include "executor/group/sent_plotter.hpp"
#include "stream/src/transport/memory_transport.hpp"

namespace jounce::group_windows_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

constexpr double dt = 1e-3;

/// Lines of about 2 mm, which turn by different angles.
std::vector<At> wave(int count) {
  std::vector<At> points;
  for (int k = 1; k <= count; ++k)
    points.push_back(
        {40 * std::sin(0.031 * k) + 0.7 * std::sin(1.7 * k), 40 * std::sin(0.023 * k)});
  return points;
}

struct GroupWindows : SentPlotter {
  explicit GroupWindows(const PlanWindow& window = {.commands = 120, .common = 60})
      : SentPlotter(window) {
    site.each_tick = [this] {
      site.judge();
      const Tick& now = site.last(group);
      if (now.job != 0) movements.insert(now.job);
      if (now.job != 0 && begin < 0) begin = now.tick;
      if (now.job != 0) places.push_back({site.last(x).position, site.last(y).position});
    };
  }
  /// The greatest distance of the axes from one plan of the whole program, in all ticks so far.
  double away_from_whole(const LimitedProgram& program) {
    const auto whole =
        planned_program(program.program, program.limits, *site.axes[Plotter::group].group);
    duration = whole->plan->duration();
    double away = 0;
    std::array<Motion, 2> motion;
    for (std::size_t k = 0; k < places.size(); ++k) {
      whole->plan->at(std::min(static_cast<double>(k) * dt, duration), motion);
      for (std::size_t i = 0; i < 2; ++i)
        away = std::max(away, std::abs(places[k][i] - motion[i].position));
    }
    return away;
  }
  /// Duration of one plan of the whole program, s.
  double duration_of_whole(const LimitedProgram& program) {
    return planned_program(program.program, program.limits, *site.axes[Plotter::group].group)
        ->plan->duration();
  }
  /// The group moves, or rests between two windows.
  [[nodiscard]] bool playing(const LimitedProgram& program) {
    const Point end = program.program.position();
    return site.last(group).job != 0 || std::hypot(place()[0] - end[0], place()[1] - end[1]) > 1e-9;
  }
  void play_to_the_end(const LimitedProgram& program) {
    for (int k = 0; k < 600 && playing(program); ++k) site.advance(100ms);
    ASSERT_FALSE(playing(program));
  }
  std::vector<At> places;
  std::set<std::uint64_t> movements;
  std::int64_t begin = -1;
  double duration = 0;
};

TEST_F(GroupWindows, TheMotionIsThatOfOnePlan) {
  const LimitedProgram program = lines(wave(500));
  ASSERT_TRUE(stream(program).ok());
  EXPECT_THAT(stream(lines({{1, 1}})).reason, HasSubstr("in_motion")) << "parts remain";
  for (int k = 0; k < 40 && site.last(group).finished == 0; ++k) site.advance(1s);
  ASSERT_EQ(site.last(group).finished, 1U) << "it rests nowhere";
  EXPECT_EQ(movements.size(), 8U) << "the windows of 120 commands, each 60 further";
  EXPECT_LT(away_from_whole(program), 1e-9);
  EXPECT_NEAR(static_cast<double>(places.size()) * dt, duration, 2 * dt);
  EXPECT_EQ(place(), wave(500).back());
  expect_same_replay();
}

TEST_F(GroupWindows, TheStatusCountsTheWholeProgram) {
  const LimitedProgram program = lines(wave(500));
  ASSERT_TRUE(stream(program).ok());
  site.advance(2s);
  const auto status = present_group(site.link, "plotter", 200ms, {}, site.clock);
  ASSERT_TRUE(status);
  away_from_whole(program);
  const auto whole =
      planned_program(program.program, program.limits, *site.axes[Plotter::group].group);
  EXPECT_NEAR(status->length, whole->plan->path().length(), 1e-6);
  EXPECT_NEAR(status->remaining_s, duration - static_cast<double>(places.size()) * dt, 0.3);
  EXPECT_TRUE(status->estimated);
  EXPECT_NEAR(static_cast<double>(status->commands) + status->line, 501, 1);
  EXPECT_EQ(site.dispatcher.server(group).status().queue_rows, 0U);
}

/// The wave as sequence of short lines, which averages make smooth.
LimitedProgram averaged(GroupWindows& test, const std::vector<At>& points) {
  LimitedProgram program = test.lines(points);
  Program smooth(2);
  smooth.set({.velocity = 100, .corner = Corner::average, .value = 0.1});
  for (std::size_t k = 0; k < points.size(); ++k)
    smooth.line({points[k][0], points[k][1]}, static_cast<int>(k) + 1);
  program.program = smooth;
  test.site.requested.tolerance = 0.1 + 1e-9;
  return program;
}

/// Lines and arcs in turns, with rounded corners: a staircase of quarters of circles, which goes up and
/// comes back.
LimitedProgram arcs(GroupWindows& test, int pairs, At from = {0, 0}) {
  Program program(2, {from[0], from[1]});
  program.set({.velocity = 100, .corner = Corner::deviation, .value = 0.05});
  Requested& requested = test.site.requested;
  for (int k = 0; k < pairs; ++k) {
    const double side = k < pairs / 2 ? 1 : -1;
    const double r = 1 + 0.3 * std::sin(1.3 * k);
    const At middle{from[0] + side * (0.8 + 0.2 * std::sin(0.9 * k)), from[1]};
    program.line({middle[0], middle[1]}, 2 * k + 1);
    requested.lines.push_back({from[0], from[1], middle[0], middle[1]});
    const At end{middle[0] + side * r, middle[1] + side * r};
    program.arc(arc_about({middle[0], middle[1]}, {middle[0], end[1]}, {end[0], end[1]},
                          Plane{0, 1}, ArcRotation::counterclockwise),
                2 * k + 2);
    requested.circles.push_back({middle[0], end[1], r});
    from = end;
  }
  requested.tolerance = 0.05 + 1e-9;
  return {program, {.axes = std::vector<Limits>(2, test::limits(200, 2000, 1e5))}, {"x", "y"}, {}};
}

/// Two plans of averages, or of rounded arcs, are not equal in their common commands. The group then rests
/// between two windows. The judge of the fixture checks
/// the path and the limits in every tick.
TEST_F(GroupWindows, AveragesKeepTheirPathAndLimits) {
  const LimitedProgram program = averaged(*this, wave(500));
  ASSERT_TRUE(stream(program).ok());
  play_to_the_end(program);
  EXPECT_EQ(place(), wave(500).back());
  EXPECT_LE(site.last(group).finished, 5U) << "120 commands each";
  EXPECT_LT(static_cast<double>(places.size()) * dt, duration_of_whole(program) * 1.01);
  expect_same_replay();
}

TEST_F(GroupWindows, ArcsKeepTheirPathAndLimits) {
  const LimitedProgram program = arcs(*this, 200);
  ASSERT_TRUE(stream(program).ok());
  play_to_the_end(program);
  EXPECT_LE(site.last(group).finished, 4U) << "120 commands each";
  EXPECT_LT(static_cast<double>(places.size()) * dt, duration_of_whole(program) * 1.01);
  expect_same_replay();
}

TEST_F(GroupWindows, HoldsAndOverridesOnAveragesAndArcsKeepTheLimits) {
  for (const bool averages : {true, false}) {
    const At from = place();
    const LimitedProgram program = averages ? averaged(*this, wave(300)) : arcs(*this, 150, from);
    ASSERT_TRUE(stream(program).ok());
    std::size_t seen = movements.size();
    for (int k = 0; k < 6000 && playing(program); ++k) {
      site.advance(10ms);
      if (movements.size() == seen) continue;
      seen = movements.size();  // a window has just begun
      accepts(command::Override{seen % 2 == 0 ? 0.4 : 1.0});
      accepts(command::Hold{});
      site.advance(300ms);
      accepts(command::Resume{});
    }
    const Point end = program.program.position();
    EXPECT_NEAR(place()[0], end[0], 1e-9) << averages;
    EXPECT_NEAR(place()[1], end[1], 1e-9) << averages;
    EXPECT_EQ(site.last(group).fault, Cause::none);
  }
}

TEST_F(GroupWindows, HoldsAndOverridesChangeNoWindow) {
  ASSERT_TRUE(stream(lines(wave(400))).ok());
  site.advance(1s);
  for (int k = 0; k < 40 && site.last(group).finished == 0; ++k) {
    accepts(command::Override{k % 3 == 0 ? 0.3 : k % 3 == 1 ? 2.0 : 1.0});
    site.advance(700ms);
    if (k % 4 != 2 || site.last(group).finished > 0) continue;
    accepts(command::Hold{});
    site.advance(400ms);
    accepts(command::Resume{});
  }
  ASSERT_EQ(site.last(group).finished, 1U);
  EXPECT_EQ(place(), wave(400).back());
  expect_same_replay();
}

TEST_F(GroupWindows, OutputsAndMWordsInTheCommonCommandsOccurOnce) {
  std::vector<ProgramWord> words;
  for (std::size_t command = 5; command < 400; command += 7) {
    words.push_back({.kind = ProgramWord::Kind::output,
                     .number = command % 2 == 0 ? -3 : 3,
                     .command = command});
    words.push_back(m_word(100 + static_cast<std::int32_t>(command), command));
  }
  MemoryTransport listener{site.network};
  listener.subscribe(wire::channel("plotter", wire::Lane::event), 4096);
  Rejects rejects;
  std::vector<std::int32_t> passed;
  decltype(wire::Event::count) counted{};
  int edges = 0;
  std::int64_t seen = -1;
  site.each_tick = [&] {
    site.judge();
    const Tick& now = site.last(group);
    if (now.tick != seen) edges += static_cast<int>(now.switches.count);
    seen = now.tick;
    while (const auto message = next_message(listener, 0ns, rejects)) {
      const auto* const event = std::get_if<wire::Event>(&message->body);
      if (event != nullptr && event->kind == wire::EventKind::m_word && event->count > counted) {
        counted = event->count;
        passed.push_back(static_cast<std::int32_t>(event->number));
      }
    }
  };
  ASSERT_TRUE(stream(lines(wave(400), words)).ok());
  for (int k = 0; k < 40 && site.last(group).finished == 0; ++k) site.advance(1s);
  site.advance(20ms);
  std::vector<std::int32_t> all;
  for (const ProgramWord& word : words)
    if (word.kind == ProgramWord::Kind::m_word) all.push_back(word.number);
  EXPECT_EQ(passed, all);
  EXPECT_EQ(edges, static_cast<int>(words.size() / 2));
  expect_same_replay();
}

TEST_F(GroupWindows, AnMWordThatWaitsDividesALongProgram) {
  ASSERT_TRUE(stream(lines(wave(500), {m_word(0, 200)})).ok());
  for (int k = 0; k < 40 && reason() != Cause::awaits_acknowledge; ++k) site.advance(1s);
  EXPECT_EQ(place(), wave(200).back());
  EXPECT_EQ(site.last(group).finished, 1U);
  accepts(command::GroupAcknowledge{});
  for (int k = 0; k < 40 && site.last(group).finished == 1; ++k) site.advance(1s);
  EXPECT_EQ(place(), wave(500).back());
  EXPECT_EQ(site.last(group).finished, 2U);
  expect_same_replay();
}

TEST_F(GroupWindows, SingleStepEndsInAndContinuesThroughAllWindows) {
  const std::vector<At> points = wave(400);
  ASSERT_TRUE(stream(lines(points)).ok());
  for (int k = 0; k < 40 && movements.size() < 3; ++k) site.advance(500ms);
  ASSERT_EQ(movements.size(), 3U);
  accepts(command::GroupSingleStep{.on = true});
  site.advance(2s);
  ASSERT_EQ(reason(), Cause::awaits_acknowledge);
  const auto here = std::find(points.begin(), points.end(), place());
  ASSERT_LT(points.end() - here, 400);
  accepts(command::GroupAcknowledge{});
  site.advance(500ms);
  EXPECT_EQ(place(), *(here + 1));
  accepts(command::GroupSingleStep{});
  accepts(command::GroupAcknowledge{});
  for (int k = 0; k < 40 && site.last(group).finished < 3; ++k) site.advance(1s);
  EXPECT_EQ(place(), points.back());
  EXPECT_EQ(site.last(group).finished, 3U) << "the rest is one motion";
  expect_same_replay();
}

TEST_F(GroupWindows, AfterAFaultOfAnAxisTheProgramContinuesToItsEnd) {
  ASSERT_TRUE(stream(lines(wave(400))).ok());
  site.advance(1s);
  site.each_tick = {};  // the faulty axis leaves the path
  accepts(command::Hold{});
  site.advance(500ms);
  ASSERT_TRUE(site.order("y", command::Disable{}).ok());
  site.advance(500ms);
  ASSERT_EQ(site.last(group).fault, Cause::axis_fault);
  if (site.last(y).fault != Cause::none) {
    ASSERT_TRUE(site.order("y", command::Reset{}).ok());
  }
  ASSERT_TRUE(site.order("y", command::Enable{}).ok());
  accepts(command::Reset{});
  accepts(command::Resume{});
  for (int k = 0; k < 40 && site.last(group).finished == 0; ++k) site.advance(1s);
  EXPECT_EQ(site.last(group).finished, 1U);
  EXPECT_EQ(place(), wave(400).back());
}

TEST_F(GroupWindows, AHaltDropsTheWindowsThatFollow) {
  ASSERT_TRUE(stream(lines(wave(400))).ok());
  site.advance(1s);
  accepts(command::Halt{});
  site.advance(3s);
  EXPECT_EQ(site.last(group).job, 0U);
  EXPECT_EQ(movements.size(), 1U);
  EXPECT_EQ(site.dispatcher.server(group).status().queue_rows, 0U);
}

TEST_F(GroupWindows, AnErrorInTheLastWindowMovesNothing) {
  LimitedProgram program = lines(wave(400));
  const auto [px, py] = wave(400).back();
  program.program.set({.velocity = 100});  // the acceleration steps where the arc begins
  program.program.line({px + 10, py}, 401);
  program.program.arc(arc_about({px + 10, py}, {px + 10, py + 5}, {px + 15, py + 5}, Plane{0, 1},
                                ArcRotation::counterclockwise),
                      402);
  EXPECT_THAT(stream(program).reason, HasSubstr("acceleration"));
  site.advance(1s);
  EXPECT_TRUE(movements.empty());
}

/// Two plans have too few commands in common: the group cannot reach its velocity from rest.
struct GroupNarrowWindows : GroupWindows {
  GroupNarrowWindows() : GroupWindows({.commands = 12, .common = 2}) {}
};

TEST_F(GroupNarrowWindows, ThatDifferTheGroupRestsAndContinues) {
  const std::vector<At> points = wave(100);
  ASSERT_TRUE(stream(lines(points)).ok());
  site.advance(20s);
  EXPECT_GT(site.last(group).finished, 1U);
  EXPECT_NEAR(place()[0], points.back()[0], 1e-12);
  EXPECT_NEAR(place()[1], points.back()[1], 1e-12);
  EXPECT_EQ(site.last(group).job, 0U);
  expect_same_replay();
}

}  // namespace
}  // namespace jounce::group_windows_test
