// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/modulo.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

// fmod is exact in IEEE arithmetic. The differences of remainders below are exact, except for one
// rounding. With r = x mod M, the way forward from x to a target u is
//
//   (1)  d = (u mod M - x mod M) mod M, in [0, M),   and backwards d - M (0 where d is)

namespace jounce {
namespace {

using profiles_detail::rounded_sum;
/// The distance by (1).
double forward(double from, double to, double period) {
  return rolled(rolled(to, period).position - rolled(from, period).position, period).position;
}

double backward(double from, double to, double period) {
  const double d = forward(from, to, period);
  return d > 0 ? d - period : 0;
}

/// The distance of at most half a turn; half a turn is positive.
double shortest(double from, double to, double period) {
  const double d = forward(from, to, period);
  return d <= period - d ? d : d - period;
}

/// Distances from the present position, which is already reduced. `stop` is the distance if the
/// axis stops now. If the direction is given, the target is searched for from there on.
struct Ways {
  double period, from, to, stop;

  [[nodiscard]] double at(double sign) const {
    const double d = forward(from, to, period);
    const double rounding =
        rounded_sum * period;  // so near counts as arrived: no turn for the last digit
    const double turns = (stop - d) / period;
    const double nearest = d + std::nearbyint(turns) * period;
    if (nearest != 0 && std::abs(nearest - stop) <= rounding) return stop;
    return d + (sign > 0 ? std::ceil(turns) : std::floor(turns)) * period;
  }
};

struct Timed {
  double distance;
  double duration;
};

/// True if a is the better way: the faster one (beyond rounding), then the shorter one, then the
/// positive one.
bool better(const Timed& a, const Timed& b) {
  if (std::abs(a.duration - b.duration) > rounded_sum * b.duration) return a.duration < b.duration;
  const double longer = std::abs(a.distance) - std::abs(b.distance);
  if (std::abs(longer) > rounded_sum * std::abs(b.distance)) return longer < 0;
  return a.distance > b.distance;
}

ModuloTarget fastest(const MotionState& from, const Ways& ways, const Bounds& bounds) {
  const MotionState here{0, from.velocity, from.acceleration};
  ModuloTarget none{MoveStatus::ok, 0, from.position};
  std::optional<Timed> best;
  const std::array candidates{forward(ways.from, ways.to, ways.period),
                              backward(ways.from, ways.to, ways.period), ways.at(1), ways.at(-1)};
  for (const double distance : candidates) {
    const Durations possible = durations(here, {distance, 0, 0}, bounds);
    if (possible.status != MoveStatus::ok) {
      none.status = possible.status;
      continue;
    }
    const Timed way{distance, possible.minimum};
    if (!best || better(way, *best)) best = way;
  }
  return best ? ModuloTarget{MoveStatus::ok, best->distance, from.position + best->distance} : none;
}

}  // namespace

Turned rolled(double x, double period) {
  require_positive("period", period);
  require_finite("position", x);
  if (!std::isfinite(x / period))
    throw InputError("position", x, "is more turns of " + number(period) + " than can be counted");
  double r = std::fmod(x, period);
  double turns = std::nearbyint((x - r) / period);
  if (r < 0) {
    r += period;
    turns -= 1;
  }
  // Less than a whole turn by so little that no double is nearer.
  if (r >= period) return {0, turns + 1};
  return {r == 0 ? 0 : r, turns};  // not -0
}

double unrolled(const Turned& spot, double period) {
  return std::fma(spot.turns, period, spot.position);
}

ModuloTarget modulo_target(const MotionState& from, double to, Direction direction, double period,
                           const Bounds& bounds) {
  require_positive("period", period);
  require_finite("target", to);
  require_finite("position", from.position);
  const auto going = [&](double distance) {
    return ModuloTarget{MoveStatus::ok, distance, from.position + distance};
  };
  if (direction == Direction::shortest) return going(shortest(from.position, to, period));

  const MoveResult halt = stop({0, from.velocity, from.acceleration}, bounds);
  if (!halt) return {halt.status, 0, from.position};
  const Ways ways{period, rolled(from.position, period).position, to, halt.profile.end().position};
  switch (direction) {
    case Direction::positive:
      return going(ways.at(1));
    case Direction::negative:
      return going(ways.at(-1));
    case Direction::fastest:
      return fastest(from, ways, bounds);
    default:
      break;
  }
  if (from.velocity == 0) return going(shortest(from.position, to, period));
  return going(ways.at(from.velocity));
}

void require_agito_modulo(double modulo, int jerk, double speed_max) {
  if (!(modulo >= 1 && modulo <= 2e9) || modulo != std::floor(modulo))
    throw InputError("ModRev", modulo, "must be a whole number of counts from 1 to 2000000000");
  if (jerk < 0 || jerk > 9) throw InputError("Jerk", jerk, "must be from 0 to 9");
  require_positive("Speed", speed_max);
  const double samples = std::ldexp(1, jerk);
  if (!(modulo * samples < 2147483647.0))
    throw InputError("ModRev", modulo,
                     "times 2^Jerk must be less than 2^31 - 1: with Jerk = " + number(jerk) +
                         " at most " + number(std::ceil(2147483647.0 / samples) - 1));
  const double jerk_time = samples / 16384;
  if (!(modulo > jerk_time * speed_max))
    throw InputError("ModRev", modulo,
                     "must take longer to travel at Speed than the jerk time " +
                         six_digits(jerk_time) + " s: more than " +
                         six_digits(jerk_time * speed_max) + " counts");
}

}  // namespace jounce
