// SPDX-License-Identifier: Apache-2.0
// Examples 22 and 23 of the HMPL manual (11.2, 11.3, 11.7), and mistakes in a file.
#include "jounce/io/user_table.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::user_table_test {
namespace {

using test::error_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A file with this text, as long as the object lives.
struct File {
  explicit File(const std::string& text)
      : path(testing::TempDir() + "/user_table_" + std::to_string(getpid()) + ".csv") {
    std::ofstream(path) << text;
  }
  ~File() { std::filesystem::remove(path); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  std::string path;
};

TEST(UserTable, GivesWhatWasSet) {
  UserTable table;
  table.set(1, {-2, 0, 2, 6, 4});
  EXPECT_THAT(table.get(3, 3, "mm"), ElementsAre(2, 6, 4));
  table.set(3, {9, 9, 9});
  EXPECT_THAT(table.get(1, 5, ""), ElementsAre(-2, 0, 9, 9, 9));
}

TEST(UserTable, IsTheSameAfterSavingAndLoading) {
  UserTable table("um");
  table.set(3, {2, 6, 4});
  table.set(UserTable::size - 1, {1e-3});
  const File file(table.text());
  table.set(3, {0, 0, 0});
  const UserTable loaded = read_user_table(file.path);
  EXPECT_THAT(loaded.get(3, 3, "um"), ElementsAre(2, 6, 4));
  EXPECT_THAT(loaded.get(3, 1, "mm"), ElementsAre(0.002));
  EXPECT_THAT(loaded.get(UserTable::size - 1, 1, "um"), ElementsAre(1e-3));
}

TEST(UserTable, RejectsIndicesThatTheControllerDoesNotHave) {
  UserTable table;
  EXPECT_THAT(error_of([&] { table.set(-1, {1}); }), HasSubstr("from 0 to 511999"));
  EXPECT_THAT(error_of([&] { table.set(511'999, {1, 2}); }), HasSubstr("from 0 to 511999"));
  table.set(5, {1});
  EXPECT_THAT(error_of([&] { (void)table.get(4, 2, ""); }), HasSubstr("the index 4 has no value"));
  for (const auto& [text, error] :
       {std::pair{"index,value\n0.5,1\n", "must be a whole number from 0 to 511999"},
        {"index,value\n-1,1\n", "must be a whole number from 0 to 511999"},
        {"index,value\n512000,1\n", "must be a whole number from 0 to 511999"},
        {"index,value\n7,1\n7,2\n", "occurs twice"},
        {"index,height\n7,1\n", "is not a column of this file"}}) {
    const File file(text);
    EXPECT_THAT(error_of([&] { (void)read_user_table(file.path); }), HasSubstr(error)) << text;
  }
}

}  // namespace
}  // namespace jounce::user_table_test
