// SPDX-License-Identifier: Apache-2.0
#include "report/src/sync_text.hpp"

#include <fmt/format.h>

#include "jounce/report/report_text.hpp"

namespace jounce {

bool is_sync_rule(const std::string& rule) {
  return rule.starts_with("knife/") || rule.starts_with("shear/") || rule.starts_with("gear/");
}

std::string sync_sentence(const Finding& f, const std::string& where) {
  if (f.rule == "shear/sync")
    return fmt::format("the carriage is in step for only {} {}, from {}: less than {} {}",
                       rounded(f.value), f.unit, where, rounded(f.limit), f.unit);
  if (f.rule == "knife/reversal")
    return f.broken ? fmt::format("the knife turns back at {}", where)
                    : fmt::format("the knife never turns back; it is slowest at {}", where);
  if (f.rule == "gear/ratio_step")
    return fmt::format("the ratio steps from {} to {} {} at {}, where the slave engages",
                       rounded(f.limit), rounded(f.value), f.unit, where);
  if (f.rule == "gear/reversal")
    return fmt::format("the slave turns back while it engages, fastest at {}", where);
  if (f.rule == "knife/slip")
    return fmt::format("the blade is {:.3g} % slower along the web than in step at {}",
                       100 * f.value, where);
  if (f.broken)
    return fmt::format("the blade is in the web for {} {}, but in step for only {}",
                       rounded(f.limit), f.unit, rounded(f.value));
  return fmt::format("the blade is in step for {} {}, in the web for {}", rounded(f.value), f.unit,
                     rounded(f.limit));
}

}  // namespace jounce
