// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jounce/path/group_limits.hpp"
#include "jounce/path/program.hpp"

namespace jounce {

/// A program and the limits within which it is planned.
struct LimitedProgram {
  Program program{1};
  GroupLimits limits;  ///< velocity, acceleration and jerk of the axes; limits of the path
  /// Names of the axes, printable characters; or empty texts. If the path is for a machine with joints,
  /// the names of its joints follow.
  std::vector<std::string> names = {};
};

/// Returns a program as a list of finite numbers, for a message or a file. program_of() returns the
/// same program from it, bit for bit. docs/stream-protocol.md describes the numbers. Position limits
/// and the reports of curves (deviation, speed_error) are not in the list.
///
///     const std::vector<double> numbers = numbers_of({program, limits});
///     const LimitedProgram same = program_of(numbers);
std::vector<double> numbers_of(const LimitedProgram& program);

/// Throws InputError, with the key "numbers[I]" or a key of Program, for a list that is not a
/// program: another version, a number out of range, an arc or a curve that does not begin where the
/// command before it ends.
LimitedProgram program_of(std::span<const double> numbers);

}  // namespace jounce
