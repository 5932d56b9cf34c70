// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/table.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

double factor(const std::string& from, const std::string& to) {
  return from.empty() || to.empty() ? 1 : conversion(from, to);
}

void scale(std::optional<double>& limit, double by) {
  if (limit) *limit *= by;
}

/// Collects differences of text.
class Remarks {
 public:
  void say(const std::string& what, const std::string& before, const std::string& after) {
    if (before != after) all.push_back({what, before, after});
  }
  /// Numbers, which a conversion of units may have rounded.
  void say(const std::string& what, const std::optional<double>& before,
           const std::optional<double>& after, const std::string& unit, double scale = 0) {
    if (!before && !after) return;
    if (before && after) {
      const double size = std::max({scale, std::abs(*before), std::abs(*after)});
      if (std::abs(*before - *after) <= rounded_sum * size) return;
    }
    const bool near = before && after && six_digits(*before) == six_digits(*after);
    const auto text = [&](const std::optional<double>& value) {
      if (!value) return std::string();
      return (near ? number(*value) : six_digits(*value)) + (unit.empty() ? "" : " " + unit);
    };
    all.push_back({what, text(before), text(after)});
  }

  std::vector<Remark> all;
};

void say_limits(Remarks& remarks, const Limits& a, const Limits& b, const Labels& labels) {
  const auto& names = labels.over_master ? OverMaster::names : OverTime::names;
  remarks.say("limit position_min", a.position_min, b.position_min, labels.units.position);
  remarks.say("limit position_max", a.position_max, b.position_max, labels.units.position);
  const std::array rates{&Limits::velocity, &Limits::acceleration, &Limits::jerk};
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const std::string name(names[i + 1]);
    remarks.say("limit " + name, a.*rates[i], b.*rates[i], labels.unit_of(name));
  }
}

template <class Over>
std::vector<Remark> remarks_of(const Curve<Over>& a, const Curve<Over>& b, const Version& before,
                               const Version& after, const Units& old_units) {
  Remarks remarks;
  const double scale = std::max({std::abs(a.start()), std::abs(a.end()), b.length()});
  remarks.say("start", a.start(), b.start(), after.labels.units.x, scale);
  remarks.say("end", a.end(), b.end(), after.labels.units.x, scale);
  remarks.say("outside", name(a.outside()), name(b.outside()));
  const Units& units = after.labels.units;
  const char* axis = after.labels.over_master ? "unit of the master" : "unit of the time";
  if (!old_units.x.empty() && !units.x.empty()) remarks.say(axis, old_units.x, units.x);
  if (!old_units.position.empty() && !units.position.empty())
    remarks.say("unit of the position", old_units.position, units.position);
  if (before.limits && after.limits)
    say_limits(remarks, *before.limits, *after.limits, after.labels);
  return std::move(remarks.all);
}

/// True if this quantity is within the tolerance.
bool tolerated(const Change& change, std::size_t order, const Tolerance& tolerance) {
  const auto most = permitted(change, order, tolerance);
  return change.none() || !most || std::abs(change.largest.value) <= *most;
}

/// The table of a version as a version of its own.
Version version_of_table(const Version& version) {
  Version table{version.name, version.curve, version.labels};
  std::visit([&]<class Over>(Curve<Over>& curve) { curve = version.table->curve<Over>(); },
             table.curve);
  table.labels.segments.clear();
  return table;
}

/// The difference between the tables of two versions, if their requirements differ.
std::optional<Remark> table_remark(const Version& before, const Version& after,
                                   const Tolerance& tolerance) {
  if (!before.table || !after.table || before.table_options == after.table_options)
    return std::nullopt;
  const Comparison tables = compare(version_of_table(before), version_of_table(after), tolerance);
  if (tables.equal()) return std::nullopt;
  const auto text = [](const Version& version) {
    return jounce::counted(version.table->size(), "knot") + ", " +
           (version.table_options.empty() ? name(version.table->rule()) : version.table_options);
  };
  const Extremum& largest = tables.changes[0].largest;
  return Remark{"[table]", text(before),
                text(after) + "; the tables differ by up to " +
                    with_unit(std::abs(largest.value), after.labels.units.position) + " at " +
                    with_unit(largest.where, after.labels.units.x)};
}

template <class Over>
std::vector<double> places(const Version& version, const Curve<Over>& curve) {
  if (!version.knots.empty()) return version.knots;
  return {curve.breaks().begin(), curve.breaks().end()};
}

}  // namespace

std::optional<double> permitted(const Change& change, std::size_t order,
                                const Tolerance& tolerance) {
  if (tolerance.of[order]) return tolerance.of[order];
  if (tolerance.share) return *tolerance.share * change.span();
  const bool others = std::any_of(tolerance.of.begin(), tolerance.of.end(),
                                  [](const auto& one) { return one.has_value(); });
  if (others) return std::nullopt;
  return change.rounding;
}

bool Comparison::equal() const {
  return remarks.empty() &&
         std::none_of(beyond.begin(), beyond.end(), [](bool is_beyond) { return is_beyond; });
}

Version in_units(Version version, const Units& units) {
  const double x = factor(version.labels.units.x, units.x);
  const double y = factor(version.labels.units.position, units.position);
  if (x != 1 || y != 1)
    std::visit([&](auto& curve) { curve = scaled(curve, y, x); }, version.curve);
  for (double& knot : version.knots) knot *= x;
  if (version.limits) {
    scale(version.limits->position_min, y);
    scale(version.limits->position_max, y);
    scale(version.limits->velocity, y / x);
    scale(version.limits->acceleration, y / (x * x));
    scale(version.limits->jerk, y / (x * x * x));
  }
  version.labels.units = units;
  return version;
}

namespace {

/// Both over the master or both over time, in units that measure the same.
void require_comparable(const Version& before, const Version& after) {
  const std::string names = before.name + " and " + after.name + " cannot be compared: ";
  if (before.curve.index() != after.curve.index())
    throw InputError("", "",
                     names + (before.labels.over_master ? before.name : after.name) +
                         " is over the master, " +
                         (before.labels.over_master ? after.name : before.name) + " over time");
  const Units& old = before.labels.units;
  const Units& now = after.labels.units;
  for (const auto& [what, a, b] :
       {std::tuple(before.labels.over_master ? "master" : "time", &old.x, &now.x),
        {"position", &old.position, &now.position}})
    try {
      (void)factor(*a, *b);
    } catch (const InputError&) {
      throw InputError("", "",
                       names + "the unit of the " + what + " is `" + *a + "` in the first and `" +
                           *b + "` in the second");
    }
}

}  // namespace

Comparison compare(const Version& before, const Version& after, const Tolerance& tolerance) {
  const Units& units = after.labels.units;
  require_comparable(before, after);
  const Version old = in_units(before, units);
  return std::visit(
      [&]<class Over>(const Curve<Over>& b) -> Comparison {
        const auto* a = &std::get<Curve<Over>>(old.curve);
        Comparison result{before.name, after.name, after.labels, compare(*a, b), {}, {}, {},
                          {},          {}};
        for (std::size_t k = 0; k < result.beyond.size(); ++k)
          result.beyond[k] = !tolerated(result.changes[k], k, tolerance);
        result.knots = knot_changes(*a, places(old, *a), b, places(after, b));
        result.knot_names_before = before.knot_names;
        result.knot_names_after = after.knot_names;
        result.remarks = remarks_of(*a, b, old, after, before.labels.units);
        if (auto remark = table_remark(before, after, tolerance))
          result.remarks.push_back(*std::move(remark));
        return result;
      },
      after.curve);
}

}  // namespace jounce
