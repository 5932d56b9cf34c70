// SPDX-License-Identifier: Apache-2.0
#include "python/src/words.hpp"

#include <cmath>

namespace jounce::python {

int valid_order(int order) {
  if (order < 0 || order > 3) throw InputError("order", order, "must be 0, 1, 2 or 3");
  return order;
}

std::vector<double> instants(double start, double end, double step) {
  require_positive("step", step);
  constexpr double most = 1e8;
  constexpr double near_end =
      1e-9;  // share of a step: a place that only rounding separates from the end is the end
  const double count = (end - start) / step;
  if (!(count < most))
    throw InputError("step", step, "makes more than 100000000 places: use a larger step");
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count) + 2);
  for (std::size_t k = 0;; ++k) {
    const double place = start + static_cast<double>(k) * step;
    if (!(place < end - near_end * step)) break;
    places.push_back(place);
  }
  places.push_back(end);
  return places;
}

}  // namespace jounce::python
