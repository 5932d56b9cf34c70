// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/detail/path_clock.hpp"
#include "jounce/axis/movement.hpp"

namespace jounce {

/// The length along the path of a group since its motion began from rest, for its position compare.
///
///     way.reset();                                     // a motion begins
///     way.pass(path, clock.at(tick));                  // if the path was played in this tick
///     compare.step(way.length(), way.velocity(), dt);
///
/// The functions do not allocate, lock or throw.
class PathWay {
 public:
  void reset() noexcept { *this = {}; }
  /// The path was played up to the path time `now`.
  void pass(const Movement& path, const PathTime& now) noexcept {
    const PathPlace place = path.along(now.s);
    length_ = before_ + place.length;
    velocity_ = place.velocity * now.rate;
    time_ = now.s;
  }
  /// The path continues as this one, whose path time is lower by `shift`.
  void continue_as(const Movement& path, double shift) noexcept {
    time_ -= shift;
    before_ = length_ - path.along(time_).length;
  }
  /// Another path takes over from this one, from its beginning, at the path time `boundary`.
  void leave(const Movement& path, double boundary) noexcept {
    before_ += path.along(boundary).length;
    time_ = 0;
  }

  [[nodiscard]] double length() const noexcept { return length_; }      ///< u
  [[nodiscard]] double velocity() const noexcept { return velocity_; }  ///< u/s

 private:
  double before_ = 0;  // length before the path
  double length_ = 0, velocity_ = 0;
  double time_ = 0;  // path time of the last pass(), s
};

}  // namespace jounce
