// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/rules.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/limits/rule.hpp"

namespace jounce::rules_test {
namespace {

namespace fs = std::filesystem;

/// The rules that the sources name in quotes, "family/name", each with a file.
std::map<std::string, std::string> named_rules() {
  const std::regex quoted(
      R"re((?:rule = (?:std::string\()?|(?:finding|add|against|obstacle|check|peak_finding|at_most|at_least|equal|expect)\((?:report, spec, |std::string\()?|rule_of\()"([a-z]+/[a-z_]*)")re");
  std::map<std::string, std::string> found;
  for (const char* module : {"profiles", "cam", "gear", "pvt", "design", "validate", "optimize",
                             "study", "executor", "axis", "controllers"})
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(JOUNCE_SOURCE_DIR) / module)) {
      if (entry.path().extension() != ".cpp") continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      for (std::sregex_iterator i(text.begin(), text.end(), quoted), end; i != end; ++i)
        found.emplace((*i)[1], entry.path().filename());
    }
  return found;
}

TEST(Rules, EachRuleOfAFindingIsExplained) {
  const auto rules = named_rules();
  EXPECT_GT(rules.size(), 60U) << "the pattern above has to find them";
  for (const auto& [rule, file] : rules) {
    EXPECT_NE(rule_info(rule), nullptr) << rule << " of " << file;
    EXPECT_NE(Rule(rule).family(), RuleFamily::none) << rule << " of " << file;
  }
}

TEST(Rules, ARuleHasOneRowWithSentences) {
  std::set<std::string> seen;
  for (const RuleInfo& one : all_rules()) {
    SCOPED_TRACE(one.rule);
    EXPECT_TRUE(seen.insert(one.rule).second);
    EXPECT_THAT(one.meaning, ::testing::EndsWith("."));
    EXPECT_THAT(one.remedy, ::testing::EndsWith("."));
  }
}

TEST(Rules, ARuleWithoutARowHasThatOfItsFamily) {
  EXPECT_STREQ(rule_info("limit/position_max")->rule, "limit/position_max");
  EXPECT_STREQ(rule_info("limit/geo_jerk")->rule, "limit/*");
  EXPECT_EQ(rule_info("knife/unknown"), nullptr);
  EXPECT_EQ(rule_info("unknown"), nullptr);
}

}  // namespace
}  // namespace jounce::rules_test
