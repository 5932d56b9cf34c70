// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/detail/knot_rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "jounce/pvt/check.hpp"

namespace jounce::pvt_detail {

KnotRounding::KnotRounding(const Table& table, double cycle) : table_(table), cycle_(cycle) {
  const Ranges peaks = extrema(table);
  const double farthest = std::max(std::abs(table.start()), std::abs(table.end()));
  error_ = 2 * std::numeric_limits<double>::epsilon() *
           (std::abs(peaks[0].peak().value) + std::abs(peaks[1].peak().value) * farthest);
}

double KnotRounding::of(std::size_t order, std::size_t interval) const {
  constexpr std::array factors{1.0, 2.0, 6.0, 60.0};
  constexpr std::array beside{0.0, 1.0, 6.0, 36.0};
  const auto& x = table_.columns().x;
  const double length = x[interval + 1] - x[interval];
  double shorter = length;
  if (interval > 0) shorter = std::min(shorter, x[interval] - x[interval - 1]);
  if (interval + 2 < x.size()) shorter = std::min(shorter, x[interval + 2] - x[interval + 1]);
  const double more = shorter < length ? beside[order] * length / shorter : 0;
  return (factors[order] + more) * error_ / std::pow(length, static_cast<double>(order));
}

double KnotRounding::least_limit(std::size_t order, std::size_t interval, double peak) const {
  const auto& x = table_.columns().x;
  const double length = x[interval + 1] - x[interval];
  const bool is_mean = order == 3 && table_.axis() == Domain::time;
  const double mean = is_mean ? std::min(length / cycle_, 1.0) : 1.0;
  // peak <= limit + of() and peak <= limit (1 + greatest_excess / mean)
  return std::max(std::abs(peak) - of(order, interval),
                  std::abs(peak) * mean / (mean + greatest_excess));
}

}  // namespace jounce::pvt_detail
