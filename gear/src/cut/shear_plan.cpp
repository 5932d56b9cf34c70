// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "jounce/gear/flying_shear.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/rest_to_rest.hpp"

// In step, the carriage's speed along the line is that of the line, v. Its guide is at the angle
// alpha to the line. So its speed along the guide, which is the slave's speed, is
//
//     (1)  k v,   k = ratio / cos(alpha)
//
// (Across the line it then moves at ratio v tan(alpha): a blade that follows the guide cuts
// square.) While the line advances by xa, the carriage's speed is k v f(x / xa). f is a symmetric
// law from 0 to 1 with the characteristic values r = Cv and q = Ca. Because f is symmetric, its
// mean is 1/2:
//
//     (2)  travel k xa / 2,   peak acceleration r k v^2 / xa,   peak jerk q k v^3 / xa^2
//     (3)  xa >= r k v^2 / amax,   xa >= sqrt(q k v^3 / jmax)
//
// The same holds for braking over xd. With xs in step, the greatest distance of the carriage from
// home is
//
//     (4)  S = k ((xa + xd) / 2 + xs)
//
// It returns over xr by a law with Cv, Ca, Cj:
//
//     (5)  xr >= Cv S v / vmax,   xr >= v sqrt(Ca S / amax),   xr >= v cbrt(Cj S / jmax)
//     (6)  L >= xa + xs + xd + xr
//
// All right sides grow with v and with xs, so bounds are found by bisection.

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double six_digit_step = 1e-5;  ///< greatest relative step of a number with six digits

/// Input of the generator: the spec, its ratio, and the peaks of its laws.
struct Worked {
  const FlyingShear& spec;
  double ratio = 1;  // k of (1)
  gear_detail::Peaks ramp = {};
  gear_detail::Peaks back = {};
};

/// The cycle at one line speed, except for the part of it that is not yet determined.
struct Cycle {
  double accelerate = 0;
  double sync = 0;
  double decelerate = 0;
  double stroke = 0;
  ShearBound ramp = {};  // the least length of a ramp, (3)
  ShearBound back = {};  // the least length of the return, (5)

  [[nodiscard]] double out() const { return accelerate + sync + decelerate; }
};

void raise(ShearBound& bound, double value, const char* quantity) {
  if (value > bound.value) bound = {value, quantity};
}

ShearBound least_ramp(const Worked& shear, double v) {
  const Limits& most = shear.spec.limits;
  const double pull = shear.ratio * v * v;
  ShearBound least;
  if (most.acceleration)
    raise(least, shear.ramp.velocity * pull / *most.acceleration, "ramp acceleration");
  if (most.jerk)
    raise(least, std::sqrt(shear.ramp.acceleration * pull * v / *most.jerk), "ramp jerk");
  return least;
}

ShearBound least_return(const Worked& shear, double stroke, double v) {
  const Limits& most = shear.spec.limits;
  const gear_detail::Peaks& law = shear.back;
  ShearBound least{0, "cut length"};
  if (most.velocity) raise(least, law.velocity * stroke * v / *most.velocity, "return velocity");
  if (most.acceleration)
    raise(least, v * std::sqrt(law.acceleration * stroke / *most.acceleration),
          "return acceleration");
  if (most.jerk) raise(least, v * std::cbrt(law.jerk * stroke / *most.jerk), "return jerk");
  return least;
}

bool longest_sync(const FlyingShear& spec) {
  return !spec.sync_time && !spec.sync_length;
}

/// Equations (4) and (5) for a sync interval of length x.
void synchronize(const Worked& shear, double v, double x, Cycle& cycle) {
  cycle.sync = x;
  cycle.stroke = shear.ratio * ((cycle.accelerate + cycle.decelerate) / 2 + x);
  cycle.back = least_return(shear, cycle.stroke, v);
}

/// The longest sync interval for which the return still fits into the rest of `length`.
void synchronize_longest(const Worked& shear, double v, double length, Cycle& cycle) {
  const double ramps = (cycle.accelerate + cycle.decelerate) / 2;
  const auto fits = [&](double x) {
    synchronize(shear, v, x, cycle);
    const double back = shear.spec.return_length.value_or(cycle.back.value);
    return cycle.back.value <= back && cycle.out() + back < length;
  };
  double hi = *shear.spec.stroke / shear.ratio - ramps;
  if (!(hi > 0) || fits(hi)) return synchronize(shear, v, hi, cycle);
  double lo = 0;
  for (double mid = hi / 2; mid > lo && mid < hi; mid = lo + (hi - lo) / 2)
    (fits(mid) ? lo : hi) = mid;
  synchronize(shear, v, lo, cycle);
}

Cycle cycle_at(const Worked& shear, double v, double length) {
  const FlyingShear& spec = shear.spec;
  Cycle cycle;
  cycle.ramp = least_ramp(shear, v);
  cycle.accelerate = spec.acceleration_length.value_or(spec.safety * cycle.ramp.value);
  cycle.decelerate = spec.deceleration_length.value_or(cycle.accelerate);
  if (longest_sync(spec))
    synchronize_longest(shear, v, length, cycle);
  else
    synchronize(shear, v, spec.sync_length ? *spec.sync_length : v * *spec.sync_time, cycle);
  return cycle;
}

/// Limit that the cycle breaks at any cut length; "" if none. Each limit has the tolerance `room`.
std::string broken_at_any_length(const Worked& shear, const Cycle& cycle, double v, double room) {
  const FlyingShear& spec = shear.spec;
  const double more = 1 + room;
  if (spec.limits.velocity && shear.ratio * v > *spec.limits.velocity * more)
    return "sync velocity";
  const double ramp = std::min(cycle.accelerate, cycle.decelerate);
  if (cycle.ramp.value > ramp * more || !std::isfinite(ramp)) return cycle.ramp.quantity;
  // A sync interval that uses the whole stroke does so only to rounding.
  const bool far = spec.stroke && cycle.stroke > *spec.stroke * more;
  if (longest_sync(spec) ? cycle.sync < 0 : far) return "stroke";
  if (spec.return_length && cycle.back.value > *spec.return_length * more)
    return cycle.back.quantity;
  return std::isfinite(cycle.back.value) ? "" : cycle.back.quantity;
}

std::string broken(const Worked& shear, const Cycle& cycle, double v, double length, double room) {
  if (auto any = broken_at_any_length(shear, cycle, v, room); !any.empty()) return any;
  const bool given = shear.spec.return_length.has_value();
  const double least = cycle.out() + shear.spec.return_length.value_or(cycle.back.value);
  const bool fits = least <= length * (1 + room) && cycle.out() < length && cycle.sync > 0;
  if (fits) return "";
  return given ? "return length" : cycle.back.quantity;
}

void require_numbers(const FlyingShear& spec) {
  require_positive("line_speed", spec.line_speed);
  require_positive("ratio", spec.ratio);
  const auto positive = [](const char* key, const std::optional<double>& value) {
    if (value) require_positive(key, *value);
  };
  positive("sync_time", spec.sync_time);
  positive("sync_length", spec.sync_length);
  positive("stroke", spec.stroke);
  positive("acceleration_length", spec.acceleration_length);
  positive("deceleration_length", spec.deceleration_length);
  positive("return_length", spec.return_length);
  positive("limits.velocity", spec.limits.velocity);
  positive("limits.acceleration", spec.limits.acceleration);
  positive("limits.jerk", spec.limits.jerk);
  require_finite("safety", spec.safety);
  require_finite("angle", spec.angle);
  if (spec.safety < 1) throw InputError("safety", spec.safety, "must be at least 1");
  if (!(std::abs(spec.angle) < std::numbers::pi / 2))
    throw InputError("angle", spec.angle,
                     "must be greater than -pi/2 and less than pi/2: otherwise the carriage does "
                     "not move with the line");
}

void require_complete(const FlyingShear& spec) {
  if (spec.sync_time && spec.sync_length)
    throw InputError("sync_length", *spec.sync_length,
                     "cannot be combined with sync_time: give one of them");
  if (longest_sync(spec) && !spec.stroke)
    throw InputError("sync_time", "", "is missing: give sync_time, sync_length or a stroke");
  if (!spec.acceleration_length && !spec.limits.acceleration && !spec.limits.jerk)
    throw InputError("acceleration_length", "", "is missing: give it, or limits.acceleration");
}

Worked worked(const FlyingShear& spec) {
  require_numbers(spec);
  require_complete(spec);
  Worked shear{.spec = spec, .ratio = spec.ratio / std::cos(spec.angle)};
  shear.ramp = gear_detail::peaks_of_ramp("ramp", spec.ramp);
  shear.back = gear_detail::peaks("return_law", spec.return_law, spec.return_form);
  return shear;
}

/// The limit that belongs to a quantity of ShearBound: "return jerk" -> "limits.jerk".
std::string limit_of(const std::string& quantity) {
  return "limits." + quantity.substr(quantity.find(' ') + 1);
}

std::string at_this_speed(const FlyingShear& spec) {
  return " at line_speed = " + six_digits(spec.line_speed);
}

/// Advice: the fastest possible line with the given value of `key`.
std::string or_slower(const FlyingShear& spec, const char* key) {
  const double fastest = greatest_line_speed(spec).value;
  return fastest > 0 ? ", or line_speed at most " + six_digits_down(fastest) + " with this " + key
                     : "";
}

bool possible(const FlyingShear& spec) {
  const Worked shear = worked(spec);
  const Cycle cycle = cycle_at(shear, spec.line_speed, spec.cut_length);
  return broken(shear, cycle, spec.line_speed, spec.cut_length, rounded_sum).empty();
}

/// Advice: the longest sync that stroke and return permit; "" if there is none.
std::string or_shorter(FlyingShear spec) {
  if (longest_sync(spec)) return "";
  const bool in_time = spec.sync_time.has_value();
  spec.sync_time.reset();
  spec.sync_length.reset();
  if (!possible(spec)) return "";
  const double sync = cycle_at(worked(spec), spec.line_speed, spec.cut_length).sync;
  return in_time ? ", or sync_time at most " + six_digits_down(sync / spec.line_speed)
                 : ", or sync_length at most " + six_digits_down(sync);
}

/// Advice: the cut length that a longer stroke needs, if the present one is too short.
std::string and_longer_cut(FlyingShear spec, double stroke) {
  spec.stroke = stroke * (1 + six_digit_step);
  if (possible(spec)) return "";
  const double least = least_cut_length(spec).value;
  return std::isfinite(least) ? ", with cut_length greater than " + six_digits_up(least) : "";
}

[[noreturn]] void refuse_length(const FlyingShear& spec, const std::string& quantity) {
  const ShearBound least = least_cut_length(spec);
  const bool by_limit = quantity.starts_with("return ") && quantity != "return length";
  throw InputError(
      "cut_length", spec.cut_length,
      std::string(longest_sync(spec) || !by_limit ? "must be greater than " : "must be at least ") +
          six_digits_up(least.value) + at_this_speed(spec) + or_slower(spec, "cut_length") +
          (by_limit ? ": a shorter return would exceed " + limit_of(quantity)
                    : ": no travel of the master is left for the return"));
}

[[noreturn]] void refuse(const Worked& shear, const Cycle& cycle, const std::string& quantity) {
  const FlyingShear& spec = shear.spec;
  if (quantity == "sync velocity") {
    const double most = *spec.limits.velocity / shear.ratio;
    const double fastest = greatest_line_speed(spec).value;
    const bool lower = fastest > 0 && fastest < most * (1 - six_digit_step);
    const std::string of_cut =
        lower ? six_digits_down(fastest) + " with this cut_length, and at most " : "";
    throw InputError("line_speed", spec.line_speed,
                     "must be at most " + of_cut + six_digits_down(most) +
                         (lower ? " with any" : "") +
                         ": at a higher speed, the carriage in the sync zone exceeds "
                         "limits.velocity = " +
                         number(*spec.limits.velocity));
  }
  if (quantity.starts_with("ramp") && !std::isfinite(cycle.ramp.value))
    throw InputError("ramp", name(spec.ramp),
                     "exceeds " + limit_of(quantity) + " at any speed: the limited quantity steps");
  if (quantity.starts_with("ramp")) {
    const bool up = cycle.accelerate <= cycle.decelerate;
    throw InputError(up ? "acceleration_length" : "deceleration_length",
                     up ? cycle.accelerate : cycle.decelerate,
                     "must be at least " + six_digits_up(cycle.ramp.value) + at_this_speed(spec) +
                         or_slower(spec, up ? "acceleration_length" : "deceleration_length") +
                         ": a shorter one would exceed " + limit_of(quantity));
  }
  if (quantity == "stroke") {
    const double ramps = shear.ratio * (cycle.accelerate + cycle.decelerate) / 2;
    throw InputError(
        "stroke", *spec.stroke,
        (longest_sync(spec)
             ? "must be greater than " + six_digits(ramps) + ", the length of run-up and braking,"
             : "must be at least " + six_digits_up(cycle.stroke)) +
            at_this_speed(spec) + (longest_sync(spec) ? "" : and_longer_cut(spec, cycle.stroke)) +
            or_shorter(spec) + or_slower(spec, "stroke"));
  }
  if (!std::isfinite(cycle.back.value))
    throw InputError("return_law", name(spec.return_law),
                     "exceeds " + limit_of(quantity) + " at any speed: the limited quantity steps");
  if (spec.return_length && cycle.back.value > *spec.return_length)
    throw InputError("return_length", *spec.return_length,
                     "must be at least " + six_digits_up(cycle.back.value) + at_this_speed(spec) +
                         or_slower(spec, "return_length") + ": a shorter one would exceed " +
                         limit_of(quantity));
  refuse_length(spec, quantity);
}

}  // namespace

ShearPlan shear_plan(const FlyingShear& spec) {
  require_positive("cut_length", spec.cut_length);
  const Worked shear = worked(spec);
  const double length = spec.cut_length;
  const Cycle cycle = cycle_at(shear, spec.line_speed, length);
  const std::string wrong = broken(shear, cycle, spec.line_speed, length, rounded_sum);
  if (!wrong.empty()) refuse(shear, cycle, wrong);
  ShearPlan plan;
  plan.accelerate = gear_detail::on_grid(cycle.accelerate, length);
  plan.sync = gear_detail::on_grid(cycle.sync, length);
  plan.decelerate = gear_detail::on_grid(cycle.decelerate, length);
  plan.back = length - (plan.accelerate + plan.sync + plan.decelerate);
  if (spec.return_length && plan.back - *spec.return_length > rounded_sum * length) {
    const double left = plan.back;
    plan.back = gear_detail::on_grid(*spec.return_length, length);
    plan.wait = left - plan.back;
  }
  plan.ratio = shear.ratio;
  plan.stroke = shear.ratio * ((plan.accelerate + plan.decelerate) / 2 + plan.sync);
  return plan;
}

ShearBound least_cut_length(const FlyingShear& spec) {
  const Worked shear = worked(spec);
  Cycle cycle = cycle_at(shear, spec.line_speed, 0);
  if (longest_sync(spec) && cycle.sync > 0) synchronize(shear, spec.line_speed, 0, cycle);
  if (auto any = broken_at_any_length(shear, cycle, spec.line_speed, rounded_sum); !any.empty())
    return {infinite, any};
  if (spec.return_length) return {cycle.out() + *spec.return_length, "return length"};
  return {cycle.out() + cycle.back.value, cycle.back.quantity};
}

ShearBound greatest_line_speed(const FlyingShear& spec) {
  require_positive("cut_length", spec.cut_length);
  const Worked shear = worked(spec);
  const auto broken_at = [&](double v) {
    return broken(shear, cycle_at(shear, v, spec.cut_length), v, spec.cut_length, 0);
  };
  double lo = spec.line_speed;
  double hi = lo;
  while (!broken_at(lo).empty())
    if (hi = lo, lo /= 2; lo < spec.line_speed * 0x1p-100) return {0, broken_at(lo)};
  while (broken_at(hi).empty())
    if (lo = hi, hi *= 2; hi > spec.line_speed * 0x1p100) return {infinite, ""};
  for (double mid = lo + (hi - lo) / 2; mid > lo && mid < hi; mid = lo + (hi - lo) / 2)
    (broken_at(mid).empty() ? lo : hi) = mid;
  return {lo, broken_at(hi)};
}

}  // namespace jounce
