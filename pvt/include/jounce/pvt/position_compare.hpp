// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// When an output fires; PMC600's modes of LS_HighSpeedCmp and their codes (manual 9.3).
enum class CompareMode : std::uint8_t {
  equal = 1,       ///< at the position; the output stays on
  less = 2,        ///< at or below it; stays on
  greater = 3,     ///< at or above it; stays on
  fifo_time = 4,   ///< at each position of a list, for `pulse`
  linear = 5,      ///< the same at equal spacing: see evenly()
  fifo_level = 6,  ///< at each position of a list the output takes that point's level
};

struct ComparePoint {
  double position = 0;  ///< u
  bool level = true;    ///< fifo_level: new level of the output
};

/// Position compare of one axis: fires a camera, a laser or a valve at positions of the axis.
///
///     PositionCompare camera{.mode = CompareMode::linear,
///                            .points = evenly(2000, 2000, 5),   // 2000, 4000 ... 10000
///                            .pulse = 0.5e-3};
///     Compared shots = compared(camera, move);                  // exact instants
///     Report report = check(camera, move, {.sampling_frequency = 16e3});
///
/// **Order.** The points of a list fire strictly in their order: each arms the next, and a point
/// that the axis does not pass blocks those after it (PMC600 manual 9.3). A point fires when the
/// axis reaches or touches it, in either direction, to rounding; if the axis is already there, at
/// once. Pulses that overlap merge into one. Positions u are those of the command.
struct PositionCompare {
  CompareMode mode = CompareMode::fifo_time;
  std::vector<ComparePoint> points = {};  ///< equal, less, greater: one
  double pulse = 0;                       ///< s, > 0: fifo_time and linear
};

/// Throws InputError, counting from 1 ("points[3].position"), for no points, or several in a mode
/// with one point, a number that is not finite, and a missing pulse or one in a mode without
/// pulses.
void require_valid(const PositionCompare& compare);

/// `count` >= 1 positions from `start` on (PMC600 SetLinearPara; 0 counts as 1 there and here).
/// Each is start + i * increment: no sum that drifts.
std::vector<ComparePoint> evenly(double start, double increment, std::size_t count);

/// A point that fired.
struct CompareEvent {
  double time = 0;        ///< s
  std::size_t point = 0;  ///< counted from 0
  double position = 0;    ///< u, of the point
  double velocity = 0;    ///< u/s, of the axis then
};

/// A change of the output.
struct OutputEdge {
  double time = 0;  ///< s
  bool on = false;
};

struct Compared {
  std::vector<CompareEvent> events;
  std::vector<OutputEdge>
      edges;  ///< off at first; the end of the last pulse may lie after the motion
};

/// Fires a compare along a known motion. Crossings are isolated, not sampled: exact to the rounding of
/// the position. Throws InputError for a motion that repeats without end, and as require_valid() does.
Compared compared(const PositionCompare& compare, const Trajectory& motion);

/// Limits of the comparing hardware.
struct CompareDevice {
  double sampling_frequency = 0;  ///< Hz, of the position that is compared; 0: continuous
  double latency = 0;             ///< s, >= 0: from the crossing to the output
};

/// Reports places at which it would not work. Broken: "compare/speed": between two points the axis
/// may cover no more than their distance in a sample, speed < distance * sampling_frequency (HMPL
/// manual 12.1), or the device misses one; "compare/missed": points that never fire. Warning:
/// "compare/merged": pulses that overlap. Note: "compare/latency": distance of the axis within
/// sample and latency.
Report check(const PositionCompare& compare, const Trajectory& motion, const CompareDevice& device);

/// Compare in a plane: a point fires when both axes are within a band of it (PMC600 manual 9.4).
struct PlaneCompare {
  struct Point {
    double x = 0, y = 0;  ///< u
    int output = 1;
  };
  double x_band = 0;  ///< u, > 0: half its width
  double y_band = 0;
  bool equal = false;  ///< mode 1: in the zone and one axis at its position; else on entering
  std::vector<Point> points = {};
  double pulse = 0;  ///< s, > 0
};

/// In the order of the points, as above; position and velocity are those along x. The motions are over
/// the same interval.
std::vector<CompareEvent> compared(const PlaneCompare& compare, const Trajectory& x,
                                   const Trajectory& y);

/// "compare/missed", as above.
Report check(const PlaneCompare& compare, const Trajectory& x, const Trajectory& y);

/// HIWIN HIMC position trigger, in the words of HMPL (manual 12.1).
namespace himc {

/// Even spacing: SetPT_StartPos, EndPos, Interval, PulseWidth. Start above end: descending. Both
/// ends fire if they are whole intervals apart (to 1e-9 of one). Pulse width in ns, 20 to 80000 in
/// steps of 20. Throws InputError with those keys.
PositionCompare position_trigger(double start, double end, double interval, int pulse_width);

/// Uneven spacing: SetPT_PosArray, StateArray (one bit per position), StartIndex, EndIndex, from 0;
/// start above end: travelled backwards. At most 256 positions.
PositionCompare random_trigger(std::span<const double> positions, const std::vector<bool>& states,
                               std::size_t start_index, std::size_t end_index);

}  // namespace himc

}  // namespace jounce
