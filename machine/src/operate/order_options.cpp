// SPDX-License-Identifier: Apache-2.0
#include "machine/src/operate/order_options.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

namespace jounce {
namespace {

using As = OptionForm;

constexpr FieldRange percent_to_200{
    .least = 0, .most = 2, .words = "from 0% to 200%, or from 0 to 2"};
constexpr FieldRange percent_to_100{
    .least = 0,
    .most = 1,
    .not_zero = true,
    .words = "more than 0% and at most 100%, or more than 0 and at most 1"};
constexpr FieldRange home_method{.least = 1,
                                 .most = 37,
                                 .whole = true,
                                 .words = "1 to 14, 17 to 30, 33, 34, 35 or 37 (CiA 402)"};
constexpr FieldRange piece_length{.least = 0, .not_zero = true, .words = "greater than 0"};
constexpr FieldRange captures{.least = 0,
                              .most = 1e9,
                              .whole = true,
                              .words =
                                  "a whole number from 0 to 1e9; 0: capture until "
                                  "abort-trigger"};
constexpr FieldRange extra_turns{.least = 0,
                                 .most = command::most_extra_turns,
                                 .whole = true,
                                 .words = "a whole number from 0 to 1000"};

static_assert(command::most_extra_turns == 1000);

constexpr FieldOption option_table[] = {
    {"set_position", "position", value_word, As::number},
    {"home", "offset", "offset", As::number,
     "home: position that the axis has at its home position. Default of all options of home: "
     "[homing] in the spec of the axis"},
    {"home", "distance", "distance", As::number,
     "home: end with a fault if one search goes further than this"},
    {"move_absolute", "position", "to", As::number, "Move to this position"},
    {"move_absolute", "direction", "direction", As::direction,
     "With --to: shortest, positive, negative; a linear axis rejects a target in the other "
     "direction"},
    {"move_relative", "distance", "by", As::number,
     "Move by this distance from the commanded position"},
    {"move_additive", "distance", "add", As::number,
     "Move by this distance from the end position of the present motion"},
    {"move_superimposed", "distance", "on-top", As::number,
     "Superimpose a move by this distance on the present motion"},
    {"move_velocity", "velocity", value_word, As::number},
    {"move_repetitive", "position", "to", As::number, "Move to this position"},
    {"change_velocity", "velocity", value_word, As::number},
    {"change_velocity", "position", "past", As::number,
     "change-velocity: change it when the setpoint passes this position; default: at once"},
    {"change_velocity", "direction", "direction", As::direction,
     "With --past: only if the axis passes the position in this direction"},
    {"cut", "position", "position", As::number,
     "cut: add a cut at this position of the web. Without --length, --position and --waste: at the "
     "next possible position"},
    {"group_jog", "direction", "along", As::coordinates,
     "jog of a group: in this direction, such as 1,0"},
    {"group_m_word", "M word", value_word, As::whole},

    {"", "velocity", "velocity", As::number,
     "Greatest velocity of the move. This option and the next three default to the limits of the "
     "axis"},
    {"", "velocity difference", "velocity", As::number,
     "Greatest velocity of the move. This option and the next three default to the limits of the "
     "axis"},
    {"", "acceleration", "acceleration", As::number,
     "Acceleration of the move, such as 2000mm/s^2"},
    {"", "deceleration", "deceleration", As::number,
     "Deceleration of the move, such as 2000mm/s^2"},
    {"", "jerk", "jerk", As::number, "Jerk of the move, such as 20000mm/s^3"},
    {"", "buffer mode", "blend", As::blend,
     "move --to, --by, jog, and moves of a group: pass the target of the present move without a "
     "stop, at the velocity of low (the slower of the two moves), previous (the present move), "
     "next "
     "(this move) or high (the faster of the two moves); look-ahead (group: the highest velocity "
     "within the limits)"},
    {"", "hold to run", "hold-to-run", As::flag,
     "jog: move only while this command runs. The axis stops when the command ends, or sends no "
     "heartbeat for 0.2 s"},
    {"", "relative", "relative", As::flag, "set-position: the value is an offset"},
    {"", "method", "method", As::whole, "home: method of CiA 402", home_method},
    {"", "search velocity", "search-velocity", As::number,
     "home: velocity of the search for a switch"},
    {"", "index velocity", "index-velocity", As::number,
     "home: velocity of the search for the edge of the switch and the index"},
    {"", "timeout", "timeout", As::number,
     "home: end with a fault after this time, such as 30s; m-word: without an acknowledge in this "
     "time, drop the commands that follow; default of m-word: no limit"},
    {"", "factor", value_word, As::factor, "", percent_to_200},
    {"", "wait", "wait", As::number, "repeat: rest between two strokes, s; default: 0"},
    {"", "strokes", "strokes", As::whole,
     "repeat: end after this number of strokes; default: go on until the order finish or halt"},
    {"", "numerator", value_word, As::ratio},
    {"", "denominator", value_word, As::ratio},
    {"", "clutch", "clutch", As::number,
     "gear-in: change the ratio during this distance of the master, not by a ramp over time",
     ranges::positive, ": leave it out to change the ratio by a ramp over time"},
    {"", "master sync position", "master-sync", As::number,
     "gear-in-pos: master position from which the axis is in step"},
    {"", "slave sync position", "slave-sync", As::number,
     "gear-in-pos: position of the axis at --master-sync"},
    {"", "master start distance", "start-distance", As::number,
     "gear-in-pos: master distance before --master-sync, in which the axis engages", std::nullopt,
     ": the slave needs a distance to reach the ratio"},
    {"", "avoid reversal", "avoid-reversal", As::flag,
     "gear-in-pos: reject a motion against the direction of the gear"},
    {"", "numerator of the second master", "second", As::ratio,
     "combine: ratio to the second master, such as 1:2; negative: subtract its motion"},
    {"", "denominator of the second master", "second", As::ratio},
    {"", "phase shift", "to", As::number, "Move to this position"},
    {"", "change of the phase shift", "by", As::number, "Move by this distance"},
    {"", "length", "length", As::number,
     "cut: length of all pieces that begin at the next cut or later", piece_length},
    {"", "waste", "waste", As::number,
     "cut: length of a piece of waste that begins at the next cut", piece_length},
    {"", "position", "to", As::coordinates, "Move to these coordinates"},
    {"", "distance", "by", As::coordinates, "Move by these distances"},
    {"", "deviation", "deviation", As::number,
     "Commands of a group with --blend: round the corner, at most this far from it"},
    {"", "corner distance", "corner-distance", As::number,
     "Commands of a group with --blend: round the corner, from at most this distance before it to "
     "at most this distance after it"},
    {"", "via", "via", As::coordinates, "move-circular: through this point"},
    {"", "center", "center", As::coordinates,
     "move-circular: around this point, in the plane of the first two axes"},
    {"", "radius", "radius", As::coordinates,
     "move-circular: with this radius; negative: along the longer arc"},
    {"", "clockwise", "clockwise", As::flag,
     "move-circular: clockwise around --center or with --radius"},
    {"", "turns", "turns", As::whole, "move-circular: additional whole turns", extra_turns},
    {"", "fast", "fast", As::flag,
     "move-direct: each axis moves in its own shortest time, not along a straight line"},
    {"", "duration", value_word, As::number},
    {"", "offset", "offset", As::coordinates,
     "set-coordinate-transform: origin of the part, in coordinates of the machine"},
    {"", "rotation", "rotation", As::number,
     "set-coordinate-transform: rotation of the part about the third axis, deg", std::nullopt, "",
     "deg"},
    {"", "angle", "zyz", As::coordinates,
     "set-coordinate-transform: three rotations, about Z, Y and Z, deg: 30,90,0", std::nullopt, "",
     "deg"},
    {"", "axis", "axis", As::whole,
     "set-limits: number of the axis in the group, from 1; default: along the path"},
    {"", "queued", "queued", As::flag,
     "set-limits: apply to the commands after this one only; default: also to the present motion"},
    {"", "M word", "m-word", As::whole,
     "acknowledge: number of the M word; default: the one that waits"},
    {"", "on", "on", As::flag,
     "single-step: from now on, each command waits for an acknowledge; without --on: it does not"},
    {"", "velocity factor", "velocity-factor", As::factor,
     "set-override: factor of the speed, 0% to 200%; default: 100%", percent_to_200},
    {"", "acceleration factor", "acceleration-factor", As::factor,
     "set-override: share of the accelerations of the axes that the group may use, more than 0% to "
     "100%; default: 100%",
     percent_to_100},
    {"", "jerk factor", "jerk-factor", As::factor,
     "set-override: the same for the jerks; default: 100%", percent_to_100},
    {"", "input", value_word, As::trigger_input},
    {"", "edge", "edge", As::edge,
     "touch-probe: edge of the input: rising (default), falling or both"},
    {"", "count", "count", As::whole,
     "touch-probe: end after this number of captures; default 1; 0: until abort-trigger", captures},
    {"", "first position", "first-position", As::number,
     "touch-probe: capture only from this position on"},
    {"", "last position", "last-position", As::number,
     "touch-probe: capture only up to this position"},
};

}  // namespace

std::span<const FieldOption> field_options() {
  return option_table;
}

const FieldOption& field_option(const CommandInfo& command, const Field& field) {
  const std::string_view name = field.name;
  const auto* const found =
      std::find_if(std::begin(option_table), std::end(option_table), [&](const auto& one) {
        return one.field == name &&
               (*one.command == 0 || one.command == std::string_view(command.name));
      });
  if (found == std::end(option_table))
    throw std::out_of_range(std::string(command.name) + " has no option for " + field.name);
  return *found;
}

}  // namespace jounce
