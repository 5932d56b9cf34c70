// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "jounce/path/group_limits.hpp"
#include "jounce/path/program.hpp"

namespace jounce {

/// A word of a program that moves no axis: an M word, or the switching of an output (an H word).
struct ProgramWord {
  static constexpr std::int32_t most_outputs = 32;     ///< greatest number of an output
  static constexpr std::int32_t most_m_word = 999999;  ///< greatest number of an M word

  enum class Kind : std::uint8_t { m_word, output };
  Kind kind = Kind::m_word;
  /// M word: its number, 0 or more. Output: its number from 1 on; negative: it is switched off.
  std::int32_t number = 0;
  std::int32_t line = 0;    ///< source line
  std::size_t command = 0;  ///< number of commands before it

  bool operator==(const ProgramWord&) const = default;
};

/// A program and the limits within which it is planned.
struct LimitedProgram {
  Program program{1};
  GroupLimits limits = {};  ///< velocity, acceleration and jerk of the axes; limits of the path
  /// Names of the axes, in printable characters; a name may be empty. If the path is for a machine
  /// with joints, the names of its joints follow.
  std::vector<std::string> names = {};
  std::vector<ProgramWord> words = {};  ///< in the order of the commands
  /// Units of the axes, then of the joints, one for each name. If the list is empty, all of them
  /// have the unit of the path.
  std::vector<std::string> units = {};
};

/// Returns a program as a list of finite numbers, for a message or a file. From this list,
/// program_of() makes the same program again, bit for bit. docs/stream-protocol.md describes the
/// numbers. Position limits and the reports of curves (deviation, speed_error) are not in the list.
///
///     const std::vector<double> numbers = numbers_of({program, limits});
///     const LimitedProgram same = program_of(numbers);
std::vector<double> numbers_of(const LimitedProgram& program);

/// Returns the program of a list from numbers_of(). Throws InputError, with the key "numbers[I]" or
/// a key of Program, for a list that is not a program: another version, a number out of range, an
/// arc or a curve that does not begin where the command before it ends.
LimitedProgram program_of(std::span<const double> numbers);

}  // namespace jounce
