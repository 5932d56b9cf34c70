// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/page.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {

/// Returns the findings of a check as a table for a page: one row for each finding, in the order of
/// the report. Rows of broken findings are marked. Columns without any entry are omitted.
DataTable findings_table(const Report& report, const Labels& labels, std::string caption = {});

/// Returns a sentence ("All 4 limits hold.", "2 of 5 findings are broken.", ...), and true if no
/// finding is broken (a check mark on the page; otherwise a cross).
Headline verdict(const Report& report);

}  // namespace jounce
