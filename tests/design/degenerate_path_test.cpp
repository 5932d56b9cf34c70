// SPDX-License-Identifier: Apache-2.0
// Degenerate paths as a spec, as points in a CSV file and as G-code: each is a plan within its limits, or an error with
// its line. Arcs have no points, so they are specs and G-code only.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/design/input.hpp"
#include "jounce/path/along.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::degenerate_path_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using Points = std::vector<std::string>;  // "x, y" of each point

class DegeneratePath : public test::WithFolder {
 protected:
  /// The spec with further keys at its top and with its commands.
  [[nodiscard]] Plan plan_of(const std::string& top, const std::string& commands) const {
    write_file(in("spec.toml"), "jounce = 1\nkind = \"path\"\n" + top +
                                    "units = { position = \"mm\", time = \"s\" }\n"
                                    "path = { velocity = 100, corner = { deviation = 0.1 } }\n"
                                    "[[axis]]\nname = \"X\"\nlimits = { velocity = 200, "
                                    "acceleration = 1000, jerk = 10000 }\n"
                                    "[[axis]]\nname = \"Y\"\nlimits = { velocity = 200, "
                                    "acceleration = 1000, jerk = 10000 }\n" +
                                    commands);
    return *read_inputs(in("spec.toml")).front().plan;
  }

  [[nodiscard]] Plan spec(const std::string& commands) const { return plan_of("", commands); }
  [[nodiscard]] Plan gcode(const std::string& text) const {
    write_file(in("part.ngc"), text);
    return plan_of("gcode = { file = \"part.ngc\" }\n", "");
  }
  /// Lines from 0, 0 through the points in each of the three forms.
  [[nodiscard]] std::vector<Plan> through(const Points& points) const {
    std::string commands;
    std::string rows = "x,y\n0,0\n";
    std::string blocks = "G64 P0.1\nF6000\n";
    for (const std::string& p : points) {
      commands += line(p);
      rows += p + "\n";
      blocks += "G1 X" + p.substr(0, p.find(',')) + " Y" + p.substr(p.find(", ") + 2) + "\n";
    }
    write_file(in("points.csv"), rows);
    return {spec(commands), plan_of("points = \"points.csv\"\n", ""), gcode(blocks)};
  }

  static std::string line(const std::string& to) {
    return "[[command]]\ntype = \"line\"\nto = [" + to + "]\n";
  }

  /// The message of an error, from the name of its file on.
  template <class Read>
  static std::string message(Read read) {
    try {
      (void)read();
    } catch (const InputError& error) {
      const std::string what = error.what();
      return what.substr(what.rfind('/', what.find(": ")) + 1);
    }
    return "none";
  }
};

/// The axes stay within their limits, and rest at the end.
void expect_sound(const Plan& plan, double x, double y) {
  EXPECT_TRUE(std::isfinite(plan.duration()));
  EXPECT_GT(plan.duration(), 0);
  EXPECT_LE(plan.duration(), plan.stop_duration() * (1 + 1e-12));
  EXPECT_TRUE(check_along(plan).ok());
  const PlanAxes axes = to_axes(plan);
  const double end[] = {x, y};
  for (std::size_t i = 0; i < 2; ++i) {
    const Trajectory& f = axes.curves[i];
    const Report report = check(f, plan.given().limits.axes[i]);
    EXPECT_TRUE(report.ok()) << i << ": "
                             << (report.ok() ? "" : report.findings.front().rule.text());
    EXPECT_NEAR(f.at(f.end(), Side::left).position, end[i], 1e-15 * (10 + std::abs(end[i])));
  }
}

std::size_t noted(const Plan& plan, JunctionNote note) {
  return static_cast<std::size_t>(std::ranges::count_if(
      plan.junctions(), [note](const JunctionMark& m) { return m.note == note; }));
}

TEST_F(DegeneratePath, APieceWithoutLengthIsLeftOut) {
  const double without = spec(line("10, 0") + line("10, 10")).duration();
  for (const Plan& p : through({"10, 0", "10, 0", "10, 10", "10, 10"})) {
    expect_sound(p, 10, 10);
    EXPECT_NEAR(p.duration(), without, 1e-12);
    EXPECT_EQ(p.path().pieces().size(), 2U);
  }
}

TEST_F(DegeneratePath, OnlyPiecesWithoutLengthAreAnErrorWithALine) {
  EXPECT_THAT(message([&] { return spec(line("0, 0") + line("0, 0")); }),
              AllOf(HasSubstr("spec.toml:11:"), HasSubstr("covers no distance")));
  write_file(in("points.csv"), "x,y\n0,0\n0,0\n");
  EXPECT_THAT(message([&] { return plan_of("points = \"points.csv\"\n", ""); }),
              AllOf(HasSubstr("points.csv:3:"), HasSubstr("covers no distance")));
  EXPECT_THAT(message([&] { return gcode("G1 X0 Y0 F600\n"); }),
              AllOf(HasSubstr("part.ngc:1:"), HasSubstr("moves no axis")));
}

TEST_F(DegeneratePath, AReversalRests) {
  for (const char* y : {"0", "0.000000001"})
    for (const Plan& p : through({"10, 0", std::string("0, ") + y, "10, 0"})) {
      expect_sound(p, 10, 0);
      EXPECT_EQ(noted(p, JunctionNote::turns_back), 2U);
      EXPECT_NEAR(p.duration(), p.stop_duration(), 1e-12);
    }
}

TEST_F(DegeneratePath, PointsOneNanometerTimesAThousandthApart) {
  const double without = spec(line("10, 0") + line("10, 10")).duration();
  for (const Plan& p :
       through({"10, 0", "10.000000001, 0", "10.000000001, 0.000000001", "10, 10"})) {
    expect_sound(p, 10, 10);
    EXPECT_LE(p.duration(), without + 1e-3);
  }
}

TEST_F(DegeneratePath, AnArcWhoseRadiusDoesNotFitIsAnErrorWithItsPlace) {
  const std::string first = line("10, 0");
  const auto arc = [&](const std::string& keys) {
    return message([&] { return spec(first + "[[command]]\ntype = \"arc\"\n" + keys); });
  };
  EXPECT_THAT(arc("radius = 4\nto = [20, 0]\nrotation = \"clockwise\"\n"),
              HasSubstr("spec.toml:16:10: command[2].radius = 4 mm: must be at least 5 mm, half"));
  EXPECT_THAT(
      arc("center = [15, 0]\nto = [21, 0]\nrotation = \"clockwise\"\n"),
      HasSubstr("spec.toml:16:10: command[2].center: is 5 mm from the start and 6 mm from"));
  EXPECT_THAT(arc("via = [15, 0]\nto = [20, 0]\n"),
              HasSubstr("spec.toml:16:7: command[2].via: lies on a line with start and end"));
  const auto block = [&](const std::string& words) {
    return message([&] { return gcode("G1 X10 F6000\n" + words + "\n"); });
  };
  EXPECT_THAT(block("G2 X20 R4"), HasSubstr("part.ngc:2:8: R4: must be at least 5 mm, half"));
  EXPECT_THAT(block("G2 X21 I5 J0"), HasSubstr("part.ngc:2:8: I5 J0: is 5 mm from the start"));
  EXPECT_THAT(block("G2 X10 I0 J0"), HasSubstr("part.ngc:2:8: I0 J0: is the start of the arc"));
}

TEST_F(DegeneratePath, AnArcOfANanometer) {
  const std::string arc =
      "[[command]]\ntype = \"arc\"\ncenter = [10, 1e-6]\nto = [10, 2e-6]\n"
      "rotation = \"counterclockwise\"\n";
  expect_sound(spec(line("10, 0") + arc + line("0, 0")), 0, 0);
  expect_sound(gcode("G64 P0.1\nG1 X10 F6000\nG3 Y0.000002 J0.000001\nG1 X0 Y0\n"), 0, 0);
}

TEST_F(DegeneratePath, ACornerWithoutRoomIsReported) {
  for (const Plan& p : through({"10, 0", "10, 0.001", "20, 0.001"})) {
    expect_sound(p, 20, 0.001);
    EXPECT_EQ(noted(p, JunctionNote::short_sides) + noted(p, JunctionNote::slower), 2U);
    for (const CornerRecord& c : p.corners()) EXPECT_LE(c.trim, 0.0005 * (1 + 1e-9));
  }
}

TEST_F(DegeneratePath, DetailOfANanometerAtAThousandKilometers) {
  // A double has 1.2e-7 mm there, so a step of 1e-6 mm is a multiple of that.
  const std::string far = "1000000000";
  for (const Plan& p :
       through({far + ", " + far, far + ".000001, " + far, far + ".000001, " + far + ".000001",
                far + ", " + far + ".000002"})) {
    expect_sound(p, 1e9, 1000000000.000002);
    EXPECT_NEAR(p.path().length(), std::sqrt(2.0) * 1e9, 1);
  }
  expect_sound(gcode("G64 P0.001\nG0 X1000000000 Y0\nG1 X1000000000.5 F600\n"
                     "G3 X1000000001 Y0.5 I0 J0.5\nG1 Y1.000001\n"),
               1e9 + 1, 1.000001);
}

}  // namespace
}  // namespace jounce::degenerate_path_test
