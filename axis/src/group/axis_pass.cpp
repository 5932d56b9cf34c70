// SPDX-License-Identifier: Apache-2.0
#include "axis/src/group/axis_pass.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/detail/evaluate.hpp"

namespace jounce {

void AxisPass::add(const Segment& f) {
  const Jet first = profiles_detail::evaluate(f, 0);
  const Jet last = profiles_detail::evaluate(f, 1);
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!(f.length > 0) || !std::ranges::all_of(first, finite) || !std::ranges::all_of(last, finite))
    static_cast<void>(Trajectory({f}));  // throws
  step_to(first);
  before_ = last;
  const double start = time_.value();
  time_.add(f.length);
  if (section_)
    widen(*section_, f, start, time_.value());
  else
    section_ = segment_extrema(f, start, time_.value());
}

/// The steps to the next segment. A step of the position at the start is none.
void AxisPass::step_to(const Jet& after) {
  const double where = time_.value();
  const double leap = begun_ ? after[0] - before_[0] : 0;
  begun_ = true;
  if (std::abs(leap) > std::abs(position_.step)) position_ = {leap, where};
  if (after[1] != before_[1]) velocity_.add({after[1] - before_[1], where});
  if (after[2] != before_[2]) acceleration_.add({after[2] - before_[2], where});
}

Peaks AxisPass::end_section() {
  if (!section_) return {};
  const Ranges& all = *section_;
  const Peaks peaks{.velocity = std::abs(all[1].peak().value),
                    .acceleration = std::abs(all[2].peak().value),
                    .jerk = std::abs(all[3].peak().value)};
  if (ranges_)
    widen(*ranges_, all);
  else
    ranges_ = all;
  section_.reset();
  return peaks;
}

AxisSteps AxisPass::steps() {
  step_to({before_[0], 0, 0, 0});
  return {position_, velocity_.result(), acceleration_.result()};
}

}  // namespace jounce
