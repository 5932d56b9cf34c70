// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce::profiles_detail {

/// A motion under construction, profile after profile; ends with the state in which the next one begins.
class Sequence {
 public:
  explicit Sequence(const MotionState& start) : state_(start) {}

  [[nodiscard]] const MotionState& state() const { return state_; }
  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] std::vector<Segment> segments() && { return std::move(segments_); }

  /// Appends a profile, planned in the axis' direction (sign 1) or in the mirrored one (-1).
  void add(const Profile& profile, double sign);

  /// Goes on for a time with the velocity reached.
  void hold(double time);

  /// Makes the next profile begin without acceleration: that of a motion of second order is no state.
  void let_go() { state_.acceleration = 0; }

  /// Ends at `time`: drops what is later, or holds on until then. Returns how many of the segments
  /// are still whole.
  std::size_t end_at(double time);

 private:
  void append(const Segment& f);

  std::vector<Segment> segments_;
  std::vector<double> begins_;  ///< begins of each segment, s
  MotionState state_;
  double end_ = 0;
};

}  // namespace jounce::profiles_detail
