// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce::profiles_detail {

/// A motion under construction, profile by profile. Its end is the state in which the next profile
/// begins.
class Sequence {
 public:
  explicit Sequence(const MotionState& start) : state_(start) {}

  [[nodiscard]] const MotionState& state() const { return state_; }
  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] std::vector<Segment> segments() && { return std::move(segments_); }

  /// Appends a profile, planned in the axis' direction (sign 1) or in the mirrored one (-1).
  void add(const Profile& profile, double sign);

  /// Continues at the present velocity for a time.
  void hold(double time);

  /// Sets the acceleration at the end to 0 for the next profile: in a motion of second order it is
  /// not part of the state.
  void let_go() { state_.acceleration = 0; }

  /// Ends the motion at `time`: removes the part after it, or holds until then. Returns the number
  /// of segments that are still complete.
  std::size_t end_at(double time);

 private:
  void append(const Segment& f);

  std::vector<Segment> segments_;
  std::vector<double> begins_;  ///< s, start of each segment
  MotionState state_;
  double end_ = 0;
};

}  // namespace jounce::profiles_detail
