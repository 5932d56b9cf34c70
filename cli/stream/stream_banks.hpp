// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "cli/common/input.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {

/// Two tables as the banks of a static queue: the first is played once, then the second
/// `loops` times.
struct BankOptions {
  std::string first, second;  ///< specs or tables
  std::string axis;           ///< axis of a spec of several axes; may be empty
  std::string to;             ///< name of the executor
  std::int32_t loops = 1;     ///< loops of the second
  bool relative = false;      ///< from where the axis stands
  LinkOptions link;
  bool json = false;
};

/// A follow spec behind the axis's live master: its tables, passes and event in the banks of a static queue.
struct FollowOptions {
  std::string to;         ///< name of the executor
  bool relative = false;  ///< from where the axis stands
  bool wait = true;       ///< until the slave follows: a master may have to pass a position first
  LinkOptions link;
  bool json = false;
};

/// Until the second one has ended: the exit status. Ctrl-C stops the axis.
int stream_banks(const BankOptions& options);

/// Until the slave follows: the exit status. It goes on without the streamer; Ctrl-C before stops the axis.
int stream_follow(const Input& input, const FollowOptions& options);

}  // namespace jounce::cli
