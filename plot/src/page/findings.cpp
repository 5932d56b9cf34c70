// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "jounce/plot/label.hpp"

namespace jounce {
namespace {

constexpr double no_margin = 1e-9;  ///< share of the limit

std::string margin_text(const Finding& f) {
  if (!f.has_limit) return "";
  if (f.limit == 0 && f.rule.family() == RuleFamily::continuity) return short_number(f.margin, 3);
  if (f.margin < -10)
    return "< −1000 %";  // a tolerance, not a limit: its multiples have no meaning
  if (!f.broken && std::abs(f.margin) < no_margin) return "0 %";
  return short_number(100 * f.margin, 3) + " %";
}

std::string limit(const Finding& f) {
  if (f.has_limit) return short_number(f.limit);
  return is_unlimited(f) ? "not limited" : "";
}

std::vector<std::string> cells(const Finding& f, const Labels& labels) {
  return {f.rule.text(),
          f.axis,
          labels.segment_of(f),
          short_number(f.where) + (f.where_unit.empty() ? "" : " " + f.where_unit),
          short_number(f.value),
          limit(f),
          superscripts(labels.unit_of(f)),
          margin_text(f),
          f.advice};
}

/// The place on the axis of the motion; nullopt for one elsewhere, such as a frequency.
std::optional<DataTable::Place> place(const Finding& f) {
  if (!f.where_unit.empty() || !std::isfinite(f.where)) return std::nullopt;
  return DataTable::Place{f.where, f.where};
}

void drop_empty_columns(DataTable& table) {
  for (std::size_t k = table.columns.size(); k-- > 0;) {
    const bool empty = std::all_of(table.rows.begin(), table.rows.end(),
                                   [&](const DataTable::Row& row) { return row.cells[k].empty(); });
    if (!empty) continue;
    const auto at = static_cast<std::ptrdiff_t>(k);
    table.columns.erase(table.columns.begin() + at);
    for (DataTable::Row& row : table.rows) row.cells.erase(row.cells.begin() + at);
  }
}

}  // namespace

DataTable findings_table(const Report& report, const Labels& labels, std::string caption) {
  DataTable table{
      std::move(caption),
      {"rule", "of", "segment", "at", "value", "limit", "unit", "margin", "what to change"},
      {}};
  for (const Finding& f : report.findings)
    table.rows.push_back({cells(f, labels), f.broken, place(f)});
  if (!table.rows.empty()) drop_empty_columns(table);
  return table;
}

Headline verdict(const Report& report) {
  const std::size_t warnings = report.warnings();
  const auto notes = static_cast<std::size_t>(
      std::count_if(report.findings.begin(), report.findings.end(),
                    [](const Finding& f) { return !f.broken && f.severity == Severity::note; }));
  const std::size_t total = report.findings.size() - warnings - notes;
  const std::size_t broken = report.broken();
  if (total + warnings == 0) return {true, "Nothing was checked."};
  if (broken == 0)
    return {true, fmt::format("All checks hold ({}){}", total,
                              warnings == 0   ? "."
                              : warnings == 1 ? "; one warning."
                                              : fmt::format("; {} warnings.", warnings))};
  return {false,
          fmt::format("{} of {} findings {} broken.", broken, total, broken == 1 ? "is" : "are")};
}

}  // namespace jounce
