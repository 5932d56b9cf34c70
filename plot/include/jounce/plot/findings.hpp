// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/page.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {

/// Findings of a check, for a page: one row for each, in the report's order, the broken ones
/// marked. Columns that are empty throughout (of, segment, unit, what to change) are omitted.
DataTable findings_table(const Report& report, const Labels& labels, std::string caption = {});

/// "All 4 limits hold.", "2 of 5 findings are broken.", ...
Headline verdict(const Report& report);

}  // namespace jounce
