// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/gear/gear.hpp"

namespace jounce {

/// A clutch in exact counts: it changes the ratio of a gear over a distance of the master. It
/// engages a gear (from the ratio 0), or replaces the ratio of a running gear (Googol
/// GT_SetGearRatio with masterSlope, manual 7.5).
///
///     const Clutch clutch(Gear::ratio(0, 1), Gear::ratio(1, 2), 100'000);   // Googol example 7-5
///     Clutch::State state;
///     slave += clutch.advance(state, master_increment);   // each cycle; 25000 at the clutch's end
///     const Clutch next(clutch.ratio(state), Gear::ratio(2, 1), 5000);    // in flight
///     state = next.after(clutch, state);
///
/// Let u be the distance of the master since the clutch began, d the length of the clutch, and r0
/// and r1 the ratios:
///
///     (1)  ratio = r0 + (r1 - r0) |u| / d
///     (2)  slave = r0 u + (r1 - r0) u |u| / (2 d),    at the end d (r0 + r1) / 2
///
/// for either direction of the master. When the clutch is complete, the ratio is r1 permanently.
///
/// **A master that reverses inside the clutch** makes the slave move back along the same curve. The
/// ratio falls to r0 at the start of the clutch, and rises again on the other side of the start. So
/// position and ratio never step, and a master that trembles does not make the slave creep. With a
/// distance of 0 the ratio changes at once: the velocity of the slave steps.
///
/// Exact: no count is lost or gained in any number of cycles. The constructor and after() describe
/// the rounding. advance() does not allocate.
class Clutch {
 public:
  /// Makes a clutch from one ratio to another over `distance` master counts. Counts are exact if 2
  /// d r q stays below 2^62, where r is the greater ratio and q the common denominator of the two
  /// ratios. `to` is never rounded. `from` may have any denominator; if the clutch replaces another
  /// one, the denominator can be large. If necessary, `from` is rounded to the nearest ratio with
  /// exact counts, within 2^-20 and usually much closer. Then the velocity of the slave steps by
  /// this share of the master's velocity, the position of the slave does not step, and (2) holds
  /// with the rounded ratio. Nothing else is rounded, so any number of clutches may follow one
  /// another.
  ///
  /// Throws InputError "distance" if the distance is negative, or too long even with rounding.
  Clutch(const Gear& from, const Gear& to, std::int64_t distance);

  /// State from cycle to cycle.
  struct State {
    /// u, master counts since the clutch began; not used when the clutch is complete.
    std::int64_t way = 0;
    std::int64_t remainder = 0;  ///< remainder of a slave count, as a multiple of 1/denominator_
    bool engaged = false;        ///< true if the clutch is complete: the ratio is r1
  };

  /// Returns the increment of the slave (counts) for an increment of the master (counts).
  std::int64_t advance(State& state, std::int64_t master_increment) const;

  /// Returns the present ratio by (1), exact.
  [[nodiscard]] Gear ratio(const State& state) const;

  /// Returns the state with which this clutch replaces another clutch in the given state. The
  /// remainder of a count is kept, but rounded down to the resolution of this clutch.
  [[nodiscard]] State after(const Clutch& before, const State& state) const;

  [[nodiscard]] std::int64_t distance() const { return distance_; }  ///< d, master counts

 private:
  std::int64_t distance_;
  std::int64_t from_, to_;    // ratios * common_
  std::int64_t common_;       // denominator of both ratios
  std::int64_t scale_;        // 2 d, or 1 where d is 0
  std::int64_t denominator_;  // common_ * scale_: number of parts of a slave count
};

/// The directions of the master in which a slave follows (Googol GT_PrfGear dir, manual 7.5).
enum class FollowDirection : std::int8_t { both = 0, positive = 1, negative = -1 };

/// Behavior while the master moves against the direction that the slave follows.
enum class Reversal : std::uint8_t {
  /// The slave stands still, and continues as soon as the master moves forwards again, like a
  /// freewheel.
  hold,
  recover,  ///< the slave stands still until the master is back at the position where it reversed
};

/// Selects the increments of a master that the slave follows. Use it in front of a gear or a
/// clutch.
///
///     DirectionMask mask{FollowDirection::positive};
///     slave += gear.advance(state, mask.advance(mask_state, master_increment));
///
/// **hold**, the default, never steps the velocity: a master reverses through standstill, so the
/// slave's velocity is 0 when it stops and when it continues. The distance that the master moves
/// back is lost. So a master that oscillates makes the slave creep forwards.
///
/// **recover** keeps the phase between master and slave, because the slave follows the furthest
/// position of its master. The slave does not creep, but its velocity steps when the master passes
/// the furthest position at speed.
struct DirectionMask {
  FollowDirection direction = FollowDirection::both;  ///< directions that the slave follows
  Reversal reversal = Reversal::hold;  ///< behavior while the master moves against `direction`

  struct State {
    /// For recover: counts from the master to its furthest position, >= 0.
    std::int64_t behind = 0;
  };
  /// Returns the part of the increment (master counts) that the slave follows.
  std::int64_t advance(State& state, std::int64_t master_increment) const;
};

}  // namespace jounce
