// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "jounce/base/detail/nearest.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

constexpr double finest_optimum = 1e-9;  ///< least tolerance of an objective

/// The unit of a number that the spec has read. Throws InputError if no number has this name.
std::string unit_of(TomlReader& parameter, const std::string& key) {
  const auto& units = parameter.document().units;
  if (const auto it = units.find(key); it != units.end() && !key.starts_with("optimize"))
    return it->second;
  std::vector<std::string> known;
  for (const auto& [name, unit] : units) known.push_back(name);
  const std::string hint = nearest(key, known);
  parameter.fail("key", '"' + key + '"',
                 "names no number in this spec" +
                     (hint.empty() ? std::string("; if the spec omits the key, add it there first")
                                   : ": did you mean \"" + hint + "\"?"));
}

SpecParameter read_parameter(TomlReader& table) {
  SpecParameter parameter;
  parameter.key = table.text("key", "KEY");
  parameter.unit = unit_of(table, parameter.key);
  const auto range = table.optional_pair("range", parameter.unit);
  if (!range) {
    table.finish();
    table.fail("range", "", "is missing: add range = [least, greatest]");
  }
  std::tie(parameter.lower, parameter.upper) = *range;
  if (parameter.lower >= parameter.upper)
    table.fail("range",
               number(parameter.lower) + " to " + number(parameter.upper) +
                   (parameter.unit.empty() || parameter.unit == "1" ? "" : " " + parameter.unit),
               "must be [least, greatest], in this order and not equal");
  table.finish();
  return parameter;
}

FigureBound read_bound(TomlReader& table) {
  FigureBound bound{table.text("figure", "FIGURE")};
  bound.at_least = table.optional_quantity("at_least");
  bound.at_most = table.optional_quantity("at_most");
  table.finish();
  if (!bound.at_least && !bound.at_most)
    table.fail("at_most", "", "is missing: add at_most, at_least, or both");
  return bound;
}

void read_figure(TomlReader& table, ParametersSpec& spec) {
  const auto least = table.optional_text("minimize");
  const auto most = table.optional_text("maximize");
  if (least.has_value() == most.has_value())
    table.fail(
        "minimize", least ? '"' + *least + '"' : "",
        least
            ? "cannot be combined with maximize: give one of the two"
            : "is missing: add minimize or maximize = \"FIGURE\", such as minimize = \"duration\"");
  spec.figure = least ? *least : *most;
  spec.maximize = most.has_value();
}

void read_options(TomlReader& table, OptimizeOptions& options) {
  const std::vector<std::string> ways{"global", "local"};
  if (const auto way = table.optional_choice("search", ways))
    options.starts = *way == 0 ? std::nullopt : std::optional(1);
  if (const auto seed = table.optional_count("seed")) options.seed = *seed;
  if (const auto most = table.optional_count("max_evaluations")) {
    if (*most > 1'000'000)
      table.fail("max_evaluations", std::to_string(*most), "must be at most 1000000");
    options.budget.evaluations = static_cast<int>(*most);
  }
  options.budget.seconds = table.optional_number("seconds", "s");
  if (const auto seconds = options.budget.seconds; seconds && *seconds <= 0)
    table.fail("seconds", number(*seconds), "must be greater than 0");
  options.tolerance = table.optional_number("tolerance", "1").value_or(options.tolerance);
  if (options.tolerance < finest_optimum || options.tolerance > 0.01)
    table.fail("tolerance", number(options.tolerance), "must be from 1e-9 to 0.01");
}

}  // namespace

std::optional<ParametersSpec> read_parameters(TomlReader& top, const Spec& whole) {
  top.may_have("optimize");
  if (!top.has("optimize")) return std::nullopt;
  TomlReader table = top.table("optimize");
  if (std::holds_alternative<CamSpec>(whole.subject) && !table.has("parameter"))
    return std::nullopt;  // read_optimize() reads free knots
  ParametersSpec spec;
  std::set<std::string> chosen;
  for (TomlReader& parameter : table.tables("parameter")) {
    if (!whole.optimize.free.empty())
      table.fail("parameter", "",
                 "cannot be combined with `free` knots or shapes: optimize one, then the other");
    spec.parameters.push_back(read_parameter(parameter));
    if (!chosen.insert(spec.parameters.back().key).second)
      parameter.fail("key", '"' + spec.parameters.back().key + '"', "is given twice");
  }
  if (spec.parameters.empty())
    table.fail("parameter", "",
               "is missing: add [[optimize.parameter]] with key and range for each number that may "
               "change");
  read_figure(table, spec);
  for (TomlReader& bound : table.tables("require")) spec.require.push_back(read_bound(bound));
  read_options(table, spec.options);
  table.finish();
  return spec;
}

}  // namespace jounce::spec_detail
