// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::stream_verb_test {
namespace {

using cli_test::cam;
using cli_test::Result;
using ::testing::HasSubstr;

using StreamVerb = cli_test::Program;

TEST_F(StreamVerb, WithoutAnExecutorReportsWhatItNeeds) {
  // memq:// reaches only this process.
  const Result result = run("stream " + cam + " --to feeder --url memq:// --patience 8");
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.err, HasSubstr("no answer from"));
  EXPECT_EQ(run("stream " + cam + " --to feeder --url ''").status, 2);
  EXPECT_EQ(run("run " + cam + " --url memq:// --seconds 0.1").status, 2) << "a cam is no axis";
}

// The tables of the axes, as from a spec that names the program.
TEST_F(StreamVerb, TakesTheMachineOfAGCodeProgramForSeveralAxes) {
  const std::string part = cli_test::examples + "gcode-part/";
  const std::string to = " --to x,y,z --url memq:// --patience 2";
  const Result program =
      run("stream " + part + "plate.ngc --machine " + part + "machine.toml" + to);
  EXPECT_EQ(program.status, 3) << program.err;
  EXPECT_EQ(program.err, run("stream " + part + "plate.toml" + to).err);
  const Result rolling = run("stream " + part + "plate.ngc --machine " + part +
                             "machine.toml --axis x --rolling --to x --url memq:// --patience 2");
  EXPECT_EQ(rolling.status, 3) << rolling.err;
}

}  // namespace
}  // namespace jounce::stream_verb_test
