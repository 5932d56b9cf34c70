// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_sum.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/wide.hpp"

// Let D be the least common multiple of the denominators q_i, and P_i = p_i D / q_i. Then
//
//   (1)  sum of p_i n_i / q_i = (sum of P_i n_i) / D
//
// exactly, so one division rounds once. Because the sum of |P_i| is below 2^63, the sum of P_i n_i
// is below 2^126 for any counts.

namespace jounce {
namespace {

using gear_detail::Wide;

Wide dot(std::span<const std::int64_t> numerators, std::span<const std::int64_t> counts) {
  require_size("masters", counts.size(), numerators.size());
  Wide sum = 0;
  for (std::size_t i = 0; i < numerators.size(); ++i) sum += Wide{numerators[i]} * counts[i];
  return sum;
}

[[noreturn]] void refuse(std::size_t masters) {
  throw InputError("gears", std::to_string(masters),
                   "have no common denominator below 2^63: give them simpler ratios");
}

}  // namespace

GearSum GearSum::of(std::span<const Gear> gears) {
  if (gears.empty()) throw InputError("gears", "0", "must be at least 1");
  GearSum sum;
  for (const Gear& gear : gears) {
    const std::int64_t common = std::gcd(sum.denominator_, gear.denominator());
    const Wide least = Wide{sum.denominator_} * (gear.denominator() / common);
    if (!gear_detail::fits(least)) refuse(gears.size());
    sum.denominator_ = static_cast<std::int64_t>(least);
  }
  Wide total = 0;
  for (const Gear& gear : gears) {
    const Wide numerator = Wide{gear.numerator()} * (sum.denominator_ / gear.denominator());  // (1)
    total += numerator < 0 ? -numerator : numerator;
    if (!gear_detail::fits(total)) refuse(gears.size());
    sum.numerators_.push_back(static_cast<std::int64_t>(numerator));
  }
  return sum;
}

std::int64_t GearSum::slave(std::span<const std::int64_t> masters) const {
  return gear_detail::narrow(
      gear_detail::floor_divide(dot(numerators_, masters), denominator_).quotient);
}

std::int64_t GearSum::advance(Gear::State& state, std::span<const std::int64_t> increments) const {
  const auto [quotient, remainder] =
      gear_detail::floor_divide(dot(numerators_, increments) + state.remainder, denominator_);
  state.remainder = remainder;
  return gear_detail::narrow(quotient);
}

std::int64_t counter_increment(std::int64_t before, std::int64_t now, std::int64_t period) {
  assert(period > 0 && before >= 0 && before < period && now >= 0 && now < period);
  std::int64_t way = now - before;
  if (way > period / 2) way -= period;
  if (way < -((period - 1) / 2)) way += period;
  return way;
}

}  // namespace jounce
