// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <nlohmann/json.hpp>

#include "jounce/plot/label.hpp"
#include "jounce/profiles/error.hpp"

#include "proof/src/page_sections.hpp"

namespace jounce {
namespace {

using nlohmann::json;

/// A number of the result, as text; "" for null and for a missing one.
std::string shown(const json& row, const char* key) {
  const auto at = row.find(key);
  return at == row.end() || !at->is_number() ? "" : short_number(at->get<double>());
}

std::string word(const json& row, const char* key) {
  const auto at = row.find(key);
  return at == row.end() || !at->is_string() ? "" : at->get<std::string>();
}

std::string percent_of(double share) {
  return short_number(100 * share, 4) + " %";
}

/// The gain of an objective as a share of the given value, and the part that is still possible.
std::vector<std::string> objective_cells(const json& row) {
  const auto given = row.find("given"), reached = row.find("reached"), gap = row.find("gap");
  const bool has_gain = given != row.end() && reached != row.end() && given->is_number() &&
                        reached->is_number() && given->get<double>() != 0;
  const bool has_gap = gap != row.end() && gap->is_number();
  return {word(row, "objective"),
          word(row, "unit"),
          shown(row, "given"),
          shown(row, "reached"),
          has_gain ? percent_of(1 - reached->get<double>() / given->get<double>()) : "",
          shown(row, "bound"),
          has_gap ? percent_of(gap->get<double>()) : ""};
}

DataTable objectives(const json& rows) {
  DataTable table{.caption = "Objectives, in their order",
                  .columns = {"objective", "unit", "given", "reached", "gain", "proven bound",
                              "could still be saved"}};
  for (const json& row : rows) table.rows.push_back({objective_cells(row)});
  return table;
}

DataTable active_limits(const json& rows, const Labels& labels) {
  DataTable table{.caption = "Places that prevent a better result",
                  .columns = {"rule", "at [" + labels.units.x + "]", "value", "limit", "unit"}};
  for (const json& row : rows) {
    DataTable::Row cells{{word(row, "rule"), shown(row, "where"), shown(row, "value"),
                          shown(row, "limit"), labels.unit_of(word(row, "quantity"))}};
    if (const auto at = row.find("where"); at != row.end() && at->is_number())
      cells.place = DataTable::Place{at->get<double>(), at->get<double>()};
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The price of the gain: all figures that the optimizer compares.
DataTable compared_figures(const json& result) {
  DataTable table{.caption = "The price: all figures before and after",
                  .columns = {"figure", "given", "optimized", "change", "limit", "unit"}};
  for (const char* key : {"peaks", "other_figures"}) {
    const auto rows = result.find(key);
    if (rows == result.end()) continue;
    for (const json& row : *rows) {
      const auto given = row.find("given"), now = row.find("optimized");
      const bool both = given != row.end() && now != row.end() && given->is_number() &&
                        now->is_number() && given->get<double>() != 0;
      table.rows.push_back({{word(row, "quantity"), shown(row, "given"), shown(row, "optimized"),
                             both ? percent_of(now->get<double>() / given->get<double>() - 1) : "",
                             shown(row, "limit"), word(row, "unit")}});
    }
  }
  return table;
}

/// The figures of a search over numbers of the spec.
DataTable searched_figures(const json& rows) {
  DataTable table{.caption = "Figures of the search; the first one is the objective",
                  .columns = {"figure", "unit", "given", "reached", "at least", "at most"}};
  for (const json& row : rows)
    table.rows.push_back({{word(row, "name"), word(row, "unit"), shown(row, "given"),
                           shown(row, "reached"), shown(row, "at_least"), shown(row, "at_most")}});
  return table;
}

DataTable searched_numbers(const json& rows) {
  DataTable table{.caption = "Numbers of the spec that the search changed",
                  .columns = {"key", "unit", "given", "reached", "from", "to"}};
  for (const json& row : rows) {
    DataTable::Row cells{
        {word(row, "key"), word(row, "unit"), shown(row, "given"), shown(row, "reached")}};
    if (const auto range = row.find("range"); range != row.end() && range->is_array())
      for (const json& end : *range)
        cells.cells.push_back(end.is_number() ? short_number(end.get<double>()) : "");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Sentences on the limits that prevent a better result.
DataTable reasons(const json& rows) {
  DataTable table{.columns = {"prevents a better result"}};
  for (const json& row : rows)
    if (row.is_string()) table.rows.push_back({{row.get<std::string>()}});
  return table;
}

/// The duration of a path before and after the refinement of its timing law.
Facts refinement_facts(const json& row) {
  const std::string unit = " " + word(row, "unit");
  return {{{"duration with the usual timing law", shown(row, "given") + unit},
           {"duration with the refined timing law", shown(row, "reached") + unit}}};
}

template <class Make>
void add(Section& section, const json& result, const char* key, const Make& make) {
  const auto part = result.find(key);
  if (part != result.end() && !part->empty()) section.blocks.emplace_back(make(*part));
}

}  // namespace

Section optimum_section(const std::string& text, const std::string& name, const Labels& labels) {
  const json result = json::parse(text, nullptr, false);
  const auto has = [&](const char* key) { return result.contains(key); };
  if (!result.is_object() ||
      !((has("status") && (has("objectives") || has("parameters"))) || has("refinement")))
    throw InputError("", "", "is not the output of `jounce optimize --json`").at(name);
  Section section{"Optimization", {}};
  if (has("status"))
    section.blocks.emplace_back(Facts{{{"result", word(result, "status")},
                                       {"reason", word(result, "reason")},
                                       {"evaluations", shown(result, "evaluations")}}});
  add(section, result, "objectives", objectives);
  add(section, result, "figures", searched_figures);
  add(section, result, "parameters", searched_numbers);
  add(section, result, "active", [&](const json& rows) {
    return rows.front().is_string() ? reasons(rows) : active_limits(rows, labels);
  });
  add(section, result, "refinement", refinement_facts);
  if (DataTable figures = compared_figures(result); !figures.rows.empty())
    section.blocks.emplace_back(std::move(figures));
  return section;
}

}  // namespace jounce
