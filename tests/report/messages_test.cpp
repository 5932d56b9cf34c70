// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/detail/messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace jounce::messages_test {
namespace {

const std::vector<Message> all{
    {"Faults", "7", "following_error", "The drive lags.", "Check the load."},
    {"Refusals", "7", "busy", "Another session owns it.", "Wait | stop it."},
    {"Errors of X", "31", "", "No cam.", "none: a table is checked", true}};

TEST(Messages, AreFoundByNumberAndName) {
  EXPECT_EQ(messages_named(all, "7").size(), 2U);
  ASSERT_EQ(messages_named(all, "busy").size(), 1U);
  EXPECT_THAT(test::rule_of([] { messages_named(all, "followin_error"); }),
              testing::HasSubstr("did you mean following_error?"));
  EXPECT_THAT(
      test::rule_of([] {
        messages_named({{"Findings", "", "limit/*", "Above.", "Less."}}, "limits/acceleration");
      }),
      testing::HasSubstr("did you mean limit/acceleration?"));
}

TEST(Messages, OfAFamilyNeedAKnownQuantity) {
  const std::vector<Message> rules{{"Findings", "", "limit/*", "Above.", "Less."},
                                   {"Findings", "", "constraint/*", "Violated.", "Relax it."}};
  const auto rule = [&](const std::string& code) {
    return test::rule_of([&] { messages_named(rules, code); });
  };
  for (const char* code : {"limit", "limit/*", "limit/velocity", "limit/geo_jerk_step",
                           "limit/peak load torque", "constraint/disc.base_radius"})
    EXPECT_EQ(messages_named(rules, code).size(), 1U) << code;
  EXPECT_THAT(rule("limit/velocityy"), testing::HasSubstr("did you mean limit/velocity?"));
  EXPECT_THAT(rule("limit/geo_jrk"), testing::HasSubstr("did you mean limit/geo_jerk?"));
  EXPECT_THAT(rule("limit/colour"), testing::HasSubstr("`jounce explain` lists them all"));
}

TEST(Messages, HaveNamesUnlessTheyAreNumbers) {
  EXPECT_THAT(message_names(all), testing::ElementsAre("following_error", "busy"));
}

TEST(Messages, AreTextListAndMarkdown) {
  EXPECT_EQ(messages_text({all[0]}),
            "7 following_error (Faults)\n  The drive lags.\n  What to do: Check the load.\n");
  EXPECT_THAT(messages_list(all), testing::StartsWith("Faults:\n       7 following_error"));
  const std::string page = messages_markdown(all);
  EXPECT_THAT(page, testing::HasSubstr("Wait \\| stop it."));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("Errors of X")));
}

}  // namespace
}  // namespace jounce::messages_test
