// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/replay_text.hpp"

#include <gtest/gtest.h>

namespace jounce::replay_text_test {
namespace {

/// A record of one axis (index 1), built from stretches of ticks.
class Record {
 public:
  explicit Record(LastMotion& motion) : motion_(motion) {}

  void add(int ticks, double velocity, Cause fault = Cause::none) {
    for (int k = 0; k < ticks; ++k) {
      RecordedCycle cycle;
      cycle.axis = 1;
      cycle.tick.tick = tick_++;
      cycle.tick.velocity = velocity;
      cycle.tick.fault = fault;
      motion_.add(cycle);
      cycle.axis = 0;  // another axis, which moves all the time
      cycle.tick.velocity = 1;
      motion_.add(cycle);
    }
  }

 private:
  LastMotion& motion_;
  std::int64_t tick_ = 0;
};

constexpr std::int64_t before = LastMotion::before;
constexpr std::int64_t after = LastMotion::after;
constexpr std::int64_t most = LastMotion::most;

TEST(TheLastMotion, IsShownWithoutTheRestAroundIt) {
  LastMotion motion(1);
  Record record(motion);
  record.add(3000, 0);
  record.add(400, 5);  // ticks 3000 to 3399
  record.add(20000, 0);
  EXPECT_EQ(motion.kept().front().tick, 3000 - before);
  EXPECT_EQ(motion.kept().back().tick, 3399 + after);
}

TEST(TheLastMotion, MayBeTheEndOfTheRecord) {
  LastMotion motion(1);
  Record record(motion);
  record.add(10, 0);
  record.add(700, -5);
  EXPECT_EQ(motion.kept().front().tick, 0);
  EXPECT_EQ(motion.kept().back().tick, 709);
  record.add(50, 0);  // less than the rest that is shown
  EXPECT_EQ(motion.kept().back().tick, 759);
}

TEST(TheLastMotion, IsCutIfItIsLong) {
  LastMotion motion(1);
  Record record(motion);
  record.add(9000, 5);
  record.add(6000, 0);
  EXPECT_EQ(motion.kept().front().tick, 9000 - most);
  EXPECT_EQ(motion.kept().back().tick, 8999 + after);
}

TEST(TheLastMotion, IncludesAFaultAtRest) {
  LastMotion motion(1);
  Record record(motion);
  record.add(100, 5);
  record.add(8000, 0);
  record.add(9000, 0, Cause::following_error);  // tick 8100
  const auto ticks = motion.kept();
  EXPECT_EQ(ticks.front().tick, 8101 - most);
  EXPECT_EQ(ticks.back().tick, 8100 + after);
}

TEST(TheLastMotion, IsTheEndOfARecordWithoutOne) {
  LastMotion motion(1);
  Record record(motion);
  EXPECT_TRUE(motion.kept().empty());
  record.add(9000, 0);
  EXPECT_EQ(motion.kept().front().tick, 9000 - most);
  EXPECT_EQ(motion.kept().back().tick, 8999);
}

}  // namespace
}  // namespace jounce::replay_text_test
