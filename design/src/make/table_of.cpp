// SPDX-License-Identifier: Apache-2.0
#include "design/src/make/table_of.hpp"

#include <algorithm>
#include <string>
#include <type_traits>

#include "jounce/controllers/table_target.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce::design_detail {
namespace {

constexpr double fine_table = 1e-9;  ///< share of the stroke

/// True if the acceleration steps at a knot; a quintic requires a single acceleration there. Steps
/// at the ends of a curve that does not repeat are outside the table.
template <class Over>
Interpolation rule_for(const Curve<Over>& curve, const TableOptions& options) {
  if (options.rule) return *options.rule;
  const Curve<Over> inside = repeats(curve.outside()) ? curve : with(curve, Extrapolation::refuse);
  return check_continuity(inside, 2).ok() ? Interpolation::quintic_hermite
                                          : Interpolation::cubic_hermite;
}

/// The default tolerance is a billionth of the stroke, below the resolution of encoders.
template <class Over>
double fine(const Curve<Over>& curve) {
  const Range travel = extrema(curve, 0);
  const double stroke = travel.max.value - travel.min.value;
  return fine_table * (stroke > 0 ? stroke : 1);
}

/// The table of fewest knots. Its errors have the keys of [table].
template <class Over>
Sampled fewest(const Curve<Over>& curve, Target target, const TableOptions& options,
               const TableLimits& limits) {
  target.rule = rule_for(curve, options);
  target.tolerance = options.tolerance;
  if (!target.tolerance && !target.velocity_tolerance && !target.most)
    target.tolerance = fine(curve);
  constexpr Domain axis = std::is_same_v<Over, OverTime> ? Domain::time : Domain::master;
  try {
    if (target.velocity_tolerance)
      require_certifiable(derivative(curve), "velocity_tolerance", *target.velocity_tolerance);
    return reduced(curve, target, limits.limits, limits.ramped);
  } catch (const InputError& error) {
    throw InputError("table." + spec_key(axis, error.key()), error.value(), error.rule());
  }
}

/// Throws Unresolved for a curve whose shortest segment vanishes beside its longest one.
template <class Over>
[[noreturn]] void fail_unresolved(const Curve<Over>& curve) {
  struct Extreme {
    std::size_t segment = 0;
    double start = 0;
    double length = 0;
  };
  Extreme longest;
  Extreme shortest{0, curve.start(), curve.end() - curve.start()};
  double start = curve.start();
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    const Extreme each{i, start, curve.segments()[i].length};
    if (each.length > longest.length) longest = each;
    if (each.length < shortest.length) shortest = each;
    start += each.length;
  }
  const auto text = [](const Extreme& each) {
    return "the segment of the length " + six_digits(each.length) +
           (std::is_same_v<Over, OverTime> ? ", at the time " : ", at master ") +
           six_digits(each.start);
  };
  throw Unresolved(longest.segment, "no table resolves both " + text(longest) + ", and " +
                                        text(shortest) +
                                        ": correct the velocity, distance or time that is far too "
                                        "small or too large");
}

}  // namespace

/// Makes the table. An error of a knot shows that doubles cannot resolve the curve.
template <class Over>
Sampled made(const Curve<Over>& curve, const TableOptions& options, const TableLimits& limits) {
  const Interpolation rule = rule_for(curve, options);
  if (options.intervals) return sample(curve, rule, *options.intervals);
  constexpr std::size_t most = 1'000'000;  // knots
  return sample_within(curve, rule, options.tolerance ? *options.tolerance : fine(curve),
                       limits.limits, most, limits.ramped);
}

template <class Over>
Sampled table_of(const Curve<Over>& curve, const TableOptions& options, const TableLimits& limits) {
  if (options.tolerance) require_certifiable(curve, "table.tolerance", *options.tolerance);
  if (options.target) return fewest(curve, *options.target, options, limits);
  try {
    return made(curve, options, limits);
  } catch (const InputError& error) {
    if (!error.key().starts_with("knot[")) throw;
    fail_unresolved(curve);
  }
}

template Sampled table_of(const Trajectory&, const TableOptions&, const TableLimits&);
template Sampled table_of(const Cam&, const TableOptions&, const TableLimits&);

}  // namespace jounce::design_detail
