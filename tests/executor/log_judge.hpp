#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jounce::test {

/// What an axis was configured with, as its operator would write it down. u, s.
struct Bounds {
  double velocity = 0;
  double acceleration = 0;
  std::optional<double> jerk{};
  double stop_acceleration = 0;
  double stop_jerk = 0;  ///< of an axis with a jerk limit
  std::optional<double> lowest{}, highest{};
  double path_stop_time = 0;  ///< s: how long a stop on one of the axis's paths may take
  double period = 1e-3;       ///< s
  bool follows = false;       ///< a live master: what is coupled has the master's jerk
};

/// An order that the axis has accepted; it took effect in one of the ticks `sent` to `answered` + 1.
struct Accepted {
  enum class What {
    moves,     ///< the axis may move from now on
    rests,     ///< it must come to rest, by `acceleration` and `jerk`
    stops,     ///< likewise by the limits of a stop, and may not move again before another order
    disables,  ///< it may not move again before another order
    places,    ///< where it stands has another name
    other
  };
  What what = What::other;
  std::int64_t sent = 0;
  std::int64_t answered = 0;
  double acceleration = 0;  ///< that were asked for; 0: the axis's limit
  double jerk = 0;
  std::string words{};
};

/// What is wrong with a tick log, in words, each with its tick. Reads the CSV alone, with arithmetic
/// of its own: shares no code with the axis, its planner, or the reader of logs.
///
/// - position: within the range; from outside it (set_position) never farther out;
/// - velocity, acceleration, jerk: within the limits, of a stop within those of a stop; and position,
///   velocity and acceleration belong together from tick to tick;
/// - after a stop, a halt, a jog of 0 or a fault: at rest in the time that its limits allow;
/// - disabled: nothing moves; at rest: nothing begins to move that no order asked to.
std::vector<std::string> judged(const std::string& csv, const Bounds& bounds,
                                const std::vector<Accepted>& orders);

}  // namespace jounce::test
