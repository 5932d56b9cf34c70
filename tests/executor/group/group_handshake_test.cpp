// SPDX-License-Identifier: Apache-2.0
// M words with a handshake, and single step: the group rests until an acknowledgment.
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "executor/group/sent_plotter.hpp"

namespace jounce::group_handshake_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

const command::PathDynamics buffered{.along = {.velocity = 100}, .buffer = PathBuffer::buffered};

struct GroupHandshake : SentPlotter {};

TEST_F(GroupHandshake, AnMWordRestsUntilItIsAcknowledged) {
  ASSERT_TRUE(site.line(20, 0, {.along = {.velocity = 10}}).ok());
  accepts(command::GroupMWord{.number = 6});
  ASSERT_TRUE(site.line(20, 10, buffered).ok());
  ASSERT_TRUE(site.line(0, 10, blending(100, 0.2)).ok());
  EXPECT_THAT(refused(command::GroupAcknowledge{}), HasSubstr("no_handshake"));
  ends(1);
  EXPECT_EQ(site.last(x).position, 20);
  EXPECT_EQ(reason(), Cause::awaits_acknowledge);
  site.advance(5s);
  EXPECT_EQ(site.last(y).position, 0) << "it waits";
  EXPECT_THAT(refused(command::Resume{}),
              HasSubstr("the group is not held: it waits for an acknowledgment of M6: send `jounce "
                        "order plotter acknowledge`"));
  EXPECT_THAT(refused(command::GroupAcknowledge{.m_word = 5}),
              HasSubstr("the group waits for an acknowledgment of M6, not of M5: leave out "
                        "--m-word, or give 6"));
  accepts(command::GroupAcknowledge{.m_word = 6});
  ends(2);
  EXPECT_EQ(site.last(x).position, 0);
  EXPECT_EQ(site.last(y).position, 10) << "both commands, as one motion";
  EXPECT_EQ(reason(), Cause::none);
  EXPECT_THAT(refused(command::GroupAcknowledge{.m_word = 6}), HasSubstr("no_handshake"));
  const Replay replay = site.replayed();
  EXPECT_TRUE(replay.same()) << replay.shorter;
}

TEST_F(GroupHandshake, AnMWordAtRestAndTwoInARow) {
  accepts(command::GroupMWord{.number = 3});
  accepts(command::GroupMWord{.number = 4});
  site.advance(20ms);
  EXPECT_EQ(reason(), Cause::awaits_acknowledge);
  accepts(command::GroupAcknowledge{.m_word = 3});
  site.advance(20ms);
  ASSERT_TRUE(site.line(10, 10, buffered).ok());
  site.advance(500ms);
  EXPECT_EQ(site.moving, 0);
  accepts(command::GroupAcknowledge{.m_word = 4});
  ends(1);
  EXPECT_EQ(site.last(x).position, 10);
}

TEST_F(GroupHandshake, ATimeoutDropsTheCommandsAfterIt) {
  ASSERT_TRUE(site.line(20, 0, {.along = {.velocity = 100}}).ok());
  accepts(command::GroupMWord{.number = 6, .timeout = 0.5});
  ASSERT_TRUE(site.line(20, 10, buffered).ok());
  ends(1);
  site.advance(300ms);
  EXPECT_EQ(reason(), Cause::awaits_acknowledge);
  site.advance(400ms);
  EXPECT_EQ(reason(), Cause::no_acknowledge);
  EXPECT_THAT(refused(command::GroupAcknowledge{}), HasSubstr("no_handshake"));
  site.advance(1s);
  EXPECT_EQ(site.last(y).position, 0);
  site.rest = {20, 0};
  site.rested = true;
  ASSERT_TRUE(site.line(0, 0, {.along = {.velocity = 100}}).ok());
  ends(2);
  EXPECT_EQ(reason(), Cause::none);
}

TEST_F(GroupHandshake, AnAbortingCommandAStopAndADisableEndTheWait) {
  for (int way = 0; way < 3; ++way) {
    accepts(command::GroupMWord{.number = 9});
    ASSERT_TRUE(site.line(30, 30, buffered).ok());
    site.advance(50ms);
    ASSERT_EQ(reason(), Cause::awaits_acknowledge) << way;
    site.rested = true;
    if (way == 0) {
      const auto finished = site.last(group).finished;
      ASSERT_TRUE(site.line(5, 0, {.along = {.velocity = 100}}).ok());
      ends(finished + 1);
      EXPECT_EQ(site.last(x).position, 5);
    } else if (way == 1) {
      Client client(site.link, "plotter", {}, site.clock);
      ASSERT_TRUE(client.stop().ok());
      static_cast<void>(client.release());
      site.advance(50ms);
    } else {
      accepts(command::Disable{});
      site.advance(50ms);
    }
    EXPECT_THAT(refused(command::GroupAcknowledge{}), HasSubstr("no_handshake")) << way;
    EXPECT_NE(site.last(y).position, 30);
  }
}

TEST_F(GroupHandshake, SingleStepBeginsOneCommandForEachAcknowledgment) {
  accepts(command::GroupSingleStep{.on = true});
  const std::vector<std::array<double, 2>> points{{10, 0}, {10, 10}, {0, 10}};
  for (const auto& [px, py] : points) ASSERT_TRUE(site.line(px, py, blending(100, 0.2)).ok());
  for (std::size_t k = 0; k < points.size(); ++k) {
    site.advance(300ms);
    ASSERT_EQ(site.last(group).finished, k) << "it waits";
    EXPECT_EQ(reason(), Cause::awaits_acknowledge);
    accepts(command::GroupAcknowledge{});
    ends(k + 1);
    EXPECT_EQ(site.last(x).position, points[k][0]);
    EXPECT_EQ(site.last(y).position, points[k][1]);
  }
  accepts(command::GroupSingleStep{});
  site.rest = {0, 10};
  site.rested = true;
  ASSERT_TRUE(site.line(0, 0, buffered).ok());
  ends(4);
}

TEST_F(GroupHandshake, IsChecked) {
  EXPECT_THAT(refused(command::GroupMWord{}), HasSubstr("M word 0 must be at least 1"));
  EXPECT_THROW(
      static_cast<void>(site.order("plotter", command::GroupMWord{.number = 5, .timeout = -1})),
      InputError);
  EXPECT_THAT(site.order("x", command::GroupMWord{.number = 5}).reason, HasSubstr("not_a_group"));
  EXPECT_THAT(site.order("x", command::GroupAcknowledge{}).reason, HasSubstr("not_a_group"));
  EXPECT_THAT(site.order("x", command::GroupSingleStep{}).reason, HasSubstr("not_a_group"));
}

}  // namespace
}  // namespace jounce::group_handshake_test
