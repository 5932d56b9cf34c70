// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>

#include "jounce/machine/detail/outcome_text.hpp"
#include "jounce/machine/watch.hpp"

namespace jounce::cli {

/// The exit status of an outcome: `findings` and `stopped` are the errors with status 1.
int status_of(const CallOutcome& outcome, std::initializer_list<StreamError> findings);

/// Prints an outcome and returns its exit status: the JSON document, if it is not empty; otherwise
/// `done`, or the error on standard error. Without an answer, it lists the executors on the link.
int report_outcome(const CallOutcome& outcome, const std::string& executor, const std::string& json,
                   const std::string& done, std::initializer_list<StreamError> findings,
                   KeyedLink& link);

}  // namespace jounce::cli
