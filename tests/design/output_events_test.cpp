// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/output_events.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
    EXPECT_NEAR(event.position, position, 1e-9);
    position += 1;
    ++pulses;
  }
  EXPECT_EQ(pulses, 11U);
  EXPECT_EQ(events.position, "mm");
  EXPECT_THAT(to_csv(events), ::testing::StartsWith("time [s],output,on,position [mm]\n"));
}

TEST(OutputEvents, ASpecWithoutOutputsIsRefused) {
  EXPECT_EQ(test::key_of([] { output_events(read_inputs(examples + "pmc600-cam/cam.toml")); }),
            "compare");
}

}  // namespace
}  // namespace jounce::output_events_test
