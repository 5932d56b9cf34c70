// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/vibration/vibration.hpp"

namespace jounce {

/// Kind of input shaper. Each leaves nothing (ei: its tolerance) of the mode it is made for; they
/// differ in how far off the mode may lie, and how much longer the motion takes (in damped
/// periods).
enum class ShaperKind {
  zv,  ///< zero vibration: two impulses, half a period; fast, needs the frequency to a few per cent
  zvd,  ///< zero vibration and derivative: three impulses, one period; forgives about 14 %
  ei,   ///< extra insensitive: three impulses, one period; leaves `tolerance`, forgives about 20 %
};

/// HIMC's names (HMPL manual 15.1): NORMAL is type 1, ROBUST type 0. The manual does not define
/// them; the names and their costs suggest these shapers.
inline constexpr ShaperKind himc_normal = ShaperKind::zv;
inline constexpr ShaperKind himc_robust = ShaperKind::zvd;

struct ShaperSpec {
  ShaperKind kind = ShaperKind::zv;
  Mode mode;
  double tolerance = 0.05;  ///< ei only: the share of vibration left at the mode, 0 < V < 1
};

/// The impulses of a shaper, ascending from time 0, all positive, adding up to 1.
///
///     const std::vector<Impulse> zv = shaper({ShaperKind::zv, {5.5, 0.03}});  // Hz, damping
///     const Trajectory quiet = shaped(move, zv);
///     const double left = residual_vibration(quiet, {5.5, 0.03});      // 0, to rounding
///
/// Sources: Smith 1957 (zv), Singer & Seering 1990 (zvd), Singhose, Seering & Singer 1994 (ei). For
/// a damped mode ei has the weights of the undamped one scaled by the mode's decay: exactly
/// `tolerance` is left at the mode; at the neighboring frequencies where the undamped shaper leaves
/// nothing, little is left. Throws InputError for a mode or tolerance out of range, and if damping
/// alone leaves less than the tolerance (ei).
std::vector<Impulse> shaper(const ShaperSpec& spec);

/// Two shapers one after the other: for two modes, or a more robust one of the same mode. Throws
/// InputError like `require_valid`.
std::vector<Impulse> convolved(std::span<const Impulse> a, std::span<const Impulse> b);

/// The curve through a shaper: the sum of its copies, each delayed and scaled by an impulse. Exact;
/// longer by the last impulse's time. f must begin and end at rest, and the axis rests before and
/// after (even if f refuses); a wrapping curve is shaped through its seam. If all impulses are
/// positive, limits that hold for f hold for the result.
///
/// Throws InputError if there is no impulse, times do not ascend from 0 or amplitudes do not add up
/// to 1, the last comes later than 10000 lengths of f, f begins or ends moving (a jog: append the
/// stop first; a delayed copy would stop in zero time), and if one piece would need more than three
/// sines.
Trajectory shaped(const Trajectory& f, std::span<const Impulse> impulses);

}  // namespace jounce
