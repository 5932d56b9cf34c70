// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::new_verb_test {
namespace {

using cli_test::Result;

using NewVerb = cli_test::Program;

TEST_F(NewVerb, EverySpecPassesItsCheck) {
  for (const char* kind : {"cam", "follow", "gear", "indexer", "knife", "shear", "move", "queue",
                           "axes", "pvt", "pt"}) {
    const std::string file = std::string(kind) + ".toml";
    EXPECT_EQ(run(std::string("new ") + kind + " -o " + file).status, 0);
    const Result check = run("check " + file);
    EXPECT_EQ(check.status, 0) << check.out << check.err;
    EXPECT_EQ(run("validate " + file).status, 0) << kind;
  }
  EXPECT_EQ(run("new axis -o axis.toml").status, 0);
  EXPECT_EQ(run("new lathe").status, 2);
}

}  // namespace
}  // namespace jounce::new_verb_test
