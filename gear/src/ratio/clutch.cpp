// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/clutch.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/wide.hpp"

// Let q be the common denominator of both ratios, P = r q, and d the distance. Then (2) of the
// header becomes
//
//   (3)  slave = N(u) / (2 d q),   N(u) = 2 d P0 u + (P1 - P0) u |u|,   |u| <= d
//
// Beyond, N grows by 2 d P1 for each count. Every term is a whole number, so only the division
// rounds.

namespace jounce {
namespace {

using gear_detail::Wide;

constexpr Wide widest = Wide{1} << 62;

Wide absolute(Wide a) {
  return a < 0 ? -a : a;
}

/// Both ratios with a common denominator.
struct Shared {
  Wide common, from, to;
  Shared(const Gear& r0, const Gear& r1) {
    const std::int64_t shared = std::gcd(r0.denominator(), r1.denominator());
    common = Wide{r0.denominator() / shared} * r1.denominator();
    from = Wide{r0.numerator()} * (r1.denominator() / shared);
    to = Wide{r1.numerator()} * (r0.denominator() / shared);
  }
  [[nodiscard]] bool fits(Wide scale) const {
    const Wide greatest = std::max({common, absolute(from), absolute(to)});
    return greatest < widest && greatest * scale < widest;
  }
};

/// The ratio nearest to r with a denominator of at most `limit`, by its continued fraction.
Gear nearest(const Gear& r, Wide limit) {
  Wide n = absolute(r.numerator()), d = r.denominator();
  Wide p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  while (d != 0 && q0 + n / d * q1 <= limit) {
    const Wide a = n / d;
    p0 = std::exchange(p1, p0 + a * p1);
    q0 = std::exchange(q1, q0 + a * q1);
    n = std::exchange(d, n - a * d);
  }
  if (d == 0) return r;
  const Wide k = (limit - q0) / q1;
  const bool last = 2 * d * (q0 + k * q1) <= r.denominator();
  const Wide p = last ? p1 : p0 + k * p1;
  return Gear::ratio(gear_detail::narrow(r.numerator() < 0 ? -p : p),
                     gear_detail::narrow(last ? q1 : q0 + k * q1));
}

/// The ratio at the start: r0 if counts are exact with it. Otherwise the nearest ratio for which
/// they are exact, provided that it differs from r0 by at most 2^-20.
Gear begun(const Gear& r0, const Gear& r1, Wide scale) {
  if (Shared(r0, r1).fits(scale)) return r0;
  const Wide whole = 1 + std::max(absolute(r0.numerator()) / r0.denominator(),
                                  absolute(r1.numerator()) / r1.denominator());
  const Wide limit = widest / 2 / scale / whole / r1.denominator();
  return limit < (Wide{1} << 20) ? r0 : nearest(r0, limit);
}

}  // namespace

Clutch::Clutch(const Gear& from, const Gear& to, std::int64_t distance) : distance_(distance) {
  if (distance < 0) throw InputError("distance", std::to_string(distance), "must not be negative");
  const Wide scale = distance == 0 ? 1 : Wide{2} * distance;
  const Shared ratios(begun(from, to, scale), to);
  if (!ratios.fits(scale))
    throw InputError("distance", std::to_string(distance),
                     "is too long for exact counts with these ratios: use a shorter one");
  from_ = static_cast<std::int64_t>(ratios.from);
  to_ = static_cast<std::int64_t>(ratios.to);
  common_ = static_cast<std::int64_t>(ratios.common);
  scale_ = static_cast<std::int64_t>(scale);
  denominator_ = static_cast<std::int64_t>(ratios.common * scale);
}

std::int64_t Clutch::advance(State& state, std::int64_t master_increment) const {
  const auto parts = [&](std::int64_t u) {  // (3)
    return Wide{scale_} * from_ * u + (Wide{to_} - from_) * u * std::abs(u);
  };
  Wide gained = state.remainder;
  Wide rest = master_increment;
  if (!state.engaged) {
    const Wide way = Wide{state.way} + master_increment;
    state.engaged = absolute(way) >= distance_;
    const auto end = static_cast<std::int64_t>(std::clamp(way, -Wide{distance_}, Wide{distance_}));
    gained += parts(end) - parts(state.way);
    rest = way - end;
    state.way = end;
  }
  gained += rest * scale_ * to_;
  const auto [quotient, remainder] = gear_detail::floor_divide(gained, denominator_);
  state.remainder = remainder;
  return gear_detail::narrow(quotient);
}

Gear Clutch::ratio(const State& state) const {
  if (state.engaged || distance_ == 0) return Gear::ratio(to_, common_);
  const Wide rise = (Wide{to_} - from_) * std::abs(state.way);
  return Gear::ratio(gear_detail::narrow(Wide{from_} * distance_ + rise),
                     gear_detail::narrow(Wide{common_} * distance_));
}

Clutch::State Clutch::after(const Clutch& before, const State& state) const {
  const Wide parts = Wide{state.remainder} * denominator_;
  return {0, gear_detail::narrow(gear_detail::floor_divide(parts, before.denominator_).quotient),
          false};
}

std::int64_t DirectionMask::advance(State& state, std::int64_t master_increment) const {
  if (direction == FollowDirection::both) return master_increment;
  const std::int64_t sign = static_cast<std::int64_t>(direction);
  const std::int64_t ahead = sign * master_increment - state.behind;
  state.behind = reversal == Reversal::recover ? std::max<std::int64_t>(0, -ahead) : 0;
  return sign * std::max<std::int64_t>(0, ahead);
}

}  // namespace jounce
