// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/cia402.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "jounce/drive/cia402_axis.hpp"
#include "jounce/profiles/error.hpp"

#include "support/random.hpp"

namespace jounce::cia402_test {
namespace {

using enum Cia402State;

constexpr std::array all{
    not_ready_to_switch_on, switch_on_disabled, ready_to_switch_on,    switched_on,
    operation_enabled,      quick_stop_active,  fault_reaction_active, fault};

// The commands, each with every value of the bits that do not count (CiA 402-2, "command coding").
constexpr std::uint16_t shutdown = 0x06;
constexpr std::uint16_t switch_on = 0x07;
constexpr std::uint16_t disable_voltage = 0x00;
constexpr std::uint16_t quick_stop = 0x02;
constexpr std::uint16_t enable_operation = 0x0f;
constexpr std::uint16_t fault_reset = 0x80;

TEST(Cia402, EveryTransitionOfTheStandardsTable) {
  struct Row {
    int number;
    Cia402State from;
    std::uint16_t word;
    Cia402Events events;
    Cia402State to;
  };
  for (const Row& row :
       {Row{1, not_ready_to_switch_on, 0, {.initialised = true}, switch_on_disabled},
        Row{2, switch_on_disabled, shutdown, {}, ready_to_switch_on},
        Row{3, ready_to_switch_on, switch_on, {}, switched_on},
        Row{4, switched_on, enable_operation, {}, operation_enabled},
        Row{5, operation_enabled, switch_on, {}, switched_on},
        Row{6, switched_on, shutdown, {}, ready_to_switch_on},
        Row{7, ready_to_switch_on, disable_voltage, {}, switch_on_disabled},
        Row{7, ready_to_switch_on, quick_stop, {}, switch_on_disabled},
        Row{8, operation_enabled, shutdown, {}, ready_to_switch_on},
        Row{9, operation_enabled, disable_voltage, {}, switch_on_disabled},
        Row{10, switched_on, disable_voltage, {}, switch_on_disabled},
        Row{10, switched_on, quick_stop, {}, switch_on_disabled},
        Row{11, operation_enabled, quick_stop, {}, quick_stop_active},
        Row{12, quick_stop_active, disable_voltage, {}, switch_on_disabled},
        Row{12, quick_stop_active, quick_stop, {.stopped = true}, switch_on_disabled},
        Row{14, fault_reaction_active, 0, {.reaction_done = true}, fault},
        Row{15, fault, fault_reset, {}, switch_on_disabled}})
    EXPECT_EQ(next(row.from, row.word, 0, row.events), row.to) << "transition " << row.number;
  for (const Cia402State state : all)  // 13, from anywhere but a fault
    EXPECT_EQ(next(state, enable_operation, enable_operation, {.fault = true}),
              state == fault ? fault : fault_reaction_active);
}

/// The states that some controlword can reach are exactly those of the table.
TEST(Cia402, NoWordMakesAnyOtherTransition) {
  const std::set<std::pair<Cia402State, Cia402State>> table{
      {switch_on_disabled, ready_to_switch_on}, {ready_to_switch_on, switched_on},
      {switched_on, operation_enabled},         {operation_enabled, switched_on},
      {switched_on, ready_to_switch_on},        {ready_to_switch_on, switch_on_disabled},
      {operation_enabled, ready_to_switch_on},  {operation_enabled, switch_on_disabled},
      {switched_on, switch_on_disabled},        {operation_enabled, quick_stop_active},
      {quick_stop_active, switch_on_disabled},  {fault, switch_on_disabled}};
  std::set<std::pair<Cia402State, Cia402State>> seen;
  for (const Cia402State state : all)
    for (unsigned word = 0; word <= 0xffff; ++word) {
      const Cia402State to = next(state, static_cast<std::uint16_t>(word), 0, {});
      if (to != state) seen.insert({state, to});
    }
  EXPECT_EQ(seen, table);
}

TEST(Cia402, AFaultIsResetByARisingEdgeOnly) {
  EXPECT_EQ(next(fault, fault_reset, fault_reset, {}), fault) << "the bit stood already";
  EXPECT_EQ(next(fault, enable_operation, fault_reset, {}), fault);
  EXPECT_EQ(next(fault, fault_reset, 0, {.fault = true}), fault) << "the reason is still there";
  EXPECT_EQ(next(fault, fault_reset | enable_operation, enable_operation, {}), switch_on_disabled);
}

TEST(Cia402, StatuswordsAreReadAsTheyAreSet) {
  for (const Cia402State state : all)
    for (const bool flag : {false, true}) {
      const auto status = status_of(statusword(
          {.state = state, .internal_limit = flag, .follows = !flag, .following_error = flag}));
      ASSERT_TRUE(status) << name(state);
      EXPECT_EQ(status->state, state);
      EXPECT_EQ(status->internal_limit, flag);
      EXPECT_EQ(status->follows, !flag);
      EXPECT_EQ(status->following_error, flag);
    }
  // Words as drives send them: voltage enabled, remote, target reached.
  EXPECT_EQ(status_of(0x0250)->state, switch_on_disabled);
  EXPECT_EQ(status_of(0x0231)->state, ready_to_switch_on);
  EXPECT_EQ(status_of(0x0233)->state, switched_on);
  EXPECT_EQ(status_of(0x1637)->state, operation_enabled);
  EXPECT_EQ(status_of(0x0617)->state, quick_stop_active);
  EXPECT_EQ(status_of(0x0218)->state, fault);
  EXPECT_EQ(status_of(0x021f)->state, fault_reaction_active);
  EXPECT_FALSE(status_of(0x0002)) << "no state has these bits";
}

TEST(Cia402, EveryWordBelongsToOneStateAtMost) {
  int without = 0;
  for (unsigned word = 0; word <= 0xffff; ++word) {
    const auto status = status_of(static_cast<std::uint16_t>(word));
    if (!status) {
      ++without;
      continue;
    }
    const unsigned again = statusword(*status);
    const unsigned counted = status->state == not_ready_to_switch_on ||
                                     status->state == switch_on_disabled ||
                                     status->state >= fault_reaction_active
                                 ? 0x4f
                                 : 0x6f;
    EXPECT_EQ(word & counted, again & counted);
  }
  EXPECT_GT(without, 0);
}

TEST(Cia402, TheMasterGetsThereFromEverywhere) {
  for (const Cia402State from : all)
    for (const bool operate : {true, false}) {
      Cia402State state = from;
      std::uint16_t before = 0;
      for (int cycle = 0; cycle < 8; ++cycle) {
        const std::uint16_t word =
            controlword(state, {.operate = operate, .reset = true, .standing = cycle > 2});
        state = next(state, word, before, {.initialised = true, .reaction_done = true});
        before = word;
      }
      EXPECT_EQ(state, operate ? operation_enabled : switch_on_disabled) << name(from);
    }
  Cia402State held = switch_on_disabled;
  for (int cycle = 0; cycle < 8; ++cycle)
    held = next(held, controlword(held, {.operate = true, .hold_back = true}), 0, {});
  EXPECT_EQ(held, switched_on);
  EXPECT_EQ(controlword(operation_enabled, {.operate = false}), quick_stop)
      << "a moving drive is stopped before its voltage is taken";
}

// ---- increments ---------------------------------------------------------------------------------

__extension__ typedef __int128 Wide;  // NOLINT: of both compilers, but not of ISO C++

TEST(Increments, AreRoundedOnceFromTheExactQuotient) {
  // Whole numbers of both make the quotient exact in 128 bits.
  test::Random random(20260402);
  for (int i = 0; i < 100'000; ++i) {
    const auto p = static_cast<std::int64_t>(random.next() >> 20U) - (std::int64_t{1} << 43U);
    const std::int64_t d = 1 + static_cast<std::int64_t>(random.next() >> 44U);
    const std::int64_t c = 1 + static_cast<std::int64_t>(random.next() >> 54U);
    const auto product = static_cast<Wide>(p) * c;
    const auto whole = product / d;
    const auto rest = product - whole * d;
    const Wide rounded = whole + (2 * rest >= d ? 1 : 0) - (2 * rest <= -d ? 1 : 0);
    const Increments increments(static_cast<double>(c), static_cast<double>(d));
    const auto got = increments.of(static_cast<double>(p));
    if (rounded > (Wide{1} << 52U) - 2 || rounded < -(Wide{1} << 52U) + 2) continue;
    ASSERT_TRUE(got);
    ASSERT_EQ(*got, static_cast<std::int64_t>(rounded)) << p << " * " << c << " / " << d;
  }
}

TEST(Increments, TiesGoAwayFromZeroAndMirror) {
  const Increments increments(2, 4);
  EXPECT_EQ(increments.of(1), 1);
  EXPECT_EQ(increments.of(-1), -1);
  EXPECT_EQ(increments.of(3), 2);
  EXPECT_EQ(increments.of(-3), -2);
  EXPECT_EQ(Increments(2, 4, true).of(3), -2);
  EXPECT_EQ(Increments(2, 4, true).position(-2), 4);
}

TEST(Increments, AreZeroWithoutAMotion) {
  const Increments increments(131072, 360);
  EXPECT_FALSE(increments.of(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(increments.of(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(increments.of(1e300));
  EXPECT_THROW(Increments(0, 360), InputError);
  EXPECT_THROW(Increments(1.5, 360), InputError);
  EXPECT_THROW(Increments(0x1p31, 360), InputError);
  EXPECT_THROW(Increments(1000, -1), InputError);
}

TEST(Increments, WrapAndUnwrap) {
  EXPECT_EQ(Increments::wrapped(std::int64_t{1} << 31U), std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(Increments::wrapped(-1), -1);
  std::int64_t seen = 0;
  for (std::int64_t at = 0; at < std::int64_t{1} << 35U; at += 1'234'567'891) {
    seen = Increments::unwrapped(Increments::wrapped(at), seen);
    EXPECT_EQ(seen, at);
  }
  for (std::int64_t at = seen; at > -(std::int64_t{1} << 35U); at -= 1'234'567'891) {
    seen = Increments::unwrapped(Increments::wrapped(at), seen);
    EXPECT_EQ(seen, at);
  }
}

// ---- axis ---------------------------------------------------------------------------------------

/// A drive that obeys, by the drive's side of the state machine.
struct Plant {
  Cia402State state = not_ready_to_switch_on;
  std::uint16_t before = 0;
  std::int32_t position = 5000;
  bool fault = false;

  Cia402Inputs inputs() const {
    return {.statusword = statusword({.state = state, .follows = state == operation_enabled}),
            .mode = 8,
            .position_actual = position,
            .torque_actual = -250};
  }
  void step(const Cia402Outputs& outputs) {
    state = next(state, outputs.controlword, before,
                 {.initialised = true, .fault = fault, .reaction_done = true, .stopped = true});
    before = outputs.controlword;
    if (state == operation_enabled) position = outputs.target_position;
  }
};

TEST(Cia402Axis, LeadsTheDriveUpWithoutAJump) {
  Cia402Axis axis({.increments_per_rev = 1000, .position_per_rev = 10});
  Plant plant;
  for (int cycle = 0; cycle < 10; ++cycle) {
    const Feedback said = axis.feedback(plant.inputs());
    EXPECT_EQ(said.position, 50);
    EXPECT_EQ(said.torque, -0.25);
    EXPECT_EQ(said.ready, cycle >= 4) << "not ready, disabled, ready, switched on; cycle " << cycle;
    plant.step(axis.command({.position = 50, .enable = true}, plant.inputs()));
    EXPECT_EQ(plant.position, 5000);
  }
  plant.step(axis.command({.position = 50.013, .enable = true}, plant.inputs()));
  EXPECT_EQ(plant.position, 5001);
}

TEST(Cia402Axis, HoldsADriveBackThatIsNotWhereItShouldBe) {
  Cia402Axis axis({.increments_per_rev = 1000, .position_per_rev = 10});
  Plant plant;
  for (int cycle = 0; cycle < 20; ++cycle) {
    EXPECT_FALSE(axis.feedback(plant.inputs()).ready);
    plant.step(axis.command({.position = 50.11, .enable = true}, plant.inputs()));
  }
  EXPECT_EQ(plant.state, switched_on);
  EXPECT_EQ(plant.position, 5000);
  for (int cycle = 0; cycle < 2; ++cycle) {
    (void)axis.feedback(plant.inputs());
    plant.step(axis.command({.position = 50.09, .enable = true}, plant.inputs()));
  }
  EXPECT_EQ(plant.state, operation_enabled);
}

TEST(Cia402Axis, ReportsAFaultAndResetsIt) {
  Cia402Axis axis({.increments_per_rev = 1000, .position_per_rev = 10});
  Plant plant;
  plant.state = operation_enabled;
  plant.fault = true;
  const auto cycle = [&](bool reset) {
    const Feedback said = axis.feedback(plant.inputs());
    plant.step(axis.command({.position = 50, .enable = true, .reset = reset}, plant.inputs()));
    return said;
  };
  cycle(false);
  EXPECT_TRUE(cycle(false).fault);
  cycle(false);
  EXPECT_EQ(plant.state, fault);
  cycle(true);
  EXPECT_EQ(plant.state, fault) << "its reason is still there";
  plant.fault = false;
  for (int i = 0; i < 2 * Cia402Axis::reset_cycles; ++i) cycle(false);
  EXPECT_EQ(plant.state, fault) << "no reset since";
  cycle(true);
  for (int i = 0; i < 5; ++i) cycle(false);
  EXPECT_EQ(plant.state, operation_enabled);
  EXPECT_FALSE(cycle(false).fault);
}

// 0x60B8 to 0x60BD, and the counters 0x60D5 to 0x60D8.
TEST(Cia402Axis, ReportsTheCapturesOfItsTouchProbes) {
  Cia402Axis axis({.increments_per_rev = 1000, .position_per_rev = 10, .touch_probes = 2});
  EXPECT_EQ(axis.command({}, {}).touch_probe, 0x3333);
  Cia402Inputs inputs{.touch_probe_status = 0b10};  // captured before the executor started
  EXPECT_EQ(axis.feedback(inputs).triggers.count, 0);
  EXPECT_EQ(axis.feedback(inputs).triggers.wired, 0b11);

  inputs.touch_probe_status = 0b100'0000'0010;  // probe 2, falling
  inputs.position_actual = 5000;
  inputs.touch_probe_position = {0, 0, 0, 4987};
  Triggers now = axis.feedback(inputs).triggers;
  ASSERT_EQ(now.count, 1);
  EXPECT_EQ(now.change[0].input, 2);
  EXPECT_FALSE(now.change[0].rising);
  EXPECT_DOUBLE_EQ(now.change[0].position, 49.87);
  EXPECT_TRUE(std::isnan(now.change[0].age));
  EXPECT_EQ(axis.feedback(inputs).triggers.count, 0) << "the same capture";

  inputs.touch_probe_count = {3, 1, 0, 0};  // the bit of probe 1, rising, is still 1
  inputs.touch_probe_position = {4990, 4995, 0, 4987};
  now = axis.feedback(inputs).triggers;
  ASSERT_EQ(now.count, 2);
  EXPECT_TRUE(now.change[0].rising);
  EXPECT_DOUBLE_EQ(now.change[0].position, 49.9);
  EXPECT_FALSE(now.change[1].rising);
  EXPECT_DOUBLE_EQ(now.change[1].position, 49.95);
  EXPECT_EQ(now.on, 0);
}

TEST(Cia402Axis, ALatchedPositionCountsThroughTheWrap) {
  Cia402Axis axis({.increments_per_rev = 1 << 20, .position_per_rev = 360, .touch_probes = 1});
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  Cia402Inputs inputs{.position_actual = most - 10};
  (void)axis.feedback(inputs);
  inputs.position_actual = std::numeric_limits<std::int32_t>::min() + 20;  // 31 further
  inputs.touch_probe_position = {std::numeric_limits<std::int32_t>::min() + 9, 0, 0, 0};
  inputs.touch_probe_count = {1, 0, 0, 0};
  const Feedback now = axis.feedback(inputs);
  ASSERT_EQ(now.triggers.count, 1);
  EXPECT_NEAR(now.position - now.triggers.change[0].position, 11 * 360.0 / (1 << 20), 1e-9);
}

TEST(Cia402Axis, ADriveHasAtMostTwoTouchProbes) {
  for (const int probes : {-1, 3})
    EXPECT_THROW(
        Cia402Axis({.increments_per_rev = 1000, .position_per_rev = 10, .touch_probes = probes}),
        InputError);
  Cia402Axis none({.increments_per_rev = 1000, .position_per_rev = 10});
  Cia402Inputs inputs;
  (void)none.feedback(inputs);
  inputs.touch_probe_count = {1, 1, 1, 1};
  EXPECT_EQ(none.feedback(inputs).triggers.count, 0);
  EXPECT_EQ(none.command({}, inputs).touch_probe, 0);
}

TEST(Cia402Axis, ASetpointThatIsNoNumberMovesNothing) {
  Cia402Axis axis({.increments_per_rev = 1000, .position_per_rev = 10});
  Plant plant;
  plant.state = operation_enabled;
  for (const double position : {50.0, std::nan(""), 1e300, 50.0}) {
    (void)axis.feedback(plant.inputs());
    plant.step(axis.command({.position = position, .enable = true}, plant.inputs()));
    EXPECT_EQ(plant.position, 5000);
  }
}

TEST(Cia402Axis, FollowsAnEndlessRotationThroughTheWrap) {
  Cia402Axis axis({.increments_per_rev = 1 << 20, .position_per_rev = 360});
  Plant plant;
  plant.state = operation_enabled;
  plant.position = 0;
  const double step = 360.0 * 37;  // 37 turns a cycle
  for (int k = 0; k < 1000; ++k) {
    EXPECT_EQ(axis.feedback(plant.inputs()).position, step * std::max(0, k - 1)) << k;
    plant.step(axis.command({.position = step * k, .enable = true}, plant.inputs()));
  }
}

}  // namespace
}  // namespace jounce::cia402_test
