// SPDX-License-Identifier: Apache-2.0
#include "study/src/sweep/journal.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/base/file.hpp"

#include "support/errors.hpp"

namespace jounce::journal_test {
namespace {

using test::error_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class JournalFile : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove(path); }
  void TearDown() override { std::filesystem::remove(path); }

  std::vector<std::string> lines() const { return Journal(path, "id").lines(); }
  void write(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }

  const std::string path = ::testing::TempDir() + "journal_" +
                           ::testing::UnitTest::GetInstance()->current_test_info()->name() +
                           std::to_string(getpid());
};

TEST_F(JournalFile, KeepsItsLines) {
  {
    Journal journal(path, "id");
    EXPECT_THAT(journal.lines(), IsEmpty());
    journal.append("first");
    journal.append("");
  }
  Journal(path, "id").append("third, with a comma");
  EXPECT_THAT(lines(), ElementsAre("first", "", "third, with a comma"));
}

TEST_F(JournalFile, ContinuesAfterAnyTearAndLosesNoWholeLine) {
  {
    Journal journal(path, "id");
    journal.append("one");
    journal.append("two");
  }
  const std::string whole = read_file(path);
  const std::size_t one = whole.find(" one") + 5;
  const std::size_t two = whole.size();
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    write(whole.substr(0, size));
    std::vector<std::string> expected;
    if (size >= one) expected.emplace_back("one");
    if (size >= two) expected.emplace_back("two");
    EXPECT_EQ(lines(), expected) << size << " bytes";
    Journal(path, "id").append("three");
    expected.emplace_back("three");
    EXPECT_EQ(lines(), expected) << size << " bytes";
  }
}

TEST_F(JournalFile, LeavesOutADamagedLine) {
  {
    Journal journal(path, "id");
    for (const char* line : {"one", "two", "three"}) journal.append(line);
  }
  std::string text = read_file(path);
  text[text.find("two")] = 'T';
  write(text);
  EXPECT_THAT(lines(), ElementsAre("one", "three"));
}

TEST_F(JournalFile, IsOfOneThingOnly) {
  Journal(path, "another").append("one");
  EXPECT_THAT(
      error_of([&] { lines(); }),
      HasSubstr("belongs to another sweep, spec or version of Jounce: delete it to start again"));
  write("case,stroke\n1,2\n");
  EXPECT_THAT(error_of([&] { lines(); }), HasSubstr("is not the journal of a sweep"));
  EXPECT_EQ(read_file(path), "case,stroke\n1,2\n");  // and is left as it is
}

TEST_F(JournalFile, IsWrittenByOneAtATime) {
  const Journal journal(path, "id");
  EXPECT_THAT(error_of([&] { lines(); }), HasSubstr("is in use by another run"));
}

}  // namespace
}  // namespace jounce::journal_test
