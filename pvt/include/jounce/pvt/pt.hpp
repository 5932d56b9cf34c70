// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Effect of a segment of a PT table on the rate (the velocity; over a master, the ratio) of the
/// one before it, with Googol's codes. P and T are the segment's increments of position and of time:
///
///     type       begins at                             ends at        rate at its start
///     normal     end of the segment before;            2P/T - begin   continuous
///                0 where it is the first
///     even       P/T                                   P/T            steps, unless P/T is it
///     stop       2P/T                                  0              steps, unless 2P/T is it
///     continued  end of the segment before; of the     2P/T - begin   continuous
///                motion before where it is the first
///
/// Sources: Googol iDEABOX Pro manual 7.4 (PT) and 7.6 (follow, which alone has CONTINUE). The
/// start of `stop` follows from its end and its area.
enum class PtType : std::uint8_t { normal = 0, even = 1, stop = 2, continued = 3 };

/// The end of a segment: both numbers count from the table's origin (0, 0), which is not a point.
struct PtPoint {
  double x = 0;         ///< time, or master position: ascending, the first above 0
  double position = 0;  ///< u
  PtType type = PtType::normal;
};

/// The rate with which a segment begins and ends, u per unit of x.
struct PtRate {
  double start = 0;
  double end = 0;
};

/// The curve of a PT table: position quadratic, rate linear within a segment.
///
///     const std::vector<PtPoint> points{{1024, 1024}, {2048, 3072}, {3072, 4096}};
///     const Trajectory move = pt<OverTime>(points);           // manual, example 7-3
///     const auto rates = pt_rates<OverTime>(points);          // ends at 2, 2 and 0
///     const Report report = check_pt<OverTime>(points);       // steps and oscillation by name
///     const Trajectory five = pt_loops<OverTime>(points, 5);  // each pass continues from the last
///
/// Position is continuous by construction, the rate except where an `even` or a `stop` begins (or a
/// `normal` that is first in a moving chain); the acceleration steps at every point. Every point is
/// met exactly to the rounding of its own position; lengths are differences of the x given, so a
/// table whose x has grown to 1e12 keeps the resolution that its numbers have.
///
/// **Outside** [0, last x]: hold stands still at the end position, for every end rate; wrap repeats
/// the positions; advance continues from the end of the pass before, and every pass begins like the
/// first one (`normal`: at rest, because it is first again; manual 7.4: "0 for the first").
///
/// **Throws** InputError that names the point (counted from 1) if there is none, a number is not
/// finite, x does not ascend, or `start_rate` is not finite.
///
/// start_rate: initial rate of a `continued` first segment; other types ignore it.
template <class Over>
Curve<Over> pt(std::span<const PtPoint> points, double start_rate = 0,
               Extrapolation outside = Extrapolation::refuse);

/// Start and end rate of every segment.
template <class Over>
std::vector<PtRate> pt_rates(std::span<const PtPoint> points, double start_rate = 0);

/// `loops` >= 1 successive passes, each continuing from the one before in x and in position. A
/// `continued` first segment takes over the end rate of the pass before; any other begins again.
template <class Over>
Curve<Over> pt_loops(std::span<const PtPoint> points, int loops, double start_rate = 0,
                     Extrapolation outside = Extrapolation::refuse);

/// Warnings about features that a controller would play without a message, with place and size:
/// velocity_steps (warnings.hpp: "pt/velocity_step", "pt/end_velocity", "pt/wrap"), with advice by
/// the type of the segment, and
///
///     pt/oscillation   four or more normal segments that speed up and slow down in turn: an error
///                      of an increment is passed on with its sign reversed. value: the greatest
///                      change of the rate within a segment; where: the end of that segment
///
/// Rates below `tolerance` of the greatest are rounding. None is broken. Throws like pt().
template <class Over>
Report check_pt(std::span<const PtPoint> points, double start_rate = 0,
                Extrapolation outside = Extrapolation::refuse, double tolerance = 1e-9);

}  // namespace jounce
