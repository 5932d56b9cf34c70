// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/stream/sender/row_sender.hpp"
#include "jounce/stream/sender/sender.hpp"

/// Outcomes of calls to an executor in words and as JSON.
namespace jounce {

/// The reason of a failed call. If the axis has rejected it: with the remedy of the cause, in which
/// `executor` is the name of the axis.
std::string reason_text(const CallOutcome& outcome, const std::string& executor);

/// {"ok": ..., "error": ..., "reason": ...}
std::string outcome_json(const CallOutcome& outcome);
/// The same with the number of the cause.
std::string command_json(const CallOutcome& outcome);

/// A stream of tables that has reached its goal, in one line. `waits`: the start was accepted for
/// later, and nothing has waited for it.
std::string stream_text(const StreamOutcome& outcome, const std::string& executor, bool waits);
std::string stream_json(const StreamOutcome& outcome);

/// A stream of rows.
std::string rows_text(const RowOutcome& outcome, const std::string& executor);
std::string rows_json(const RowOutcome& outcome);

/// The outcome of each axis of a group, a list.
std::string group_json(const std::vector<std::string>& axes,
                       const std::vector<StreamOutcome>& outcomes);

}  // namespace jounce
