// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/slave_check.hpp"

#include <array>
#include <optional>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/limit_check.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/coupling/derivatives.hpp"

namespace jounce {
namespace {

using cam_detail::Derivatives;

/// Both ranges together.
Range joined(const Range& a, const Range& b) {
  return {b.min.value < a.min.value ? b.min : a.min, b.max.value > a.max.value ? b.max : a.max};
}

/// Velocity, acceleration and jerk of the slave, by (1) of master_limits.hpp, for master rates of the given signs:
/// weights of f', f'' and f'''.
std::array<std::array<double, 3>, 3> weights(double w, double a, double j) {
  return {{{w, 0, 0}, {a, w * w, 0}, {j, 3 * w * a, w * w * w}}};
}

/// The range of one of these (0: velocity) on a segment, over all signs of the rates of the master.
Range slave_range(const Derivatives& f, double start, double end, std::size_t rate, double w,
                  const MasterRates& rates) {
  std::optional<Range> all;
  for (const double a : {rates.acceleration, -rates.acceleration})
    for (const double j : {rates.jerk, -rates.jerk}) {
      const Range one = segment_range(f.weighted(weights(w, a, j)[rate]), start, end, 0);
      all = all ? joined(*all, one) : one;
    }
  return *all;
}

}  // namespace

Report check_slave(const Cam& cam, const Limits& slave, double velocity, const MasterRates& rates) {
  require_positive("velocity", velocity);
  require_not_negative("acceleration", rates.acceleration);
  require_not_negative("jerk", rates.jerk);
  Limits limits = slave;
  limits.position_min.reset();
  limits.position_max.reset();
  require_valid(limits);
  profiles_detail::LimitCheck found(limits, OverTime::names, 0);
  const auto& bounds = found.bounds();
  for (std::size_t i = 0; i < cam.segments().size(); ++i) {
    const Derivatives f(cam.segments()[i]);
    Range range;
    for (std::size_t b = 0; b < bounds.size(); ++b) {
      if (b == 0 || bounds[b].order != bounds[b - 1].order)
        range = slave_range(f, cam.breaks()[i], cam.breaks()[i + 1], bounds[b].order - 1, velocity,
                            rates);
      found.consider(b, range, cam.breaks()[i], cam.breaks()[i + 1], i);
    }
  }
  return std::move(found).report();
}

}  // namespace jounce
