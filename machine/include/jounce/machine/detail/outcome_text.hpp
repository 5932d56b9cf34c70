// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jounce/command/state.hpp"
#include "jounce/machine/detail/command_words.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/sender/row_plan.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"

/// Outcomes of calls to an executor in words and as JSON.
namespace jounce {

/// Returns the reason with the name of the file in place of the word "line": "part.toml:12:
/// x.position = ..." for "line 12: x.position = ...". `reason`: the reason that a group gives for a
/// path from this file.
std::string with_file(const std::string& reason, const std::string& file);

/// Returns the reason of a failed call. If the axis has rejected the call, the text includes the
/// remedy for an order of this kind. `executor` is the name of the axis, `fault` the number of the
/// fault that it has; 0: none.
std::string reason_text(const CallOutcome& outcome, const std::string& executor,
                        CommandKind order = {}, std::int32_t fault = 0);

/// Like reason_text() above, for an order in words. `before`: status of the axis before the order.
/// If an option of the order gave the rejected number, the remedy names this option.
std::string reason_text(const CallOutcome& outcome, const CommandWords& words,
                        const wire::Status& before, const std::string& executor);

/// Returns the answer to an accepted command: "move accepted". `before`: status of the axis before
/// the command. If the axis stays in a fault after `enable`, the text includes the remedy. For a
/// gear in position, the text includes the position of the master at which the gear begins. `note`:
/// the remark of the executor.
std::string accepted_text(const CommandWords& words, const wire::Status& before,
                          const std::string& executor, const std::string& note = {});

/// Returns the state of an axis after a stop: "feeder is at rest: standstill". In error_stop, the
/// text states how to reset the axis.
std::string stopped_text(const std::string& executor, State rest);

/// Hint for an executor that sends no message.
inline constexpr const char* unheard_hint =
    "check that it is running, with the same --url and the same --key";

/// Returns the name of the error and reason_text(); if there was no answer, reason_text() and
/// `hint`.
std::string error_text(const CallOutcome& outcome, const std::string& executor,
                       const std::string& hint = unheard_hint);

/// Returns {"ok": ..., "error": ..., "reason": ...}.
std::string outcome_json(const CallOutcome& outcome);
/// Returns outcome_json() with the number of the cause.
std::string command_json(const CallOutcome& outcome);

/// Returns the text, with the remark of its plan (StreamPlan::remark, BankPlan::remark) on a second
/// line.
std::string with_remark(const std::string& text, const std::string& remark);
/// Return the outcome of a stream of tables that has reached its goal, as one line of text and as
/// JSON. `waits` is true if the start was accepted for a later time and the sender has not waited
/// for the start.
std::string stream_text(const StreamOutcome& outcome, const std::string& executor, bool waits);
std::string stream_json(const StreamOutcome& outcome);

/// Return the outcome of a stream of rows, as text and as JSON.
std::string rows_text(const RowOutcome& outcome, const std::string& executor);
std::string rows_json(const RowOutcome& outcome);

/// Returns the state of an axis after a successful stream to a group: "started", or the end of its
/// motion if the sender has `waited` for it.
std::string group_text(const StreamOutcome& outcome, bool waited);

/// Returns a JSON list with the outcome of each axis of a group.
std::string group_json(const std::vector<std::string>& axes,
                       const std::vector<StreamOutcome>& outcomes);

}  // namespace jounce
