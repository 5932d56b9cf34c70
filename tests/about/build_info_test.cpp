// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/build_info.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace jounce::build_info_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

const BuildInfo sample{.version = "1.2.3",
                       .commit = "0123456789ab",
                       .date = "2026-11-26",
                       .changed = true,
                       .compiler = "GNU 12.2.0",
                       .build_type = "Release",
                       .libraries = {{"Eigen", "3.4.0"}, {"NLopt", "2.7.1"}},
                       .options = {{"MPI", "ON"}}};

TEST(BuildInfo, AsTextBeginsWithTheVersion) {
  EXPECT_EQ(build_text(sample),
            "jounce 1.2.3\n"
            "commit:     0123456789ab, 2026-11-26, with changes\n"
            "compiler:   GNU 12.2.0\n"
            "build:      Release\n"
            "libraries:  Eigen 3.4.0, NLopt 2.7.1\n"
            "options:    MPI=ON\n");
}

TEST(BuildInfo, WithoutACommitNamesNone) {
  BuildInfo bare = sample;
  bare.commit.clear();
  EXPECT_THAT(build_text(bare), Not(HasSubstr("commit")));
  EXPECT_FALSE(nlohmann::json::parse(build_json(bare)).contains("commit"));
}

TEST(BuildInfo, AsJsonHasTheSameValues) {
  EXPECT_EQ(nlohmann::json::parse(build_json(sample)),
            nlohmann::json::parse(R"({"version": "1.2.3", "commit": "0123456789ab",
              "commit_date": "2026-11-26", "changed": true, "compiler": "GNU 12.2.0",
              "build_type": "Release", "libraries": {"Eigen": "3.4.0", "NLopt": "2.7.1"},
              "options": {"MPI": "ON"}})"));
}

TEST(BuildInfo, OfThisBuildHasTheVersionsOfTheLibraries) {
  const BuildInfo& build = build_info();
  EXPECT_FALSE(build.compiler.empty());
  EXPECT_THAT(build.commit, MatchesRegex("([0-9a-f]+)?"));
  std::vector<std::string> names;
  for (const auto& [name, version] : build.libraries) {
    names.push_back(name);
    EXPECT_THAT(version, MatchesRegex("[0-9]+\\.[0-9]+.*")) << name;
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"Eigen", "NLopt", "SUNDIALS", "LCM"}));
}

}  // namespace
}  // namespace jounce::build_info_test
