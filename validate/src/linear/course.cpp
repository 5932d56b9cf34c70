// SPDX-License-Identifier: Apache-2.0
#include "validate/src/linear/course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jounce::validate_detail {
namespace {

constexpr double rounded_step = 1e-12;  // a smaller step of position or velocity does not count
constexpr double smooth = 1e-4;         // error control handles a smaller step of acceleration

}  // namespace

double usable(double scale) {
  return scale > 0 && std::isfinite(scale) ? scale : 1;
}

double shortest_time(double from, double to) {
  return std::max(rounded_step * (to - from), 16 * std::numeric_limits<double>::epsilon() *
                                                  std::max(std::abs(from), std::abs(to)));
}

bool steps(const Jet& before, const Jet& after, const Scales& size) {
  const auto by = [&](std::size_t k, double scale, double share) {  // true for NaN
    return !(std::abs(after[k] - before[k]) <= share * scale);
  };
  return by(0, size.range, rounded_step) || by(1, size.peak[1], rounded_step) ||
         by(2, size.peak[2], smooth);
}

}  // namespace jounce::validate_detail
