// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/coupling/passing.hpp"

namespace jounce {

/// Start event of a follow table, with Googol's codes (manual 7.6, GT_SetFollowEvent).
enum class FollowEvent : std::uint8_t {
  start = 1,  ///< no event: it begins at the start command
  pass = 2,   ///< the master passes a position
};

/// When a slave begins to follow, and from which master position on its table counts.
///
///     const FollowStart pass{FollowEvent::pass, 50000};
///     const auto t = begin_of(pass, master, 0);                    // manual, example 7-7: 1025 ms
///     if (t) const Followed slave = followed_from(follow(spec).cam, master, *t, 0);
///
/// `position` is absolute, in the master's unit. The master *passes* it when it leaves it in
/// `direction`, after it came from before it or stood on it. A master that is already beyond has
/// passed: the slave waits until it comes back and passes again.
struct FollowStart {
  FollowEvent event = FollowEvent::start;
  double position = 0;
  int direction = 1;  ///< masterDir: 1 or -1
};

/// Throws InputError for a position that is not finite and a direction other than 1 and -1.
void require_valid(const FollowStart& start);

/// Returns the exact time at or after `armed` at which following begins; nullopt if the master does
/// not pass before its motion ends. For a periodic master, its first period is searched.
std::optional<double> begin_of(const FollowStart& start, const Trajectory& master, double armed);

/// The same cycle by cycle, without memory or allocation: whether following begins after `before`
/// and not after `now`, and the master then; between the cycles as passing.hpp.
std::optional<Sample> begin_of(const FollowStart& start, const Sample& before, const Sample& now);

/// The slave over time from t on, when it stands at `slave`: the start of the cam is shifted to the
/// master's position at t. Throws like Followed, and if t is not before the end of the master's
/// motion.
Followed followed_from(const Cam& cam, const Trajectory& master, double t, double slave);

}  // namespace jounce
