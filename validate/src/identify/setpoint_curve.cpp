// SPDX-License-Identifier: Apache-2.0
#include "validate/src/identify/setpoint_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace jounce::validate_detail {
namespace {

Jet jet_of(const RecordedSetpoint& s) {
  return {s.position, s.velocity, s.acceleration, 0};
}

bool stands(const RecordedSetpoint& a, const RecordedSetpoint& b) {
  return a.position == b.position && a.velocity == 0 && b.velocity == 0 && a.acceleration == 0 &&
         b.acceleration == 0;
}

double least_spacing(const std::vector<RecordedSetpoint>& setpoints) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < setpoints.size(); ++i)
    least = std::min(least, setpoints[i].time - setpoints[i - 1].time);
  const double length = setpoints.back().time - setpoints.front().time;
  return length / std::round(length / least);  // without the rounding of one spacing
}

}  // namespace

SetpointCurve::SetpointCurve(const std::vector<RecordedSetpoint>& setpoints)
    : breaks_{setpoints.front().time},
      setpoints_{jet_of(setpoints.front())},
      cycle_(least_spacing(setpoints)) {
  bool stood = false;
  for (std::size_t i = 1; i < setpoints.size(); ++i) {
    const RecordedSetpoint& a = setpoints[i - 1];
    const RecordedSetpoint& b = setpoints[i];
    const bool stand = stands(a, b);
    if (stand && stood) {
      breaks_.back() = b.time;
      continue;
    }
    stood = stand;
    breaks_.push_back(b.time);
    setpoints_.push_back(jet_of(b));
    pieces_.emplace_back(jet_of(a), jet_of(b), b.time - a.time);
  }
}

Jet SetpointCurve::jet(double t, Side side) const {
  const auto inner = side == Side::right ? std::upper_bound(breaks_.begin(), breaks_.end(), t)
                                         : std::lower_bound(breaks_.begin(), breaks_.end(), t);
  const auto end = std::clamp<std::ptrdiff_t>(inner - breaks_.begin(), 1,
                                              static_cast<std::ptrdiff_t>(pieces_.size()));
  const auto i = static_cast<std::size_t>(end - 1);
  Jet at = pieces_[i].at(t - breaks_[i]);
  at[0] += setpoints_[i][0];
  return at;
}

}  // namespace jounce::validate_detail
