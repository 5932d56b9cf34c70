// SPDX-License-Identifier: Apache-2.0
// A program as a CAM system writes it, made by tests/oracle/cam_program.py: 30000 short lines of a surface.
#include <algorithm>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/io/gcode.hpp"

#include "support/temporary_folder.hpp"
#include "tests/path/paths.hpp"

namespace jounce::cam_program_test {
namespace {

constexpr double deviation = 0.02;  // mm, G64 P of the program

GcodeProgram program(Corner corner) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "part.ngc";
  const std::string make =
      "/usr/bin/python3 " JOUNCE_SOURCE_DIR "/tests/oracle/cam_program.py " + file;
  EXPECT_EQ(std::system(make.c_str()), 0);
  GcodeMachine machine{.axes = {{"x", "mm"}, {"y", "mm"}, {"z", "mm"}},
                       .path_axes = 3,
                       .start = {0, 0, 30},
                       .settings = {.corner = corner, .value = deviation},
                       .rapid = 250};
  machine.frames[0] = turned_frame({200, 100, 0}, 30);  // the part lies askew
  return parse_gcode(read_file(file), file, machine);
}

const GroupLimits limits{.axes = {{.velocity = 300, .acceleration = 3000, .jerk = 6e4},
                                  {.velocity = 300, .acceleration = 3000, .jerk = 6e4},
                                  {.velocity = 200, .acceleration = 2000, .jerk = 4e4}}};

TEST(CamProgram, ThirtyThousandShortLinesRunNearTheirFeed) {
  const GcodeProgram made = program(Corner::average);
  EXPECT_GT(made.program.commands().size(), 29000u);
  EXPECT_GE(made.events.size(), 6u);
  const Plan motion = plan(made.program, limits);
  EXPECT_LT(motion.duration(), 0.25 * motion.stop_duration());
  EXPECT_GE(motion.duration(), lower_bound(motion, 2) * (1 - 1e-9));
  EXPECT_GT(motion.path().length() / motion.duration(), 60) << "mm/s, of a feed of 100";
  EXPECT_LE(path_tests::worst_ratio(to_axes(motion), limits), 1 + 1e-12);
}

TEST(CamProgram, RoundedCornersStayWithinTheirDeviation) {
  const GcodeProgram made = program(Corner::deviation);
  const Plan motion = plan(made.program, limits);
  EXPECT_LE(motion.duration(), motion.stop_duration());
  EXPECT_LE(path_tests::worst_ratio(to_axes(motion), limits), 1 + 1e-12);
  double farthest = 0;
  for (const CornerRecord& corner : motion.corners())
    farthest = std::max(farthest, corner.deviation);
  EXPECT_GT(farthest, 0);
  EXPECT_LE(farthest, deviation * (1 + 1e-9));
}

}  // namespace
}  // namespace jounce::cam_program_test
