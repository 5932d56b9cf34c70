// SPDX-License-Identifier: Apache-2.0
#include "design/src/path/path_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>

namespace jounce::design_detail {
namespace {

/// Error of a segment's derivative of this order, by rounding of its coefficients.
double rounding_of(const Segment& f, std::size_t order) {
  const double per_length = std::max(1, f.degree) / f.length;
  return 8 * std::numeric_limits<double>::epsilon() * magnitude(f) *
         std::pow(per_length, static_cast<double>(order));
}

/// Order of the derivative to which a finding refers.
std::size_t order_of(const std::string& quantity) {
  for (std::size_t k = 0; k < OverTime::names.size(); ++k)
    if (quantity.ends_with(OverTime::names[k])) return k;
  return 0;
}

/// The same for both sides of a break.
double rounding_at(const Trajectory& curve, double where, std::size_t order) {
  const auto breaks = curve.breaks();
  const auto at = std::lower_bound(breaks.begin(), breaks.end(), where);
  const auto i = static_cast<std::size_t>(at - breaks.begin());
  double sum = 0;
  if (i < curve.segments().size()) sum += rounding_of(curve.segments()[i], order);
  if (i > 0) sum += rounding_of(curve.segments()[i - 1], order);
  return sum;
}

}  // namespace

void discount_rounding(const Trajectory& curve, Report& report) {
  std::set<std::string> held;
  std::erase_if(report.findings, [&](Finding& f) {
    if (!f.broken) return false;
    const std::size_t order = order_of(f.quantity);
    const bool joint = f.rule.family() == RuleFamily::continuity;
    if (!joint && (f.rule.family() != RuleFamily::limit || !f.segment)) return false;
    const double excess = joint ? f.value : f.value - f.limit;
    const double rounding = joint ? rounding_at(curve, f.where, order)
                                  : rounding_of(curve.segments()[*f.segment], order);
    if (!(std::abs(excess) <= rounding)) return false;
    f.broken = false;
    f.margin = 0;
    f.advice.clear();
    return !held.insert(f.rule.text()).second;
  });
}

}  // namespace jounce::design_detail
