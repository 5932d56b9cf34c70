// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jounce/stream/sender/driver.hpp"

#include "cli/common/input.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {

/// Options of `jounce stream`.
struct StreamVerb {
  std::string file;
  std::string axis;
  std::string to;
  std::string master;
  bool live = false;
  std::string start_at;
  std::string at;
  bool at_next_cut = false;
  bool keep_velocity = false;
  bool no_wait = false;
  LinkOptions link;
  std::vector<std::string> swaps;
  std::string bank;
  std::int32_t loops = 1;
  bool rolling = false;
  bool resume = false;
  bool relative = false;
  std::uint32_t capacity = 4096;
  std::string until = "start";
  double patience = 60;
  bool json = false;
};

/// The stream plan of this input for this executor. Throws InputError for options that do not fit it.
StreamPlan plan_of(const StreamVerb& options, const std::string& executor, Input input);

/// --at: a tick, or so long from now by the status of the executor; -1: the next one.
std::int64_t tick_of(const StreamVerb& options, Link& link, const std::string& executor);

/// Patience, the key, and a Ctrl-C that stops what was armed.
StreamOptions stream_options(const StreamVerb& options, const Link& link);

/// True if it is a follow spec for a live master. One that waits for a place of its master is for
/// nothing else: InputError.
bool is_live_follow(const Input& input, const StreamVerb& options);

/// `--to` with several axes: the exit status.
int stream_group(const StreamVerb& options);

}  // namespace jounce::cli
