// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/detail/path_clock.hpp"

#include "axis/model/any_command.hpp"
#include "axis/model/model_movements.hpp"
#include "axis/src/state/supervision.hpp"
#include "axis/tables.hpp"
#include "support/random.hpp"

namespace jounce::test {

/// One input of a random run. The seed and the state of the axis determine it, so a run is a list
/// of numbers, and a shorter list is a run too.
using Seed = std::uint64_t;

/// An axis under random commands, masters, drives and late ticks, with the conditions that every
/// tick must meet. step() returns the violated condition as text; empty: none.
class AxisModel {
 public:
  explicit AxisModel(const AxisConfig& config, bool has_drive);

  std::string step(Seed seed);

  [[nodiscard]] const Tick& last() const { return last_; }
  /// "tick 17: move_absolute 3.5 refused in_error; error_stop ..." of the last step.
  [[nodiscard]] std::string told() const;

  std::set<State> states;
  std::set<Cause> refusals;
  std::set<Cause> faults;

 private:
  AnyCommand random_command(test::Random& random);
  Movement* random_movement(test::Random& random);
  Inputs random_inputs(test::Random& random);

  std::string check_numbers(const Tick& now) const;
  std::string check_motion(const Command& command, const Tick& now) const;
  std::string check_faults(const Command& command, const Tick& now) const;
  std::string check_stop(const Command& command, const Tick& now);
  std::string check_slots(const Tick& now);

  AxisConfig config_;
  bool has_drive_;
  MotionAxis axis_;
  std::int64_t tick_ = -1;
  double master_ = 0;
  double master_velocity_ = 0;
  bool master_lost_ = false;
  double drive_ = 0;  // position of the drive, in its own count
  std::int64_t stop_began_ = -1;
  double stop_bound_ = 0;  // ticks
  std::uint64_t ids_ = 0;
  struct Kept {
    std::unique_ptr<Movement> movement;
    Feed* feed = nullptr;
  };
  std::map<std::uint64_t, Kept> kept_;
  AnyCommand command_;
  Inputs inputs_;
  Tick last_;
};

}  // namespace jounce::test
