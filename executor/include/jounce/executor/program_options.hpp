// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "jounce/path/program_numbers.hpp"

namespace jounce {

struct ExecutorGroup;
struct SentProgram;

/// M words of programs that wait for an acknowledgment.
struct MWordHandshake {
  bool all = false;                         ///< true: all M words wait, except M2 and M30, which
                                            ///< end the program
  std::vector<std::int32_t> numbers = {0};  ///< numbers of the M words that wait
  double timeout = 0;                       ///< greatest time of the wait, s; 0: no limit

  [[nodiscard]] bool waits_at(const ProgramWord& word) const;
};

/// A long program is planned in *windows*: successive parts that overlap. The group changes from
/// one plan to the next within the commands that both contain. So only two plans need memory at a
/// time.
struct PlanWindow {
  std::size_t commands = 16384;  ///< greatest number of commands of a plan; more than `common`
  std::size_t common = 4096;     ///< number of commands that two plans have in common
};

/// Divides a program and plans all its stages. The plans of a long program are made again when the
/// group comes to their windows. Throws like planned_program().
std::shared_ptr<const SentProgram> sent_program(LimitedProgram sent, const ExecutorGroup& group,
                                                const std::atomic<bool>* canceled = nullptr);

}  // namespace jounce
