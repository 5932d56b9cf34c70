// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "cli/machine/link.hpp"

namespace jounce::cli {

/// `jounce stream FILE --rolling`: a table that is sent while it plays.
struct RollingOptions {
  std::string file;
  std::string axis;         ///< axis of a file of several; empty: its only one
  std::string to;           ///< executor
  std::uint32_t ahead = 0;  ///< rows to begin with
  bool resume = false;      ///< after the axis had to stop for want of rows
  bool relative = false;    ///< from where the axis stands
  LinkOptions link;
  bool json = false;
};

/// Sends it to its end. The exit status of the verb; throws InputError for a file that is not over time.
int stream_rolling(const RollingOptions& options);

}  // namespace jounce::cli
