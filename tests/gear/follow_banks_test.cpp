// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/detail/follow_banks.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/segment_fifos.hpp"

#include "gear/follow_tables.hpp"

namespace jounce::follow_banks_test {
namespace {

/// The motion of the banks, played as an axis plays them, against the cam of the spec.
void expect_plays(const FollowSpec& spec, double to) {
  const FollowBanks banks = follow_banks(spec, 1000);
  SegmentFifos fifos(1000);
  fifos.reset({.each = 1000, .total = 2000});
  fifos.set_loops(banks.loops);
  for (const SegmentRow& row : banks.first) ASSERT_EQ(fifos.push(0, row), RowRule::none);
  for (const SegmentRow& row : banks.second) ASSERT_EQ(fifos.push(1, row), RowRule::none);
  if (!banks.second.empty()) {
    ASSERT_TRUE(fifos.queue_switch());
  }
  ASSERT_TRUE(fifos.start(0, 0, 0));
  const Cam cam = follow(spec).cam;
  for (double x = 0; x <= to; x += to / 997) {
    const Jet now = fifos.at(x);
    ASSERT_NEAR(now[0], cam.jet(x)[0], 1e-9 * to) << x;
    if (x < to) {
      ASSERT_NEAR(now[1], cam.jet(x)[1], 1e-9) << x;
    }
  }
}

TEST(FollowBanks, PlayTheirSpec) {
  const FollowTable catch_up{{{5000, 2500}}};
  expect_plays({{catch_up, test::shear_cycle()}}, 15000);  // 7-6
  expect_plays({{test::example_7_7()}}, 200000);           // 7-7
  expect_plays({{test::example_7_8(100)}}, 50000);         // 7-8
  FollowTable thrice = test::shear_cycle();
  thrice.loops = 3;
  expect_plays({{catch_up, thrice, {{{1000, 500, PtType::stop}}}}}, 36000);
  expect_plays({{thrice}, 1}, 30000);  // comes in at ratio 1
  FollowTable once = thrice;
  once.loops = 1;
  expect_plays({{once}, 1}, 10000);
}

TEST(FollowBanks, AnEndlessTableGoesOn) {
  const FollowBanks banks = follow_banks({{{{{5000, 2500}}}, test::shear_cycle()}}, 10);
  EXPECT_EQ(banks.first.size(), 1U);
  EXPECT_EQ(banks.second.size(), 5U);
  EXPECT_EQ(banks.loops, 0);
  const FollowBanks alone = follow_banks({{test::shear_cycle()}, 1}, 10);
  EXPECT_EQ(alone.first.size(), 5U) << "the pass that takes over the start ratio";
  EXPECT_EQ(alone.first.front().v_start, 1);
  EXPECT_EQ(alone.second.size(), 5U);
  EXPECT_TRUE(std::isnan(alone.second.front().v_start)) << "the ratio of the pass before";
  EXPECT_EQ(alone.loops, 0);
}

TEST(FollowBanks, RejectMoreThanABankHolds) {
  FollowTable many = test::shear_cycle();
  many.loops = 3;
  EXPECT_NO_THROW(follow_banks({{many, {{{1000, 500, PtType::stop}}}}, 1}, 15));
  EXPECT_THROW(follow_banks({{many, {{{1000, 500, PtType::stop}}}}, 1}, 14), InputError);
}

}  // namespace
}  // namespace jounce::follow_banks_test
