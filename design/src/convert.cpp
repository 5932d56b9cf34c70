// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/convert.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/io/points_text.hpp"
#include "jounce/pvt/fill.hpp"

namespace jounce {
namespace {

/// The table in other units, and periodic if that is asked for.
TableFile in_units(TableFile file, const Conversion& wanted) {
  const auto change = [](const char* key, std::string& unit, const std::string& to) {
    if (!to.empty() && !is_unit(to)) throw InputError(key, to, "is not a known unit");
    double factor = 1;
    try {
      if (!unit.empty() && !to.empty()) factor = conversion(unit, to);
    } catch (const InputError&) {
      throw InputError(key, to, "does not measure what the table's unit does, " + unit);
    }
    if (!to.empty()) unit = to;
    return factor;
  };
  if (const double factor = change("master_unit", file.units.x, wanted.units.x); factor != 1)
    file.table = stretched(file.table, factor);
  const double factor = change("position_unit", file.units.position, wanted.units.position);
  Columns columns = file.table.columns();
  if (factor != 1)
    for (auto* column : {&columns.p, &columns.v, &columns.a})
      for (double& value : *column) value *= factor;
  const auto [least, most] = std::minmax_element(columns.p.begin(), columns.p.end());
  const bool closes = std::abs(columns.p.back() - columns.p.front()) <= 1e-9 * (*most - *least);
  const Extrapolation repeated = closes ? Extrapolation::wrap : Extrapolation::advance;
  file.table = Table(file.table.axis(), file.table.rule(),
                     wanted.periodic ? repeated : file.table.outside(), std::move(columns));
  return file;
}

Sampled with_knots(const Input& input, const Conversion& wanted) {
  return std::visit(
      [&](const auto& curve) {
        if (const auto& target = wanted.target) {
          if (target->tolerance) require_certifiable(curve, "tolerance", *target->tolerance);
          if (target->velocity_tolerance)
            require_certifiable(derivative(curve), "velocity_tolerance",
                                *target->velocity_tolerance);
          return reduced(curve, *target);
        }
        return wanted.intervals > 0 ? sample(curve, wanted.rule, wanted.intervals)
                                    : sample(curve, wanted.rule, input.table.table.columns().x);
      },
      *input.curve);
}

/// Error of a cubic spline through the knots, periodic if the cam repeats, otherwise with natural
/// ends. KAS joins points of the type SPLINE by curves; their ends are not documented.
SampleError spline_error(const Input& input, const Table& made) {
  Columns columns{made.columns().x, made.columns().p, std::vector<double>(made.size()), {}};
  spline_velocities(columns.x, columns.p,
                    repeats(made.outside()) ? Filling::periodic : Filling::natural, columns.v);
  return std::visit(
      [&](const auto& curve) {
        return certified(curve, Interpolation::cubic_hermite, std::move(columns)).error;
      },
      *input.curve);
}

/// "laws, limits, coupling and 2 cam switches stay in the spec"
std::string left_in(const Spec& spec) {
  std::vector<std::string> parts{"laws", "limits"};
  if (spec.coupling) parts.emplace_back("the coupling");
  if (const std::size_t n = spec.switches.table.switches.size(); n > 0)
    parts.push_back(fmt::format("{} cam switch{}", n, n == 1 ? "" : "es"));
  const std::string last = parts.back();
  parts.pop_back();
  return fmt::format("{} and {} stay in the spec", fmt::join(parts, ", "), last);
}

/// Losses of a table of straight lines or splines beside a table of Jounce.
void add_losses(std::vector<std::string>& all, Format format, const Table& table) {
  if (format == Format::xyva || format == Format::codesys) return;
  all.emplace_back(format == Format::kollmorgen
                       ? "positions only: the error is that of a cubic spline through them; "
                         "Kollmorgen does not document how KAS ends its splines"
                       : "positions only: the error is that of straight lines between them");
  all.emplace_back("units and hash are not in the file");
  if (repeats(table.outside()) && format != Format::kollmorgen)
    all.emplace_back("the file does not state that the cam repeats: read it with --periodic");
}

}  // namespace

Converted converted(const Input& input, const Conversion& wanted) {
  Converted result{input.table, input.error};
  if (wanted.rule != input.table.table.rule() || wanted.target || wanted.intervals > 0) {
    Sampled made = with_knots(input, wanted);
    result = {{std::move(made.table), input.table.units, input.table.provenance}, made.error};
  }
  if (wanted.format == Format::kollmorgen) result.error = spline_error(input, result.file.table);
  result.file = in_units(std::move(result.file), wanted);
  return result;
}

std::vector<std::string> losses(const Input& input, const std::optional<Format>& format,
                                const Table& made) {
  std::vector<std::string> all;
  if (input.spec) all.push_back(left_in(*input.spec));
  if (format) add_losses(all, *format, made);
  return all;
}

std::string error_text(const Converted& made, const Labels& labels) {
  if (!made.error) return "the numbers are unchanged";
  const std::string rate = labels.over_master ? OverMaster::names[1] : OverTime::names[1];
  return fmt::format("error: at most {} {} (certified), at {} {}; {} {} in the {}",
                     rounded(made.error->position), labels.units.position,
                     rounded(made.error->where), labels.units.x, rounded(made.error->velocity),
                     labels.unit_of(rate), rate);
}

TableForm table_form(const std::string& name, const std::string& path) {
  const auto format = name.empty() ? format_of_path(path) : format_named(name);
  if (format) return {jounce::name(*format), format};
  if (name.empty()) return {path.ends_with(".json") ? "json" : "csv"};
  return {name};
}

std::string form_text(const TableForm& form, const TableFile& file) {
  if (form.format) return exchange_text(*form.format, file);
  if (form.name == "points") return points_text(file);
  return form.name == "json" ? to_json(file) : to_csv(file);
}

std::string conversion_text(const Input& input, const Converted& made, const TableForm& form,
                            const std::vector<std::string>& losses) {
  std::string text =
      fmt::format("{} -> {}: {} knots, {}\n{}\n", input.name, form.name, made.file.table.size(),
                  name(made.file.table.rule()), error_text(made, input.labels));
  for (const std::string& loss : losses) text += loss + "\n";
  return text;
}

std::string conversion_json(const Converted& made, const TableForm& form, const std::string& path,
                            const std::vector<std::string>& losses) {
  nlohmann::ordered_json document{{"table", path},
                                  {"format", form.name},
                                  {"knots", made.file.table.size()},
                                  {"rule", name(made.file.table.rule())},
                                  {"lossless", !made.error.has_value()}};
  if (made.error) {
    document["error"] = made.error->position;
    document["error_where"] = made.error->where;
    document["error_velocity"] = made.error->velocity;
  }
  document["losses"] = losses;
  return document.dump();
}

}  // namespace jounce
