// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/against.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/base/file.hpp"
#include "jounce/design/convert.hpp"
#include "jounce/design/over_time.hpp"
#include "jounce/profiles/curve/difference.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "design/src/convert/for_controller.hpp"
#include "design/src/input/against_spec.hpp"

namespace jounce {
namespace {

namespace fs = std::filesystem;

using profiles_detail::rounded_input;
using profiles_detail::rounded_value;

constexpr double single_digits = 0x1p-23;  ///< rounding of a REAL, as a share of its value

/// The name of the axis in the file that `jounce design` writes for it: "x" in "feeder-x.csv".
bool names_axis(const std::string& file, const std::string& axis) {
  return !axis.empty() && fs::path(file).stem().string().ends_with("-" + axis);
}

/// The axis of the spec to which a table belongs.
const Input& partner(const Input& table, const std::vector<Input>& specs, const std::string& path) {
  if (specs.size() == 1) return specs.front();
  const auto found = std::find_if(specs.begin(), specs.end(), [&](const Input& spec) {
    return table.axis.empty() ? names_axis(table.file, spec.axis) : table.axis == spec.axis;
  });
  if (found != specs.end()) return *found;
  if (!table.axis.empty())
    throw InputError("against", path,
                     "has no axis " + table.axis + ": name one of " + listed(specs, &Input::axis) +
                         " with --axis");
  throw InputError("against", path,
                   "has the axes " + listed(specs, &Input::axis) + ", and " + table.name +
                       " names none of them: name the axis with --axis, or rename the table, "
                       "such as " +
                       fs::path(table.file).stem().string() + "-" + specs.front().axis +
                       fs::path(table.file).extension().string());
}

/// The table in the units of its spec. `repeats`: the spec repeats.
TableFile in_units_of(const Input& spec, bool repeats, const Input& table,
                      const std::string& path) {
  const Units& units = spec.labels.units;
  Conversion wanted;
  wanted.units = units;
  wanted.periodic = repeats && table.table.units.x.empty();
  try {
    return design_detail::in_units(table.table, wanted);
  } catch (const InputError& error) {
    const bool is_x = error.key() == "master_unit";
    throw InputError(
        "against", path,
        fmt::format("the {} is in {}, and in {} of {}: these units do not convert",
                    is_x ? spec.labels.over_master ? "master" : "time" : "position",
                    is_x ? units.x : units.position,
                    is_x ? table.table.units.x : table.table.units.position, table.name));
  }
}

/// Throws for a table that does not cover the interval of its spec, or that goes on in another way
/// outside it.
void require_same_interval(const Table& table, Extrapolation outside, double start, double end,
                           const Input& spec, const std::string& name, const std::string& path) {
  const double allowed = rounded_input * std::max({std::abs(start), std::abs(end), end - start});
  if (std::abs(table.start() - start) > allowed || std::abs(table.end() - end) > allowed)
    throw InputError(
        "against", path,
        fmt::format("the motion is from {0} to {1} {4}, and {5} is from {2} to {3} {4}: give the "
                    "spec from which the table was made",
                    rounded(start), rounded(end), rounded(table.start()), rounded(table.end()),
                    spec.labels.units.x, name));
  if (repeats(table.outside()) != repeats(outside))
    throw InputError(
        "against", path,
        fmt::format("the motion {}, and {} {}", repeats(outside) ? "repeats" : "runs once", name,
                    repeats(outside) ? "runs once" : "repeats"));
}

/// For each interval of the table, the name of the segment of the spec in which it is.
template <class Over>
std::vector<std::string> segments_of(const Table& table, const Curve<Over>& curve,
                                     const std::vector<std::string>& names) {
  if (names.empty()) return {};
  std::vector<std::string> all;
  const auto& x = table.columns().x;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const auto after = std::upper_bound(curve.breaks().begin() + 1, curve.breaks().end() - 1,
                                        (x[i] + x[i + 1]) / 2);
    const auto segment = static_cast<std::size_t>(after - curve.breaks().begin()) - 1;
    all.push_back(segment < names.size() ? names[segment] : std::to_string(segment + 1));
  }
  return all;
}

/// The greatest permitted deviation without a request.
double usual_tolerance(const Input& spec, const ExchangeFormat* format, double peak) {
  double most = std::max(table_tolerance(spec).value_or(0), rounded_value * peak);
  if (format != nullptr) most = std::max(most, design_detail::default_tolerance(spec));
  if (format != nullptr && format->single) most = std::max(most, single_digits * peak);
  return most;
}

template <class Over>
AgainstSpec deviation(const Curve<Over>& curve, const Input& spec, const Input& table,
                      const Tolerance& tolerance) {
  const Changes changes = compare(curve, table.table.table.curve<Over>());
  const Extremum& largest = changes[0].largest;
  AgainstSpec against;
  against.error = {std::abs(largest.value), largest.where, std::abs(changes[1].largest.value)};
  const double usual =
      usual_tolerance(spec, table.format, std::abs(changes[0].before.peak().value));
  const bool wanted = tolerance.of[0] || tolerance.share;
  against.tolerance = (wanted ? *permitted(changes[0], 0, tolerance) : usual) + changes[0].rounding;
  if (table.format != nullptr && table.format->single) against.digits = single_digits;
  return against;
}

/// The rules of limits and of continuity that the spec itself breaks.
std::vector<std::string> broken_rules(const Input& spec) {
  std::vector<std::string> all;
  for (const Finding& f : check_all(spec).findings)
    if (f.broken &&
        (f.rule.family() == RuleFamily::limit || f.rule.family() == RuleFamily::continuity))
      all.push_back(f.rule.text());
  return all;
}

void set_spec(Input& table, const Input& given, const std::string& path,
              const std::vector<std::string>& tolerance) {
  const bool over_its_master = table.labels.over_master || !given.labels.over_master;
  const Input spec = over_its_master ? given : over_time(given);
  if (table.labels.over_master != spec.labels.over_master)
    throw InputError("against", path,
                     "is over time, and " + table.name +
                         " is over a master: give the spec from which the table was made");
  std::visit(
      [&](const auto& curve) {
        table.table = in_units_of(spec, repeats(curve.outside()), table, path);
        require_same_interval(table.table.table, curve.outside(), curve.start(), curve.end(), spec,
                              table.name, path);
        table.against = deviation(curve, spec, table, tolerance_of(tolerance, spec.labels));
        table.labels = {spec.labels.units, spec.labels.over_master,
                        segments_of(table.table.table, curve, spec.labels.segments)};
      },
      *spec.curve);
  table.newer_spec.clear();  // the comparison replaces it
  table.against->spec = path;
  table.against->broken = broken_rules(spec);
  table.curve = LazyCurve(table.table.table);
  table.spec = spec.spec;
  table.limits = spec.limits;
  table.drive = spec.drive;
  table.rate_units = spec.rate_units;
  table.name += " against " + printable(path);
}

}  // namespace

void set_against(std::vector<Input>& tables, const std::string& spec_path,
                 const std::vector<std::string>& tolerance) {
  const std::vector<Input> specs = read_inputs(spec_path);
  if (!specs.front().spec)
    throw InputError("against", spec_path, "is a table: give the spec of the motion");
  if (tables.front().spec)
    throw InputError("against", spec_path,
                     "is the spec of a table, but " +
                         printable(tables.front().spec->document.name) +
                         " is a spec, too: leave out --against; `jounce diff` compares two specs");
  for (Input& table : tables)
    if (!table.spec) set_spec(table, partner(table, specs, spec_path), spec_path, tolerance);
}

void set_limits_of_header(Input& table) {
  const std::string spec_path = newer_spec(table.table.provenance, table.file, true);
  if (table.spec || table.error || spec_path.empty()) return;  // it has an exact curve
  Input limited = table;
  try {
    set_spec(limited, partner(table, read_inputs(spec_path), spec_path), spec_path, {});
  } catch (const InputError&) {
    return;  // such as a table of a part of the motion
  }
  limited.name = table.name;
  limited.against->limits_only = true;
  table = std::move(limited);
}

bool may_be_made_from(const Input& table, const std::string& spec_path) {
  if (table.spec) return false;
  const fs::path named = table.table.provenance.spec;
  if (named.empty()) return true;
  std::error_code none;
  const fs::path folder = fs::path(table.file).parent_path();
  bool exists = false;
  for (const fs::path& path : {folder / named, folder / named.filename(), named}) {
    if (fs::equivalent(path, spec_path, none)) return true;
    exists = exists || fs::is_regular_file(path, none);
  }
  return !exists && named.filename() == fs::path(spec_path).filename();
}

std::string newer_spec(const Provenance& provenance, const std::string& table_path, bool same) {
  if (provenance.spec.empty() || provenance.spec_sha256.empty()) return "";
  const fs::path named = provenance.spec;
  const fs::path folder = fs::path(table_path).parent_path();
  std::string newer;
  for (const fs::path& path : {folder / named, folder / named.filename(), named}) {
    std::error_code none;
    if (!fs::is_regular_file(path, none)) continue;
    try {
      if (hex(sha256(read_file(path.string()))) == provenance.spec_sha256)
        return same ? path.lexically_normal().string() : "";
    } catch (const InputError&) {
      continue;  // it cannot be read
    }
    if (newer.empty()) newer = path.lexically_normal().string();
  }
  return same ? "" : newer;
}

std::string renewal(const Input& table, const std::string& spec_path) {
  std::string axis;
  bool over_its_master = true;
  try {
    const Spec spec = parse_spec(read_file(spec_path), spec_path);
    over_its_master = table.labels.over_master || !spec.over_master();
    for (const AxisPart& part : spec.parts())
      if (names_axis(table.file, part.name)) axis = " --axis " + part.name;
  } catch (const InputError&) {
    // the spec has errors of its own
  }
  const std::string over = over_its_master ? "" : " --over time";
  const std::string spec = printable(spec_path) + axis + over;
  const std::string file = table.file == "-" ? "TABLE" : printable(table.file);
  if (table.format == nullptr && (file.ends_with(".csv") || file.ends_with(".json")))
    return "jounce design " + spec + " -o " + file;
  const bool needs_form =
      table.format != nullptr && exchange_format_of_path(table.file) != table.format;
  return "jounce convert " + spec + " " + file +
         (needs_form ? std::string(" --to ") + table.format->name : "");
}

namespace design_detail {

void judge_against(const Input& input, Report& report) {
  const AgainstSpec& against = *input.against;
  const std::string spec = printable(against.spec);
  const std::string again = "make the table again: `" + renewal(input, against.spec) + "`";
  sort(report);
  bool has_remedy = false;  // one remedy for all limits that only the table exceeds
  for (Finding& f : report.findings) {
    if (!f.broken || f.rule.family() != RuleFamily::limit || f.rule.name().ends_with("_step"))
      continue;  // a step has its remedy
    const bool is_known = std::find(against.broken.begin(), against.broken.end(), f.rule.text()) !=
                          against.broken.end();
    f.advice = is_known ? "the curve of " + spec + " exceeds this limit, too: `jounce check " +
                              spec + "` gives the remedy"
                        : "only the table exceeds this limit; the curve of " + spec + " keeps it" +
                              (std::exchange(has_remedy, true) ? "" : ": " + again);
  }
  if (against.limits_only) return;
  Finding f;
  f.rule = "table/position";
  f.quantity = "position";
  f.axis = "table";
  f.where = against.error.where;
  f.value = against.error.position;
  f.limit = against.tolerance;
  f.margin = 1 - f.value / f.limit;
  f.broken = f.value > f.limit;
  if (f.broken) f.advice = again + ", or permit the deviation with --tolerance";
  report.findings.push_back(std::move(f));
}

Finding older_table(const Input& input) {
  Finding f;
  f.rule = "warning/older_table";
  f.quantity = printable(input.newer_spec);
  f.severity = Severity::warning;
  f.has_limit = false;
  f.advice = "make it again: `" + renewal(input, input.newer_spec) +
             "`, or compare it: --against " + f.quantity;
  return f;
}

}  // namespace design_detail
}  // namespace jounce
