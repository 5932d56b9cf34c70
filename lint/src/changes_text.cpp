// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "jounce/design/files/file_difference.hpp"
#include "jounce/lint/accepted.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

using What = FileChange::What;

constexpr std::array words{std::pair{What::wrong, "not compared (wrong)"},
                           std::pair{What::changed, "changed"},
                           std::pair{What::added, "new"},
                           std::pair{What::removed, "removed"},
                           std::pair{What::renamed, "renamed"},
                           std::pair{What::same, "the same"}};

/// True if the motion differs, also of a renamed file.
bool differs(const FileChange& change) {
  return std::any_of(change.diagnostics.begin(), change.diagnostics.end(),
                     [](const Diagnostic& each) { return each.rule == "baseline/changed"; });
}

/// "1 changed, 2 new, 38 the same"
std::string counts(const std::vector<FileChange>& changes) {
  std::string text;
  for (const auto& [what, word] : words) {
    const auto n =
        std::count_if(changes.begin(), changes.end(),
                      [what = what](const FileChange& each) { return each.what == what; });
    if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, word);
  }
  return text.empty() ? "no files" : text;
}

const char* word_of(What what) {
  const auto* const found = std::find_if(words.begin(), words.end(),
                                         [&](const auto& each) { return each.first == what; });
  return found->second;
}

std::string headline(const FileChange& change) {
  if (change.what == What::removed) return change.before;
  if (change.what == What::renamed) return change.before + " -> " + change.file;
  return change.file;
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

std::string cell_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& each : cells) row += " " + cell(each) + " |";
  return row + "\n";
}

/// Peaks before and after, the greatest difference, and what is allowed: a row for each quantity.
std::string quantity_table(const Comparison& c, const Tolerance& tolerance) {
  const auto& names = c.labels.over_master ? OverMaster::names : OverTime::names;
  std::string text =
      "| quantity | peak before | peak after | greatest difference | at | allowed | |\n"
      "|---|---|---|---|---|---|---|\n";
  for (std::size_t k = 0; k < c.changes.size(); ++k) {
    const Change& change = c.changes[k];
    const std::string unit = c.labels.unit_of(names[k]);
    const auto allowed = permitted(change, k, tolerance);
    const std::string most = !allowed                      ? "not compared"
                             : *allowed == change.rounding ? "rounding"
                                                           : with_unit(*allowed, unit);
    text += cell_row({names[k], with_unit(change.before.peak().value, unit),
                      with_unit(change.after.peak().value, unit),
                      change.none() ? "none" : with_unit(change.largest.value, unit),
                      change.none() ? "" : with_unit(change.largest.where, c.labels.units.x), most,
                      c.beyond[k] ? "**beyond**" : ""});
  }
  return text;
}

std::string section_of(const FileChange& change) {
  std::string text = fmt::format("### {}: `{}`\n\n", word_of(change.what), cell(headline(change)));
  for (std::size_t i = 0, picture = 0; i < change.comparisons.size(); ++i) {
    const Comparison& c = change.comparisons[i];
    if (c.equal()) continue;
    if (change.comparisons.size() > 1) text += fmt::format("**{}**\n\n", cell(c.after));
    text += quantity_table(c, change.tolerances[i]) + "\n";
    for (const auto& [what, before, after] : c.remarks)
      text += fmt::format("- {}: {} -> {}\n", what, before.empty() ? "none" : before,
                          after.empty() ? "none" : after);
    if (!c.remarks.empty()) text += "\n";
    if (picture + 1 < change.pictures.size()) {
      text += fmt::format(
          "| before | after, over the paler before |\n|---|---|\n| ![before]({}) | ![after]({}) "
          "|\n\n",
          change.pictures[picture], change.pictures[picture + 1]);
      picture += 2;
    }
  }
  if (!change.keys.empty()) text += "- " + cell(to_text(change.keys)) + "\n\n";
  for (const Diagnostic& each : change.diagnostics)
    if (change.comparisons.empty() && each.rule == "baseline/changed")
      text += fmt::format("{}.\n\n", each.message);
  for (const std::string& error : change.errors) text += fmt::format("- {}\n", cell(error));
  if (!change.errors.empty()) text += "\n";
  return text;
}

}  // namespace

std::string to_text(const std::vector<FileChange>& changes, const std::string& name) {
  std::string text = fmt::format("compared with {}: {}\n", name, counts(changes));
  for (const FileChange& change : changes) {
    if (change.what == What::same) continue;
    text += fmt::format("{}: {}\n", word_of(change.what), headline(change));
    for (const Comparison& c : change.comparisons)
      if (!c.equal()) text += to_text(c);
    if (!change.keys.empty()) text += "  ~ " + to_text(change.keys) + "\n";
  }
  return text;
}

std::string to_markdown(const std::vector<FileChange>& changes, const std::string& name) {
  std::string text = fmt::format("## Motions compared with `{}`: {}\n\n", name, counts(changes));
  std::string rows;
  for (const FileChange& change : changes)
    if (change.what != What::same && change.errors.empty() && !differs(change))
      rows += fmt::format("- {}: `{}`\n", word_of(change.what), headline(change));
  if (!rows.empty()) text += rows + "\n";
  for (const FileChange& change : changes)
    if (differs(change) || !change.errors.empty()) text += section_of(change);
  return text;
}

}  // namespace jounce
