// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/override.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "profiles/src/sequences/override_ramp.hpp"

namespace jounce {
namespace {

using profiles_detail::Clock;
using profiles_detail::Path;
using profiles_detail::rounded_sum;

void require_factor(const std::string& key, double factor, double maximum) {
  require_not_negative(key.c_str(), factor);
  if (factor > maximum)
    throw InputError(key, factor, "must not be greater than maximum = " + number(maximum));
}

void require_valid(const OverrideSpec& spec, double start) {
  require_positive("maximum", spec.maximum);
  require_factor("factor", spec.factor, spec.maximum);
  double last = start;
  for (std::size_t i = 0; i < spec.requests.size(); ++i) {
    const std::string key = "request[" + std::to_string(i + 1) + "]";
    const auto& [time, factor] = spec.requests[i];
    require_finite((key + ".time").c_str(), time);
    if (time < last)
      throw InputError(key + ".time", time,
                       "must not be less than " + number(last) +
                           (i == 0 ? ", the start" : ", the previous request"));
    require_factor(key + ".factor", factor, spec.maximum);
    last = time;
  }
}

/// Throws for the worst violation of the axis.
void require_kept(const std::string& key, const Trajectory& axis, const Limits& limits) {
  const Report report = check(axis, limits);
  if (report.ok()) return;
  const Finding& worst = report.findings.front();
  throw InputError(key + ".limits." + worst.quantity, worst.limit,
                   "is exceeded before any override: the plan itself has the " +
                       std::string(worst.quantity) + " " + six_digits(worst.value) +
                       " at the time " + six_digits(worst.where));
}

/// Throws for a first factor that would step the velocity.
void require_no_step(const std::string& key, const Trajectory& axis, double factor) {
  const double velocity = axis.jet(axis.start())[1];
  if (factor == 1 || std::abs(velocity) <= rounded_sum * std::abs(extrema(axis, 1).peak().value))
    return;
  throw InputError("factor", factor,
                   "must be 1, because " + key + " begins in motion, at velocity " +
                       six_digits(velocity) + ", and any other factor steps it");
}

/// The plan; it must keep its limits unchanged and at the first factor.
Path planned(std::span<const Trajectory> axes, std::span<const Limits> limits, double factor) {
  if (axes.empty()) throw InputError("axes", "", "are missing: a motion needs at least one axis");
  Path path{{}, limits, Bounds::none, Bounds::none};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string key = "axis[" + std::to_string(i + 1) + "]";
    const double apart = std::max(std::abs(axes[i].start() - axes[0].start()),
                                  std::abs(axes[i].end() - axes[0].end()));
    if (apart > rounded_sum * std::max(std::abs(axes[0].start()), std::abs(axes[0].end())))
      throw InputError(key, number(axes[i].start()) + " to " + number(axes[i].end()),
                       "must have the interval of axis[1]");
    if (!limits[i].velocity || !limits[i].acceleration || !limits[i].jerk)
      throw InputError(key + ".limits", "",
                       "need a velocity, an acceleration and a jerk: add what is missing");
    require_kept(key, axes[i], limits[i]);
    require_no_step(key, axes[i], factor);
    path.axes.push_back(with(axes[i], Extrapolation::hold));
    const double v = std::abs(extrema(axes[i], 1).peak().value);
    path.acceleration = std::min(path.acceleration, *limits[i].acceleration / v);
    path.jerk = std::min(path.jerk, *limits[i].jerk / v);
  }
  if (!std::isfinite(path.acceleration)) throw InputError("axes", "", "do not move");
  if (factor > 1 && factor > path.room(path.start()) * (1 + rounded_sum))
    throw InputError("factor", factor,
                     "exceeds a limit: the greatest possible factor is " +
                         six_digits_down(path.room(path.start())));
  return path;
}

/// The complete clock, up to the end of the path.
Trajectory finished(const Clock& clock, double path_end) {
  const double end = clock.reaches(path_end);
  if (std::isfinite(end)) return clock.until(end);
  if (clock.pieces.empty()) throw InputError("factor", 0, "needs a request that starts the motion");
  return clock.until(clock.end());
}

}  // namespace

Overridden overridden(std::span<const Trajectory> axes, std::span<const Limits> limits,
                      const OverrideSpec& spec) {
  if (limits.size() != axes.size())
    throw InputError("limits", static_cast<double>(limits.size()),
                     "must be as many as the axes, " + std::to_string(axes.size()));
  const Path path = planned(axes, limits, spec.factor);
  require_valid(spec, path.start());
  Clock clock{path.start(), path.start(), {}, path.start(), spec.factor};
  std::vector<FactorRamp> ramps;
  for (const FactorRequest& request : spec.requests) {
    const auto ramp = profiles_detail::earliest_ramp(path, clock, request, spec.maximum);
    if (!ramp) {
      ramps.push_back({request.time, request.time, clock.rate, false});
      continue;
    }
    clock.follow(*ramp);
    ramps.push_back({ramp->begin, ramp->end, ramp->factor, true});
  }
  const bool arrived = std::isfinite(clock.reaches(path.end()));
  Overridden result{finished(clock, path.end()), {}, std::move(ramps), arrived};
  for (const Trajectory& axis : path.axes) result.axes.push_back(composed(axis, result.clock));
  return result;
}

}  // namespace jounce
