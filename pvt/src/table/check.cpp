// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/check.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/detail/limit_check.hpp"
#include "jounce/profiles/error.hpp"

#include "pvt/src/table/hull_kernel.hpp"

// The exact search of extrema.cpp takes about 100 ns for each interval and order. Here it runs only
// in the intervals that can change the result, in ascending order, so that the result is the same.
// For each chunk, let U be the bound of an interval (hull_kernel.hpp), B the best value so far, and
// T a value that the chunk certainly takes. For the greatest value, an interval matters only if
//
//   (1)  U > B   and   U >= T - r,     r = 4 eps (|T| + |limit|)
//
// where r covers values that differ but whose margins round to the same number. If there is a limit
// G, it also matters if
//
//   (2)  U > G + 0.999e-12 max(|G|, scale),
//
// since no smaller value breaks the limit. For least values and lower limits the same holds
// with -f.

namespace jounce {
namespace {

using pvt_detail::Hulls;

/// One search: the greatest value of f (side 0) or of -f (side 1) for one order of derivative.
struct Sought {
  std::size_t order;
  std::size_t side;
  double rounding = 0;                                      ///< |limit| of (1)
  double broken = std::numeric_limits<double>::infinity();  ///< (2)
  double best = -std::numeric_limits<double>::infinity();   ///< B
  double least = -std::numeric_limits<double>::infinity();  ///< T - r

  void begin_chunk(const Hulls& hulls) {
    const double taken = hulls.taken[order][side];
    least = taken - 4 * std::numeric_limits<double>::epsilon() * (std::abs(taken) + rounding);
  }
  [[nodiscard]] bool matters(double bound) const {
    return bound > broken || (bound > best && bound >= least);
  }
};

bool is_finite(const Hulls& hulls) {
  return std::all_of(std::begin(hulls.greatest), std::end(hulls.greatest), [](const auto& sides) {
    return std::isfinite(sides[0]) && std::isfinite(sides[1]);
  });
}

/// Throws if a bound is NaN. If there is a segment at fault, the check of the curve names it.
void refuse(const Table& table) {
  if (table.axis() == Domain::time)
    (void)table.curve<OverTime>();
  else
    (void)table.curve<OverMaster>();
  throw InputError("knots", std::to_string(table.size()),
                   "have values or derivatives too large for a double");
}

/// The intervals [first, end).
struct Intervals {
  std::size_t first = 0;
  std::size_t end = 0;
};

Intervals all_of(const Table& table) {
  return {0, table.size() - 1};
}

/// Calls visit(index of the search, range, interval) for every interval that can matter to a
/// search; visit raises its `best`. The searches of one order are adjacent.
template <class Visit>
void search(const Table& table, const Intervals& within, std::vector<Sought>& sought, Visit visit) {
  const pvt_detail::KnotColumns knots = pvt_detail::knots_of(table.columns());
  const pvt_detail::HullKernel kernel = pvt_detail::hull_kernel();
  const auto visit_interval = [&](std::size_t i, const Hulls& hulls, std::size_t k) {
    Range range;
    std::size_t known = 4;  // the order whose range is known
    for (std::size_t b = 0; b < sought.size(); ++b) {
      const auto [order, side] = std::pair(sought[b].order, sought[b].side);
      if (!sought[b].matters(hulls.bound[order][side][k])) continue;
      if (known != order)
        range =
            segment_range(table.segment(i), knots.x[i], knots.x[i + 1], static_cast<int>(order));
      known = order;
      visit(b, range, i);
    }
  };
  Hulls hulls;
  for (std::size_t first = within.first; first < within.end; first += Hulls::size) {
    const std::size_t n = std::min(Hulls::size, within.end - first);
    kernel(knots, table.rule(), first, n, hulls);
    if (!is_finite(hulls)) refuse(table);
    bool any = false;
    for (Sought& s : sought) {
      s.begin_chunk(hulls);
      any = any || s.matters(hulls.greatest[s.order][s.side]);
    }
    for (std::size_t k = 0; any && k < n; ++k) visit_interval(first + k, hulls, k);
  }
}

const Extremum& extremum_of(const Range& range, std::size_t side) {
  return side == 0 ? range.max : range.min;
}
double signed_value(const Extremum& e, std::size_t side) {
  return side == 0 ? e.value : -e.value;
}

/// The ranges of the orders from `first` to `last`.
Ranges ranges_of(const Table& table, const Intervals& within, std::size_t first, std::size_t last) {
  std::vector<Sought> sought;
  for (std::size_t order = first; order <= last; ++order)
    for (const std::size_t side : {0U, 1U}) sought.push_back({.order = order, .side = side});
  Ranges ranges;
  search(table, within, sought, [&](std::size_t b, const Range& range, std::size_t) {
    Sought& s = sought[b];
    const Extremum& here = extremum_of(range, s.side);
    if (!(signed_value(here, s.side) > s.best)) return;
    s.best = signed_value(here, s.side);
    (s.side == 0 ? ranges[s.order].max : ranges[s.order].min) = here;
  });
  return ranges;
}

std::vector<Sought> sought_for(const profiles_detail::LimitCheck& found) {
  std::vector<Sought> sought;
  for (const profiles_detail::Bound& bound : found.bounds()) {
    const double limit = bound.upper ? bound.limit : -bound.limit;
    const double forgiven =
        0.999 * profiles_detail::forgiven * std::max(std::abs(limit), bound.scale);
    sought.push_back({.order = bound.order,
                      .side = bound.upper ? 0U : 1U,
                      .rounding = std::abs(limit),
                      .broken = limit + forgiven});
  }
  return sought;
}

const std::array<const char*, 4>& names_of(const Table& table) {
  return table.axis() == Domain::time ? OverTime::names : OverMaster::names;
}

/// The greatest step of every order, in one pass.
class Steps {
 public:
  void consider(const Jet& before, const Jet& after, double where, std::size_t from = 0) {
    for (std::size_t k = from; k < largest_.size(); ++k) {
      const double step = after[k] - before[k];
      if (std::abs(step) > std::abs(largest_[k].step)) largest_[k] = {step, where};
    }
  }
  [[nodiscard]] const std::array<Jump, 4>& largest() const { return largest_; }

 private:
  std::array<Jump, 4> largest_{};
};

std::array<Jump, 4> largest_jumps(const Table& table) {
  const auto at_end = [](const Segment& f) { return profiles_detail::evaluate(f, 1); };
  const auto at_start = [](const Segment& f) { return profiles_detail::evaluate(f, 0); };
  const auto& x = table.columns().x;
  const std::size_t last = table.size() - 2;
  Steps steps;
  const Segment first = table.segment(0);
  Jet before = at_end(first);
  for (std::size_t i = 1; i <= last; ++i) {
    const Segment f = table.segment(i);
    steps.consider(before, at_start(f), x[i]);
    before = at_end(f);
  }
  if (repeats(table.outside()))
    steps.consider(before, at_start(first), table.end(),
                   table.outside() == Extrapolation::wrap ? 0 : 1);
  // The table is at rest before its start and after its end.
  if (table.outside() == Extrapolation::hold) {
    steps.consider({}, at_start(first), table.start(), 1);
    steps.consider(before, {}, table.end(), 1);
  }
  return steps.largest();
}

}  // namespace

pvt_detail::HullKernel pvt_detail::hull_kernel() {
#ifdef JOUNCE_WIDE_KERNELS
  static const HullKernel best = __builtin_cpu_supports("avx512f") ? hulls_avx512
                                 : __builtin_cpu_supports("avx2")  ? hulls_avx2
                                                                   : hulls_anywhere;
  return best;
#else
  return hulls_anywhere;
#endif
}

Ranges extrema(const Table& table) {
  return ranges_of(table, all_of(table), 0, 3);
}

Ranges segment_extrema(const Table& table, std::size_t first, std::size_t last) {
  assert(first <= last && last + 1 < table.size());
  return ranges_of(table, {first, last + 1}, 0, 3);
}

Report check(const Table& table, const Limits& limits) {
  require_valid(limits);
  const bool one_end = profiles_detail::LimitCheck::needs_stroke(limits);
  const Range travel = one_end ? ranges_of(table, all_of(table), 0, 0)[0] : Range{};
  profiles_detail::LimitCheck found(limits, names_of(table), travel.max.value - travel.min.value);
  std::vector<Sought> sought = sought_for(found);
  if (sought.empty()) return {};
  search(table, all_of(table), sought, [&](std::size_t b, const Range& range, std::size_t i) {
    found.consider(b, range, table.columns().x[i], table.columns().x[i + 1], i);
    if (const auto closest = found.closest(b))
      sought[b].best = sought[b].side == 0 ? *closest : -*closest;
  });
  return std::move(found).report();
}

Report check_continuity(const Table& table, int order, double tolerance) {
  const auto& x = table.columns().x;
  return profiles_detail::continuity_report(extrema(table), largest_jumps(table), names_of(table),
                                            {x.front(), x.back(), repeats(table.outside())}, order,
                                            tolerance);
}

}  // namespace jounce
