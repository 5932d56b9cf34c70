// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Cam switches (tappets, programmable limit switches): output bits that are on over ranges of an
/// axis' position. The names are the names in PLCopen's MC_DigitalCamSwitch.
///
///     CamSwitchSpec glue{
///         .switches = {{.track = 1, .first_on_position = 30, .last_on_position = 80},
///                     {.track = 2, .first_on_position = 350, .last_on_position = 10}},
///         .tracks = {{.track = 1, .on_compensation = -0.004}},  // 4 ms early
///         .period = 360};
///     SwitchTimes edges = switch_times(glue, master);   // all edges of a given motion, exact
///     CamSwitches bits(glue);                           // cycle by cycle: cam_switches.hpp
///
/// **Vocabulary.** A *track* is one output. A *switch* belongs to a track and has a range of
/// positions; the output is on while one of the track's switches is on. The *range* is closed,
/// [first_on_position, last_on_position]: an axis that stops on a boundary is in the range (to
/// rounding, 1e-12 of the positions). On a rotary axis (`period`), a range whose last position is
/// below its first one crosses the end of the period.
///
/// **Direction.** A switch of one direction is on while the axis is in the range and has last moved
/// in this direction. So a reversal inside the range changes the output.
///
/// **Time mode.** The switch is on for `duration` after the axis passes first_on_position (in the
/// direction of the switch). Each further passage restarts the duration.
///
/// **Compensation** is a time c in s for each edge: negative for early, positive for late, as in
/// PLCopen. The edge at position p occurs when the position x and the velocity v of the axis
/// satisfy
///
///     (1)  x(t) - c v(t) = p,
///
/// that is, at the time c after the axis would pass p at its present velocity, as in common
/// controllers. At constant velocity, the time of the edge is exact; at an acceleration a, its
/// error is c^2 a / (2 v). For an axis that moves forwards, the lower boundary of the range is the
/// on edge and the upper one the off edge; for an axis that moves backwards, they are exchanged. On
/// edges and off edges have separate values of c. If compensation places the off edge before the on
/// edge, the switch stays off; it never stays on.
///
/// **Hysteresis** is a distance h in the unit of the position. After an edge at p, no further edge
/// occurs at p until the axis has left the interval from p - h to p + h. If the axis leaves on the
/// side from which it came, the reverse edge occurs at that moment. So the first edge is never
/// late, and an oscillating axis does not make the output chatter. A reversal changes the direction
/// of the axis when the axis has moved back by more than h.
///
/// Positions are in the axis' unit u, times in s. All edges are computed, not sampled.

/// Direction in which a switch works.
enum class AxisDirection : std::uint8_t { both, positive, negative };
/// Condition of a switch: a range of positions, or a duration after a position.
enum class CamSwitchMode : std::uint8_t { position, time };

/// The position that the switches of an axis use.
enum class SwitchesOf : std::uint8_t {
  position,  ///< position of the axis, u
  master,    ///< position of the axis' master, in the master's unit
  actual,    ///< actual position of its drive, u
};

/// One range of a track: an entry of PLCopen's MC_CAMSWITCH_REF.
struct CamSwitch {
  int track = 1;                                       ///< 1 to 32
  double first_on_position = 0;                        ///< u; start of the range
  std::optional<double> last_on_position = {};         ///< u; end of the range, in position mode
  AxisDirection axis_direction = AxisDirection::both;  ///< direction in which the switch works
  CamSwitchMode mode = CamSwitchMode::position;
  std::optional<double> duration = {};  ///< s, > 0; in time mode
};

/// Options of one track: an entry of PLCopen's MC_TRACK_REF. Two options are added: the inversion,
/// and the initial value of SMC_GetTappetValue (PMC600 manual 6.2).
struct SwitchTrack {
  int track = 1;                ///< 1 to 32
  double on_compensation = 0;   ///< s; negative: early
  double off_compensation = 0;  ///< s; negative: early
  double hysteresis = 0;        ///< u, >= 0
  bool inverted = false;        ///< true: the output is inverted
  /// Bit of the track in EnableMask. The output of a disabled track is off, even if inverted.
  bool enabled = true;
  /// The output while its state is unknown: before the first position; and, for a switch that works
  /// in one direction, while the axis is in its range and has not moved yet.
  bool initial = false;
};

/// All switches of one axis. A track without an entry in `tracks` has the default options.
struct CamSwitchSpec {
  static constexpr int most_tracks = 32;  ///< greatest number of tracks

  std::vector<CamSwitch> switches = {};
  std::vector<SwitchTrack> tracks = {};  ///< options of tracks
  std::optional<double> period = {};  ///< u, > 0: period of a rotary axis; omitted: a linear axis

  /// Returns the options of a track: its entry, or the defaults.
  [[nodiscard]] SwitchTrack options(int track) const;
};

/// Throws InputError unless all of these rules hold. The key names the entry, counted from 1
/// ("switch[2].track"). Numbers in parentheses are errors of the PMC600.
/// - A track is 1 to 32 (601), and has at most one entry of options. A track with options has at
///   least one switch (600).
/// - All numbers are finite, `period` is greater than 0, a hysteresis is at least 0.
/// - Position mode: last_on_position is given, duration is not. The last position is above the
///   first one; on a rotary axis, it may be anywhere else within one period of the first one.
/// - Time mode: duration is given, last_on_position is not. The compensations leave some of the
///   duration: duration + off_compensation - on_compensation > 0.
/// - The hysteresis is less than each range of its track, less than half a period and, on a rotary
///   axis, less than the gap between the ends of a range.
void require_valid(const CamSwitchSpec& spec);

/// The switches of an axis, and the position that they use.
struct AxisSwitches {
  SwitchesOf of = SwitchesOf::position;  ///< position that the switches use
  CamSwitchSpec table = {};              ///< the switches
};

/// A change of an output.
struct SwitchEdge {
  double time = 0;  ///< s
  int track = 1;    ///< 1 to 32
  bool on = false;  ///< true: the output goes on
};

/// All edges of a motion, in ascending order of time.
struct SwitchTimes {
  std::uint32_t outputs = 0;           ///< outputs at the start: bit k - 1 is track k
  std::vector<SwitchEdge> edges = {};  ///< ascending in time
};

/// Returns the edges of a given motion over its interval, at the exact instants that satisfy (1).
/// `position` is the motion of the position that the switches use: the position of a master, or the
/// position of a slave, composed(cam, master). A track that goes on and off at the same instant has
/// no edge at that instant. Throws InputError like require_valid().
SwitchTimes switch_times(const CamSwitchSpec& spec, const Trajectory& position);

/// Returns the word of the spec: "both", "positive", "negative"; "position", "time".
const char* name(AxisDirection direction);
const char* name(CamSwitchMode mode);

}  // namespace jounce
