// SPDX-License-Identifier: Apache-2.0
#include "executor/src/cycle/notices.hpp"

#include <gtest/gtest.h>

#include "jounce/command/refusal_text.hpp"

namespace jounce::notices_test {
namespace {

using Notices = std::vector<std::string>;

TEST(Notices, ReportWhatChangedInATick) {
  const Tick before{.tick = 9, .job = 1, .finished = 4, .stopped = 2};
  EXPECT_EQ(notices_of(before, before, "mm"), Notices{});
  EXPECT_EQ(notices_of(before, {.tick = 10, .job = 2, .finished = 5, .stopped = 2}, "mm"),
            (Notices{"started at tick 10", "finished at tick 10"}));
  EXPECT_EQ(notices_of(before, {.tick = 10, .finished = 4, .stopped = 3}, "mm"),
            Notices{"stopped at tick 10"});
}

TEST(Notices, ReportAFaultOnceWithItsMeaning) {
  const Tick before{.tick = 9};
  const Tick now{.tick = 10, .fault = Cause::drive_fault};
  const Notices notices = notices_of(before, now, "mm");
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0], std::string("fault at tick 10: ") + name(Cause::drive_fault) + ": " +
                            meaning(Cause::drive_fault));
  EXPECT_EQ(notices_of(now, now, "mm"), Notices{});
  EXPECT_EQ(notices_of(now, before, "mm"), Notices{}) << "a reset";
}

TEST(Notices, ReportAStartThatDidNotBegin) {
  const Refusal why{.cause = Cause::group_stopped};
  EXPECT_EQ(notices_of({}, {.tick = 10, .dropped = why}, "mm"),
            Notices{"the armed motion did not start at tick 10: " + text(why, "mm")});
}

}  // namespace
}  // namespace jounce::notices_test
