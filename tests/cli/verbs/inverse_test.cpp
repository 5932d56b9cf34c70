// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::inverse_verb_test {
namespace {

using cli_test::examples;
using nlohmann::json;
using ::testing::HasSubstr;

using InverseVerb = cli_test::Program;

TEST_F(InverseVerb, FindsTheMasterOfASlavePosition) {
  const std::string pusher = examples + "cam-algebra/last-year.toml";
  EXPECT_EQ(run("inverse " + pusher + " --slave 20mm").out,
            "60 deg (segment 1 push)\n240 deg (segment 3 return)\n");
  EXPECT_EQ(run("inverse " + pusher + " --slave 41").status, 1);
  EXPECT_EQ(json::parse(run("inverse --json " + pusher).out)["branches"].size(), 2U);
  EXPECT_EQ(run("inverse " + pusher + " --at 60 --from 1 --to 39 -o inverse.csv").status, 0);
  EXPECT_EQ(run("inverse inverse.csv --slave 60").out.substr(0, 3), "20 ");
  EXPECT_THAT(run("inverse " + pusher + " -o x.csv").err, HasSubstr("jounce: --at: is missing"));
  EXPECT_THAT(run("inverse " + pusher + " --at 60 -o x.csv").err, HasSubstr("--from: is missing"));
  EXPECT_THAT(run("inverse " + pusher + " --at 60").err, HasSubstr("--output"));
}

}  // namespace
}  // namespace jounce::inverse_verb_test
