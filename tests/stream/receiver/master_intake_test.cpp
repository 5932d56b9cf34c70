// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/master_intake.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "jounce/stream/detail/receiver_pump.hpp"
#include "jounce/stream/receiver/receiver_options.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "stream/src/transport/lossy_transport.hpp"
#include "stream/src/transport/memory_transport.hpp"

namespace jounce::master_intake_test {
namespace {

using namespace std::chrono_literals;

wire::Master sample(std::int64_t seq, std::int64_t stamp_ns, std::int32_t clock = 1) {
  return {.seq = seq, .stamp_ns = stamp_ns, .clock = clock, .valid = true, .unit = "mm"};
}

TEST(MasterIntake, WhatIsRepeatedOrOldDoesNothing) {
  MasterIntake intake({.unit = "mm"});
  EXPECT_TRUE(intake.take(sample(5, 5000), 0s));
  EXPECT_FALSE(intake.take(sample(5, 5000), 1ms));
  EXPECT_FALSE(intake.take(sample(4, 4000), 1ms));
  EXPECT_FALSE(intake.take(sample(6, 5000), 1ms)) << "the stamp must rise";
  EXPECT_FALSE(intake.take(sample(5, 6000), 1ms)) << "the number must rise";
  EXPECT_TRUE(intake.take(sample(7, 6000), 1ms));
  EXPECT_EQ(intake.taken(), 2);
  EXPECT_EQ(intake.refused(), 4);
}

TEST(MasterIntake, AcceptsTheLaterOfTwoSenders) {
  MasterIntake intake({.unit = "mm"});
  EXPECT_TRUE(intake.take(sample(100, 100'000, 7), 0s));
  EXPECT_TRUE(intake.take(sample(0, 0, 8), 1ms));
  for (int i = 1; i < 50; ++i) {
    EXPECT_FALSE(intake.take(sample(100 + i, 100'000 + i, 7), i * 1ms));
    EXPECT_TRUE(intake.take(sample(i, i, 8), i * 1ms));
  }
}

TEST(MasterIntake, AnEpochThatIsOverComesBackWithoutAKeyOnly) {
  for (const bool keyed : {false, true}) {
    MasterIntake intake({.unit = "mm", .keyed = keyed});
    EXPECT_TRUE(intake.take(sample(100, 100'000, 7), 0s));
    EXPECT_FALSE(intake.take(sample(0, 0, 3), 1s)) << "not as long as the other one is fresh";
    EXPECT_EQ(intake.take(sample(0, 0, 3), 1001ms), !keyed);
    EXPECT_EQ(intake.take(sample(1, 1, 3), 1002ms), !keyed);
  }
}

TEST(MasterIntake, AnotherUnitIsRejectedAndNamed) {
  MasterIntake intake({.unit = "mm"});
  wire::Master inches = sample(1, 1);
  inches.unit = "in";
  EXPECT_FALSE(intake.take(inches, 0s));
  EXPECT_EQ(intake.other_unit(), "in");
  EXPECT_TRUE(intake.take(sample(1, 1), 0s)) << "it has not spent the number";
}

wire::Key key_of(std::uint8_t first) {
  wire::Key key{};
  key[0] = first;
  return key;
}

struct Bus {
  MemoryNetwork network;
  Nanos now{};
  MemoryTransport here{network}, there{network};
  Clock clock = [this] { return now; };
};

// A pump with a key, with signed, unsigned and wrongly signed samples.
TEST(MasterIntake, WithAKeyOnlyWhatIsSignedIsHandedOn) {
  Bus bus;
  ReceiverPump pump(bus.here, ReceiverOptions{.executor = "knife", .key = key_of(1)}, 1, bus.clock);
  std::vector<std::int64_t> heard;
  pump.subscribe("line", [&](const wire::Master& m) { heard.push_back(m.seq); });
  send_message(bus.there, {"line", 0, sample(1, 1)}, key_of(1));
  send_message(bus.there, {"line", 0, sample(2, 2)});
  send_message(bus.there, {"line", 0, sample(3, 3)}, key_of(2));
  send_message(bus.there, {"web", 0, sample(4, 4)}, key_of(1));
  send_message(bus.there, {"line", 0, sample(5, 5)}, key_of(1));
  pump.run(0s);
  EXPECT_EQ(heard, (std::vector<std::int64_t>{1, 5}));
  EXPECT_EQ(pump.rejects()[wire::Reject::not_authentic], 2U);
}

// Lost, doubled, damaged and delayed: what counts rises, and each of it is what was sent.
TEST(MasterIntake, RisesWhateverTheLinkDoes) {
  Bus bus;
  LossyTransport lossy(bus.there,
                       {.seed = 5, .lost = 0.1, .doubled = 0.1, .corrupted = 0.05, .delayed = 0.2},
                       bus.clock);
  ReceiverPump pump(bus.here, ReceiverOptions{.executor = "knife"}, 1, bus.clock);
  MasterIntake intake({.unit = "mm"});
  std::int64_t last = -1;
  pump.subscribe("line", [&](const wire::Master& m) {
    if (!intake.take(m, bus.now)) return;
    EXPECT_GT(m.seq, last);
    EXPECT_EQ(m.stamp_ns, m.seq * 1'000'000);
    EXPECT_EQ(m.position, 0.25 * static_cast<double>(m.seq));
    last = m.seq;
  });
  for (std::int64_t i = 0; i < 5000; ++i, bus.now += 1ms) {
    wire::Master m = sample(i, i * 1'000'000);
    m.position = 0.25 * static_cast<double>(i);
    send_message(lossy, {"line", 0, m});
    static_cast<void>(lossy.receive(0s));
    pump.run(0s);
  }
  EXPECT_GT(intake.taken(), 3000);
  EXPECT_GT(intake.refused(), 400) << "doubled and overtaken";
  EXPECT_GT(pump.rejects()[wire::Reject::wrong_checksum], 50U);
}

}  // namespace
}  // namespace jounce::master_intake_test
