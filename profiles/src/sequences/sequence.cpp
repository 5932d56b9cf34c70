// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/sequences/sequence.hpp"

#include <algorithm>

namespace jounce::profiles_detail {

void Sequence::append(const Segment& f) {
  if (end_ + f.length == end_) return;  // shorter than the rounding of the time
  segments_.push_back(f);
  begins_.push_back(end_);
  end_ += f.length;
}

void Sequence::add(const Profile& profile, double sign) {
  const MotionState& end = profile.end();
  if (profile.phases() > 0) {
    const Trajectory curve = profile.curve();
    for (const Segment& f : curve.segments()) append(sign < 0 ? scaled(f, -1) : f);
  }
  state_ = {sign * end.position, sign * end.velocity, sign * end.acceleration};
}

void Sequence::hold(double time) {
  if (!(time > 0)) return;
  const double way = state_.velocity * time;
  Segment f;
  f.length = time;
  f.degree = way == 0 ? 0 : 1;
  f.c = {state_.position, way};
  append(f);
  state_.position += way;
}

std::size_t Sequence::end_at(double time) {
  // A phase shorter than the rounding of the time is not a segment.
  const double dust = 0x1p-50 * time;
  if (time >= end_) {
    if (time - end_ > dust) hold(time - end_);
    return segments_.size();
  }
  const auto running = std::upper_bound(begins_.begin(), begins_.end(), time) - begins_.begin() - 1;
  const auto whole = static_cast<std::size_t>(running);
  const double s = (time - begins_[whole]) / segments_[whole].length;
  const bool cut = time - begins_[whole] > dust;
  const Segment piece = cut ? part(segments_[whole], 0, std::min(s, 1.0)) : segments_[whole];
  const Jet now = evaluate(piece, cut ? 1 : 0);
  state_ = {now[0], now[1], now[2]};
  end_ = begins_[whole];
  segments_.resize(whole);
  begins_.resize(whole);
  if (cut) append(piece);
  return whole;
}

}  // namespace jounce::profiles_detail
