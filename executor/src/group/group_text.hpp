// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "jounce/axis/detail/path_commands.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// The sentence of an error, with units. A coordinate, such as "to[1]", has the name of its axis.
[[nodiscard]] std::string reason_of(const InputError& plain, const ExecutorGroup& group);
/// "12.5 mm": the end of the position range of an axis.
[[nodiscard]] std::string end_of_range(const JogEnd& end, const ExecutorGroup& group);
/// The notice of a jog: where it ends, and why.
[[nodiscard]] std::string text_of(const JogEnd& end, const ExecutorGroup& group);
/// The note on the velocity of the last command: the limits of `space` lower it, or it is that of a
/// follower. Empty: none. `fast`: each axis moves in its own shortest time.
[[nodiscard]] std::string velocity_note(const PathCommands& commands, const GroupSpace& space,
                                        const ExecutorGroup& group, bool fast);
/// "1 command was dropped"
[[nodiscard]] std::string dropped_text(std::size_t commands);

}  // namespace jounce
