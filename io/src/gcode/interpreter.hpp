// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "jounce/io/gcode.hpp"

#include "io/src/gcode/block.hpp"

namespace jounce::io_detail {

/// Executes the blocks of a program. Its state is what the previous blocks have set. Throws
/// InputError with line and column, but without a document.
class GcodeInterpreter {
 public:
  explicit GcodeInterpreter(const GcodeMachine& machine);

  /// Executes a block. Returns false at the end of the program (M2, M30).
  bool execute(const GcodeBlock& block);
  /// Returns the commands of all blocks so far.
  [[nodiscard]] GcodeProgram take();

 private:
  [[nodiscard]] std::size_t axis_of(std::string_view letter) const {
    return letter.size() == 1 ? letters_.find(letter[0]) : std::string::npos;
  }
  /// require_supported() throws for a G number that is not supported, require_known() for such a
  /// letter.
  void require_supported(const GcodeBlock& block) const;
  void require_known(const GcodeBlock& block) const;
  void add_events(const GcodeBlock& block);
  void rest(const GcodeBlock& block);
  /// Returns true after M2 or M30. M0 and M1 come to rest.
  bool stops(const GcodeBlock& block);

  // gcode_modes.cpp: G words and rates.
  /// Sets the unit of the lengths in the program; "": the unit of each axis.
  void set_units(const std::string& length);
  /// Applies the G words. Returns true if the block is a dwell.
  bool set_modes(const GcodeBlock& block);
  void set_mode(const GcodeBlock& block, const GcodeWord& word, int code);
  void set_length(const GcodeBlock& block, const GcodeWord& word, const char* length);
  void set_frame(const GcodeBlock& block, const GcodeWord& word, std::size_t number);
  void set_tolerance(const GcodeBlock& block, const GcodeWord& word);
  void set_rates(const GcodeBlock& block);
  /// Time in which F and FF count lengths, in the time unit of the program.
  [[nodiscard]] double time() const { return machine_.feed_time * machine_.second; }

  // gcode_moves.cpp: lines and arcs.
  void move(const GcodeBlock& block);
  /// The end of a block, in its frame and in the machine.
  struct Target {
    Point part{}, machine{};
  };
  /// Throws if a word moves its axis beyond the position limits.
  void require_inside(const GcodeBlock& block, const GcodeWord& word, std::size_t axis,
                      double position) const;
  [[nodiscard]] Target target(const GcodeBlock& block) const;
  /// Returns feed and corner of the next command. If only axes outside the path move, F counts in
  /// their unit.
  [[nodiscard]] PathSettings settings(const GcodeBlock& block, const Point& to) const;
  void turn(const GcodeBlock& block, const Target& to, const GcodeWord& given);
  /// Returns the error of an arc with its words, and with numbers in the unit of the program.
  [[nodiscard]] InputError in_program(const GcodeBlock& block, Plane plane,
                                      const InputError& error) const;
  /// Returns the center of an arc from I, J and K. A word outside the plane is an error. If these
  /// words are relative, a missing one is 0.
  [[nodiscard]] Point center(const GcodeBlock& block, const Point& from, Plane plane) const;

  const GcodeMachine& machine_;
  GcodeProgram made_;
  std::string letters_;                   ///< letters of the axes
  std::string length_ = {};               ///< unit of the lengths in the program; "": of the axis
  std::array<double, max_axes> scale_{};  ///< unit of the axis divided by the unit of its word
  Frame frame_{};
  Point part_{};     ///< position in the frame
  int motion_ = -1;  ///< 0 to 3: G0 to G3; -1: none
  std::string_view plane_ = "XY";
  bool relative_ = false;
  bool center_relative_ = true;
  PathSettings feed_, rapid_, corner_;
  double feed_word_ = 0;
};

constexpr std::string_view gcode_axes = "XYZABCUVW";

/// Returns the factor from the unit of a word to the unit of its axis; 1 if the unit of the axis is
/// not a length.
double gcode_scale(const std::string& from, const std::string& unit);

[[noreturn]] void fail_at(const GcodeBlock& block, const GcodeWord& word, const std::string& rule);
[[noreturn]] void fail_at(const GcodeBlock& block, const std::string& key, const std::string& rule);

}  // namespace jounce::io_detail
