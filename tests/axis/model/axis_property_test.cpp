// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "axis/model/axis_model.hpp"

namespace jounce::axis_property_test {
namespace {

using namespace test;

AxisConfig within_100() {
  AxisConfig config{.limits = limits(500, 2e4)};
  config.limits.position_min = -100;
  config.limits.position_max = 100;
  config.following_error = 4;
  return config;
}

struct Variant {
  const char* name;
  AxisConfig config;
  bool has_drive;
};

std::vector<Variant> variants() {
  AxisConfig plain = within_100();
  AxisConfig jerk = within_100();
  jerk.limits.jerk = 2e6;
  AxisConfig round = within_100();
  round.modulo = 60;
  round.abort_acceleration = 4e4;
  AxisConfig tight = within_100();
  tight.stop_acceleration = 2.2e4;
  tight.limit_acceleration = 1e4;
  return {{"plain", plain, false},
          {"jerk", jerk, true},
          {"modulo", round, true},
          {"tight", tight, false}};
}

/// The first violated condition of this run; empty: none.
std::string played(const Variant& variant, const std::vector<Seed>& seeds) {
  AxisModel model(variant.config, variant.has_drive);
  for (const Seed seed : seeds)
    if (std::string wrong = model.step(seed); !wrong.empty()) return wrong;
  return {};
}

/// The same break with as few inputs as can be had by leaving out stretches of them.
std::vector<Seed> shrunk(const Variant& variant, std::vector<Seed> seeds) {
  for (std::size_t length = seeds.size() / 2; length > 0; length /= 2)
    for (std::size_t at = 0; at + length <= seeds.size() && seeds.size() < 20'000;) {
      std::vector<Seed> fewer(seeds);
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(at),
                  fewer.begin() + static_cast<std::ptrdiff_t>(at + length));
      if (played(variant, fewer).empty())
        at += length;
      else
        seeds = std::move(fewer);
    }
  return seeds;
}

std::string told(const Variant& variant, const std::vector<Seed>& seeds) {
  AxisModel model(variant.config, variant.has_drive);
  std::string text = std::string(variant.name) + ":\n";
  for (const Seed seed : seeds) {
    const std::string wrong = model.step(seed);
    if (!wrong.empty() || model.told().find(": none") == std::string::npos)
      text += model.told() + "\n";
    if (!wrong.empty()) return text + wrong;
  }
  return text;
}

TEST(MotionAxisProperty, AMillionRandomInputs) {
  constexpr int runs = 50;  // for each variant
  constexpr int inputs = 5'000;
  std::set<State> states;
  std::set<Cause> refusals;
  std::set<Cause> faults;
  std::uint64_t finished = 0;
  std::uint64_t stopped = 0;
  for (const Variant& variant : variants())
    for (std::uint64_t run = 0; run < runs; ++run) {
      test::Random random(0x6a6f756e6365 + run);
      AxisModel model(variant.config, variant.has_drive);
      std::vector<Seed> seeds;
      for (int i = 0; i < inputs; ++i) {
        seeds.push_back(random.next());
        if (const std::string wrong = model.step(seeds.back()); !wrong.empty())
          FAIL() << wrong << " in run " << run << ", input " << i << "\n"
                 << told(variant, shrunk(variant, seeds));
      }
      states.insert(model.states.begin(), model.states.end());
      refusals.insert(model.refusals.begin(), model.refusals.end());
      faults.insert(model.faults.begin(), model.faults.end());
      finished += model.last().finished;
      stopped += model.last().stopped;
    }
  // The runs were worth something: they met every state, and what there is to meet of faults and
  // refusals (out_of_range needs a table that changes after it was admitted).
  EXPECT_EQ(states.size(), jounce::states);
  EXPECT_GT(finished, 1000U);
  EXPECT_GT(stopped, 300U);
  for (const Cause fault :
       {Cause::aborted, Cause::disabled_in_motion, Cause::stalled, Cause::overspeed,
        Cause::following_error, Cause::positive_soft_limit, Cause::negative_soft_limit,
        Cause::positive_switch, Cause::negative_switch, Cause::underrun, Cause::watchdog,
        Cause::drive_fault, Cause::drive_not_ready, Cause::master_lost, Cause::jump})
    EXPECT_EQ(faults.count(fault), 1U) << name(fault);
  for (const Cause cause :
       {Cause::not_enabled, Cause::in_error, Cause::in_motion, Cause::not_armed,
        Cause::not_at_start, Cause::too_late, Cause::no_value, Cause::start_position,
        Cause::velocity_limit, Cause::acceleration_limit, Cause::synchronized, Cause::stopping,
        Cause::not_on_path, Cause::no_movement, Cause::not_synchronized, Cause::rate_changing,
        Cause::position_limit, Cause::halting, Cause::buffer_full})
    EXPECT_EQ(refusals.count(cause), 1U) << name(cause);
}

}  // namespace
}  // namespace jounce::axis_property_test
