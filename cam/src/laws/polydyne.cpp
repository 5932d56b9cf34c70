// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/polydyne.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

// The mode obeys x'' + 2 D w x' + w^2 x = w^2 f. Requiring x = y everywhere gives
//
//   (1)  f = y + (2 D / w) y' + y'' / w^2
//
// and x = y holds if both begin with the same state. f^(k) is continuous wherever y^(k), y^(k+1)
// and y^(k+2) are.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::two_pi;

/// Equation (1) on one segment. Derivatives have no sines or powers that the function lacks.
Segment driving(const Segment& y, double by_velocity, double by_acceleration) {
  const Segment velocity = derivative(y);
  const Segment with_velocity = sum(y, scaled(velocity, by_velocity)).value();
  return sum(with_velocity, scaled(derivative(velocity), by_acceleration)).value();
}

/// The step of a derivative, or 0 if it is only rounding.
Jump step_of(const Cam& f, int order) {
  const Jump step = largest_jump(f, order);
  const double peak = std::abs(extrema(f, order).peak().value);
  return std::abs(step.step) > rounded_input * peak ? step : Jump{};
}

/// Throws if the cam itself or its geo_velocity is not continuous.
void require_smooth(const Cam& f, const char* whose, int order) {
  const Jump step = step_of(f, order);
  if (step.step == 0) return;
  throw InputError("polydyne", "",
                   std::string(whose) + OverMaster::names[static_cast<std::size_t>(order)] +
                       " would step by " + six_digits(step.step) + " at " + six_digits(step.where) +
                       ", which no follower can follow. Use laws that begin and end with "
                       "geo_acceleration and geo_jerk 0, such as 56789 or nonic");
}

Report warnings_of(const Cam& cam) {
  const Jump step = step_of(cam, 2);
  if (step.step == 0) return {};
  Finding f;
  f.rule = "polydyne/geo_acceleration";
  f.quantity = "step of geo_acceleration";
  f.where = step.where;
  f.value = std::abs(step.step);
  f.margin = -f.value / std::abs(extrema(cam, 2).peak().value);
  f.advice =
      "the fourth derivative of the wanted output steps there: to avoid the impact, use a smoother "
      "output, law 56789 or nonic";
  f.severity = Severity::warning;
  f.has_limit = false;
  return {{std::move(f)}};
}

}  // namespace

Polydyne polydyne(const Cam& output, const Mode& mode) {
  require_valid(mode);
  const double w = two_pi * mode.frequency;
  require_smooth(output, "the output's ", 1);
  require_smooth(output, "the output's ", 2);
  std::vector<Segment> segments;
  segments.reserve(output.segments().size());
  for (const Segment& y : output.segments())
    segments.push_back(driving(y, 2 * mode.damping / w, 1 / (w * w)));
  Cam cam(std::move(segments), output.start(), output.outside());
  require_smooth(cam, "the cam's ", 1);
  Report warnings = warnings_of(cam);
  return {std::move(cam), std::move(warnings)};
}

}  // namespace jounce
