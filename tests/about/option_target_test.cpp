// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/option_target.hpp"

#include <gtest/gtest.h>

namespace jounce::option_target_test {
namespace {

TEST(OptionTarget, SetsTheVariableOrReturnsTheBrokenRule) {
  double number = 0.5;
  const OptionTarget of_number(number);
  EXPECT_EQ(of_number.text(), "0.5");
  EXPECT_EQ(of_number.put({"2.5"}), "");
  EXPECT_EQ(number, 2.5);
  EXPECT_EQ(of_number.put({"fast"}), "must be a number");

  unsigned jobs = 0;
  EXPECT_EQ(OptionTarget(jobs).put({"-1"}), "must be a whole number from 0 to 4294967295");
  std::optional<std::uint16_t> port;
  EXPECT_EQ(OptionTarget(port).put({"8080"}), "");
  EXPECT_EQ(port, 8080);
  EXPECT_EQ(OptionTarget(port).put({"65536"}), "must be a whole number from 0 to 65535");
  std::optional<std::filesystem::path> log;
  EXPECT_EQ(OptionTarget(log).put({"run.csv"}), "");
  EXPECT_EQ(log, "run.csv");
}

TEST(OptionTarget, TakesAllWordsOfAListAndTheFirstOfAText) {
  std::string file;
  std::vector<std::string> files;
  const OptionTarget text(file), list(files);
  EXPECT_EQ(text.put({"a", "b"}) + list.put({"a", "b"}), "");
  EXPECT_EQ(file, "a");
  EXPECT_EQ(files, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(text.text(), "a");
  EXPECT_EQ(list.text(), "");
}

TEST(OptionTarget, DistinguishesTextsNumbersAndLists) {
  std::string text;
  std::vector<std::string> list;
  std::optional<double> number;
  std::optional<std::filesystem::path> path;
  EXPECT_TRUE(OptionTarget(list).is_list());
  EXPECT_FALSE(OptionTarget(text).is_list());
  EXPECT_TRUE(OptionTarget(number).is_number());
  for (const OptionTarget& target : {OptionTarget(text), OptionTarget(list), OptionTarget(path)})
    EXPECT_FALSE(target.is_number());
}

}  // namespace
}  // namespace jounce::option_target_test
