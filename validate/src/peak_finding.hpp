// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// Returns the finding of a peak against the limit of its magnitude, > 0. `advice`: remedy if the
/// peak exceeds the limit.
inline Finding peak_finding(const char* rule, const char* quantity, const Peak& peak, double limit,
                            const char* advice) {
  Finding finding;
  finding.rule = rule;
  finding.quantity = quantity;
  finding.where = peak.where;
  finding.value = peak.value;
  finding.limit = std::copysign(limit, peak.value);
  finding.margin = (limit - std::abs(peak.value)) / limit;
  finding.broken = !(std::abs(peak.value) <= limit);
  if (finding.broken) finding.advice = advice;
  return finding;
}

/// Returns the finding of an incomplete integration.
inline Finding integration_finding(const char* rule, const char* quantity,
                                   const Integration& integration) {
  Finding finding;
  finding.rule = rule;
  finding.has_limit = false;
  finding.quantity = quantity;
  finding.where = finding.value = integration.reached;
  finding.broken = true;
  finding.advice = integration.reason;
  return finding;
}

}  // namespace jounce::validate_detail
