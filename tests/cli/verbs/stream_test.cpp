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

}  // namespace
}  // namespace jounce::stream_verb_test
