// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear.hpp"

#include <limits>
#include <numeric>
#include <string>

#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/wide.hpp"

namespace jounce {
namespace {

using gear_detail::floor_divide;
using gear_detail::narrow;
using gear_detail::Wide;

}  // namespace

Gear Gear::ratio(std::int64_t numerator, std::int64_t denominator) {
  if (denominator <= 0)
    throw InputError("denominator", std::to_string(denominator), "must be greater than 0");
  if (numerator == std::numeric_limits<std::int64_t>::min())
    throw InputError("numerator", std::to_string(numerator), "must be greater than -2^63");
  const std::int64_t common = std::gcd(numerator, denominator);
  return {numerator / common, denominator / common};
}

std::int64_t Gear::slave(std::int64_t master) const {
  return narrow(floor_divide(Wide{master} * numerator_, denominator_).quotient);
}

std::int64_t Gear::advance(State& state, std::int64_t master_increment) const {
  const auto [quotient, remainder] =
      floor_divide(Wide{master_increment} * numerator_ + state.remainder, denominator_);
  state.remainder = remainder;
  return narrow(quotient);
}

}  // namespace jounce
