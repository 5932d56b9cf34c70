// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/value_check.hpp"

#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace jounce::value_check_test {
namespace {

std::string broken(const ValueCheck& check, const std::string& text) {
  return check(text);
}

TEST(ValueCheck, AcceptsTheListedWordsAndNamesTheNearest) {
  const ValueCheck format = checks::one_of({"text", "json"});
  EXPECT_EQ(broken(format, "json"), "");
  EXPECT_EQ(broken(format, "jsn"), "must be one of text, json: did you mean json?");
  EXPECT_EQ(broken(format, "sarif"), "must be one of text, json");
  EXPECT_EQ(format.words, (std::vector<std::string>{"text", "json"}));
  const ValueCheck many = checks::one_of({"a1", "b2", "c3", "d4", "e5", "f6", "g7", "h8", "json"});
  EXPECT_EQ(broken(many, "jsn"), "is unknown: did you mean json?") << "nine words are too many";
}

TEST(ValueCheck, IncludesBothEndsOfARange) {
  const ValueCheck priority = checks::whole(1, 99);
  for (const char* const good : {"1", "99", "007"}) EXPECT_EQ(broken(priority, good), "") << good;
  for (const char* const bad : {"0", "100", "1.0", "0x10", "", " 1", "99999999999999999999"})
    EXPECT_EQ(broken(priority, bad), "must be a whole number from 1 to 99") << bad;
  EXPECT_EQ(broken(checks::whole(0, std::numeric_limits<std::int64_t>::max()), "-1"),
            "must be a whole number of at least 0");
  const ValueCheck rate = checks::within(1, 1e4);
  for (const char* const good : {"1", "1e4", "2.5"}) EXPECT_EQ(broken(rate, good), "") << good;
  for (const char* const bad : {"0.99", "10001", "nan", "1 s", ""})
    EXPECT_EQ(broken(rate, bad), "must be a number from 1 to 10000") << bad;
}

TEST(ValueCheck, ReadsSeconds) {
  EXPECT_EQ(broken(checks::seconds(), "0.001"), "");
  EXPECT_EQ(broken(checks::seconds(), "0"), "must be a number of seconds from 0.001 to 1e12");
  const ValueCheck watchdog = checks::seconds_or_none(0.01, 3600);
  for (const char* const good : {"0", "0.01", "3600"}) EXPECT_EQ(broken(watchdog, good), "");
  for (const char* const bad : {"0.001", "3601", "-1", "soon"})
    EXPECT_EQ(broken(watchdog, bad), "must be from 0.01 to 3600 seconds, or 0 for none") << bad;
}

TEST(ValueCheck, ReadsTheEndingAndTheFolderOfAFile) {
  const ValueCheck picture = checks::ends_in({".svg", ".png"});
  EXPECT_EQ(broken(picture, "a.svg"), "");
  EXPECT_EQ(broken(picture, "-"), "");
  EXPECT_EQ(broken(picture, "a.pdf"), "must end in .svg or .png");
  EXPECT_EQ(broken(checks::ends_in({".toml"}), "a.txt"), "must end in .toml");
  const ValueCheck table = checks::output_file({".csv"});
  const test::TemporaryFolder temporary;
  const std::string folder = temporary / "";
  EXPECT_EQ(broken(table, "-"), "");
  EXPECT_EQ(broken(table, folder + "a.csv"), "");
  EXPECT_EQ(broken(table, folder + "a.txt"), "must end in .csv");
  EXPECT_EQ(broken(table, folder), "is a folder: name a file in it");
  EXPECT_EQ(broken(table, "no such folder/a.csv"),
            "cannot be written, because the folder no such folder does not exist: make it first");
  std::ofstream(folder + "file") << "x";
  EXPECT_EQ(broken(table, folder + "file/a.csv"),
            "cannot be written, because " + folder + "file is a file: name a folder there");
}

TEST(ValueCheck, TakesAWholeTextForANumber) {
  EXPECT_EQ(number_in("2.5e1"), 25);
  EXPECT_EQ(number_in("2.5 mm"), std::nullopt);
  EXPECT_EQ(number_in(""), std::nullopt);
  EXPECT_EQ(number_in<std::uint16_t>("65535"), 65535);
  EXPECT_EQ(number_in<std::uint16_t>("65536"), std::nullopt);
  EXPECT_EQ(number_in<int>("-3"), -3);
}

}  // namespace
}  // namespace jounce::value_check_test
