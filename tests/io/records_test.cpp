// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/detail/records.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::records_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

GcodeMachine machine() {
  return {.axes = {{"x", "pulse"}, {"y", "pulse"}, {"z", "pulse"}, {"u", "pulse"}},
          .path_axes = 3,
          .settings = {.corner = Corner::curvature, .value = 0.02}};
}

Program parsed(const std::string& text) {
  return record_program(parse_points(text, "records.csv"), machine(), {"pulse/s", "pulse/s^2"});
}

std::string complaint(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

const std::string header =
    "LineNum;DataType;X_EndPos;Y_EndPos;Z_EndPos;U_EndPos;Vel;Acc;Aux_Pos0;Aux_Pos1\n";

TEST(Records, AreLinesAndArcsWithTheirRates) {
  const Program p =
      parsed(header +
             "1;1;1000;0;0;10;500;2000;0;0\n"
             "2;2;2000;1000;50;20;400;1000;1707.10678118654752;292.893218813452475\n");
  ASSERT_EQ(p.commands().size(), 2u);
  EXPECT_EQ(p.commands()[0].line, 2);
  EXPECT_EQ(p.commands()[1].line, 3);
  EXPECT_THAT(p.position(), ElementsAre(2000, 1000, 50, 20, 0, 0, 0, 0, 0));
  EXPECT_EQ(p.settings()[0].velocity, 500);
  EXPECT_EQ(p.settings()[1].deceleration, 1000);
  EXPECT_EQ(p.settings()[1].corner, Corner::curvature);
  const Arc& arc = p.arcs()[0];  // a quarter about (1000, 1000)
  EXPECT_NEAR(arc.radius, 1000, 1e-9);
  EXPECT_NEAR(arc.center[0], 1000, 1e-9);
  EXPECT_NEAR(arc.center[1], 1000, 1e-9);
  EXPECT_NEAR(arc.sweep, std::acos(-1) / 2, 1e-12);
  EXPECT_EQ(arc.drift[2], 50);
  EXPECT_EQ(arc.drift[3], 10);
}

TEST(Records, ColumnsMayBeLeftOutAndHaveUnits) {
  const Program p = parsed("X_EndPos,Y_EndPos,Z_EndPos,U_EndPos,Vel [pulse/min]\n1,2,3,4,600\n");
  EXPECT_THAT(p.position(), ElementsAre(1, 2, 3, 4, 0, 0, 0, 0, 0));
  EXPECT_DOUBLE_EQ(p.settings()[0].velocity, 10);
}

TEST(Records, AnythingElseIsRejectedWithLineAndColumn) {
  const std::string row = "1;1;1000;0;0;10;500;2000;0;0\n";
  EXPECT_THAT(complaint("X_EndPos;Y_EndPos;Z_EndPos;U_EndPos;Speed\n1;2;3;4;5\n"),
              HasSubstr("records.csv:1: speed: is not a column of records; possible columns: "));
  EXPECT_THAT(complaint("X_EndPos;Y_EndPos;Z_EndPos\n1;2;3\n"),
              HasSubstr("records.csv:1: column \"u_endpos\": is missing"));
  EXPECT_THAT(complaint(header + row + "2;3;0;0;0;0;1;1;0;0\n"),
              HasSubstr("records.csv:3:3: datatype = 3: must be 1, a line, or 2, an arc"));
  EXPECT_THAT(complaint(header + row + "2;1;0;0;0;0;0;1;0;0\n"),
              HasSubstr("records.csv:3:13: vel = 0 pulse/s: must be greater than 0"));
  EXPECT_THAT(complaint(header + row + "2;1;0;0;0;0;1;-1;0;0\n"),
              HasSubstr("records.csv:3:15: acc = -1 pulse/s^2: must be greater than 0"));
  EXPECT_THAT(complaint(header + row + "2.5;1;0;0;0;0;1;1;0;0\n"),
              HasSubstr("records.csv:3:1: linenum = 2.5: must be a whole number"));
  EXPECT_THAT(complaint(header + row + "2;2;2000;0;0;0;1;1;1500;0\n"),
              HasSubstr("records.csv:3: aux_pos0"));
  EXPECT_THAT(complaint(header + row + "2;1;x;0;0;0;1;1;0;0\n"),
              HasSubstr("records.csv:3:5: x_endpos = x: must be a finite number"));
  EXPECT_THAT(complaint("DataType;X_EndPos;Y_EndPos;Z_EndPos;U_EndPos\n2;1;2;3;4\n"),
              HasSubstr("records.csv:2: aux_pos0 = 2: is missing"));
}

}  // namespace
}  // namespace jounce::records_test
