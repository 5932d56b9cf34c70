// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::order_verb_test {
namespace {

using cli_test::Result;
using ::testing::HasSubstr;
using ::testing::Not;

using OrderVerb = cli_test::Program;

TEST_F(OrderVerb, RejectsSecondsThatItWouldIgnore) {
  const std::string far = " --url memq://";
  const Result jog = run("order feeder jog 100 --seconds 1" + far);
  EXPECT_EQ(jog.status, 2);
  EXPECT_EQ(jog.err,
            "jounce: --seconds = 1: applies to jog --hold-to-run only: add --hold-to-run\n");
  EXPECT_EQ(run("order feeder move --to 5 --seconds 1" + far).err,
            "jounce: --seconds = 1: applies to jog --hold-to-run only\n");
  EXPECT_THAT(run("order feeder jog 100 --hold-to-run --seconds 1" + far).err,
              Not(HasSubstr("--seconds")));
}

TEST_F(OrderVerb, NamesSwappedWords) {
  EXPECT_EQ(run("order enable feeder").err,
            "jounce: WHAT = feeder: is not a command: did you mean jounce order feeder enable?\n");
}

}  // namespace
}  // namespace jounce::order_verb_test
