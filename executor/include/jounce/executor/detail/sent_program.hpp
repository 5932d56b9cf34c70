// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/executor/program_options.hpp"
#include "jounce/path/point.hpp"

namespace jounce {

/// The rest of a stage after a window.
struct WindowRest {
  std::size_t last = 0;  ///< index of the command after the last one of the window
  double length = 0;     ///< length along the path of all commands from `last` on, u
  double time = 0;       ///< duration of these commands, s
  ProgramPart
      peaks{};  ///< greatest magnitudes from the beginning of the window to the end of the stage
};

/// Commands of a program between two M words that wait. The group begins and ends them at rest.
struct SentStage {
  std::optional<std::int32_t> m_word = {};  ///< M word before it; nullopt: none
  std::size_t first = 0;                    ///< index of its first command
  std::size_t last = 0;                     ///< index of the command after its last one
  std::size_t first_word = 0;               ///< index of its first word, which follows `m_word`
  std::size_t last_word = 0;                ///< index of the word after its last word
  /// The plan of its commands up to `planned`. Null: the stage has no command and no word, or is
  /// planned when it begins.
  std::shared_ptr<const GroupProgram> program = {};
  std::size_t planned = 0;               ///< index of the command after the last one of `program`
  std::vector<WindowRest> windows = {};  ///< empty: one plan contains all commands
};

/// A program that was sent as a whole, divided at the M words that wait.
struct SentProgram {
  LimitedProgram sent = {};
  std::vector<SentStage> stages = {};  ///< at least one; the first has no M word
  PlanWindow window = {};              ///< windows of its plans

  /// Returns the index after the first moving command from `first` on and after the dwells that
  /// follow it; at most `last`.
  [[nodiscard]] std::size_t step_end(std::size_t first, std::size_t last) const;
  /// Returns the index of the command after the window that begins at rest, at the command `first`
  /// of the stage.
  [[nodiscard]] std::size_t window_end(const SentStage& stage, std::size_t first) const;
};

/// A program whose motion is planned already, and in which no M word waits.
std::shared_ptr<const SentProgram> sent_program(LimitedProgram sent, GroupProgram planned);

/// Plans the commands of a stage from `first` to before `last`, from rest to rest. If none of them
/// moves, the group rests for the time of the dwells, and at least for one cycle. Throws like
/// planned_program().
std::shared_ptr<const GroupProgram> planned_part(const SentProgram& program, const SentStage& stage,
                                                 std::size_t first, std::size_t last,
                                                 const ExecutorGroup& group,
                                                 const std::atomic<bool>* canceled = nullptr);

/// Returns the first motion of a program: its first stage or, in single step, its first command.
/// `last` receives the number of the command after it.
std::shared_ptr<const GroupProgram> first_motion(const SentProgram& program, bool single_step,
                                                 const ExecutorGroup& group, std::size_t& last);

}  // namespace jounce
