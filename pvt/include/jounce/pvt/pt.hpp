// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Type of a segment of a PT table, with Googol's codes. The type determines the *rate* in the
/// segment: the velocity of a table over time, or the ratio of a table over a master. P and T are
/// the segment's increments of position and time (or master position). "begin" is the rate at the
/// start of the segment:
///
///     type       begins at                             ends at        rate at its start
///     normal     end rate of the previous segment;     2P/T - begin   continuous
///                0 if it is the first
///     even       P/T                                   P/T            steps, unless it is already P/T
///     stop       2P/T                                  0              steps, unless it is already 2P/T
///     continued  end rate of the previous segment; if  2P/T - begin   continuous
///                first, of the motion before
///
/// Sources: Googol iDEABOX Pro manual 7.4 (PT) and 7.6 (follow mode; only this mode has CONTINUE).
/// The start rate of `stop` follows from the end rate and P.
enum class PtType : std::uint8_t { normal = 0, even = 1, stop = 2, continued = 3 };

/// The end of a segment. Both numbers count from the table's origin (0, 0), which is not a point of
/// the table. u is the unit of the position.
struct PtPoint {
  double x = 0;         ///< s, or m of the master: ascending, the first above 0
  double position = 0;  ///< u
  PtType type = PtType::normal;
};

/// The rates at both ends of a segment, in u per unit of x.
struct PtRate {
  double start = 0;
  double end = 0;
};

/// Returns the curve of a PT table: within a segment, the rate is linear and the position
/// quadratic.
///
///     const std::vector<PtPoint> points{{1024, 1024}, {2048, 3072}, {3072, 4096}};
///     const Trajectory move = pt<OverTime>(points);           // Googol example 7-3
///     const auto rates = pt_rates<OverTime>(points);          // ends at 2, 2 and 0
///     const Report report = check_pt<OverTime>(points);       // finds steps and oscillation
///     const Trajectory five = pt_loops<OverTime>(points, 5);  // each pass begins at the last end
///
/// The position is always continuous. The rate steps where an `even` or a `stop` segment begins,
/// and where a `normal` segment is the first after a motion. The acceleration steps at every point.
/// The curve passes every point exactly, to the rounding of its position. The length of a segment
/// is the difference of the given x, so it loses digits if x is large (1e12).
///
/// **Outside** [0, last x]: `hold` stands still at the end position, for every end rate. `wrap`
/// repeats the positions. `advance` begins the next pass at the end of the previous pass. Every
/// pass begins like the first pass: if the first segment is `normal`, at rest (manual 7.4: "0 for
/// the first").
///
/// **Throws** InputError with the point (counted from 1) if there is no point, a number is not
/// finite, x does not ascend, or `start_rate` is not finite.
///
/// start_rate (u per unit of x) is the initial rate of a first segment of type `continued`; other
/// types ignore it.
template <class Over>
Curve<Over> pt(std::span<const PtPoint> points, double start_rate = 0,
               Extrapolation outside = Extrapolation::refuse);

/// Returns the start and end rate of every segment.
template <class Over>
std::vector<PtRate> pt_rates(std::span<const PtPoint> points, double start_rate = 0);

/// Returns `loops` >= 1 successive passes; each begins at the end of the previous one, in x and in
/// position. A `continued` first segment begins with the end rate of the previous pass; other types
/// begin as in the first pass.
template <class Over>
Curve<Over> pt_loops(std::span<const PtPoint> points, int loops, double start_rate = 0,
                     Extrapolation outside = Extrapolation::refuse);

/// Warns of features that a controller plays without a message, with place and size. No finding is
/// broken. Throws like pt(). Rates below `tolerance` times the greatest rate count as rounding.
/// Rules:
/// - the rules of velocity_steps() in warnings.hpp ("pt/velocity_step", "pt/end_velocity",
///   "pt/wrap"), with an advice for the type of the segment;
/// - "pt/oscillation": four or more normal segments speed up and slow down in turn, because the
///   error of one increment continues with alternating sign. value: the greatest change of the rate
///   within a segment; where: the end of this segment.
template <class Over>
Report check_pt(std::span<const PtPoint> points, double start_rate = 0,
                Extrapolation outside = Extrapolation::refuse, double tolerance = 1e-9);

}  // namespace jounce
