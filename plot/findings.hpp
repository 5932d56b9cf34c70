#pragma once

#include <string>

#include "jounce/io/report_text.hpp"
#include "jounce/plot/page.hpp"
#include "jounce/profiles/limits.hpp"

namespace jounce {

/// Findings of a check, for a page: one row for each, in the report's order, the broken ones
/// marked. Columns that are empty throughout (of, segment, unit, what to change) are left out.
DataTable findings_table(const Report& report, const Labels& labels, std::string caption = {});

/// "All 4 limits hold.", "2 of 5 findings are broken.", ...
Headline verdict(const Report& report);

}  // namespace jounce
