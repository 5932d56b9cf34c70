// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jounce/stream/sender/banks.hpp"
#include "jounce/stream/sender/stream_group.hpp"

#include "cli/machine/link.hpp"

namespace jounce::cli {

/// Options of `jounce stream`.
struct StreamArguments {
  std::string file;
  std::string axis, machine;
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

/// Each kind of stream returns its exit status. Throws InputError for options that do not fit it.
int stream_table(
    const StreamArguments& options);  ///< whole tables, or a follow spec behind a live master
int stream_group(const StreamArguments& options);    ///< --to with several names
int stream_rolling(const StreamArguments& options);  ///< --rolling
int stream_banks(const StreamArguments& options);    ///< --bank

/// Plays two banks, and prints "WHAT at NAME: END".
int play(const BankPlan& plan, const StreamArguments& options, BankOptions::Until until,
         const std::string& what, const std::string& end);

}  // namespace jounce::cli
