// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/profiles/detail/common_pieces.hpp"
#include "jounce/profiles/error.hpp"

// Bounds of the rounding error. Each number of a segment has a relative error of a few epsilon. So
// the error of the segment's value is
//
//   (1)  r_0 = 16 eps M,   M the sum of the magnitudes of its terms,
//
// Each derivative with respect to u multiplies this by at most n / L for a polynomial of degree n
// over a length L, and by w / L for a sine that turns through the angle w:
//
//   (2)  r_k = r_0 (max(1, n, w) / L)^k.
//
// M includes the value itself: the jerk of a table is computed from differences of its positions,
// so it has the rounding of the positions.
//
// Sines that do not fit. If a sine A sin(h s + phase) turns through h <= 1/16 over a piece, the
// error of the k-th derivative of its Taylor polynomial of degree 11 is at most
//
//   (3)  A (h / L)^k h^(12-k) / (12-k)!  <=  4e-17 A (h / L)^k   for k <= 3,
//
// which is less than (2) by two orders of magnitude.
namespace jounce {
namespace {

constexpr double widest_angle = 1.0 / 16;  // see (3)

double widest(const Segment& f) {
  double angle = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i)
    angle = std::max(angle, std::abs(f.sine[i].angle));
  return angle;
}

/// Rounding of a segment by (1), (2).
Jet rounding_of(const Segment& f) {
  const double growth = std::max({1.0, static_cast<double>(f.degree), widest(f)}) / f.length;
  Jet r{16 * std::numeric_limits<double>::epsilon() * magnitude(f)};
  for (std::size_t k = 1; k < r.size(); ++k) r[k] = r[k - 1] * growth;
  return r;
}

Jet added(const Jet& a, const Jet& b) {
  Jet c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = a[k] + b[k];
  return c;
}

/// f with each sine replaced by its Taylor polynomial; the sines must extend over at most
/// widest_angle.
Segment expanded(const Segment& f) {
  Segment g = f;
  g.sines = 0;
  g.sine = {};
  g.degree = Segment::max_degree;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const auto& [amplitude, angle, phase] = f.sine[i];
    const std::array cycle{std::sin(phase), std::cos(phase), -std::sin(phase), -std::cos(phase)};
    double factor = amplitude;
    for (std::size_t k = 0; k < g.c.size(); ++k) {
      g.c[k] += factor * cycle[k % 4];
      factor *= angle / static_cast<double>(k + 1);
    }
  }
  return g;
}

/// after - before, both of one length, as a single segment or as the number that (3) requires.
std::vector<Segment> subtracted(const Segment& after, const Segment& before) {
  const Segment minus = scaled(before, -1);
  if (const auto one = sum(after, minus)) return {*one};
  std::vector<Segment> all;
  const double n = std::ceil(std::max(widest(after), widest(before)) / widest_angle);
  for (double i = 0; i < n; ++i)
    all.push_back(
        *sum(expanded(part(after, i / n, (i + 1) / n)), expanded(part(minus, i / n, (i + 1) / n))));
  return all;
}

/// The greatest difference; if some differences are beyond rounding, the greatest of them.
template <class Over>
Change largest_change(const Difference<Over>& d, const std::vector<Ranges>& ranges, std::size_t k) {
  Change change;
  bool beyond = false;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Extremum& here = ranges[i][k].peak();
    const double rounding = d.rounding[i][k];
    const bool counts = std::abs(here.value) > rounding;
    const bool first = i == 0 || (counts && !beyond);
    if (!first && (counts != beyond || std::abs(here.value) <= std::abs(change.largest.value)))
      continue;
    change.largest = here;
    change.rounding = rounding;
    beyond = beyond || counts;
  }
  return change;
}

}  // namespace

bool Change::none() const {
  return std::abs(largest.value) <= rounding;
}

double Change::span() const {
  return std::max(before.max.value - before.min.value, after.max.value - after.min.value);
}

bool Change::within(double share) const {
  return none() || std::abs(largest.value) <= share * span();
}

template <class Over>
Difference<Over> difference(const Curve<Over>& before, const Curve<Over>& after) {
  std::vector<Segment> segments;
  std::vector<Jet> rounding;
  std::optional<double> start;
  profiles_detail::for_common_pieces(
      before, after,
      [&](double x, const Segment& f, std::size_t i, const Segment& g, std::size_t k) {
        if (!start) start = x;
        for (const Segment& piece : subtracted(g, f)) {
          segments.push_back(piece);
          rounding.push_back(
              added(rounding_of(before.segments()[i]), rounding_of(after.segments()[k])));
        }
      });
  if (!start)
    throw InputError("interval", number(after.start()) + " to " + number(after.end()),
                     "does not overlap the interval of the other curve, " + number(before.start()) +
                         " to " + number(before.end()));
  return {Curve<Over>(std::move(segments), *start), std::move(rounding)};
}

template <class Over>
Changes compare(const Curve<Over>& before, const Curve<Over>& after) {
  const Difference<Over> d = difference(before, after);
  std::vector<Ranges> ranges;
  ranges.reserve(d.rounding.size());
  for (std::size_t i = 0; i < d.rounding.size(); ++i) ranges.push_back(segment_extrema(d.curve, i));
  const Ranges of_before = extrema(before);
  const Ranges of_after = extrema(after);
  Changes changes;
  for (std::size_t k = 0; k < changes.size(); ++k) {
    changes[k] = largest_change(d, ranges, k);
    changes[k].before = of_before[k];
    changes[k].after = of_after[k];
  }
  return changes;
}

namespace {

using Knot = KnotChange::Knot;

template <class Over>
std::vector<Knot> knots_of(const Curve<Over>& f, std::span<const double> places) {
  std::vector<Knot> all;
  for (const double place : places) {
    const double x = std::clamp(place, f.start(), f.end());
    all.push_back({all.size(), place, f.jet(x, x == f.end() ? Side::left : Side::right)});
  }
  return all;
}

/// The greater rounding of the two segments next to x.
template <class Over>
Jet rounding_at(const Curve<Over>& f, double x) {
  const auto breaks = f.breaks();
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - breaks.begin()) - 1;
  Jet r = rounding_of(f.segments()[i]);
  if (i > 0) {
    const Jet left = rounding_of(f.segments()[i - 1]);
    for (std::size_t k = 0; k < r.size(); ++k) r[k] = std::max(r[k], left[k]);
  }
  return r;
}

/// The changes of the knots: first the pairs, then the knots without a pair.
template <class Over>
class Matching {
 public:
  Matching(const Curve<Over>& before, std::span<const double> a, const Curve<Over>& after,
           std::span<const double> b)
      : before_(before), after_(after), a_(knots_of(before, a)), b_(knots_of(after, b)) {
    for (const auto& knots : {a, b})
      if (!knots.empty())
        scale_ = std::max({scale_, std::abs(knots.front()), std::abs(knots.back())});
  }

  std::vector<KnotChange> run() {
    std::size_t i = 0;  // i: first knot of a without a pair; k: the same for b
    std::size_t k = 0;
    for (std::size_t m = 0, n = 0; m < a_.size() && n < b_.size();) {
      if (profiles_detail::same_place(a_[m].where, b_[n].where, scale_)) {
        gap(i, m, k, n);
        pair(a_[m], b_[n]);
        i = ++m;
        k = ++n;
      } else {
        ++(a_[m].where < b_[n].where ? m : n);
      }
    }
    gap(i, a_.size(), k, b_.size());
    return std::move(changes_);
  }

 private:
  /// Among the knots of `all` in [first, last), the one nearest to x; the first one of equals.
  static std::size_t nearest(const std::vector<Knot>& all, std::size_t first, std::size_t last,
                             double x) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(last);
    const auto above = std::lower_bound(
        begin, end, x, [](const Knot& knot, double place) { return knot.where < place; });
    if (above == begin) return first;
    const auto below = above - 1;
    const bool up = above != end && above->where - x < x - below->where;
    return static_cast<std::size_t>((up ? above : below) - all.begin());
  }

  /// Handles the interval between two knots that stayed: knots [i, m) of a, and [k, n) of b.
  void gap(std::size_t i, std::size_t m, std::size_t k, std::size_t n) {
    while (i < m || k < n) {
      const std::size_t mate = i < m && k < n ? nearest(b_, k, n, a_[i].where) : n;
      const bool moved = mate < n && nearest(a_, i, m, b_[mate].where) == i;
      // All knots of b before the partner, or before the next one of a, have been added.
      if (k < n && (moved ? k < mate : i == m || b_[k].where < a_[i].where)) {
        changes_.push_back({.after = b_[k++]});
      } else if (moved) {
        pair(a_[i++], b_[k++]);
      } else {
        changes_.push_back({.before = a_[i++]});
      }
    }
  }

  void pair(const Knot& a, const Knot& b) {
    KnotChange change{.before = a, .after = b};
    change.moved = !profiles_detail::same_place(a.where, b.where, scale_);
    const Jet rounding = added(rounding_at(before_, a.where), rounding_at(after_, b.where));
    bool any = change.moved;
    for (std::size_t order = 0; order < change.changed.size(); ++order) {
      change.changed[order] = std::abs(b.jet[order] - a.jet[order]) > rounding[order];
      any = any || change.changed[order];
    }
    if (any) changes_.push_back(change);
  }

  const Curve<Over>& before_;
  const Curve<Over>& after_;
  std::vector<Knot> a_, b_;
  double scale_ = 0;
  std::vector<KnotChange> changes_;
};

}  // namespace

template <class Over>
std::vector<KnotChange> knot_changes(const Curve<Over>& before,
                                     std::span<const double> knots_before, const Curve<Over>& after,
                                     std::span<const double> knots_after) {
  return Matching<Over>(before, knots_before, after, knots_after).run();
}

#define JOUNCE_INSTANTIATE(Over)                                                             \
  template struct Difference<Over>;                                                          \
  template Difference<Over> difference(const Curve<Over>&, const Curve<Over>&);              \
  template Changes compare(const Curve<Over>&, const Curve<Over>&);                          \
  template std::vector<KnotChange> knot_changes(const Curve<Over>&, std::span<const double>, \
                                                const Curve<Over>&, std::span<const double>);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
