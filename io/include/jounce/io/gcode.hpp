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

/// Properties of a machine that a G-code program does not contain.
struct GcodeMachine {
  /// One axis of the machine.
  struct Axis {
    std::string name = {};  ///< one of X Y Z A B C U V W, in upper or lower case
    std::string unit = {};  ///< unit of its positions in the resulting Program
    /// Position limits for the ends of lines and arcs; nullopt: none.
    std::optional<double> position_min = {}, position_max = {};
    /// Length of a turn. > 0: a rotary axis, which takes the shorter way to an absolute position.
    /// 0: a linear axis.
    double modulo = 0;
  };

  std::vector<Axis> axes = {};  ///< axes, in the order of the resulting Program
  /// Number of axes, from the first one, in which the length of the path is measured; 0: all.
  std::size_t path_axes = 0;
  Point start{};  ///< position before the program
  /// Settings before the program changes them: the feed of G1, G2 and G3, the corner (G61, G64),
  /// and the junction.
  PathSettings settings{};
  double rapid = PathSettings::none;  ///< velocity of G0 before the first FF, > 0
  /// Frames G54 to G59; G54 without a frame: no offset.
  std::array<std::optional<Frame>, 6> frames = {};
  double second = 1;      ///< length of one second in the time unit of the resulting Program
  double feed_time = 60;  ///< duration in s to which F and FF refer: 60 for lengths per minute
};

/// A word of the program that moves no axis: M, H, S or T.
struct GcodeEvent {
  std::string word = {};    ///< the word: "M8", "H3"
  int line = 0;             ///< line of the word in the G-code
  std::size_t command = 0;  ///< number of commands of the program before it
  double number = 0;        ///< number after the letter
};

/// Result of parse_gcode().
struct GcodeProgram {
  Program program;                      ///< the commands of the path
  std::vector<GcodeEvent> events = {};  ///< the words that move no axis, in their order
  std::vector<int> rapids = {};         ///< lines with a rapid (G0), ascending
};

/// True if the text begins like G-code: with `%`, a comment in parentheses, or a word such as G21
/// or N10.
bool begins_as_gcode(std::string_view text);

/// Reads a G-code program (DIN 66025) as the commands of a path. The source line of each command is
/// the line of its block.
///
/// **Words**:
/// - G0, G1: lines. G2 (clockwise), G3 (counterclockwise): arcs and helices in the plane of G17,
///   G18 or G19, by I, J, K or by R (positive: up to half a turn, negative: more). G4 P: dwell, s.
/// - G20: inch, G21: mm; before either, the unit of each axis. G90: absolute, G91: relative. G90.1:
///   absolute I, J and K, G91.1: relative ones; before either, I, J and K are relative.
/// - G54 to G59: frames, which are offsets with or without a rotation.
/// - G61: stop at each corner. G61.1: stop at each junction, even at a tangential one. G64 P:
///   greatest deviation; 0: stop; without P: the corner of the settings of the machine, which must
///   not be a stop. P is the deviation of averaged lines if the settings of the machine have
///   Corner::average; otherwise, P is the deviation at corners.
/// - X Y Z A B C U V W: positions. F, E: feed and acceleration of G1 to G3. FF, EF: feed and
///   acceleration of G0.
/// - M, H, S, T: events at the start of the block. M0 and M1 come to rest at the end of the block;
///   M2 and M30 end the program. H may be negative: it switches its output off.
/// - N: line number. O as the first word, alone in its block, or a number after the first %: number of
///   the program. G40, G49, G94 switch off functions that are not supported, and are accepted.
///   G80 ends G0 to G3: the next motion must name one of them. Comments are in ( ) or after a
///   semicolon.
///
/// **Units**: F and FF are lengths per `feed_time`, E and EF lengths per s^2; A, B and C are in
/// deg.
///
/// **Errors**: throws InputError with document, line and column for anything else: another word or
/// G number, two words of one group, a word that requires a missing word, an axis that the machine
/// does not have, an arc that does not fit, a missing feed, and a line or an arc that ends outside
/// the position limits of an axis.
GcodeProgram parse_gcode(std::string_view text, const std::string& document,
                         const GcodeMachine& machine);

}  // namespace jounce
