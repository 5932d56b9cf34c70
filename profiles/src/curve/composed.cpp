// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/composed.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/over_length.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

// A piece of the inner curve, y(s) for s in [0, 1], lies within one segment of the outer curve,
// F(r) with r = (y - b) / L. b is the break at which this segment begins, L its length. Relative to
// the start of the piece, r = r0 + d(s) with d(0) = 0. In this form no terms cancel, however many
// segments precede b:
//
//   (1)  r0 = (y(0) - b) / L,   d(s) = (y(s) - y(0)) / L
//   (2)  F(r0 + d) = sum over k of F_k d^k,   F_k the Taylor coefficients of F at r0
//   (3)  A sin(w (r0 + d1 s) + p) = A sin(w d1 s + (p + w r0))   where d = d1 s
//
// (2) is evaluated by Horner's rule over polynomials. Far from the axis' origin (1) has few digits
// in a short segment, and so has the place where y passes a break. So r0 is set to 0 or 1 if the
// piece begins at a break; within a segment, it continues the previous piece. A piece that ends at
// a break, r1, ends there exactly: both d and the piece's length are multiplied by
//
//   (4)  (r1 - r0) / d(1)
//
// This moves the place by rounding and does not change the slope.
//
// If (2) and (3) do not fit and a tolerance is given, F(r0 + d) is fitted (detail/hermite.hpp). (2)
// with series for F and d gives its coefficients at both ends and the majorant of the twelfth
// derivative.
//
// In a short piece, the differences of both ends are mostly rounding, which the coefficients of the
// fit multiply. The series at the start has no such differences: each of its coefficients is exact
// to the rounding of its own terms. By Taylor's theorem, without the terms beyond s^n the error of
// its k-th derivative with respect to s is at most
//
//   (5)  (n + 1)! / (n + 1 - k)! M_(n+1)
//
// M_n is coefficient n of the majorant. The k-th derivative itself is at most k! M_k. So the error is
// this share of a bound of the derivative:
//
//   (6)  C(n + 1, k) M_(n+1) / M_k
//
// If it is below rounding for k = 1, 2 and 3, the series is the better fit.

namespace jounce {
namespace {

using profiles_detail::rounded_root;
using profiles_detail::rounded_sum;
using profiles_detail::rounded_value;
using profiles_detail::two_roundings;

constexpr double same_travel = 1e-6;  ///< share of a travel by which (4) may correct it
constexpr double most_breaks = 1e6;

bool is_linear(const Segment& f) {
  return f.degree <= 1 && f.sines == 0;
}

bool is_constant(const Segment& f) {
  return f.degree == 0 && f.sines == 0;
}

/// p(s) = p(s) * d(s) + c, both without sines; the degree of the result must fit.
void multiply_add(Segment& p, const Segment& d, double c) {
  std::array<double, Segment::max_degree + 1> product{};
  for (std::size_t i = 0; i <= static_cast<std::size_t>(p.degree); ++i)
    for (std::size_t k = 1; k <= static_cast<std::size_t>(d.degree); ++k)
      product[i + k] += p.c[i] * d.c[k];
  product[0] += c;
  p.c = product;
  p.degree = std::min(p.degree + d.degree, Segment::max_degree);
  while (p.degree > 0 && p.c[static_cast<std::size_t>(p.degree)] == 0) --p.degree;
}

/// F(r0 + u) as a polynomial and sines of u: a part of the outer segment, for any r0.
Segment about(const Segment& f, double r0) {
  Segment g = f;
  for (int i = 0; i < g.degree; ++i)
    for (int k = g.degree - 1; k >= i; --k)
      g.c[static_cast<std::size_t>(k)] += r0 * g.c[static_cast<std::size_t>(k) + 1];
  for (std::size_t i = 0; i < static_cast<std::size_t>(g.sines); ++i)
    g.sine[i].phase += g.sine[i].angle * r0;
  return g;
}

/// A piece of the inner curve that is within one segment of the outer curve. That segment begins at
/// `start`.
struct Piece {
  Segment outer;
  double start = 0;
  Segment inner;
  double r0 = 0;
  std::optional<double> r1 = {};  ///< set if the piece ends at a break

  [[nodiscard]] double end() const {
    return r1 ? *r1 : r0 + (value(inner, 1) - value(inner, 0)) / outer.length;
  }
};

/// The piece by (2) and (3); nullopt if it does not fit a segment.
std::optional<Segment> substituted(const Piece& p) {
  const Segment f = about(p.outer, p.r0);
  const double y0 = value(p.inner, 0);
  if (is_constant(p.inner)) return line(p.inner.length, value(f, 0), value(f, 0));
  const double slope = f.c[1] / p.outer.length;
  if (is_linear(f) && slope == 0) return line(p.inner.length, f.c[0], f.c[0]);
  if (is_linear(f)) return scaled(p.inner, slope, f.c[0] - slope * y0);
  if (p.inner.sines > 0 || (f.sines > 0 && !is_linear(p.inner)) ||
      f.degree * p.inner.degree > Segment::max_degree)
    return std::nullopt;
  Segment d = scaled(p.inner, 1 / p.outer.length);
  d.c[0] = 0;
  const double travel = value(d, 1);
  if (p.r1 && travel != 0 && std::abs((*p.r1 - p.r0) / travel - 1) < same_travel) {  // (4)
    const double factor = (*p.r1 - p.r0) / travel;
    d = scaled(d, factor);
    d.length *= factor;
  }
  Segment g;
  for (int k = f.degree; k >= 0; --k) multiply_add(g, d, f.c[static_cast<std::size_t>(k)]);  // (2)
  g.length = d.length;
  g.sines = f.sines;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i)  // (3)
    g.sine[i] = {f.sine[i].amplitude, f.sine[i].angle * d.c[1], f.sine[i].phase};
  return g;
}

/// The segments of the outer curve for any position on its axis; outside its interval by its
/// policy.
template <class Outer>
class Places {
 public:
  explicit Places(const Curve<Outer>& f) : f_(f) {}

  struct Place {
    Segment segment;
    double start = 0;
  };
  [[nodiscard]] Place at(double y) const {
    const double turn = repeats(f_.outside()) ? turn_of(y) : 0;
    const double u = y - turn;
    if (f_.outside() == Extrapolation::hold && (u < f_.start() || u > f_.end())) {
      const bool before = u < f_.start();
      const double rest = before ? value(f_.segments().front(), 0) : value(f_.segments().back(), 1);
      return {line(f_.length(), rest, rest), y};
    }
    const auto breaks = f_.breaks();
    const auto it = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, u);
    const auto i = static_cast<std::size_t>(it - breaks.begin()) - 1;
    const double gone = turn / f_.length() * f_.advance();
    return {gone == 0 ? f_.segments()[i] : scaled(f_.segments()[i], 1, gone), breaks[i] + turn};
  }

  /// Appends every break from lo to hi, with a tolerance for rounding, in ascending order.
  void breaks_within(double lo, double hi, std::vector<double>& out) const {
    out.clear();
    const double rounding = two_roundings * std::max(std::abs(lo), std::abs(hi));
    lo -= rounding;
    hi += rounding;
    if ((hi - lo) / f_.length() * static_cast<double>(f_.segments().size()) > most_breaks &&
        repeats(f_.outside()))
      throw InputError("inner", hi - lo, "crosses more than 1e6 segments of the outer curve");
    const double last_turn = repeats(f_.outside()) ? turn_of(hi) : 0;
    for (double turn = repeats(f_.outside()) ? turn_of(lo) : 0; turn <= last_turn;
         turn += f_.length()) {
      const auto breaks = f_.breaks();
      const auto first = std::lower_bound(breaks.begin(), breaks.end(), lo - turn);
      for (auto it = first; it != breaks.end() && *it + turn <= hi; ++it) out.push_back(*it + turn);
    }
    out.erase(std::unique(out.begin(), out.end()), out.end());
  }

 private:
  [[nodiscard]] double turn_of(double y) const {
    return std::floor((y - f_.start()) / f_.length()) * f_.length();
  }
  const Curve<Outer>& f_;
};

/// Adds the difference between the inner curve's length and the sum of the pieces, which is
/// rounding, to one of the longest pieces. If a sum lies half-way between two doubles, half of the
/// difference is necessary, or another piece.
template <class Inner>
Curve<Inner> closed(std::vector<Segment> all, const Curve<Inner>& inner) {
  Curve<Inner> g(std::move(all), inner.start(), inner.outside());
  const double missing = inner.end() - g.end();
  if (missing == 0) return g;
  std::vector<Segment> pieces(g.segments().begin(), g.segments().end());
  std::vector<Segment*> longest;
  for (Segment& piece : pieces) longest.push_back(&piece);
  const auto last = longest.begin() + std::min<std::ptrdiff_t>(3, std::ssize(longest));
  std::partial_sort(longest.begin(), last, longest.end(),
                    [](const Segment* a, const Segment* b) { return a->length > b->length; });
  for (auto piece = longest.begin(); piece != last; ++piece)
    for (const double share : {1.0, 0.5, 0.75, 0.25, 1.5}) {
      const double length = (*piece)->length;
      if (std::abs(missing) > rounded_root * length) return g;
      (*piece)->length += share * missing;
      if (Curve<Inner> h(pieces, inner.start(), inner.outside()); h.end() == inner.end()) return h;
      (*piece)->length = length;
    }
  return g;
}

struct Cut {
  double s = 0;
  std::optional<double> level = {};  ///< the break of the outer curve that is passed there
};

/// The places where the inner segment passes a break of the outer curve, including 0 and 1.
template <class Outer>
void cuts(const Places<Outer>& places, const Segment& inner, std::vector<Cut>& out) {
  out.assign(1, Cut{});
  if (!is_constant(inner)) {
    const Trajectory alone({inner});
    const Range range = extrema(alone, 0);
    thread_local std::vector<double> levels;
    places.breaks_within(range.min.value, range.max.value, levels);
    for (const double level : levels)
      for (const double x : crossings(alone, 0, level)) out.push_back({x / inner.length, level});
  }
  out.push_back({1});
  std::stable_sort(out.begin(), out.end(), [](const Cut& a, const Cut& b) { return a.s < b.s; });
  constexpr double apart = 1e-13;  // smaller distances are rounding of `crossings`
  std::size_t kept = 0;
  for (std::size_t i = 1; i < out.size(); ++i) {
    if (out[i].s - out[kept].s >= apart) {
      out[++kept] = out[i];
    } else if (out[i].level) {
      out[kept].level = out[i].level;
    }
  }
  out.resize(kept + 1);
  out.front().s = 0;
  out.back().s = 1;
}

template <class Outer, class Inner>
void require_inside(const Curve<Outer>& outer, const Curve<Inner>& inner) {
  if (outer.outside() != Extrapolation::refuse) return;
  const Range range = extrema(inner, 0);
  const double rounding = rounded_sum * std::max(std::abs(outer.start()), std::abs(outer.end()));
  for (const Extremum& end : {range.min, range.max})
    if (end.value < outer.start() - rounding || end.value > outer.end() + rounding)
      throw InputError("inner", end.value,
                       "leaves the outer curve, which runs from " + number(outer.start()) + " to " +
                           number(outer.end()));
}

/// The segment of the outer curve that contains a piece of the inner curve, and the position in it.
template <class Outer>
Piece placed(const Places<Outer>& places, const Segment& y, std::optional<double> first,
             std::optional<double> last, const std::optional<Piece>& before) {
  const auto [segment, start] = places.at(value(y, 0.5));
  Piece p{segment, start, y, (value(y, 0) - start) / segment.length};
  const auto snapped = [&](double level) { return level == p.start ? 0.0 : 1.0; };
  const double rounding = rounded_value * std::abs(start) / segment.length;
  if (first) {
    if (const double r = snapped(*first); std::abs(r - p.r0) <= rounding + rounded_sum) p.r0 = r;
  } else if (before && before->start == start && std::abs(before->end() - p.r0) <= rounding) {
    p.r0 = before->end();
  }
  if (last) p.r1 = snapped(*last);
  return p;
}

[[noreturn]] void refuse(const Piece& p, double where) {
  throw InputError("composed", number(where),
                   "does not fit: an outer curve of degree " + std::to_string(p.outer.degree) +
                       " with " + std::to_string(p.outer.sines) + " sines, an inner of degree " +
                       std::to_string(p.inner.degree) + " with " + std::to_string(p.inner.sines) +
                       "; the product of the degrees may be 11, sines need the other to be linear");
}

/// A piece that needs a fit.
struct Fit {
  Piece p;

  [[nodiscard]] double length() const { return p.inner.length; }
  /// Coefficients at the start (s = 0) or at the end (s = 1).
  template <std::size_t n>
  [[nodiscard]] profiles_detail::Series<n> series(int s) const {
    profiles_detail::Series<n> d = profiles_detail::taylor<n>(p.inner, s);
    for (double& c : d) c /= p.outer.length;
    return profiles_detail::substituted(
        profiles_detail::taylor<n>(p.outer, s == 0 ? p.r0 : p.end()), d);
  }
  [[nodiscard]] profiles_detail::EndSeries end(int s) const { return series<6>(s); }
  [[nodiscard]] profiles_detail::Majorant majorant() const {
    profiles_detail::Majorant d = profiles_detail::majorant(p.inner, 1);
    for (double& c : d) c /= p.outer.length;
    return profiles_detail::substituted(profiles_detail::majorant(about(p.outer, p.r0), d[1]), d);
  }
  [[nodiscard]] double twelfth() const { return majorant().back(); }
  [[nodiscard]] std::pair<Fit, Fit> halves() const {
    Piece left = p;
    left.inner = part(p.inner, 0, 0.5);
    left.r1.reset();
    Piece right = p;
    right.inner = part(p.inner, 0.5, 1);
    right.r0 = left.end();
    return {{left}, {right}};
  }
};

/// True if the error (5) of the series up to s^n is at most `tolerance`, and (6) is rounding.
bool ends_at(std::size_t n, const profiles_detail::Majorant& bound, double tolerance) {
  constexpr double rounding = 1e-13;  // relative rounding in a fit
  double rest = bound[n + 1];
  if (!(rest <= tolerance)) return false;
  for (std::size_t k = 1; k < std::tuple_size_v<Jet>; ++k) {
    rest *= static_cast<double>(n + 2 - k) / static_cast<double>(k);
    if (!(rest <= rounding * bound[k])) return false;
  }
  return true;
}

/// The series of a short piece, with its error (5); nullopt if a fit is better.
std::optional<Segment> series_of(const Fit& piece, double tolerance, Jet& error) {
  const profiles_detail::Majorant bound = piece.majorant();
  std::size_t n = 5;
  while (n <= Segment::max_degree && !ends_at(n, bound, tolerance)) ++n;
  if (n > Segment::max_degree) return std::nullopt;
  const auto series = piece.series<Segment::max_degree + 1>(0);
  Segment f;
  f.length = piece.length();
  f.degree = static_cast<int>(n);
  std::copy_n(series.begin(), n + 1, f.c.begin());
  double stray = bound[n + 1];
  for (std::size_t k = 0; k < error.size(); ++k) {
    error[k] = std::max(error[k], stray);
    stray *= static_cast<double>(n + 1 - k) / f.length;
  }
  return f;
}

/// The composition, piece by piece. `otherwise` appends a replacement for a piece that does not fit
/// a segment.
template <class Outer, class Inner, class Otherwise>
Curve<Inner> assembled(const Curve<Outer>& outer, const Curve<Inner>& inner, Otherwise otherwise) {
  require_inside(outer, inner);
  const Places places(outer);
  std::vector<Segment> pieces;
  std::vector<Cut> cut;
  std::optional<Piece> before;
  for (std::size_t i = 0; i < inner.segments().size(); ++i) {
    const Segment& whole = inner.segments()[i];
    cuts(places, whole, cut);
    for (std::size_t k = 0; k + 1 < cut.size(); ++k) {
      before = placed(places, cut.size() == 2 ? whole : part(whole, cut[k].s, cut[k + 1].s),
                      cut[k].level, cut[k + 1].level, before);
      if (const auto f = substituted(*before)) {
        pieces.push_back(*f);
      } else {
        otherwise(*before, inner.breaks()[i] + cut[k].s * whole.length, pieces);
      }
    }
  }
  return closed(std::move(pieces), inner);
}

}  // namespace

template <class Outer, class Inner>
Curve<Inner> composed(const Curve<Outer>& outer, const Curve<Inner>& inner) {
  return assembled(outer, inner,
                   [](const Piece& p, double where, std::vector<Segment>&) { refuse(p, where); });
}

template <class Outer, class Inner>
Fitted<Inner> composed_within(const Curve<Outer>& outer, const Curve<Inner>& inner,
                              double tolerance) {
  double scale = 0;
  for (const Segment& f : outer.segments()) scale = std::max(scale, magnitude(f));
  profiles_detail::require_tolerance(tolerance, scale);
  Jet error{};
  auto curve = assembled(outer, inner, [&](const Piece& p, double, std::vector<Segment>& pieces) {
    if (const auto f = series_of(Fit{p}, tolerance, error)) {
      pieces.push_back(*f);
    } else {
      profiles_detail::fit(Fit{p}, tolerance, pieces, error);
    }
  });
  return {std::move(curve), error};
}

#define JOUNCE_INSTANTIATE(Outer, Inner)                                    \
  template Curve<Inner> composed(const Curve<Outer>&, const Curve<Inner>&); \
  template Fitted<Inner> composed_within(const Curve<Outer>&, const Curve<Inner>&, double);
JOUNCE_INSTANTIATE(OverTime, OverTime)
JOUNCE_INSTANTIATE(OverMaster, OverTime)
JOUNCE_INSTANTIATE(OverMaster, OverMaster)
JOUNCE_INSTANTIATE(OverLength, OverTime)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
