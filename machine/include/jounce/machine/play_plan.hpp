// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/stream/sender/banks.hpp"
#include "jounce/stream/sender/row_sender.hpp"
#include "jounce/stream/sender/stream_plan.hpp"

/// Makes the plans of a streamer from the inputs of a design: whole tables, rows of one long table,
/// two banks.
namespace jounce {

/// The way in which an axis plays an input.
struct PlayOptions {
  bool live = false;  ///< it follows the live master of the axis
  std::optional<TableFile> master =
      {};  ///< table of the master over time; nullopt: [master] of the spec
  bool at_next_cut =
      false;  ///< live: begins at the end of the present pass, wherever the master is then
  bool keep_velocity =
      false;  ///< live: keeps the velocity at the end of the cam instead of braking
};

/// The plan that plays this input alone.
StreamPlan stream_plan(const std::string& executor, const Input& input, const PlayOptions& options);

/// Adds an input that continues in motion at the end of the one before.
void add_swap(StreamPlan& plan, const Input& input, const PlayOptions& options);

/// True for a follow spec: an axis plays it from two banks behind its live master (follow_bank_plan()).
bool is_follow(const Input& input);
/// The position of the live master at which a follow spec begins; nullopt: it has none.
std::optional<double> pass_position(const Input& input);

/// The tables, passes and event of a follow spec in two banks. `relative`: from the position of the axis.
BankPlan follow_bank_plan(const Input& input, bool relative);

/// The table of an input as a bank: over a master unchanged, over time in seconds.
TableFile bank_of(const Input& input);
/// True if both banks are over the same quantity, in the same units.
bool fit_in_one_queue(const TableFile& first, const TableFile& second);
/// The first bank once, then the second `loops` times.
BankPlan bank_plan(const TableFile& first, const TableFile& second, std::int32_t loops,
                   bool relative);

/// The rows of a table over time, in seconds. The queue starts with `ahead` rows and holds twice as many.
RowPlan row_plan(const std::string& executor, TableFile table, std::uint32_t ahead, bool relative);

/// The axes of a file for these executors: its only axis for all of them; otherwise each gets the
/// axis of its name, or the one in its place if there are as many. `path` is the name of the file.
/// Throws InputError (key "to").
std::vector<Input> inputs_for(const std::vector<std::string>& executors,
                              const std::vector<Input>& axes, const std::string& path);

}  // namespace jounce
