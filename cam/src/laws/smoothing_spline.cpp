// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/smoothing_spline.hpp"

#include <algorithm>

#include "jounce/profiles/error.hpp"

#include "cam/src/design/table.hpp"
#include "cam/src/laws/tolerance_program.hpp"

namespace jounce {
namespace {

using cam_detail::Pin;
using cam_detail::ToleranceProgram;

void require_valid(const SplineSpec& spec) {
  cam_detail::require_points(spec.points, 3, true);
  cam_detail::require_ends(spec);
  if (spec.ends == SplineEnds::not_a_knot)
    throw InputError("ends", "not_a_knot", "a smoothing spline needs natural or periodic ends");
  const double first = spec.points.front().tolerance;
  const double last = spec.points.back().tolerance;
  if (spec.ends == SplineEnds::periodic && first != last)
    throw InputError(
        "points[" + std::to_string(spec.points.size()) + "].tolerance", last,
        "must be " + number(first) + ": the first and the last point of a periodic table are one");
}

}  // namespace

SmoothingSpline smoothing_spline(const SplineSpec& spec) {
  require_valid(spec);
  const ToleranceProgram program(spec);
  ToleranceProgram::Solution s = program.solve();
  SmoothingSpline answer{std::move(s.segments), {}, 0, 0, s.solutions};
  answer.square_jerk = cam_detail::square_jerk(answer.segments);
  const bool none = std::count(s.pins.begin(), s.pins.end(), Pin::held) > 0;
  answer.gap = none ? answer.square_jerk : std::min(program.gap(s), answer.square_jerk);
  for (std::size_t i = 0; i < s.pins.size(); ++i)
    if (s.pins[i] != Pin::none && s.pins[i] != Pin::held) answer.touched.push_back(i);
  return answer;
}

}  // namespace jounce
