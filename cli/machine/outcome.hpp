// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>

#include <fmt/format.h>

#include "cli/common/json.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {

/// The outcome of a call to an executor (StreamOutcome, RowOutcome, CallOutcome) as JSON: ok, error, reason.
template <class Outcome>
Json json_of(const Outcome& outcome) {
  return {{"ok", outcome.ok()}, {"error", name(outcome.error)}, {"reason", outcome.reason}};
}

/// The exit status of an outcome: `findings` are the errors with status 1.
template <class Outcome>
int status_of(const Outcome& outcome, std::initializer_list<StreamError> findings) {
  if (outcome.ok()) return fine;
  return std::find(findings.begin(), findings.end(), outcome.error) != findings.end() ? finding
                                                                                      : fault;
}

/// The reason of an outcome, for a person: if an axis rejects the call, with the remedy.
template <class Outcome>
std::string reason_of(const Outcome& outcome, const std::string& executor) {
  return outcome.refusal == wire::Refusal::axis
             ? reason_of_axis(outcome.reason, outcome.cause, executor)
             : outcome.reason;
}

/// Prints an outcome and returns its exit status. As JSON with the entries of `more`; otherwise
/// `done`, or the error on standard error.
template <class Outcome>
int report_outcome(const Outcome& outcome, const std::string& executor, bool json,
                   const std::string& done, const Json& more,
                   std::initializer_list<StreamError> findings) {
  if (json) {
    Json document = json_of(outcome);
    document.update(more);
    print_json(document);
  } else if (outcome.ok()) {
    fmt::print("{}\n", done);
  } else {
    fmt::print(stderr, "jounce: {}\n", said_of(outcome.error, reason_of(outcome, executor)));
  }
  return status_of(outcome, findings);
}

}  // namespace jounce::cli
