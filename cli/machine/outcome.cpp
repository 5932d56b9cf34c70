// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/outcome.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/common/json.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {

int status_of(const CallOutcome& outcome, std::initializer_list<StreamError> findings) {
  if (outcome.ok()) return fine;
  const bool found = std::find(findings.begin(), findings.end(), outcome.error) != findings.end();
  return found || outcome.error == StreamError::stopped ? finding : fault;
}

int report_outcome(const CallOutcome& outcome, const std::string& executor, const std::string& json,
                   const std::string& done, std::initializer_list<StreamError> findings,
                   KeyedLink& link) {
  if (!json.empty())
    print_json(json);
  else if (outcome.ok())
    fmt::print("{}\n", done);
  else
    fmt::print(stderr, "jounce: {}\n", dashboard::error_text(outcome, executor, link));
  return status_of(outcome, findings);
}

}  // namespace jounce::cli
