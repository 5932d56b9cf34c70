// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jounce/path/plan.hpp"
#include "jounce/path/program.hpp"

namespace jounce {

/// Place and time at which a command of a program begins in its plan.
struct CommandStart {
  double where = 0;  ///< q, length along the path; at a rounded corner, its middle
  double time = 0;   ///< s, after the dwells before the command
};

/// Returns where and when commands begin. `commands`: ascending numbers of commands; the number of
/// all commands stands for the end of the program. The time of a place on the path is exact, except
/// for rounding: it follows from the timing law. In a sequence of averaged lines (Corner::average),
/// the place is the start of the first piece that has the line of the command. The duration of the
/// call is proportional to the length of the program.
std::vector<CommandStart> command_starts(const Program& program, const Plan& plan,
                                         std::span<const std::size_t> commands);

}  // namespace jounce
