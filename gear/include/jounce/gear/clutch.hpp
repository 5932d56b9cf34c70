// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/gear/gear.hpp"

namespace jounce {

/// A change of ratio over a distance of the master, in exact counts: the clutch of a gear that is
/// engaged (from a ratio of 0) or changed on the fly (Googol GT_SetGearRatio with masterSlope, manual
/// 7.5).
///
///     const Clutch clutch(Gear::ratio(0, 1), Gear::ratio(1, 2), 100'000);   // example 7-5
///     Clutch::State state;
///     slave += clutch.advance(state, master_increment);   // cycle by cycle; 25000 in the clutch
///     const Clutch next(clutch.ratio(state), Gear::ratio(2, 1), 5000);      // on the fly
///     state = next.after(clutch, state);
///
/// Let u be the distance of the master since the clutch began, d the length of the clutch, and r0
/// and r1 the ratios:
///
///     (1)  ratio = r0 + (r1 - r0) |u| / d
///     (2)  slave = r0 u + (r1 - r0) u |u| / (2 d),    d (r0 + r1) / 2 in all
///
/// in either direction of the master, and r1 permanently after that. **A master that reverses
/// inside the clutch** takes the slave back along the same path: the ratio falls, is r0 again at
/// the start of the clutch, and rises on the other side. So position and ratio never step, and a
/// trembling master does not make the slave creep. A distance of 0 changes the ratio at once: the
/// slave's velocity steps.
///
/// Exact: no count is lost or gained in any number of cycles; advance() does not allocate. The
/// comments of the constructor and after() state the rounding.
class Clutch {
 public:
  /// Counts are exact if 2 d r q stays below 2^62, q the common denominator of both ratios. `to` is
  /// never rounded. `from` may have any denominator if the clutch takes over from another; if
  /// necessary it is rounded to the nearest ratio with exact counts, within 2^-20 and usually far
  /// closer. Nothing else is rounded: the slave's velocity steps by that share of the master's, its
  /// position does not step, and (2) holds with the rounded ratio. So any number of clutches may
  /// follow each other.
  ///
  /// Throws InputError "distance" (master counts) if it is negative, or too long even with
  /// rounding.
  Clutch(const Gear& from, const Gear& to, std::int64_t distance);

  struct State {
    std::int64_t way = 0;        ///< u, master counts; no longer used once engaged
    std::int64_t remainder = 0;  ///< remainder of a slave count, in parts of this clutch's own
    bool engaged = false;        ///< the new ratio holds
  };

  /// Slave increment for a master increment.
  std::int64_t advance(State& state, std::int64_t master_increment) const;

  /// (1), exactly.
  [[nodiscard]] Gear ratio(const State& state) const;

  /// State in which this clutch takes over from one in any state. The remaining part of a count is
  /// carried over, rounded down to this clutch's own parts.
  [[nodiscard]] State after(const Clutch& before, const State& state) const;

  [[nodiscard]] std::int64_t distance() const { return distance_; }

 private:
  std::int64_t distance_;
  std::int64_t from_, to_;    // ratios * common_
  std::int64_t common_;       // denominator of both ratios
  std::int64_t scale_;        // 2 d, or 1 where d is 0
  std::int64_t denominator_;  // common_ * scale_: the parts of a slave count
};

/// The directions of its master in which a slave follows (Googol GT_PrfGear dir, manual 7.5).
enum class FollowDirection : std::int8_t { both = 0, positive = 1, negative = -1 };

/// Behavior of a one-way slave when its master reverses.
enum class Reversal : std::uint8_t {
  hold,     ///< it stands still, and continues as soon as the master does: a freewheel
  recover,  ///< it stands still until the master has recovered its distance
};

/// Passes those increments of a master that the slave follows; used in front of a gear or a clutch.
///
///     DirectionMask mask{FollowDirection::positive};
///     slave += gear.advance(state, mask.advance(mask_state, master_increment));
///
/// **hold**, the default, never steps: a master reverses through standstill, and so the slave's
/// velocity is 0 when it stops and when it continues. The distance that the master moves back is
/// lost: a master that oscillates makes the slave creep forward. **recover** keeps the phase (the
/// slave follows the furthest position of its master) and does not creep, but its velocity steps
/// when the master passes that position at speed.
struct DirectionMask {
  FollowDirection direction = FollowDirection::both;
  Reversal reversal = Reversal::hold;

  struct State {
    std::int64_t behind = 0;  ///< recover: master counts still to be made good, >= 0
  };
  std::int64_t advance(State& state, std::int64_t master_increment) const;
};

}  // namespace jounce
