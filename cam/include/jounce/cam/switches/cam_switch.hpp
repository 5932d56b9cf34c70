// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Cam switches (tappets, programmable limit switches) in the vocabulary of PLCopen's
/// MC_DigitalCamSwitch: output bits that are on over ranges of an axis's position.
///
///     CamSwitchSpec glue{
///         .switches = {{.track = 1, .first_on_position = 30, .last_on_position = 80},
///                     {.track = 2, .first_on_position = 350, .last_on_position = 10}},
///         .tracks = {{.track = 1, .on_compensation = -0.004}},  // 4 ms ahead
///         .period = 360};
///     SwitchTimes edges = switch_times(glue, master);   // for a given motion: every edge, exact
///     CamSwitches bits(glue);                           // tick by tick: cam_switches.hpp
///
/// **Vocabulary.** A *switch* is a range of positions; a *track* is one output, on while one of its
/// switches is. The *range* is closed, [first_on_position, last_on_position]: an axis that stops on
/// a boundary, to rounding (1e-12 of the positions), is in it. On a rotary axis (`period`) a range
/// whose last position lies below its first one passes through the wrap.
///
/// **Direction.** A switch of one direction is on while the axis is in the range and its last
/// motion was in that direction; a reversal inside the range switches it. **Time mode**: on for
/// `duration` from the instant at which the axis passes first_on_position (in that direction); each
/// further passage restarts it.
///
/// **Compensation** c (s; < 0 leads, > 0 lags, as in PLCopen) of an edge at position p: the edge
/// occurs when
///
///     (1)  x(t) - c v(t) = p,
///
/// which is c after the crossing at the present velocity, as in common controllers: exact at
/// constant velocity, with an error of c^2 a / (2 v) at an acceleration a. The lower boundary is an
/// on edge for an axis that moves forwards and an off edge backwards; each has its own c. The on
/// edge of one boundary and the off edge of the other, both from (1), are combined as levels: if
/// they overtake one another, the switch stays off and never gets stuck.
///
/// **Hysteresis** h (in the unit of the position): after an edge at p, no edge at p until the axis
/// has left p - h to p + h. If it leaves on the side opposite to the edge, the reverse edge follows
/// there. A first edge is therefore never late, and an oscillating axis does not chatter. A
/// reversal changes the direction once the axis has moved back by more than h.
///
/// Positions in the axis's unit u, times in s. Nothing is sampled.
enum class AxisDirection : std::uint8_t { both, positive, negative };
enum class CamSwitchMode : std::uint8_t { position, time };

/// Position of an axis that the switches use.
enum class SwitchesOf : std::uint8_t {
  position,  ///< its own, u
  master,    ///< that of its master, m
  actual,    ///< actual position of its drive, u
};

/// One range of one track: an entry of PLCopen's MC_CAMSWITCH_REF.
struct CamSwitch {
  int track = 1;                                ///< 1 to 32
  double first_on_position = 0;                 ///< u
  std::optional<double> last_on_position = {};  ///< u; in position mode
  AxisDirection axis_direction = AxisDirection::both;
  CamSwitchMode mode = CamSwitchMode::position;
  std::optional<double> duration = {};  ///< s, > 0; in time mode
};

/// The options of one track: an entry of PLCopen's MC_TRACK_REF, inversion, and the initial value
/// of SMC_GetTappetValue (PMC600 manual 6.2).
struct SwitchTrack {
  int track = 1;
  double on_compensation = 0;   ///< s; < 0: ahead
  double off_compensation = 0;  ///< s
  double hysteresis = 0;        ///< u, >= 0
  bool inverted = false;
  bool enabled = true;   ///< its bit of EnableMask; a disabled track is off, inverted or not
  bool initial = false;  ///< the output before it can be computed: before the first position, and
                         ///< in a range of one direction until the axis has moved
};

/// All switches of one axis. A track without options of its own has the defaults.
struct CamSwitchSpec {
  static constexpr int most_tracks = 32;

  std::vector<CamSwitch> switches = {};
  std::vector<SwitchTrack> tracks = {};
  std::optional<double> period = {};  ///< u, > 0, of a rotary axis: positions repeat

  /// The options of a track, its own or the defaults.
  [[nodiscard]] SwitchTrack options(int track) const;
};

/// Throws InputError unless all hold; the key names the entry, counted from 1 ("switch[2].track").
///   - a track is 1 to 32 (PMC600 errors 601, 602), has its options once, and at least one switch
///     (600): options without a switch are a mistake;
///   - all numbers are finite, `period` is greater than 0, hysteresis at least 0;
///   - position mode has a last_on_position and no duration: above the first one, or on a rotary
///     axis anywhere within one period of it, and not the same;
///   - time mode has a duration and no last_on_position; with the compensations, some of it is
///     left: duration + off_compensation - on_compensation > 0;
///   - the hysteresis is less than each range of its track, than the gap that a rotary axis leaves,
///     and than half a period.
void require_valid(const CamSwitchSpec& spec);

/// The switches of an axis that may follow a master.
struct AxisSwitches {
  SwitchesOf of = SwitchesOf::position;
  CamSwitchSpec table = {};
};

/// A change of one output.
struct SwitchEdge {
  double time = 0;  ///< s
  int track = 1;
  bool on = false;
};

/// Every edge of a motion, ascending in time.
struct SwitchTimes {
  std::uint32_t outputs = 0;  ///< at the start: bit k - 1 is track k
  std::vector<SwitchEdge> edges;
};

/// Returns the edges of a given motion over its interval, with the exact instants at which (1)
/// holds. `position` is the motion of the axis of the switches: of a master, or of a slave as
/// composed(cam, master). An instant at which a track goes on and off again is not an edge. Throws
/// InputError like require_valid.
SwitchTimes switch_times(const CamSwitchSpec& spec, const Trajectory& position);

const char* name(AxisDirection direction);
const char* name(CamSwitchMode mode);

}  // namespace jounce
