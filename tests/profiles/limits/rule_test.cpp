// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/limits/rule.hpp"

#include <string>

#include <gtest/gtest.h>

namespace jounce::rule_test {
namespace {

TEST(Rule, IsAFamilyAndAName) {
  const Rule rule = "limit/position_max";
  EXPECT_EQ(rule.family(), RuleFamily::limit);
  EXPECT_EQ(rule.name(), "position_max");
  EXPECT_EQ(rule.text(), "limit/position_max");
  EXPECT_EQ(rule, Rule(RuleFamily::limit, "position_max"));
  EXPECT_NE(rule, "limit/position_min");
  EXPECT_NE(rule, "unlimited/position_max");
}

TEST(Rule, EveryFamilyIsReadFromItsWord) {
  for (int i = 1; i <= static_cast<int>(RuleFamily::constraint); ++i) {
    const auto family = static_cast<RuleFamily>(i);
    const Rule rule(family, "x");
    EXPECT_EQ(rule.text(), std::string(name(family)) + "/x");
    EXPECT_EQ(Rule(rule.text()).family(), family) << rule;
  }
}

TEST(Rule, NoRuleIsAnEmptyText) {
  EXPECT_EQ(Rule(), "");
  EXPECT_EQ(Rule().family(), RuleFamily::none);
  EXPECT_EQ(Rule().name(), "");
}

TEST(Rule, AnotherWordHasNoFamilyAndKeepsItsText) {
  for (const char* text : {"limits/velocity", "limit", "/velocity"}) {
    EXPECT_EQ(Rule(text).family(), RuleFamily::none) << text;
    EXPECT_EQ(Rule(text).text(), text);
  }
  EXPECT_EQ(Rule("limits/velocity").name(), "velocity");
}

}  // namespace
}  // namespace jounce::rule_test
