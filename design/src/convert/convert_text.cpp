// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/controllers/table_target.hpp"
#include "jounce/design/convert.hpp"
#include "jounce/io/detail/points_text.hpp"
#include "jounce/io/detail/samples_csv.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "design/src/convert/for_controller.hpp"
#include "design/src/convert/missing_units.hpp"

namespace jounce {
namespace {

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
void add_losses(std::vector<std::string>& all, const ExchangeFormat& format, const Table& table) {
  if (format.join == KnotJoin::lines)
    all.emplace_back("positions only: the error is that of straight lines between them");
  if (format.join == KnotJoin::cubic)
    all.emplace_back(
        "the accelerations are not in the file: the controller moves on cubic polynomials");
  if (format.join == KnotJoin::quadratic)
    all.emplace_back("the velocities are not in the file: the controller moves on parabolas");
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
  if (!format.keeps_notes)
    all.emplace_back(format.keeps_units ? "the hash is not in the file"
                                        : "units and hash are not in the file");
  if (format.not_kept[0] != '\0') all.emplace_back(format.not_kept);
  if (repeats(table.outside()) && !format.keeps_notes && !format.states_period)
    all.emplace_back("the file does not state that the cam repeats: read it with --periodic");
}

}  // namespace

std::vector<std::string> losses(const Input& input, const ExchangeFormat* format,
                                const Table& made) {
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
    if (changes.empty())
      return made.given_counts.empty()
                 ? "the numbers are unchanged"
                 : "the numbers are converted from counts, without any other change";
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
  const ExchangeFormat* const format =
      name.empty() ? exchange_format_of_path(path) : exchange_format_named(name);
  if (format != nullptr) return {format->name, format};
  if (!name.empty()) return {name};
  const OwnForm* const own = own_form_of_path(path);
  return {own != nullptr ? own->name : "csv"};
}

Interpolation rule_for(const TableForm& form, std::optional<Interpolation> wanted,
                       const std::string& controller, const Table& table) {
  const ControllerTable* const target = controller_table(controller);
  if (form.format != nullptr && wanted)
    throw InputError("rule", name(*wanted),
                     "applies to csv, json, lcm-log and mcap only: this format has its own rule");
  if (form.format != nullptr && target != nullptr && target->rule != rule_of(*form.format))
    throw InputError("controller", controller,
                     std::string("has ") + name(target->rule) + " tables, but the format " +
                         form.name + " has " + name(rule_of(*form.format)) +
                         " tables: leave out one of the two");
  if (form.format != nullptr) return rule_of(*form.format);
  if (wanted) return *wanted;
  return target != nullptr ? target->rule : table.rule();
}

std::optional<Interpolation> interpolation_named(const std::string& word) {
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite})
    if (word == name(rule)) return rule;
  return std::nullopt;
}

std::string form_text(const TableForm& form, const TableFile& file, const std::string& every) {
  if (form.format == nullptr || !every.empty()) require_units(file);
  if (!every.empty() && form.name != "csv")
    throw InputError("every", every,
                     "writes samples, which are CSV: end OUT in .csv, and leave out --to");
  if (!every.empty()) return samples_csv(file, every);
  if (form.format != nullptr) return exchange_text(*form.format, file);
  if (form.name == "points") return points_text(file);
  for (const OwnForm& own : own_forms())
    if (form.name == own.name) return own.write(file);
  return to_csv(file);
}

void require_units(const TableFile& file) {
  if (file.units.x.empty() && file.units.position.empty())
    throw design_detail::both_units_missing(file.table.axis() == Domain::time ? "s" : "deg", "mm");
  for (const auto& [unit, key] :
       {std::pair{&file.units.x, "master_unit"}, {&file.units.position, "position_unit"}})
    if (unit->empty())
      throw InputError(key, "", "is missing: the file names no unit. Give one, such as mm or deg");
}

namespace {

/// The peak of a motion with a reserve for the rounding to counts; "" for other formats.
std::string reserve_for_counts(const Finding& f, const Labels& labels,
                               const ExchangeFormat* format) {
  if (format == nullptr || format->p != Numbers::whole || f.value == 0) return "";
  const double peak = std::abs(f.limit * (f.limit / f.value));
  const std::string unit = labels.unit_of(f);
  return fmt::format(
      "; the rounding to counts needs a reserve: lower the peak {} of the motion to {}{}",
      f.quantity, six_digits_down(peak), unit.empty() ? "" : " " + unit);
}

}  // namespace

std::string conversion_text(const Input& input, const Converted& made, const TableForm& form,
                            const std::vector<std::string>& losses) {
  std::string text = fmt::format("{} -> {}: {}, {}\n{}\n", input.name, form.name,
                                 counted(made.file.table.size(), "knot"),
                                 name(made.file.table.rule()), error_text(made, input.labels));
  for (const std::string& line : {made.given_counts, made.counts})
    if (!line.empty()) text += line + "\n";
  for (const std::string& loss : losses) text += loss + "\n";
  if (!made.within_limit())
    text += fmt::format("the error exceeds the tolerance, {} {}{}{}\n", rounded(*made.limit),
                        input.labels.units.position,
                        *made.limit == design_detail::default_tolerance(input)
                            ? " (by default, a ten-thousandth of the travel)"
                            : "",
                        form.format != nullptr && made.file.table.size() > form.format->most / 2
                            ? fmt::format("; the format holds at most {} knots", form.format->most)
                            : "");
  for (const Finding& f : made.exceeded.findings)
    text += "the table exceeds a limit that the motion keeps: " + sentence(f, input.labels) +
            reserve_for_counts(f, input.labels, form.format) + "\n";
  return text;
}

std::string not_written_text(const Conversion& wanted, const Converted& made) {
  if (made.within_limit())
    return "nothing was written: change the knots, or accept the excess with --allow-loss. "
           "--tolerance divides intervals where a limit requires it, but not if the knots are at "
           "whole steps\n";
  const Target target = wanted.target.value_or(Target{});
  const std::string tolerance = target.tolerance ? "a greater --tolerance" : "--tolerance";
  const bool most = target.most && made.file.table.size() >= *target.most;
  return fmt::format("nothing was written: {}, or accept the error with --allow-loss\n",
                     wanted.intervals > 0 ? "give more --intervals"
                     : most ? fmt::format("raise --most ({}), give {}", *target.most, tolerance)
                            : "give " + tolerance);
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
  if (made.limit) document["limit"] = *made.limit;
  if (!made.given_counts.empty()) document["given_counts"] = made.given_counts;
  if (!made.counts.empty()) document["counts"] = made.counts;
  for (const Finding& f : made.exceeded.findings)
    document["exceeded"].push_back({{"rule", f.rule.text()},
                                    {"value", f.value},
                                    {"limit", f.limit},
                                    {"unit", f.unit},
                                    {"where", f.where}});
  document["losses"] = losses;
  return document.dump();
}

std::vector<std::string> all_losses(const Input& input, const TableForm& form, const Table& made,
                                    bool sampled) {
  std::vector<std::string> all = input.unread;
  if (sampled) all.emplace_back("samples only: the file contains no values between them");
  if (form.name == "points")
    all.emplace_back("points count from the first knot; their types define the rates");
  if (form.name == "npy")
    all.emplace_back("units, rule and hash are not in the file; numpy.load() reads its columns");
  const std::vector<std::string> more = losses(input, form.format, made);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<std::string> form_names() {
  std::vector<std::string> names;
  for (const OwnForm& own : own_forms()) names.emplace_back(own.name);
  names.emplace_back("points");
  for (const ExchangeFormat* format : exchange_formats()) names.emplace_back(format->name);
  return names;
}

std::string known_endings(bool named) {
  std::string endings;
  for (const OwnForm& own : own_forms())
    endings += (endings.empty() ? "" : ", ") + std::string(own.ending);
  for (const ExchangeFormat* format : exchange_formats()) {
    const std::string ending = format->extension;
    if (ending.empty()) continue;
    endings += ", " + ending;
    if (named && ending.substr(1) != format->name)
      endings += std::string(" (") + format->name + ")";
  }
  return endings;
}

bool has_known_ending(const std::string& path) {
  return exchange_format_of_path(path) != nullptr || own_form_of_path(path) != nullptr ||
         path == "-";
}

void require_known_ending(const std::string& path, const std::string& input) {
  if (path.ends_with(".toml"))
    throw InputError("path", path,
                     input.ends_with(".toml")
                         ? "would be a spec, but convert writes tables: choose another ending, "
                           "such as .csv"
                         : "would be a spec, but convert writes tables: to make the spec of a cam, "
                           "use `jounce fit " +
                               input + " -o " + path + "`");
  if (!has_known_ending(path))
    throw InputError("path", path,
                     "must end in one of " + known_endings() +
                         "; for another ending, name the format with --to");
}

}  // namespace jounce
