// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/vibration/vibration.hpp"

namespace jounce {

/// Kind of input shaper. A shaper removes the vibration of one mode; the kind ei reduces it to a
/// tolerance. The kinds differ in the error of the frequency that they permit, and in the time that
/// they add to the motion. A period is a damped period of the mode.
enum class ShaperKind {
  /// Zero vibration: two impulses, half a period longer; permits an error of the frequency of a few
  /// percent.
  zv,
  /// Zero vibration and derivative: three impulses, one period longer; permits about 14 % error.
  zvd,
  /// Extra insensitive: three impulses, one period longer; permits about 20 % error; leaves
  /// `tolerance`.
  ei,
};

/// The shapers of HIMC (HMPL manual 15.1): NORMAL is type 1, ROBUST is type 0. The manual does not
/// define them; their names and the times they add suggest these kinds.
inline constexpr ShaperKind himc_normal = ShaperKind::zv;
inline constexpr ShaperKind himc_robust = ShaperKind::zvd;

/// Input of shaper().
struct ShaperSpec {
  ShaperKind kind = ShaperKind::zv;
  Mode mode = {};  ///< the mode to suppress
  /// For ei only: share of the vibration that remains at the mode, > 0 and < 1.
  double tolerance = 0.05;
};

/// Returns the impulses of a shaper: ascending from time 0, all positive, with the sum 1.
///
///     const std::vector<Impulse> zv = shaper({ShaperKind::zv, {5.5, 0.03}});  // Hz, damping
///     const Trajectory quiet = shaped(move, zv);
///     const double left = residual_vibration(quiet, {5.5, 0.03});      // 0, to rounding
///
/// Sources: Smith 1957 (zv), Singer & Seering 1990 (zvd), Singhose, Seering & Singer 1994 (ei). For
/// a damped mode, the amplitudes of ei are the amplitudes of the undamped shaper, scaled by the
/// decay of the mode. So exactly `tolerance` remains at the frequency of the mode, and little
/// remains at the two neighboring frequencies where the undamped shaper leaves no vibration.
///
/// Throws InputError for a mode or tolerance out of range; for ei also if the damping of the mode
/// is so strong that no middle impulse > 0 leaves the tolerance.
std::vector<Impulse> shaper(const ShaperSpec& spec);

/// Returns the convolution of two shapers, which suppresses two modes, or one mode with a larger
/// permitted error. Throws InputError like require_valid().
std::vector<Impulse> convolved(std::span<const Impulse> a, std::span<const Impulse> b);

/// Returns f after a shaper: the sum of copies of f, each delayed by the time of an impulse and
/// multiplied by its amplitude. Exact. The result is longer than f by the time of the last impulse.
/// f must begin and end at rest, and counts as at rest outside its interval (even with the policy
/// `refuse`). A periodic curve is shaped across its ends. If all impulses are positive, the result
/// stays within all limits that f satisfies.
///
/// Throws InputError if there is no impulse; if the times do not ascend from 0, or the amplitudes
/// do not have the sum 1; if the last impulse comes later than 10000 lengths of f; if f begins or
/// ends in motion (append the stop first); or if a piece would need more than three sines: a segment
/// holds at most Segment::max_sines = 3 terms. This can happen if f has sines of several frequencies
/// and their copies overlap.
Trajectory shaped(const Trajectory& f, std::span<const Impulse> impulses);

}  // namespace jounce
