// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "executor/record/log_judge.hpp"
#include "executor/record/log_line.hpp"

namespace jounce::test {

/// The rules of a homing and of limit switches, from the log and from the places of the switches on the machine:
///
/// - a homing is not faster than the greater of its two velocities, keeps its acceleration, and ends in its timeout;
/// - it ends at rest. Its home position is the edge or the index that CiA 402 names for its method;
/// - the axis is not homed during a search, and nothing but a homing makes it homed;
/// - an axis that has passed a limit switch outwards comes to rest, or turns round, in the time of its brakes.
class HomingJudge {
 public:
  using Find = std::function<void(const char* what, double value, double limit)>;

  explicit HomingJudge(const Bounds& bounds) : bounds_(bounds) {}

  /// This order may take effect in the next line.
  void offer(const Accepted& order) { offered_.push_back(&order); }
  /// `placed`: the position may have got another name in this line.
  void take(const Line& now, const std::optional<Line>& before, bool placed, const Find& find);

  /// The position range does not hold: it searches, or has not come to rest since.
  [[nodiscard]] bool unranged() const { return unranged_; }
  /// A search has ended in this line: the position has another name.
  [[nodiscard]] bool named() const { return named_; }

 private:
  void search(const Line& now, const Line& before, const Find& find);
  void end(const Line& now, const Find& find) const;
  void limit(const Line& now, const Line& before, const Find& find);
  [[nodiscard]] std::vector<double> homes_of(int method, double rounding) const;

  const Bounds& bounds_;
  std::vector<const Accepted*> offered_;   // for this line
  std::vector<const Accepted*> searches_;  // one of these is the search under way
  std::int64_t since_ = 0;                 // tick in which it began
  double begun_ = 0;                       // u: where the machine was then
  bool unranged_ = false;
  bool named_ = false;
  double machine_ = 0;                   // u: where the machine is
  double rounded_ = 0;                   // u: the rounding in that
  std::optional<std::int64_t> outward_;  // beyond a limit switch: until this tick at most
};

}  // namespace jounce::test
