// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::explain_verb_test {
namespace {

using cli_test::Result;
using ::testing::HasSubstr;

using ExplainVerb = cli_test::Program;

TEST_F(ExplainVerb, NamesMeaningAndRemedy) {
  const Result name = run("explain following_error");
  EXPECT_EQ(name.status, 0);
  EXPECT_THAT(name.out,
              HasSubstr("6 following_error (Faults of an axis)\n  The following error exceeded "));
  EXPECT_THAT(name.out, HasSubstr("What to do: "));
  const Result number = run("explain 6");
  EXPECT_THAT(number.out, HasSubstr(name.out)) << "the same fault";
  EXPECT_THAT(number.out, HasSubstr("6 out_of_memory (Rejections of the stream)"));
  EXPECT_THAT(run("explain 0x1392").out, HasSubstr("Errors of HMPL for cams and gears"));
  const Result finding = run("explain limit/geo_jerk");  // a member of the family limit/*
  EXPECT_EQ(finding.status, 0);
  EXPECT_THAT(finding.out,
              HasSubstr("limit/* (Findings of a check)\n  The named quantity exceeds its limit."));
  EXPECT_EQ(run("explain limit/velocityy").status, 2);
  const Result wrong = run("explain folowing_error");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.err,
            "jounce: CODE = folowing_error: is not the number or name of a message: did you mean "
            "following_error?\n");
}

}  // namespace
}  // namespace jounce::explain_verb_test
