// SPDX-License-Identifier: Apache-2.0
// A program as a list of numbers: the same program again, and lists that are none.
#include "jounce/path/program_numbers.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::program_numbers_test {
namespace {

using test::error_of;
using test::Random;
using ::testing::HasSubstr;

/// Every kind of command in two axes and a follower.
LimitedProgram everything() {
  Program program(3, {1, 2, 3}, 2);
  program.set({.velocity = 50, .acceleration = 400});
  program.line({101, 2, 5}, 11);
  program.set({.velocity = 80,
               .corner = Corner::deviation,
               .value = 0.5,
               .junction = Junction::blending_low});
  program.line({101, 102, 5}, 12);
  program.dwell(0.25, 13);
  program.set({.velocity = 80});
  program.arc(arc_about(program.position(), {51, 102}, {1, 102}, Plane{0, 1},
                        ArcRotation::counterclockwise),
              14);
  const std::vector<Point> points{program.position(), {0, 60, 6}, {10, 30, 7}, {1, 2, 8}};
  program.curve(spline_through(points, 3), 15);
  const Limits axis{.velocity = 200, .acceleration = 1000, .jerk = 1e4};
  return {.program = program,
          .limits = {.axes = {axis, axis, {.velocity = 90, .acceleration = 800, .jerk = 9000}},
                     .path = {.velocity = 120, .normal_acceleration = 700}},
          .names = {"x", "y", "feed"},
          .words = {{.number = 6, .line = 10},
                    {.kind = ProgramWord::Kind::output, .number = -32, .line = 13, .command = 2},
                    {.number = 0, .line = 13, .command = 2},
                    {.number = 30, .line = 16, .command = 5}}};
}

TEST(ProgramNumbers, AreTheSameProgramAgain) {
  const LimitedProgram given = everything();
  const std::vector<double> numbers = numbers_of(given);
  const LimitedProgram same = program_of(numbers);
  EXPECT_EQ(same.names, given.names);
  EXPECT_EQ(same.words, given.words);
  EXPECT_EQ(numbers_of(same), numbers) << "bit for bit";
  EXPECT_EQ(same.program.commands().size(), given.program.commands().size());
  EXPECT_EQ(same.program.commands()[3].line, 14);
  EXPECT_EQ(same.limits.path.normal_acceleration, 700);
  EXPECT_TRUE(std::isinf(same.limits.path.jerk));
  const Plan a = plan(given.program, given.limits);
  const Plan b = plan(same.program, same.limits);
  ASSERT_EQ(a.duration(), b.duration());
  std::vector<Motion> at_a(3);
  std::vector<Motion> at_b(3);
  for (double t = 0; t < a.duration(); t += a.duration() / 997) {
    a.at(t, at_a);
    b.at(t, at_b);
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(at_a[k].position, at_b[k].position);
  }
}

TEST(ProgramNumbers, HaveTheLimitsOfAxesInCommands) {
  LimitedProgram given = everything();
  const std::size_t without = numbers_of(given).size();
  given.program.set({.velocity = 80, .axes = {{}, {.velocity = 7, .jerk = 900}}});
  given.program.line({5, 6, 7}, 17);
  given.program.set({.velocity = 90, .axes = {{}, {.velocity = 7, .jerk = 900}}});
  given.program.line({6, 6, 7}, 18);
  given.program.set({.velocity = 90});
  given.program.line({7, 6, 7}, 19);
  const std::vector<double> numbers = numbers_of(given);
  // Three lines of 5 numbers, three settings of 8, limits of two axes, and of none.
  EXPECT_EQ(numbers.size(), without + 3 * 5 + 3 * 8 + (2 + 6) + 2);
  const LimitedProgram same = program_of(numbers);
  const auto settings_of = [](const Program& program) {
    return std::vector<PathSettings>(program.settings().begin(), program.settings().end());
  };
  EXPECT_EQ(settings_of(same.program), settings_of(given.program));
  EXPECT_EQ(numbers_of(same), numbers);
}

TEST(ProgramNumbers, ListsThatAreNoProgramAreRejected) {
  const std::vector<double> good = numbers_of(everything());
  const auto error = [&](auto spoil) {
    std::vector<double> list = good;
    spoil(list);
    return error_of([&] { static_cast<void>(program_of(list)); });
  };
  EXPECT_THAT(error([](auto& list) { list.clear(); }), HasSubstr("numbers[0]"));
  EXPECT_THAT(error([](auto& list) { list[0] = 4; }), HasSubstr("must be 1, 2 or 3, the version"));
  EXPECT_THAT(error([](auto& list) { list[1] = 10; }), HasSubstr("from 1 to 9"));
  EXPECT_THAT(error([](auto& list) { list[2] = 4; }), HasSubstr("from 1 to 3"));
  EXPECT_THAT(error([](auto& list) { list.pop_back(); }), HasSubstr("ends within a command"));
  EXPECT_THAT(error([](auto& list) { list.push_back(7); }), HasSubstr("from 0 to 6"));
  EXPECT_THAT(error([](auto& list) { list[3] = std::nan(""); }), HasSubstr("must be finite"));
}

TEST(ProgramNumbers, AMachineWithJointsHasTheirNames) {
  LimitedProgram joints = everything();
  const std::size_t plain = numbers_of(joints).size();
  joints.names.resize(joints.program.axes(), "x");
  const std::size_t named = numbers_of(joints).size();
  joints.names.emplace_back("a0");
  joints.names.emplace_back("a1");
  const std::vector<double> list = numbers_of(joints);
  EXPECT_EQ(list[0], 2);
  EXPECT_EQ(list.size(), named + 1 + 2 * 3);
  EXPECT_GE(named, plain);
  const LimitedProgram same = program_of(list);
  EXPECT_EQ(same.names, joints.names);
  EXPECT_EQ(numbers_of(same), list);
}

TEST(ProgramNumbers, AxesWithSeveralUnitsHaveThem) {
  LimitedProgram given = everything();
  const std::size_t plain = numbers_of(given).size();
  given.units = {"mm", "mm", "deg"};
  const std::vector<double> list = numbers_of(given);
  EXPECT_EQ(list[0], 3);
  EXPECT_EQ(list.size(), plain + 1 + 3 + 3 + 4) << "no joints; each unit with its length";
  const LimitedProgram same = program_of(list);
  EXPECT_EQ(same.names, given.names);
  EXPECT_EQ(same.units, given.units);
  EXPECT_EQ(numbers_of(same), list);
  given.names.emplace_back("a0");
  given.units.emplace_back("\xC2\xB0");  // a degree sign in UTF-8
  const LimitedProgram joint = program_of(numbers_of(given));
  EXPECT_EQ(joint.names, given.names);
  EXPECT_EQ(joint.units, given.units);
}

TEST(ProgramNumbers, LimitsTooSmallForAPlanAreRejected) {
  LimitedProgram slow = everything();
  slow.limits.axes[1].velocity = 1e-300;
  const LimitedProgram read = program_of(numbers_of(slow));
  EXPECT_THAT(error_of([&] { static_cast<void>(plan(read.program, read.limits)); }),
              HasSubstr("must be at least 1e-12"));
  slow.limits.axes[1].velocity = 200;
  slow.limits.path.jerk = 1e-300;
  EXPECT_THAT(error_of([&] { static_cast<void>(plan(slow.program, slow.limits)); }),
              HasSubstr("must be at least 1e-12"));
  EXPECT_THAT(error_of([&] { slow.program.set({.velocity = 1e-300}); }),
              HasSubstr("must be at least 1e-12"));
}

// A list with one spoiled number is rejected, or is a program again. It causes nothing else.
TEST(ProgramNumbers, AnySpoiledNumberIsRejectedOrIsAProgram) {
  const std::vector<double> good = numbers_of(everything());
  Random random(27);
  const double values[] = {0, -1, 1, 2.5, 1e300, -1e300, 1e18, 4, 7};
  int rejected = 0;
  for (int i = 0; i < 5000; ++i) {
    std::vector<double> list = good;
    list[random.below(list.size())] = values[random.below(std::size(values))];
    try {
      static_cast<void>(program_of(list));
    } catch (const InputError&) {
      ++rejected;
    }
  }
  EXPECT_GT(rejected, 1000);
}

}  // namespace
}  // namespace jounce::program_numbers_test
