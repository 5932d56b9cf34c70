// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/command/commands.hpp"

#include "executor/src/server/command_queue.hpp"

/// Steps that the queue of a group returns, and its server executes.
namespace jounce::group_step {

using Request = CommandQueue::Request;

/// The group must come to rest on its path and end its motion.
struct Halt {};

/// The group must play this program from its beginning. The queue waits for answered().
struct Play {
  std::shared_ptr<const GroupProgram> program;
  Request request;
  std::string notice = {};  ///< text for the operator; empty: none
  /// true: its commands contain limits that are not those of limit()
  bool own_limits = false;
};

/// The group must continue its present path with this program. The queue waits for answered().
struct Extend {
  std::shared_ptr<const GroupProgram> program;
  double position = 0;  ///< length along the path at which the program begins, u
  double shift = 0;     ///< time of the present program at which this one begins, s
  double until = 0;     ///< time of the present program up to which both are equal, s
  Request request;
};

/// The server must set these limits, call limit(), and answer the sender.
struct SetLimits {
  command::GroupSetLimits limits;
  Request request;
  bool continues = false;  ///< true: the commands after it may continue the present motion
};

/// The group rests at an M word, or continues after it. The server must send an event.
struct Announce {
  std::int32_t m_word = 0;
  bool waits = false;       ///< true: the group waits for the acknowledgment
  double timeout = 0;       ///< > 0: no acknowledgment arrived within this time, s
  std::size_t dropped = 0;  ///< commands that were dropped for this reason
};

/// The server must answer the sender: the command is accepted (Cause::none) or rejected.
struct Reply {
  Request request;
  Cause cause = Cause::none;
  std::string reason = {};  ///< empty: the cause suffices
};

/// The server must show this text to the operator.
struct Note {
  std::string text;
};

}  // namespace jounce::group_step

namespace jounce {

/// A step that the server of a group must execute.
using GroupStep =
    std::variant<group_step::Halt, group_step::Play, group_step::Extend, group_step::SetLimits,
                 group_step::Announce, group_step::Note, group_step::Reply>;

}  // namespace jounce
