#include "jounce/gear/clutch.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <string>

#include "jounce/gear/detail/wide.hpp"
#include "jounce/profiles/error.hpp"

// With the common denominator q of both ratios, P = r q, and d the distance, (2) of the header is
//
//   (3)  slave = N(u) / (2 d q),   N(u) = 2 d P0 u + (P1 - P0) u |u|,   |u| <= d
//
// and beyond, N grows by 2 d P1 a count. Every term is whole, so that only the division rounds.

namespace jounce {
namespace {

using detail::Wide;

constexpr Wide most = Wide{1} << 62;

Wide absolute(Wide a) {
  return a < 0 ? -a : a;
}

}  // namespace

Clutch::Clutch(const Gear& from, const Gear& to, std::int64_t distance) : distance_(distance) {
  if (distance < 0) throw InputError("distance", std::to_string(distance), "must not be negative");
  const std::int64_t shared = std::gcd(from.denominator(), to.denominator());
  const Wide common = Wide{from.denominator() / shared} * to.denominator();
  const Wide scale = distance == 0 ? 1 : Wide{2} * distance;
  const auto too_long = [&] {
    return InputError("distance", std::to_string(distance),
                      "is too long for exact counts with these ratios: give it a shorter one");
  };
  if (common >= most || common * scale >= most) throw too_long();
  const Wide p0 = Wide{from.numerator()} * (to.denominator() / shared);
  const Wide p1 = Wide{to.numerator()} * (from.denominator() / shared);
  const Wide greatest = std::max(absolute(p0), absolute(p1));
  if (greatest >= most || greatest * scale >= most) throw too_long();
  from_ = static_cast<std::int64_t>(p0);
  to_ = static_cast<std::int64_t>(p1);
  common_ = static_cast<std::int64_t>(common);
  scale_ = static_cast<std::int64_t>(scale);
  denominator_ = static_cast<std::int64_t>(common * scale);
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
  const auto [quotient, remainder] = detail::floor_divide(gained, denominator_);
  state.remainder = remainder;
  return detail::narrow(quotient);
}

Gear Clutch::ratio(const State& state) const {
  if (state.engaged || distance_ == 0) return Gear::ratio(to_, common_);
  const Wide rise = (Wide{to_} - from_) * std::abs(state.way);
  return Gear::ratio(detail::narrow(Wide{from_} * distance_ + rise),
                     detail::narrow(Wide{common_} * distance_));
}

Clutch::State Clutch::after(const Clutch& before, const State& state) const {
  const Wide parts = Wide{state.remainder} * denominator_;
  return {0, detail::narrow(detail::floor_divide(parts, before.denominator_).quotient), false};
}

std::int64_t DirectionMask::advance(State& state, std::int64_t master_increment) const {
  if (direction == FollowDirection::both) return master_increment;
  const std::int64_t sign = static_cast<std::int64_t>(direction);
  const std::int64_t ahead = sign * master_increment - state.behind;
  state.behind = reversal == Reversal::recover ? std::max<std::int64_t>(0, -ahead) : 0;
  return sign * std::max<std::int64_t>(0, ahead);
}

}  // namespace jounce
