// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/cells.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::controllers_detail {

using profiles_detail::rounded_sum;

void Increments::add(const Place& place, int line, double dx, double dp, double v, Exchanged& to) {
  if (!(dx > 0)) place.fail(line, "time", number(dx), "must be greater than 0");
  x += dx;
  p += dp;
  to.columns.x.push_back(x);
  to.columns.p.push_back(p);
  to.columns.v.push_back(v);
  to.lines.push_back(line);
}

std::string tidy_number(double value) {
  const double whole = std::round(value);
  return number(std::abs(value - whole) <= rounded_sum * std::abs(value) ? whole : value);
}

double increment(double sum, double target) {
  const double difference = target - sum;
  const double rounding = rounded_sum * std::abs(target);
  constexpr int most_digits = 9;  // more digits are no decimal step
  for (int digits = 1; digits <= most_digits; ++digits) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.begin(), text.end(), difference,
                                   std::chars_format::scientific, digits - 1)
                         .ptr;
    double step = 0;
    std::from_chars(text.begin(), end, step);
    if (std::abs(sum + step - target) <= rounding) return step;
  }
  return difference;
}

std::string whole_number(double value) {
  return std::to_string(std::llround(value));
}

}  // namespace jounce::controllers_detail
