// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/jog.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/path/hold.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/geometry/vector.hpp"
#include "path/src/timing/box.hpp"
#include "path/src/timing/stretch.hpp"

namespace jounce {

Plan jogged(const Point& from, const Point& direction, double velocity, double duration,
            const GroupLimits& limits) {
  require_positive("velocity", velocity);
  require_positive("duration", duration);
  const double norm = vec::norm(direction);
  if (!(norm > 0) || !std::isfinite(norm))
    throw InputError("direction", norm, "must have a length greater than 0");
  const std::size_t n = limits.axes.size();
  const Point u = vec::scaled(direction, 1 / norm);
  PathSettings settings;
  settings.velocity = velocity;
  const Box box = line_box(rates_of(limits, n, n), settings, u.data());
  if (!(box.deceleration > 0 && box.deceleration < PathSettings::none))
    throw InputError(
        "acceleration", box.deceleration,
        "is missing: add acceleration to the limits of each axis that moves, or to [path.limits]");
  // A line so long that the button is released before the plan brakes.
  const double length =
      box.velocity * duration + 2 * ramp_distance(box.velocity, 0, box.deceleration, box.jerk);
  Program program(n, from);
  program.set(settings);
  program.line(vec::sum(from, u, length));
  return halted(plan(program, limits), duration);
}

}  // namespace jounce
