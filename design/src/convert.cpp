// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/convert.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/controllers/table_target.hpp"
#include "jounce/io/points_text.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/six_digits.hpp"
#include "jounce/pvt/fill.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
/// The table in the requested units; periodic if requested.
TableFile in_units(TableFile file, const Conversion& wanted) {
  const auto change = [](const char* key, std::string& unit, const std::string& to) {
    if (!to.empty() && !is_unit(to)) throw InputError(key, to, "is not a known unit");
    double factor = 1;
    try {
      if (!unit.empty() && !to.empty()) factor = conversion(unit, to);
    } catch (const InputError&) {
      throw InputError(key, to, "cannot be converted from the unit of the table, " + unit);
    }
    if (!to.empty()) unit = to;
    return factor;
  };
  if (const double factor = change("master_unit", file.units.x, wanted.units.x); factor != 1)
    file.table = stretched(file.table, factor);
  if (const std::string& to = wanted.units.position; is_unit(to) && !is_position_unit(to))
    throw InputError("position_unit", to,
                     "is not a unit of position: give a length, an angle, or pulse, count or inc");
  const double factor = change("position_unit", file.units.position, wanted.units.position);
  Columns columns = file.table.columns();
  if (factor != 1)
    for (auto* column : {&columns.p, &columns.v, &columns.a})
      for (double& value : *column) value *= factor;
  const auto [least, most] = std::minmax_element(columns.p.begin(), columns.p.end());
  const bool closes =
      std::abs(columns.p.back() - columns.p.front()) <= rounded_input * (*most - *least);
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

bool joins_by_spline(const CamFormat* format) {
  return format != nullptr &&
         (format->join == KnotJoin::spline || format->join == KnotJoin::clamped_spline);
}

/// The spline by which the controller joins the knots of a table. Its ends have the slopes of the
/// table; if the ends are not documented, it is periodic if the cam repeats, otherwise natural.
/// Numbers are rounded as in the file.
Columns controller_spline(const CamFormat& format, const Table& made) {
  Columns columns{made.columns().x, made.columns().p, std::vector<double>(made.size()), {}};
  if (format.single)
    for (auto* column : {&columns.x, &columns.p})
      for (double& value : *column) value = static_cast<double>(static_cast<float>(value));
  const bool given = format.join == KnotJoin::clamped_spline;
  std::vector<std::optional<double>> ends(given ? made.size() : 0);
  if (given) ends.front() = made.columns().v.front(), ends.back() = made.columns().v.back();
  const bool periodic = !given && repeats(made.outside());
  columns.v = filled({.axis = Domain::master,
                      .x = columns.x,
                      .p = columns.p,
                      .v = std::move(ends),
                      .filling = periodic ? Filling::periodic : Filling::natural})
                  .table.columns()
                  .v;
  return columns;
}

/// The columns in the units of the input.
Columns in_units_of(const TableFile& input, const Units& units, Columns columns) {
  const auto factor = [](const std::string& from, const std::string& to) {
    return from.empty() || to.empty() ? 1.0 : conversion(from, to);
  };
  const double x = factor(units.x, input.units.x);
  const double p = factor(units.position, input.units.position);
  for (double& value : columns.x) value *= x;
  for (double& value : columns.p) value *= p;
  for (double& value : columns.v) value *= p / x;
  return columns;
}

/// Changes the result to what the controller plays: if its spline is documented, the spline becomes
/// the table, and its distance from the input is the error.
void play_spline(const Input& input, const CamFormat& format, Converted& result) {
  Columns spline = controller_spline(format, result.file.table);
  result.error = std::visit(
      [&](const auto& curve) {
        return certified(curve, Interpolation::cubic_hermite,
                         in_units_of(input.table, result.file.units, spline))
            .error;
      },
      *input.curve);
  if (format.join == KnotJoin::clamped_spline)
    result.file.table = Table(Domain::master, Interpolation::cubic_hermite,
                              result.file.table.outside(), std::move(spline));
}

/// Text such as "laws, limits, coupling and 2 cam switches stay in the spec".
std::string left_in(const Spec& spec) {
  std::vector<std::string> parts{"laws", "limits"};
  if (spec.coupling) parts.emplace_back("the coupling");
  if (const std::size_t n = spec.switches.table.switches.size(); n > 0)
    parts.push_back(fmt::format("{} cam switch{}", n, n == 1 ? "" : "es"));
  const std::string last = parts.back();
  parts.pop_back();
  return fmt::format("{} and {} stay in the spec", fmt::join(parts, ", "), last);
}

/// Adds what a table in this format loses, compared with a table of Jounce.
void add_losses(std::vector<std::string>& all, const CamFormat& format, const Table& table) {
  if (format.join == KnotJoin::lines)
    all.emplace_back("positions only: the error is that of straight lines between them");
  if (format.join == KnotJoin::spline)
    all.emplace_back(
        "positions only: the error is that of a cubic spline through them; the ends of the "
        "controller's splines are not documented");
  if (format.join == KnotJoin::clamped_spline)
    all.push_back(
        fmt::format("the file has positions, and slopes only at its two ends, {} and {}: the error "
                    "is that of the cubic spline that the controller lays through them",
                    rounded(table.columns().v.front()), rounded(table.columns().v.back())));
  if (format.single) all.emplace_back("numbers are rounded to REAL, 24 bits");
  if (!format.keeps_notes) all.emplace_back("units and hash are not in the file");
  if (repeats(table.outside()) && !format.keeps_notes && !format.states_period)
    all.emplace_back("the file does not state that the cam repeats: read it with --periodic");
}

/// Converts knots, rule and units, without the spline of a controller.
Converted converted_once(const Input& input, const Conversion& wanted) {
  if (wanted.format != nullptr) require_cam(*wanted.format, input.table.table);
  Converted result{input.table, input.error};
  if (wanted.rule != input.table.table.rule() || wanted.target || wanted.intervals > 0) {
    Sampled made = with_knots(input, wanted);
    result = {{std::move(made.table), input.table.units, input.table.provenance}, made.error};
  }
  result.file = in_units(std::move(result.file), wanted);
  if (joins_by_spline(wanted.format)) play_spline(input, *wanted.format, result);
  return result;
}

bool keeps(const Target& target, const SampleError& error) {
  return (!target.tolerance || error.position <= *target.tolerance) &&
         (!target.velocity_tolerance || error.velocity <= *target.velocity_tolerance);
}

}  // namespace

Converted converted(const Input& input, const Conversion& wanted) {
  Converted result = converted_once(input, wanted);
  if (!joins_by_spline(wanted.format) || !wanted.target) return result;
  // Knots that keep a tolerance with the rule of the table may not keep it with the spline: then
  // more knots are used.
  Conversion finer = wanted;
  for (int i = 0; i < 30 && !keeps(*wanted.target, *result.error); ++i) {
    for (std::optional<double>* tolerance :
         {&finer.target->tolerance, &finer.target->velocity_tolerance})
      if (*tolerance) **tolerance /= 2;
    result = converted_once(input, finer);
  }
  return result;
}

std::vector<std::string> losses(const Input& input, const CamFormat* format, const Table& made) {
  std::vector<std::string> all;
  if (input.spec) all.push_back(left_in(*input.spec));
  if (format != nullptr) add_losses(all, *format, made);
  return all;
}

std::string error_text(const Converted& made, const Labels& labels) {
  if (!made.error) {
    std::vector<std::string> changes;
    const auto add = [&](const std::string& from, const std::string& to) {
      if (!from.empty() && !to.empty() && from != to) changes.push_back(from + " to " + to);
    };
    add(labels.units.x, made.file.units.x);
    add(labels.units.position, made.file.units.position);
    if (changes.empty()) return "the numbers are unchanged";
    return fmt::format("the numbers are converted from {}, without any other change",
                       fmt::join(changes, " and from "));
  }
  const std::string rate = labels.over_master ? OverMaster::names[1] : OverTime::names[1];
  return fmt::format("error: at most {} {} (certified), at {} {}; {} {} in the {}",
                     rounded(made.error->position), labels.units.position,
                     rounded(made.error->where), labels.units.x, rounded(made.error->velocity),
                     labels.unit_of(rate), rate);
}

TableForm table_form(const std::string& name, const std::string& path) {
  const CamFormat* const format = name.empty() ? cam_format_of_path(path) : cam_format_named(name);
  if (format != nullptr) return {format->name, format};
  if (name.empty()) return {path.ends_with(".json") ? "json" : "csv"};
  return {name};
}

Interpolation rule_for(const TableForm& form, std::optional<Interpolation> wanted,
                       const std::string& controller, const Table& table) {
  if (form.format != nullptr) return rule_of(*form.format);
  if (wanted) return *wanted;
  const ControllerTable* const target = controller_table(controller);
  return target != nullptr ? target->rule : table.rule();
}

std::optional<Interpolation> interpolation_named(const std::string& word) {
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite})
    if (word == name(rule)) return rule;
  return std::nullopt;
}

std::string form_text(const TableForm& form, const TableFile& file) {
  if (form.format != nullptr) return exchange_text(*form.format, file);
  if (form.name == "points") return points_text(file);
  return form.name == "json" ? to_json(file) : to_csv(file);
}

void require_units(const TableFile& file) {
  for (const auto& [unit, key] :
       {std::pair{&file.units.x, "master_unit"}, {&file.units.position, "position_unit"}})
    if (unit->empty())
      throw InputError(key, "", "is missing: the file names no unit. Give one, such as mm or deg");
}

std::string conversion_text(const Input& input, const Converted& made, const TableForm& form,
                            const std::vector<std::string>& losses) {
  std::string text = fmt::format("{} -> {}: {}, {}\n{}\n", input.name, form.name,
                                 counted(made.file.table.size(), "knot"),
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

std::vector<std::string> all_losses(const Input& input, const TableForm& form, const Table& made,
                                    bool sampled) {
  std::vector<std::string> all = input.unread;
  if (sampled) all.emplace_back("samples only: the file contains no values between them");
  if (form.name == "points")
    all.emplace_back("points count from the first knot; their types define the rates");
  const std::vector<std::string> more = losses(input, form.format, made);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<std::string> form_names() {
  std::vector<std::string> names{"csv", "json", "points"};
  for (const CamFormat* format : cam_formats()) names.emplace_back(format->name);
  return names;
}

std::string known_endings(bool named) {
  std::string endings = ".csv, .json";
  for (const CamFormat* format : cam_formats()) {
    const std::string ending = format->extension;
    if (ending.empty()) continue;
    endings += ", " + ending;
    if (named && ending.substr(1) != format->name)
      endings += std::string(" (") + format->name + ")";
  }
  return endings;
}

bool has_known_ending(const std::string& path) {
  return cam_format_of_path(path) != nullptr || path == "-" || path.ends_with(".csv") ||
         path.ends_with(".json");
}

}  // namespace jounce
