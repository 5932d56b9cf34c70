// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/table_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/pvt/detail/knot_rounding.hpp"

#include "design/src/check/master_check.hpp"
#include "design/src/check/slave_advice.hpp"
#include "design/src/check/step_check.hpp"

namespace jounce::design_detail {
namespace {

using pvt_detail::KnotRounding;

KnotRounding rounding_of(const Table& table, const Input& input) {
  return KnotRounding(table, input.labels.over_master ? 0 : usual_cycle(input.labels.units.x));
}

void join(Report& all, Report part) {
  std::move(part.findings.begin(), part.findings.end(), std::back_inserter(all.findings));
}

bool limits_the_slave(const Input& input) {
  return input.labels.over_master && input.spec && input.spec->master &&
         has_slave_limits(*input.spec);
}

/// The order of a finding's quantity, in these names; 4 if it has none of them.
std::size_t order_in(const std::array<const char*, 4>& names, const Finding& finding) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), finding.quantity) -
                                  names.begin());
}

/// True for an excess of a cam over a master that an executor tolerates, too (admit() in axis/job.hpp).
bool is_tolerated(const Finding& f, std::size_t order) {
  const double share = order == 3 ? profiles_detail::rounded_jerk : profiles_detail::rounded_input;
  return order == 0 || std::abs(f.value - f.limit) <= share * std::abs(f.limit);
}

/// True for a finding of a limit of the table that is no more than the rounding of its knots, and the
/// rise of its interval.
bool is_rounding(const Finding& f, const Table& table, const KnotRounding& rounding,
                 std::span<const Jet> rises = {}) {
  const auto& names = table.axis() == Domain::time ? OverTime::names : OverMaster::names;
  const std::size_t order = order_in(names, f);
  if (order >= names.size() || !f.segment) return false;
  if (order == 0) return std::abs(f.value - f.limit) <= rounding.of(0, *f.segment);
  const double rise = rises.empty() ? 0 : rises[*f.segment][order];
  return std::abs(f.limit) >=
         rounding.least_limit(order, *f.segment, std::max(std::abs(f.value) - rise, 0.0));
}

/// The same for a limit of the slave over time.
bool is_slave_rounding(const Finding& f, const Spec& spec, const KnotRounding& rounding) {
  const std::size_t order = order_in(OverTime::names, f);
  if (order >= OverTime::names.size() || !f.segment || !is_tolerated(f, order)) return false;
  const double w = spec.master->velocity;
  const double a = master_rates(spec).acceleration;
  double error = rounding.of(order, *f.segment);
  for (std::size_t k = 0; k < order; ++k) error *= w;
  if (order == 2) error += a * rounding.of(1, *f.segment);
  if (order == 3) error += 3 * w * a * rounding.of(2, *f.segment);
  const std::string own = rate_unit(spec.units.position, spec.time_unit, static_cast<int>(order));
  return std::abs(f.value - f.limit) <= error * conversion(own, f.unit);
}

/// The broken limits of a table itself.
Report own_limits(const Table& table, const Limits& limits, const KnotRounding& rounding,
                  std::span<const Jet> rises) {
  Report report = check(table, limits);
  std::erase_if(report.findings, [&](const Finding& f) {
    return !f.broken || is_rounding(f, table, rounding, rises);
  });
  return report;
}

/// The broken limits of a slave over time that moves on a table.
Report slave_limits(const Table& table, const Spec& spec, const KnotRounding& rounding) {
  Report report = jounce::check_slave(table.curve<OverMaster>(), spec);
  std::erase_if(report.findings, [&](const Finding& f) {
    return !f.broken || is_slave_rounding(f, spec, rounding);
  });
  return report;
}

/// The remedy for a table that exceeds a limit of its curve. Tables with a tolerance, and those with
/// the fewest knots, get more knots where a limit requires them, unless [table] prevents this.
const char* advice_for_table(const TableOptions& options) {
  if (options.intervals)
    return "only the table exceeds this limit, with its present intervals; the curve keeps it. "
           "Increase "
           "intervals in [table], or replace it with tolerance, which adds knots where a limit "
           "requires them";
  if (options.target)
    return "only the table exceeds this limit, with its present knots; the curve keeps it. "
           "Increase most in "
           "[table], or remove its resolutions, so that knots can be added where a limit requires "
           "them";
  return "only the table exceeds this limit; the curve keeps it. Give [table] a smaller tolerance, "
         "more knots, or another rule";
}

/// True for one finding of a limit after a worse one.
class Seen {
 public:
  bool operator()(const Finding& f, const std::string& segment) {
    return !seen_.emplace(f.rule.text(), f.limit < 0, segment).second;
  }

 private:
  std::set<std::tuple<std::string, bool, std::string>> seen_;
};

}  // namespace

void keep_worst(Report& report, const Labels& labels) {
  Seen seen;
  std::erase_if(report.findings, [&](const Finding& f) {
    return f.broken && f.segment && f.rule.family() == RuleFamily::limit &&
           seen(f, labels.segment_of(f));
  });
}

namespace {

/// The excesses of limits that are only rounding become one finding for each limit, which is just
/// met. A limit that is broken elsewhere keeps its broken findings alone.
template <class IsRounding>
void meet(Report& report, const IsRounding& is_only_rounding) {
  std::set<std::string> met;
  std::set<std::string> broken;
  std::vector<bool> forgiven;
  for (const Finding& f : report.findings) {
    const bool breaks = f.broken && f.rule.family() == RuleFamily::limit;
    forgiven.push_back(breaks && is_only_rounding(f));
    if (breaks && !forgiven.back()) broken.insert(f.rule.text());
  }
  std::size_t k = 0;
  std::erase_if(report.findings, [&](Finding& f) {
    if (!forgiven[k++]) return false;
    f.broken = false;
    f.margin = 0;
    f.advice.clear();
    return broken.contains(f.rule.text()) || !met.insert(f.rule.text()).second;
  });
}

/// For a table without its spec.
void forgive_knots(Report& report, const Input& input) {
  if (report.ok()) return;
  const Table& table = input.table.table;
  const KnotRounding rounding = rounding_of(table, input);
  meet(report, [&](const Finding& f) {
    return !f.rule.name().starts_with("position") && is_rounding(f, table, rounding);
  });
}

}  // namespace

void forgive_rounding(Report& report, const Input& input) {
  if (!input.against) {
    if (!input.error) forgive_knots(report, input);
    return;
  }
  if (report.ok()) return;
  const AgainstSpec& against = *input.against;
  const Table& table = input.table.table;
  const KnotRounding rounding = rounding_of(table, input);
  const auto is_new = [&](const Finding& f) {
    return std::find(against.broken.begin(), against.broken.end(), f.rule.text()) ==
           against.broken.end();
  };
  meet(report, [&](const Finding& f) {
    const double beyond = std::abs(f.value - f.limit);
    if (f.rule.name().starts_with("position"))
      return is_new(f) && beyond <= std::min(against.error.position, against.tolerance);
    const bool of_slave =
        limits_the_slave(input) && order_in(OverTime::names, f) < OverTime::names.size();
    return beyond <= against.digits * std::abs(f.limit) ||
           (of_slave ? is_slave_rounding(f, *input.spec, rounding)
                     : is_rounding(f, table, rounding));
  });
}

Report check_slave(const Input& input) {
  if (!limits_the_slave(input)) return {};
  const Cam& cam = std::get<Cam>(*input.curve);
  Report report = jounce::check_slave(cam, *input.spec);
  forgive_rounding(report, input);
  keep_worst(report, input.labels);
  advise_on_slave(input, report);
  report.findings.push_back(master_finding(cam, *input.spec));
  const bool is_step =
      greatest_master_velocity(cam, input.spec->slave, master_rates(*input.spec)).is_step;
  if (input.against && !is_step && report.broken() == 1 && report.findings.back().broken)
    report.findings.pop_back();  // only by the rounding above
  return report;
}

Report check_table(const Table& table, const Input& input, const Report& of_curve,
                   std::span<const Jet> rises) {
  const auto breaks = [&](const auto& which) {
    return std::any_of(of_curve.findings.begin(), of_curve.findings.end(),
                       [&](const Finding& f) { return f.broken && which(f); });
  };
  if (breaks([](const Finding& f) { return f.rule.family() == RuleFamily::continuity; })) return {};
  const KnotRounding of_knots = rounding_of(table, input);
  Report report = own_limits(table, input.limits, of_knots, rises);
  if (limits_the_slave(input)) join(report, slave_limits(table, *input.spec, of_knots));
  sort(report);
  Seen seen;
  std::erase_if(report.findings, [&](const Finding& f) {
    return breaks([&](const Finding& of) { return of.rule == f.rule; }) || seen(f, "");
  });
  for (Finding& finding : report.findings) {
    finding.axis = "table";
    finding.segment = std::nullopt;
    finding.advice = advice_for_table(input.options);
  }
  return report;
}

Report check_converted(const Table& table, const Input& input, const FileRounding& file) {
  Report of_curve = of_motion(input, [&](const auto& motion) {
    Report all = check(motion, input.limits);
    join(all, check_continuity(motion, 1));
    return all;
  });
  if (of_curve.findings.empty() && !limits_the_slave(input)) return {};
  join(of_curve, check_slave(input));
  Report report = check_table(table, input, of_curve, file.rises);
  std::erase_if(report.findings, [&](const Finding& f) {
    const bool is_position = f.rule == "limit/position_max" || f.rule == "limit/position_min";
    return is_position || std::abs(f.value - f.limit) <= file.share * std::abs(f.limit);
  });
  return report;
}

}  // namespace jounce::design_detail
