// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/version.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/detail/axes.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

namespace {

/// The requirements of [table] for its knots: "quintic_hermite, tolerance 0.01 mm".
std::string options_text(const TableOptions& options, const Labels& labels) {
  std::vector<std::string> parts;
  const auto add = [&](const char* key, double value, const std::string& unit) {
    if (value > 0) parts.push_back(fmt::format("{} {} {}", key, rounded(value), unit));
  };
  const Units& units = labels.units;
  const std::string rate = rate_unit(units.position, units.x, 1);
  if (options.rule) parts.emplace_back(name(*options.rule));
  if (options.intervals) parts.push_back(counted(*options.intervals, "interval"));
  add("tolerance", options.tolerance.value_or(0), units.position);
  if (options.target) {
    const Target& target = *options.target;
    parts.emplace_back("fewest knots");
    if (target.most) parts.push_back("most " + std::to_string(*target.most));
    add("velocity tolerance", target.velocity_tolerance.value_or(0), rate);
    add("spacing", target.spacing, units.x);
    add("resolution", target.x_step, units.x);
    add("position resolution", target.p_step, units.position);
    add("velocity resolution", target.v_step, rate);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Version version_of(const Input& input, const std::string& path) {
  Version version{printable(path) + (input.axis.empty() ? "" : " " + input.axis), *input.curve,
                  input.labels};
  const auto breaks = std::visit(
      [](const auto& curve) {
        return std::vector<double>(curve.breaks().begin(), curve.breaks().end());
      },
      *input.curve);
  version.knots.push_back(breaks.front());
  version.knot_names.emplace_back(input.labels.segments.empty() ? "" : "start");
  for (const auto& [label, first, last] : groups(breaks.size() - 1, input.labels)) {
    version.knots.push_back(breaks[last + 1]);
    version.knot_names.push_back(input.labels.segments.empty() ? "" : "end of " + label);
  }
  if (input.spec) version.limits = input.limits;
  if (input.spec && input.error) {
    version.table = input.table.table;
    version.table_options = options_text(input.options, input.labels);
  }
  return version;
}

namespace {

std::string not_comparable(bool first_over_master, const std::string& first,
                           const std::string& second) {
  const std::string cam = printable(first_over_master ? first : second);
  const std::string motion = printable(first_over_master ? second : first);
  return cam + " is over the master, " + motion +
         " over time: convert the first with `jounce convert " + cam +
         " FILE.csv --over time`, and compare FILE.csv with " + motion;
}

}  // namespace

void require_one_kind(const Input& before, const Input& after, const std::string& before_path,
                      const std::string& after_path) {
  if (before.labels.over_master != after.labels.over_master)
    throw InputError("", "", not_comparable(before.labels.over_master, before_path, after_path));
}

std::vector<std::pair<Input, Input>> paired_axes(std::vector<Input> before,
                                                 std::vector<Input> after,
                                                 const std::string& before_path,
                                                 const std::string& after_path,
                                                 const std::string& axis) {
  require_one_kind(before.front(), after.front(), before_path, after_path);
  const bool mixed = (before.size() == 1) != (after.size() == 1);
  if (!mixed || before.size() > 1) before = axes_named(std::move(before), axis, before_path);
  if (!mixed || after.size() > 1) after = axes_named(std::move(after), axis, after_path);
  std::vector<std::pair<Input, Input>> all;
  if (before.size() == 1 && after.size() == 1) {
    all.emplace_back(std::move(before.front()), std::move(after.front()));
    return all;
  }
  for (const auto& [some, others, file] :
       {std::tuple{&before, &after, &after_path}, {&after, &before, &before_path}})
    for (const Input& one : *some)
      if (std::none_of(others->begin(), others->end(),
                       [&](const Input& other) { return other.axis == one.axis; }))
        throw InputError("axis", "",
                         "is missing: " + *file +
                             (others->size() == 1 && others->front().axis.empty()
                                  ? " has only one axis, without a name; the other file has " +
                                        listed(*some, &Input::axis)
                              : one.axis.empty() ? " has the axes " + listed(*others, &Input::axis)
                                                 : " has no axis " + one.axis) +
                             ". Name the axis to compare");
  for (Input& one : before) {
    const auto other = std::find_if(after.begin(), after.end(),
                                    [&](const Input& each) { return each.axis == one.axis; });
    all.emplace_back(std::move(one), std::move(*other));
  }
  return all;
}

}  // namespace jounce
