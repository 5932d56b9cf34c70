// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "jounce/profiles/curve/over_length.hpp"
#include "jounce/profiles/detail/bernstein.hpp"
#include "jounce/profiles/detail/derivative_order.hpp"
#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::one_rounding;
using profiles_detail::rounded_digit;
using profiles_detail::rounded_root;
using profiles_detail::two_roundings;

/// Share of the magnitude of a segment by which rounding may change a sign.
constexpr double sign_rounding = 2e-15;
/// The greatest angle over which the Taylor polynomial of degree 11 replaces a sine to within
/// rounding: the remainder is at most angle^12 / 12! = 1.3e-16.
constexpr double widest_piece_angle = 0.25;

/// f with each sine, over at most widest_piece_angle, replaced by this polynomial. Otherwise a sine
/// and a polynomial that almost cancel (the error of a table) have no tight enclosure.
Segment as_polynomial(const Segment& f) {
  Segment g = f;
  g.sines = 0;
  g.degree = Segment::max_degree;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const auto& [amplitude, angle, phase] = f.sine[i];
    const double sn = std::sin(phase);
    const double cs = std::cos(phase);
    const std::array cycle{sn, cs, -sn, -cs};  // sin and its derivatives
    double factor = amplitude;
    for (std::size_t k = 0; k < g.c.size(); ++k) {
      g.c[k] += factor * cycle[k % 4];
      factor *= angle / static_cast<double>(k + 1);
    }
  }
  return g;
}

/// Finds the sign change of f, which is monotone over [a, b], by Newton's method inside a bracket.
void bracket(const Segment& f, double a, double b, std::vector<double>& out) {
  const double fa = value(f, a);
  const double fb = value(f, b);
  if (fa == 0 || fb == 0) {
    out.push_back(fa == 0 ? a : b);
    return;
  }
  if ((fa > 0) == (fb > 0)) {
    // The Bernstein form changes its sign at an end of the piece, where rounding gives f the
    // other sign: the root is that end.
    const double nearest = std::min(std::abs(fa), std::abs(fb));
    if (nearest <= sign_rounding * magnitude(f)) out.push_back(nearest == std::abs(fa) ? a : b);
    return;
  }
  double s = a + (b - a) * fa / (fa - fb);
  for (int i = 0; i < 100; ++i) {
    const Jet g = profiles_detail::evaluate(f, s);
    if (g[0] == 0) break;
    ((g[0] > 0) == (fa > 0) ? a : b) = s;
    const double newton = s - g[0] / (g[1] * f.length);
    const double next = newton > a && newton < b ? newton : (a + b) / 2;
    if (next == s || b - a <= one_rounding) break;
    s = next;
  }
  out.push_back(s);
}

/// Isolates the roots of f piece by piece; n is the degree of the Bernstein form.
template <std::size_t n>
struct Isolation {
  const Segment& f;
  double flat;
  double remainder;  // greatest difference of the polynomials from f, without rounding
  double border;     // the same at the ends of [a, b], with rounding
  double noise;      // greatest error of f = 0 by rounding
  std::vector<double>& out;

  /// Finds the roots of f over [a, b]; beta is its Bernstein form there.
  void run(double a, double b, const profiles_detail::Bernstein<n>& beta) const {
    const auto [lo, hi] = profiles_detail::hull<n>(beta);
    if (lo > border || hi < -border) return;
    if ((lo >= -flat && hi <= flat) || b - a < rounded_root) {
      out.push_back((a + b) / 2);
      return;
    }
    if (is_monotone(beta)) {
      bracket(f, a, b, out);
      return;
    }
    if (lo >= -noise && hi <= noise) {  // a multiple root: all values here are within rounding
      out.push_back((a + b) / 2);
      return;
    }
    profiles_detail::Bernstein<n> left;
    profiles_detail::Bernstein<n> right;
    profiles_detail::halve<n>(beta, left, right);
    const double middle = (a + b) / 2;
    run(a, middle, left);
    run(middle, b, right);
  }

  [[nodiscard]] bool is_monotone(const profiles_detail::Bernstein<n>& beta) const {
    bool rises = true;
    bool falls = true;
    for (std::size_t i = 0; i < n; ++i) {
      const double difference = beta[i + 1] - beta[i];
      rises = rises & (difference > remainder);
      falls = falls & (difference < -remainder);
    }
    return rises || falls;
  }
};

double noise_of(const Segment& f) {
  return rounded_digit * magnitude(f);
}

void isolate_sines(const Segment& f, double flat, std::vector<double>& out) {
  double widest = 0;
  double remainder = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    widest = std::max(widest, std::abs(f.sine[i].angle));
    remainder += one_rounding * std::abs(f.sine[i].amplitude);
  }
  constexpr std::size_t n = Segment::max_degree;
  // The pieces do not share their ends: by rounding, a root between two pieces may be in neither of them.
  const double border = std::max(remainder, noise_of(f));
  const Isolation<n> isolation{f, flat, remainder, border, noise_of(f), out};
  const double pieces = std::max(1.0, std::ceil(widest / widest_piece_angle));
  for (int i = 0; i < static_cast<int>(pieces); ++i) {
    const double a = i / pieces;
    const double b = (i + 1) / pieces;
    isolation.run(a, b, profiles_detail::to_bernstein<n>(as_polynomial(part(f, a, b))));
  }
}

void isolate(const Segment& f, double flat, std::vector<double>& out) {
  if (f.sines > 0) return isolate_sines(f, flat, out);
  profiles_detail::with_degree(static_cast<std::size_t>(f.degree), [&](auto n) {
    Isolation<n>{f, flat, 0, 0, noise_of(f), out}.run(0, 1, profiles_detail::to_bernstein<n>(f));
  });
}

}  // namespace

void roots(const Segment& f, double flat, std::vector<double>& out) {
  out.clear();
  isolate(f, flat, out);
  std::erase_if(out, [](double s) { return s <= 0 || s >= 1; });
  std::sort(out.begin(), out.end());
  out.erase(
      std::unique(out.begin(), out.end(), [](double a, double b) { return b - a < rounded_root; }),
      out.end());
}

namespace {

/// Appends every s in [0, 1] at which g is zero; an interval in which |g| <= `flat` counts once.
void zeros(const Segment& g, double flat, std::vector<double>& out) {
  thread_local std::vector<double> interior;
  roots(g, flat, interior);
  out.clear();
  const auto is_new = [&](double s) {
    return out.empty() || std::abs(value(g, (out.back() + s) / 2)) > flat;
  };
  if (std::abs(value(g, 0)) <= flat) out.push_back(0);
  for (const double s : interior)
    if (is_new(s)) out.push_back(s);
  if (std::abs(value(g, 1)) > flat) return;
  if (!is_new(1) && out.back() > 0) out.pop_back();  // a root next to an end is the end itself
  if (is_new(1)) out.push_back(1);
}

}  // namespace

template <class Over>
std::vector<double> crossings(const Curve<Over>& f, int order, double level) {
  profiles_detail::require_order(order);
  require_finite("level", level);
  std::vector<double> found;
  std::vector<double> s;
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    Segment g = f.segments()[i];
    for (int k = 0; k < order; ++k) g = derivative(g);
    const double flat = two_roundings * (magnitude(g) + std::abs(level));
    g.c[0] -= level;
    zeros(g, flat, s);
    for (const double at : s)
      found.push_back(at == 1 ? f.breaks()[i + 1] : f.breaks()[i] + at * g.length);
  }
  const double apart = rounded_root * f.length();
  const auto same = [&](double a, double b) { return b - a <= apart; };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

template std::vector<double> crossings(const Curve<OverTime>&, int, double);
template std::vector<double> crossings(const Curve<OverMaster>&, int, double);
template std::vector<double> crossings(const Curve<OverLength>&, int, double);

}  // namespace jounce
