// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/completion.hpp"

#include <gmock/gmock.h>

#include "about/sample.hpp"

namespace jounce::completion_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Line = std::vector<std::string>;

std::vector<std::string> words(const Line& line) {
  std::vector<std::string> found;
  for (const Candidate& each : complete(about_test::sample(), line).candidates)
    found.push_back(each.word);
  return found;
}

bool files(const Line& line) {
  return complete(about_test::sample(), line).files;
}

TEST(Completion, OffersVerbsAndTheOptionsOfTheProgramFirst) {
  EXPECT_THAT(words({""}), ElementsAre("check", "chart"));
  EXPECT_THAT(words({}), ElementsAre("check", "chart"));
  EXPECT_THAT(words({"che"}), ElementsAre("check"));
  EXPECT_THAT(words({"--v"}), ElementsAre("--version"));
  EXPECT_THAT(words({"x"}), IsEmpty());
  EXPECT_EQ(complete(about_test::sample(), {"che"}).candidates,
            (std::vector<Candidate>{{"check", "Check limits"}}));
}

TEST(Completion, OffersOptionsThatAreNotGivenYet) {
  EXPECT_THAT(words({"check", "-"}), ElementsAre("--format", "--limit", "--count", "--strict"));
  EXPECT_THAT(words({"check", "--strict", "-n", "3", "--limit", "a", "--"}),
              ElementsAre("--format", "--limit"));
  EXPECT_THAT(words({"check", "a.toml", "--fo"}), ElementsAre("--format"));
}

TEST(Completion, OffersTheValuesOfAnOptionAsEachShellWritesIt) {
  EXPECT_THAT(words({"check", "--format", ""}), ElementsAre("json", "text", "junit"));
  EXPECT_THAT(words({"check", "--format", "j"}), ElementsAre("json", "junit"));
  EXPECT_THAT(words({"check", "--format", "=", "j"}), ElementsAre("json", "junit"));
  EXPECT_THAT(words({"check", "--format", "="}), ElementsAre("json", "text", "junit"));
  EXPECT_THAT(words({"check", "--format=j"}), ElementsAre("--format=json", "--format=junit"));
  EXPECT_FALSE(files({"check", "--format", "j"}));
}

TEST(Completion, OffersFilesForTextsAndNothingForNumbers) {
  EXPECT_TRUE(files({"check", "--limit", ""}));
  EXPECT_TRUE(files({"check", "--limit=x"}));
  EXPECT_FALSE(files({"check", "--count", ""}));
  EXPECT_THAT(words({"check", "--count", ""}), IsEmpty());
  EXPECT_TRUE(files({"check", "a.toml", "b.toml", ""}));
  EXPECT_TRUE(files({"check", "--strict", ""}));
  EXPECT_TRUE(files({"check", "--count=3", ""}));
  EXPECT_TRUE(files({"check", "--", "-a"}));
}

TEST(Completion, OffersEachPositionalAtItsPlace) {
  EXPECT_THAT(words({"chart", "t"}), ElementsAre("text"));
  EXPECT_FALSE(files({"chart", ""}));
  EXPECT_TRUE(files({"chart", "text", ""}));
  EXPECT_FALSE(files({"chart", "text", "a", ""}));
  EXPECT_THAT(words({"nothing", ""}), IsEmpty());
  EXPECT_FALSE(files({"nothing", ""}));
}

TEST(Completion, LinesHaveAWordATabAndItsHelp) {
  EXPECT_EQ(completion_lines(complete(about_test::sample(), {"check", "--st"})),
            "--strict\tStrict\n");
  EXPECT_EQ(completion_lines(complete(about_test::sample(), {"check", ""})), ":files\n");
}

TEST(Completion, HasAScriptForEachShell) {
  EXPECT_THAT(completion_shells(), ElementsAre("bash", "fish", "zsh"));
  for (const std::string& shell : completion_shells())
    EXPECT_THAT(completion_script(shell), HasSubstr("__complete")) << shell;
  EXPECT_EQ(completion_script("tcsh"), "");
}

}  // namespace
}  // namespace jounce::completion_test
