// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace jounce::test {

/// One tick of a log, as a judge reads it: with code of its own.
struct Line {
  std::int64_t tick = 0;
  std::string_view state{};
  double p = 0, v = 0, a = 0;
  bool path = false;         // a table, a stream or a coupling is played
  std::string_view fault{};  // "none", or why the axis is in error
  bool homed = false;
  [[nodiscard]] bool failed() const { return fault != "none"; }
};

/// The lines of a log, without its head.
class Lines {
 public:
  explicit Lines(const std::string& csv) : rest_(csv) { static_cast<void>(text()); }

  std::optional<Line> next();

 private:
  std::string_view text();
  std::string_view rest_;
};

/// s in which a motion with v, u/s, and a, u/s^2, comes to rest by this acceleration and jerk, with 1 % to spare: first
/// its acceleration ends, then its velocity, and then the braking.
double time_to_rest(double v, double a, double acceleration, double jerk);

}  // namespace jounce::test
