// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/detail/law_names.hpp"

#include <cctype>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace jounce::law_names_test {
namespace {

std::string letters_of(const std::string& name) {
  std::string all;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      all += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return all;
}

TEST(LawNames, OfOtherToolsHaveTheirLaw) {
  const std::map<std::string, Law> expected{{"cycloidal", Law::inclined_sine},
                                            {"Bestehorn", Law::inclined_sine},
                                            {"Poly5", Law::quintic},
                                            {"POLY_5", Law::quintic},
                                            {"3-4-5", Law::poly345},
                                            {"poly 3-4-5", Law::poly345},
                                            {"4-5-6-7", Law::poly4567},
                                            {"Modified Sine", Law::modified_sine},
                                            {"mod. sine", Law::modified_sine},
                                            {"modsine", Law::modified_sine},
                                            {"mod-trap", Law::modified_trapezoid},
                                            {"MCV50", Law::modified_constant_velocity},
                                            {"simple harmonic", Law::simple_sine},
                                            {"linear", Law::line},
                                            {"Rast", Law::dwell},
                                            {"InclinedSine", Law::inclined_sine},
                                            {"trapezoidal velocity", Law::scca}};
  for (const auto& [name, law] : expected) {
    const LawAlias* alias = law_alias(name);
    ASSERT_NE(alias, nullptr) << name;
    EXPECT_EQ(alias->law, law) << name;
  }
}

TEST(LawNames, OfJounceAreNoAliases) {
  for (const LawInfo& law : all_laws()) EXPECT_EQ(law_alias(law.name), nullptr) << law.name;
  EXPECT_EQ(law_alias(""), nullptr);
  EXPECT_EQ(law_alias("--"), nullptr);
  EXPECT_EQ(law_alias("modified_sin"), nullptr) << "a slip: nearest() finds it";
}

TEST(LawNames, EachNameHasOneLaw) {
  std::map<std::string, Law> all;
  for (const LawInfo& law : all_laws()) all.emplace(letters_of(law.name), law.law);
  Law before = Law::line;
  for (const LawAlias& alias : law_aliases()) {
    const auto [other, is_new] = all.emplace(letters_of(alias.name), alias.law);
    EXPECT_TRUE(is_new) << alias.name;
    EXPECT_EQ(law_alias(alias.name), &alias) << alias.name;
    EXPECT_LE(before, alias.law) << alias.name << " is in the order of the laws";
    before = alias.law;
  }
}

TEST(LawNames, TheRuleNamesTheLawAndItsDifference) {
  EXPECT_EQ(rule_of(*law_alias("cycloidal")), "is called \"inclined_sine\" here");
  EXPECT_EQ(rule_of(*law_alias("Poly5")),
            "is called \"quintic\" here; between two rests it is the same as \"345\"");
}

}  // namespace
}  // namespace jounce::law_names_test
