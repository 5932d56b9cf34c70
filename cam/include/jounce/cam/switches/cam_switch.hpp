// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Cam switches (tappets, programmable limit switches): output bits that are on over ranges of an
/// axis' position. The names are those of PLCopen's MC_DigitalCamSwitch.
///
///     CamSwitchSpec glue{
///         .switches = {{.track = 1, .first_on_position = 30, .last_on_position = 80},
///                     {.track = 2, .first_on_position = 350, .last_on_position = 10}},
///         .tracks = {{.track = 1, .on_compensation = -0.004}},  // 4 ms early
///         .period = 360};
///     SwitchTimes edges = switch_times(glue, master);   // all edges of a given motion, exact
///     CamSwitches bits(glue);                           // cycle by cycle: cam_switches.hpp
///
/// **Vocabulary.** A *switch* is a range of positions. A *track* is one output, which is on while
/// one of its switches is on. The *range* is closed, [first_on_position, last_on_position]: it
/// contains an axis that stops on a boundary (to rounding, 1e-12 of the positions). On a rotary
/// axis (`period`), a range whose last position is below its first one crosses the end of the
/// period.
///
/// **Direction.** A switch of one direction is on while the axis is in the range and has last moved
/// in this direction; a reversal inside the range changes the output.
///
/// **Time mode.** The switch is on for `duration` after the axis passes first_on_position (in the
/// direction of the switch). Each further passage restarts the duration.
///
/// **Compensation** c of an edge at position p (s; negative: early, positive: late, as in PLCopen).
/// The edge occurs when the position x and the velocity v of the axis satisfy
///
///     (1)  x(t) - c v(t) = p,
///
/// which is c after the crossing at the present velocity, as in common controllers. It is exact at
/// constant velocity; at an acceleration a the error is c^2 a / (2 v). The lower boundary is an on
/// edge for an axis that moves forwards, and an off edge for one that moves backwards; on and off
/// edges have their own c. The on edge of one boundary and the off edge of the other are combined
/// as levels. If the off edge comes first, the switch stays off; it never stays on.
///
/// **Hysteresis** h (in the unit of the position). After an edge at p, there is no further edge at
/// p until the axis has left the interval from p - h to p + h. If it leaves on the side that it
/// came from, the reverse edge occurs there. So a first edge is never late, and an oscillating axis
/// does not make the output chatter. A reversal changes the direction of the axis when it has moved
/// back by more than h.
///
/// Positions are in the axis' unit u, times in s. Nothing is sampled.

/// Direction in which a switch works.
enum class AxisDirection : std::uint8_t { both, positive, negative };
/// Condition of a switch: a range of positions, or a duration after a position.
enum class CamSwitchMode : std::uint8_t { position, time };

/// The position that the switches use.
enum class SwitchesOf : std::uint8_t {
  position,  ///< position of the axis, u
  master,    ///< position of its master, in its unit
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

/// Options of one track: an entry of PLCopen's MC_TRACK_REF, with inversion and with the initial
/// value of SMC_GetTappetValue (PMC600 manual 6.2).
struct SwitchTrack {
  int track = 1;                ///< 1 to 32
  double on_compensation = 0;   ///< s; negative: early
  double off_compensation = 0;  ///< s; negative: early
  double hysteresis = 0;        ///< u, >= 0
  bool inverted = false;        ///< true: the output is inverted
  /// Its bit in EnableMask; the output of a disabled track is off, even if inverted.
  bool enabled = true;
  /// The output before it can be computed: before the first position, and in a range of one
  /// direction until the axis has moved.
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
/// - A track is 1 to 32 (601, 602), has at most one entry of options, and has at least one switch
///   (600).
/// - All numbers are finite, `period` is greater than 0, a hysteresis is at least 0.
/// - Position mode: there is a last_on_position and no duration. It is above the first position or,
///   on a rotary axis, anywhere else within one period of it.
/// - Time mode: there is a duration and no last_on_position. The compensations leave some of the
///   duration: duration + off_compensation - on_compensation > 0.
/// - The hysteresis is less than each range of its track, than the gap between the ends of a range
///   on a rotary axis, and than half a period.
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
  std::uint32_t outputs = 0;      ///< outputs at the start: bit k - 1 is track k
  std::vector<SwitchEdge> edges;  ///< ascending in time
};

/// Returns the edges of a given motion over its interval, at the exact instants that satisfy (1).
/// `position` is the motion of the position that the switches use: that of a master, or of a slave
/// as composed(cam, master). A track that goes on and off at the same instant has no edge there.
/// Throws InputError like require_valid().
SwitchTimes switch_times(const CamSwitchSpec& spec, const Trajectory& position);

/// Returns the word of the spec: "both", "positive", "negative"; "position", "time".
const char* name(AxisDirection direction);
const char* name(CamSwitchMode mode);

}  // namespace jounce
