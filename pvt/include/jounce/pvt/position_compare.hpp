// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Condition under which an output fires: modes of LS_HighSpeedCmp with their codes (PMC600 manual
/// 9.3).
enum class CompareMode : std::uint8_t {
  equal = 1,       ///< at the position; the output then stays on
  less = 2,        ///< at or below the position; the output then stays on
  greater = 3,     ///< at or above the position; the output then stays on
  fifo_time = 4,   ///< at each position of a list, for the time `pulse`
  linear = 5,      ///< like fifo_time, for positions of equal spacing: see evenly()
  fifo_level = 6,  ///< at each position of a list, the output takes the level of the point
};

/// A position at which the output fires. u is the axis' unit.
struct ComparePoint {
  double position = 0;  ///< u
  bool level = true;    ///< for fifo_level: new level of the output
};

/// Position compare of one axis: triggers a camera, a laser or a valve at positions of the axis.
///
///     PositionCompare camera{.mode = CompareMode::linear,
///                            .points = evenly(2000, 2000, 5),   // 2000, 4000 ... 10000
///                            .pulse = 0.5e-3};
///     Compared shots = compared(camera, move);                  // exact instants
///     Report report = check(camera, move, {.sampling_frequency = 16e3});
///
/// **Order.** The points of a list fire in their order only. Each point arms the next one, so a
/// point that the axis does not pass blocks all later points (PMC600 manual 9.3). A point fires
/// when the axis reaches or touches it, in either direction (to rounding). It fires at once if the
/// axis is already at the point. Pulses that overlap become one pulse. Positions (u) refer to the
/// setpoint.
struct PositionCompare {
  CompareMode mode = CompareMode::fifo_time;
  /// One point for equal, less and greater; otherwise a list.
  std::vector<ComparePoint> points = {};
  double pulse = 0;  ///< s, > 0; for fifo_time and linear only
};

/// Throws InputError, with keys that count from 1 ("points[3].position"), in these cases: no point,
/// or several points in a mode with one point; a number that is not finite; a pulse that is
/// missing, or given in a mode without pulses.
void require_valid(const PositionCompare& compare);

/// Returns `count` positions start + i * increment (PMC600 SetLinearPara). Rounding does not
/// accumulate. A count of 0 gives one position, as in the PMC600. Throws InputError for an
/// increment of 0 if there is more than one position, and for numbers that are not finite.
std::vector<ComparePoint> evenly(double start, double increment, std::size_t count);

/// A point that has fired.
struct CompareEvent {
  double time = 0;        ///< s, when it fired
  std::size_t point = 0;  ///< index of the point, from 0
  double position = 0;    ///< u, position of the point
  double velocity = 0;    ///< u/s, velocity of the axis at that time
};

/// A change of the output.
struct OutputEdge {
  double time = 0;      ///< s
  bool on = false;      ///< true: the output goes on
  double position = 0;  ///< u, where the output changes; at a point, its given position
};

/// Result of compared().
struct Compared {
  std::vector<CompareEvent> events = {};  ///< in order of time
  /// The output is off at first; the last pulse may end after the motion.
  std::vector<OutputEdge> edges = {};
};

/// Returns the points that fire during a known motion. Crossings are exact roots, not samples:
/// exact to the rounding of the position. Throws InputError for a motion that repeats without end,
/// and like require_valid().
Compared compared(const PositionCompare& compare, const Trajectory& motion);

/// Properties of the hardware that compares.
struct CompareDevice {
  double sampling_frequency = 0;  ///< Hz, sampling rate of the compared position; 0: continuous
  double latency = 0;             ///< s, >= 0: delay from the crossing to the output
};

/// Reports conditions under which the hardware would fail. Rules:
/// - "compare/speed" (broken): within one sample the axis covers the whole distance between two
///   points, so the hardware can miss a point. Required: speed < distance * sampling_frequency
///   (HMPL manual 12.1).
/// - "compare/missed" (broken): points that never fire.
/// - "compare/merged" (warning): pulses that overlap.
/// - "compare/latency" (note): distance that the axis covers during one sample and the latency
///   together.
/// `unit`: unit of the positions in the advice; "": none.
Report check(const PositionCompare& compare, const Trajectory& motion, const CompareDevice& device,
             const std::string& unit = {});

/// Position compare in a plane: a point fires when both axes are within a band around the point
/// (PMC600 manual 9.4).
struct PlaneCompare {
  struct Point {
    double x = 0, y = 0;  ///< u
    int output = 1;       ///< number of the output
  };
  double x_band = 0;  ///< u, > 0: half of the band's width
  double y_band = 0;  ///< u, > 0: half of the band's width
  /// True (mode 1): a point fires when, inside the band, one axis is exactly at the point. False: a
  /// point fires when the axes enter the band.
  bool equal = false;
  std::vector<Point> points = {};  ///< in the order in which they fire
  double pulse = 0;                ///< s, > 0: duration of the output
};

/// Returns the points that fire, in their order. `position` and `velocity` of an event belong to
/// the axis x. Requires motions over the same interval.
std::vector<CompareEvent> compared(const PlaneCompare& compare, const Trajectory& x,
                                   const Trajectory& y);

/// Reports points that never fire: "compare/missed" (broken). `unit`: unit of the positions.
Report check(const PlaneCompare& compare, const Trajectory& x, const Trajectory& y,
             const std::string& unit = {});

/// The position trigger of HIWIN HIMC, with the names of the HMPL manual (12.1).
namespace himc {

/// Returns the position compare for positions of equal spacing: SetPT_StartPos, EndPos, Interval,
/// PulseWidth. If start is above end, positions descend. Both start and end fire if their distance
/// is a whole number of intervals (to 1e-9 of an interval). At most 1e7 positions. pulse_width is
/// in ns, 20 to 80000 in steps of 20. Throws InputError with these names as keys.
PositionCompare position_trigger(double start, double end, double interval, int pulse_width);

/// Returns the position compare for given positions: SetPT_PosArray, StateArray (one bit for each
/// position), StartIndex, EndIndex (from 0). If start_index is above end_index, the positions fire
/// in the order of an axis that travels backwards. At most 256 positions. Throws InputError with
/// these names as keys.
PositionCompare random_trigger(std::span<const double> positions, const std::vector<bool>& states,
                               std::size_t start_index, std::size_t end_index);

}  // namespace himc

}  // namespace jounce
