// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/output_events.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"

#include "support/errors.hpp"

namespace jounce::output_events_test {
namespace {

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

// 11 pulses, 1 mm apart from 10 mm on: each on at its position.
TEST(OutputEvents, ACompareFiresAtItsPositions) {
  const OutputEvents events = output_events(read_inputs(examples + "position-compare/scan.toml"));
  double position = 10;
  double time = 0;
  std::size_t pulses = 0;
  for (const OutputEvent& event : events.all) {
    EXPECT_GT(event.time, time);
    time = event.time;
    if (!event.on) continue;
    EXPECT_EQ(event.position, position);
    position += 1;
    ++pulses;
  }
  EXPECT_EQ(pulses, 11U);
  EXPECT_EQ(events.position, "mm");
  EXPECT_THAT(to_csv(events), ::testing::StartsWith("time [s],output,on,position [mm]\n"));
}

// The middles of three sides of a square: the x axis enters the first zone at 49.5 mm. By hand: 100 mm/s after
// 0.2 s and 10 mm.
TEST(OutputEvents, ZonesFireWhereBothAxesEnterThem) {
  const OutputEvents events = output_events(read_inputs(examples + "position-compare/zones.toml"));
  ASSERT_EQ(events.all.size(), 6U);
  EXPECT_TRUE(events.report.ok());
  EXPECT_EQ(events.all[0].output, "output 16");
  EXPECT_NEAR(events.all[0].position, 49.5, 1e-9);
  EXPECT_NEAR(events.all[0].time, 0.2 + (49.5 - 10) / 100, 1e-9);
  EXPECT_NEAR(events.all[1].time, events.all[0].time + 2e-3, 1e-12);
  EXPECT_FALSE(events.all[1].on);
  EXPECT_EQ(events.all[2].output, "output 17");
  EXPECT_NEAR(events.all[2].position, 100, 1e-9);
  EXPECT_EQ(events.all[4].output, "output 16");
  EXPECT_NEAR(events.all[4].position, 50.5, 1e-9);  // from the other side
}

TEST(OutputEvents, AZoneThatIsNotEnteredIsAFinding) {
  std::string text = read_file(examples + "position-compare/zones.toml");
  text.replace(text.find("at = [100, 50]"), 14, "at = [102, 50]");
  const OutputEvents events = output_events(inputs_of(parse_spec(text, "z.toml"), "z.toml"));
  ASSERT_EQ(events.report.findings.size(), 1U);
  EXPECT_EQ(events.report.findings[0].rule, "compare/missed");
  EXPECT_EQ(events.report.findings[0].value, 1);  // it blocks the one behind it
  EXPECT_EQ(events.all.size(), 2U);
}

// A pulse each 100 mm along the square without rounding: at the corners, where the axes rest.
TEST(OutputEvents, TheLengthAlongAPathIsCompared) {
  const std::string text = read_file(examples + "path-square/stop.toml") +
                           "\n[compare]\naxis = \"path\"\nmode = \"linear\"\nstart = 50\n"
                           "increment = 100\ncount = 4\npulse = \"1 ms\"\n";
  const OutputEvents events = output_events(inputs_of(parse_spec(text, "p.toml"), "p.toml"));
  EXPECT_TRUE(events.report.ok());
  ASSERT_EQ(events.all.size(), 8U);
  for (std::size_t k = 0; k < 4; ++k) {
    // At 100 mm/s, a pulse of 1 ms ends 0.1 mm later.
    EXPECT_EQ(events.all[2 * k].position, 50 + 100.0 * static_cast<double>(k));
    EXPECT_EQ(number(events.all[2 * k + 1].position), std::to_string(50 + 100 * k) + ".1");
    EXPECT_NEAR(events.all[2 * k].time, 0.6 + 1.2 * static_cast<double>(k), 1e-9);
  }
}

// Without a jerk limit, the corner is a parabola: over the 10 mm of the sides that it replaces, it is as long as
// 10 (1/2 + asinh(1) / 8^(1/2)) mm. Its middle is as far from the first side as the end of that side is from it.
TEST(OutputEvents, ARoundedCornerCountsItsOwnLength) {
  const double corner = 10 * (0.5 + std::asinh(1.0) / std::sqrt(8.0));
  const std::string text =
      "jounce = 1\nkind = \"path\"\nname = \"corner\"\nunits = { position = \"mm\", time = \"s\" "
      "}\n"
      "[path]\nvelocity = 200\ncorner = { distance = 5 }\n"
      "[[axis]]\nname = \"x\"\nlimits = { velocity = 200, acceleration = 1000 }\n"
      "[[axis]]\nname = \"y\"\nlimits = { velocity = 200, acceleration = 1000 }\n"
      "[[command]]\ntype = \"line\"\nto = [50, 0]\n[[command]]\ntype = \"line\"\nto = [50, 50]\n"
      "[compare]\naxis = \"path\"\nmode = \"fifo_time\"\npulse = \"1 us\"\npoint = [{ position = "
      "45 }, "
      "{ position = " +
      number(45 + corner / 2) + " }, { position = " + number(45 + corner) +
      " }, { position = " + number(85 + corner) + " }]\n";
  const std::vector<Input> axes = inputs_of(parse_spec(text, "p.toml"), "p.toml");
  const OutputEvents events = output_events(axes);
  ASSERT_EQ(events.all.size(), 8U);
  const double places[4][2] = {{45, 0}, {NAN, NAN}, {50, 5}, {50, 45}};
  for (std::size_t k = 0; k < 4; ++k) {
    const double px = std::get<Trajectory>(*axes[0].curve).at(events.all[2 * k].time).position;
    const double py = std::get<Trajectory>(*axes[1].curve).at(events.all[2 * k].time).position;
    if (k == 1) {
      EXPECT_NEAR(py, 50 - px, 1e-9);
      EXPECT_GT(py, 1);
      continue;
    }
    EXPECT_NEAR(px, places[k][0], 1e-9) << k;
    EXPECT_NEAR(py, places[k][1], 1e-9) << k;
  }
}

// The square with stops: a side takes 1.2 s.
TEST(OutputEvents, OfAPathAreItsLines) {
  const OutputEvents events = output_events(read_inputs(examples + "path-square/stop.toml"));
  ASSERT_EQ(events.all.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(events.all[k].time, 1.2 * static_cast<double>(k), 1e-6);
    EXPECT_NEAR(events.all[k].position, 100.0 * static_cast<double>(k), 1e-9);
    EXPECT_THAT(events.all[k].output, ::testing::StartsWith("line "));
  }
}

TEST(OutputEvents, ASpecWithoutOutputsIsRejected) {
  EXPECT_EQ(test::key_of([] { output_events(read_inputs(examples + "pmc600-cam/cam.toml")); }),
            "switch");
}

}  // namespace
}  // namespace jounce::output_events_test
