// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jounce/path/frame.hpp"
#include "jounce/path/program.hpp"

namespace jounce {

/// Properties of a machine that a G-code program leaves open.
struct GcodeMachine {
  struct Axis {
    std::string name;  ///< one of X Y Z A B C U V W, either case
    std::string unit;  ///< unit of its positions in the Program
    std::optional<double> position_min = {},
                          position_max = {};  ///< limits of the ends of lines and arcs
    double modulo = 0;  ///< > 0: a rotary axis, whose absolute positions it takes the shortest way
  };

  std::vector<Axis> axes;     ///< axes, in the order of the Program
  std::size_t path_axes = 0;  ///< the first ones, whose lengths count; 0: all
  Point start{};              ///< position before the program
  PathSettings
      settings{};  ///< feed of G1, G2 and G3 before an F; corner before G61 or G64; junction
  double rapid = PathSettings::none;                ///< velocity of G0 before an FF, > 0
  std::array<std::optional<Frame>, 6> frames = {};  ///< G54 ... G59; G54 without one: no offset
  double second = 1;                                ///< one second in the Program's unit of time
  double feed_time = 60;                            ///< F and FF count lengths in this time, s
};

/// A word that does not move the axes: M, H, S or T.
struct GcodeEvent {
  std::string word;  ///< "M8", "H3"
  int line = 0;      ///< line of the G-code
};

struct GcodeProgram {
  Program program;
  std::vector<GcodeEvent> events;
};

/// True if the text begins as G-code does: `%`, a comment in parentheses, or a word such as G21 or N10.
bool begins_as_gcode(std::string_view text);

/// A program of DIN 66025 as commands of a path. Each command has the line of its block.
///
/// **Words**: N; G0 and G1 lines; G2 clockwise and G3 counterclockwise arcs and helices, by I, J, K or by R
/// (positive: up to half a turn, negative: more), in the plane of G17, G18 or G19; G4 P dwell in s; G20 in, G21 mm
/// (before either: the unit of each axis); G54 to G59 frames: offsets, with a rotation or without; G61 stop at each
/// corner; G64 P greatest deviation (0: stop), of averaged lines where the machine's settings have Corner::average,
/// of corners otherwise; G90 absolute, G91 relative; G90.1 and G91.1 the same for I, J and K (at first relative); X
/// Y Z A B C U V W positions; F feed and E acceleration of G1 to G3, FF and EF of G0; M, H, S and T as events. M0
/// and M1 rest, M2 and M30 end the program. G40, G49, G80 and G94 switch off what is not supported, so they are
/// accepted. Comments in ( ) and after a semicolon.
///
/// **Units**: F and FF in length per `feed_time`, E and EF in length per s^2; A, B and C in deg.
///
/// **Throws** InputError with document, line and column for everything else: another word or G number, two words
/// of one group, a word without its partner, an axis that the machine lacks, an arc that does not fit,
/// a missing feed, a line or an arc that ends beyond the position limits of an axis.
GcodeProgram parse_gcode(std::string_view text, const std::string& document,
                         const GcodeMachine& machine);

}  // namespace jounce
