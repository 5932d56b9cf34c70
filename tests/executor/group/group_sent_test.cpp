// SPDX-License-Identifier: Apache-2.0
// A program that is sent as a whole: it waits at its M words, and in single step at the end of each
// command. The judge of the plotter checks every tick.
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "executor/group/sent_plotter.hpp"

namespace jounce::group_sent_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

struct GroupSent : SentPlotter {};

TEST_F(GroupSent, AnMWordThatWaitsStopsAtItsPlaceUntilItIsAcknowledged) {
  const auto outcome = stream(
      lines({{20, 0}, {20, 10}, {0, 10}, {0, 0}}, {m_word(8, 1), m_word(0, 2), m_word(30, 4)}));
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_THAT(refused(command::GroupAcknowledge{}), HasSubstr("no_handshake"));
  ends(1);
  EXPECT_EQ(place(), (At{20, 10})) << "M8 does not wait, M0 does";
  EXPECT_EQ(reason(), Cause::awaits_acknowledge);
  EXPECT_EQ(site.dispatcher.server(group).status().queue_rows, 2U) << "M0, and what follows it";
  EXPECT_THAT(refused(command::GroupAcknowledge{.m_word = 8}),
              HasSubstr("waits for an acknowledgment of M0, not of M8"));
  EXPECT_THAT(stream(lines({{30, 10}})).reason, HasSubstr("awaits_acknowledge"));
  EXPECT_THAT(refused(command::StartTable{}), HasSubstr("awaits_acknowledge"));
  site.advance(1s);
  EXPECT_EQ(place(), (At{20, 10}));
  accepts(command::GroupAcknowledge{});
  ends(2);
  EXPECT_EQ(place(), (At{0, 0}));
  EXPECT_EQ(reason(), Cause::none);
  expect_same_replay();
}

TEST_F(GroupSent, AWordAtTheStartTwoInARowADwellBetweenThemAndOneAtTheEnd) {
  LimitedProgram program =
      lines({{20, 0}}, {m_word(0, 0), m_word(0, 0), m_word(0, 2), m_word(0, 3)});
  program.program.dwell(0.5, 2);
  program.program.dwell(0.3, 3);
  ASSERT_TRUE(stream(program).ok());
  ends(1);
  for (int k = 0; k < 2; ++k) {
    ASSERT_EQ(reason(), Cause::awaits_acknowledge) << k;
    EXPECT_EQ(place(), (At{0, 0}));
    accepts(command::GroupAcknowledge{});
    site.advance(20ms);
  }
  ends(2);
  EXPECT_EQ(place(), (At{20, 0}));
  ASSERT_EQ(reason(), Cause::awaits_acknowledge);
  accepts(command::GroupAcknowledge{});
  site.advance(150ms);
  EXPECT_EQ(site.last(group).finished, 2U) << "the dwell of 0.3 s lasts";
  ends(3);
  ASSERT_EQ(reason(), Cause::awaits_acknowledge);
  accepts(command::GroupAcknowledge{});
  site.advance(50ms);
  EXPECT_EQ(reason(), Cause::none);
  expect_same_replay();
}

TEST_F(GroupSent, CommandsThatFollowBeginAfterTheWholeProgram) {
  ASSERT_TRUE(stream(lines({{20, 0}, {20, 10}}, {m_word(0, 1)})).ok());
  site.rested = false;
  site.end = {20, 10};
  ASSERT_TRUE(site.line(0, 10, {.along = {.velocity = 100}, .buffer = PathBuffer::buffered}).ok());
  ends(1);
  EXPECT_EQ(place(), (At{20, 0}));
  accepts(command::GroupAcknowledge{});
  ends(3);
  EXPECT_EQ(place(), (At{0, 10}));
}

TEST_F(GroupSent, AStopAnAbortingCommandADisableAndTheEndOfTheSessionDropTheRest) {
  for (int way = 0; way < 4; ++way) {
    const auto [px, py] = place();
    const std::uint64_t before = site.last(group).finished;
    ASSERT_TRUE(stream(lines({{px + 5, py}, {px + 5, py + 7}}, {m_word(0, 1)})).ok());
    ends(before + 1);
    ASSERT_EQ(reason(), Cause::awaits_acknowledge) << way;
    site.rested = true;
    site.rest = place();
    if (way == 0) {
      Client client(site.link, "plotter", {}, site.clock);
      ASSERT_TRUE(client.stop().ok());
      static_cast<void>(client.release());
    } else if (way == 1) {
      ASSERT_TRUE(site.line(px + 6, py, {.along = {.velocity = 100}}).ok());
      ends(before + 2);
    } else if (way == 2) {
      accepts(command::Disable{});
      accepts(command::Enable{});
    } else {
      accepts(command::Halt{});
    }
    site.advance(50ms);
    EXPECT_THAT(refused(command::GroupAcknowledge{}), HasSubstr("no_handshake")) << way;
    EXPECT_EQ(place()[1], py) << way;
  }
}

TEST_F(GroupSent, SingleStepBeforeTheStartStopsAtTheEndOfEachCommand) {
  const std::vector<At> points{{20, 0}, {20, 10}, {0, 10}, {0, 0}, {5, 0}, {5, 5}};
  accepts(command::GroupSingleStep{.on = true});
  ASSERT_TRUE(stream(lines(points, {m_word(0, 2)})).ok());
  for (std::size_t k = 0; k < 4; ++k) {
    ends(k + 1);
    EXPECT_EQ(place(), points[k]);
    ASSERT_EQ(reason(), Cause::awaits_acknowledge) << k;
    site.advance(300ms);
    EXPECT_EQ(place(), points[k]) << "it waits";
    if (k == 3) accepts(command::GroupSingleStep{});
    accepts(command::GroupAcknowledge{});
  }
  ends(5);
  EXPECT_EQ(place(), points.back()) << "the other commands as one motion";
  expect_same_replay();
}

TEST_F(GroupSent, SingleStepDuringTheMotionStopsAtTheEndOfACommand) {
  std::vector<At> points;
  for (int k = 0; k < 40; ++k)
    points.push_back({5.0 * (k / 2 + 1), k % 4 == 1 || k % 4 == 2 ? 5.0 : 0.0});
  ASSERT_TRUE(stream(lines(points)).ok());
  site.advance(700ms);
  ASSERT_GT(site.last(group).velocity, 0);
  const double before = site.last(group).position;
  accepts(command::GroupSingleStep{.on = true});
  ends(1);
  const At first = place();
  const auto here = std::find(points.begin(), points.end(), first);
  ASSERT_NE(here, points.end()) << first[0] << ' ' << first[1];
  ASSERT_LT(here - points.begin(), 38) << "before the end";
  EXPECT_LT(site.last(group).position - before, 40) << "soon";
  EXPECT_EQ(reason(), Cause::awaits_acknowledge);
  accepts(command::GroupAcknowledge{});
  ends(2);
  EXPECT_EQ(place(), *(here + 1)) << "one command";
  accepts(command::GroupSingleStep{});
  accepts(command::GroupAcknowledge{});
  ends(3);
  EXPECT_EQ(place(), points.back());
  expect_same_replay();
}

TEST_F(GroupSent, SingleStepInTheLastCommandWaitsNowhere) {
  ASSERT_TRUE(stream(lines({{20, 0}})).ok());
  site.advance(100ms);
  accepts(command::GroupSingleStep{.on = true});
  ends(1);
  EXPECT_EQ(place(), (At{20, 0}));
  EXPECT_EQ(reason(), Cause::none);
}

TEST_F(GroupSent, TheProgramOfTheSpecAlsoStopsInSingleStep) {
  accepts(command::GroupSingleStep{.on = true});
  site.requested.tolerance = std::numeric_limits<double>::infinity();  // group_play_test judges it
  accepts(command::StartTable{});
  ends(1);
  EXPECT_EQ(reason(), Cause::awaits_acknowledge);
  EXPECT_EQ(site.dispatcher.server(group).status().queue_rows, 2U);
}

}  // namespace
}  // namespace jounce::group_sent_test
