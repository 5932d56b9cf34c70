// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/coupling/passing.hpp"

namespace jounce {

/// Start event of a follow table. The values are Googol's codes (manual 7.6, GT_SetFollowEvent).
enum class FollowEvent : std::uint8_t {
  start = 1,  ///< no event: following begins with the start command
  pass = 2,   ///< following begins when the master passes a position
};

/// The event at which a slave begins to follow. The travel of the master counts from the event.
///
///     const FollowStart pass{FollowEvent::pass, 50000};
///     const auto t = begin_of(pass, master, 0);                    // Googol example 7-7: 1.025 s
///     if (t) const Followed slave = followed_from(follow(spec).cam, master, *t, 0);
///
/// `position` is absolute (m). The master *passes* the position when it leaves the position in
/// `direction`, after it was before the position or on it. If the master is already beyond the
/// position, the slave waits until the master returns and passes the position again. u is the
/// slave's unit, m the master's.
struct FollowStart {
  FollowEvent event = FollowEvent::start;
  double position = 0;  ///< m
  int direction = 1;    ///< masterDir: 1 or -1
};

/// Throws InputError if the position is not finite, or the direction is neither 1 nor -1.
void require_valid(const FollowStart& start);

/// Returns the exact time (s), not before `armed` (s), at which following begins; without an event:
/// `armed`. Returns nullopt if the master does not pass the position before its motion ends. For a
/// periodic master, only its first period is searched.
std::optional<double> begin_of(const FollowStart& start, const Trajectory& master, double armed);

/// Returns the master at the start of following, if the start lies between `before` and `now`;
/// otherwise nullopt. Without an event, returns `now`. If the master is on the position in `before`
/// and beyond it in `now`, returns `before`. For use in each cycle: the function has no memory and
/// does not allocate. Between the cycles, the master is assumed to move as in passing.hpp.
std::optional<Sample> begin_of(const FollowStart& start, const Sample& before, const Sample& now);

/// Returns the motion of the slave over time from t (s) on. The motion begins at t, with the slave
/// at `slave` (u); the start of the cam is shifted to the master's position at t. Throws like
/// Followed, and InputError "t" if t is before the start of the master's motion or not before its
/// end.
Followed followed_from(const Cam& cam, const Trajectory& master, double t, double slave);

}  // namespace jounce
