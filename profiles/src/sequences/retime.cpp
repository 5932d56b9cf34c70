// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/retime.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

// If f is stretched by k, g(t) = f(t / k), then g' = f' / k, g'' = f'' / k^2, g''' = f''' / k^3.
// With the greatest magnitudes v, a, j of f and the limits V, A, J, the least k that keeps the
// limits is
//
//   (1)  k = max( v / V, (a / A)^(1/2), (j / J)^(1/3) )

namespace jounce {

double least_stretch(std::span<const Trajectory> axes, std::span<const Limits> limits) {
  if (axes.size() != limits.size())
    throw InputError("limits", static_cast<double>(limits.size()),
                     "must be as many as the axes, " + std::to_string(axes.size()));
  double k = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    require_valid(limits[i]);
    const Ranges r = extrema(axes[i]);
    const auto used = [&](std::size_t order, const std::optional<double>& limit) {
      return limit ? std::abs(r[order].peak().value) / *limit : 0;
    };
    k = std::max({k, used(1, limits[i].velocity), std::sqrt(used(2, limits[i].acceleration)),
                  std::cbrt(used(3, limits[i].jerk))});  // (1)
  }
  if (!(k > 0))
    throw InputError("limits", "", "do not limit the motion: add velocity, acceleration or jerk");
  return k;
}

double least_stretch(const Trajectory& motion, const Limits& limits) {
  return least_stretch(std::span(&motion, 1), std::span(&limits, 1));
}

Trajectory retimed(const Trajectory& motion, const Limits& limits) {
  const double k = least_stretch(motion, limits);
  const Trajectory stretched = scaled(motion, 1, k);
  return shifted(stretched, motion.start() - stretched.start());
}

}  // namespace jounce
