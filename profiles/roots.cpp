#include "jounce/profiles/roots.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace jounce {
namespace {

struct Interval {
  double lo = 0;
  double hi = 0;
};

Interval operator+(Interval a, Interval b) {
  return {a.lo + b.lo, a.hi + b.hi};
}
bool excludes_zero(Interval a) {
  return a.lo > 0 || a.hi < 0;
}

/// The exact range of amplitude * sin over [from, to] (rad, any order).
Interval sine_range(double amplitude, double from, double to) {
  constexpr double pi = std::numbers::pi;
  if (from > to) std::swap(from, to);
  double lo = std::min(std::sin(from), std::sin(to));
  double hi = std::max(std::sin(from), std::sin(to));
  // A crest lies at pi/2 + 2 k pi, a trough half a turn later.
  const auto holds = [&](double at) {
    return std::floor((to - at) / (2 * pi)) >= std::ceil((from - at) / (2 * pi));
  };
  if (holds(pi / 2)) hi = 1;
  if (holds(-pi / 2)) lo = -1;
  return amplitude < 0 ? Interval{amplitude * hi, amplitude * lo}
                       : Interval{amplitude * lo, amplitude * hi};
}

using Bernstein = std::array<double, Segment::max_degree + 1>;

/// A piece [a, b] of the segment with the Bernstein coefficients of its polynomial over that piece.
struct Piece {
  double a = 0;
  double b = 1;
  Bernstein beta{};
};

Bernstein to_bernstein(const Segment& f) {
  // beta_i = sum over k <= i of C(i, k) / C(n, k) * c_k, by differences of the scaled coefficients.
  const auto n = static_cast<std::size_t>(f.degree);
  Bernstein beta{};
  double binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    beta[k] = f.c[k] / binomial;
    binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
  }
  for (std::size_t k = 1; k <= n; ++k)
    for (std::size_t i = n; i >= k; --i) beta[i] += beta[i - 1];
  return beta;
}

class Isolation {
 public:
  Isolation(const Segment& f, double flat, std::vector<double>& out)
      : f_(f), n_(static_cast<std::size_t>(f.degree)), flat_(flat), out_(out) {}

  void run(const Piece& piece) {
    const Interval range = enclosure(piece);
    if (excludes_zero(range)) return;
    const double middle = (piece.a + piece.b) / 2;
    if ((range.lo >= -flat_ && range.hi <= flat_) || piece.b - piece.a < 1e-13) {
      out_.push_back(middle);
      return;
    }
    const Interval slope = slope_enclosure(piece);
    if (excludes_zero(slope)) {
      bracket(piece.a, piece.b);
      return;
    }
    // The mean-value form closes in quadratically where the plain enclosure is slow (sines).
    const double radius = (piece.b - piece.a) / 2 * std::max(-slope.lo, slope.hi);
    if (std::abs(value(f_, middle)) > radius) return;
    const auto [left, right] = halves(piece);
    run(left);
    run(right);
  }

 private:
  [[nodiscard]] Interval enclosure(const Piece& piece) const {
    const auto end = piece.beta.begin() + static_cast<std::ptrdiff_t>(n_) + 1;
    const auto [lo, hi] = std::minmax_element(piece.beta.begin(), end);
    Interval range{*lo, *hi};
    for (std::size_t i = 0; i < static_cast<std::size_t>(f_.sines); ++i) {
      const auto& t = f_.sine[i];
      range =
          range + sine_range(t.amplitude, t.angle * piece.a + t.phase, t.angle * piece.b + t.phase);
    }
    return range;
  }

  [[nodiscard]] Interval slope_enclosure(const Piece& piece) const {
    Interval range;
    for (std::size_t i = 0; i < n_; ++i) {
      const double difference =
          static_cast<double>(n_) * (piece.beta[i + 1] - piece.beta[i]) / (piece.b - piece.a);
      range = i == 0 ? Interval{difference, difference}
                     : Interval{std::min(range.lo, difference), std::max(range.hi, difference)};
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(f_.sines); ++i) {
      const auto& t = f_.sine[i];
      const double quarter = t.phase + std::numbers::pi / 2;
      range = range + sine_range(t.amplitude * t.angle, t.angle * piece.a + quarter,
                                 t.angle * piece.b + quarter);
    }
    return range;
  }

  /// De Casteljau at the middle: the coefficients of both halves.
  [[nodiscard]] std::pair<Piece, Piece> halves(const Piece& piece) const {
    const double middle = (piece.a + piece.b) / 2;
    Piece left{piece.a, middle, {}};
    Piece right{middle, piece.b, {}};
    Bernstein row = piece.beta;
    for (std::size_t k = 0; k <= n_; ++k) {
      left.beta[k] = row[0];
      right.beta[n_ - k] = row[n_ - k];
      for (std::size_t i = 0; i + k + 1 <= n_; ++i) row[i] = (row[i] + row[i + 1]) / 2;
    }
    return {left, right};
  }

  /// f is monotone over [a, b]: one sign change at the most, found by Newton kept inside a bracket.
  void bracket(double a, double b) {
    double fa = value(f_, a);
    const double fb = value(f_, b);
    if (fa == 0 || fb == 0) {
      out_.push_back(fa == 0 ? a : b);
      return;
    }
    if ((fa > 0) == (fb > 0)) return;
    double s = a + (b - a) * fa / (fa - fb);
    for (int i = 0; i < 100; ++i) {
      const Jet f = evaluate(f_, s);
      if (f[0] == 0) break;
      ((f[0] > 0) == (fa > 0) ? a : b) = s;
      const double newton = s - f[0] / (f[1] * f_.length);
      const double next = newton > a && newton < b ? newton : (a + b) / 2;
      if (next == s || b - a <= 2e-16) break;
      s = next;
    }
    out_.push_back(s);
  }

  const Segment& f_;
  std::size_t n_;
  double flat_;
  std::vector<double>& out_;
};

}  // namespace

void roots(const Segment& f, double flat, std::vector<double>& out) {
  out.clear();
  Isolation(f, flat, out).run({0, 1, to_bernstein(f)});
  std::erase_if(out, [](double s) { return s <= 0 || s >= 1; });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end(), [](double a, double b) { return b - a < 1e-13; }),
            out.end());
}

template <class Over>
std::vector<double> crossings(const Curve<Over>& f, int order, double level) {
  assert(order >= 0 && order <= 3);
  std::vector<double> found;
  std::vector<double> s;
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    Segment g = f.segments()[i];
    for (int k = 0; k < order; ++k) g = derivative(g);
    const double flat = 4e-16 * (magnitude(g) + std::abs(level));
    g.c[0] -= level;
    if (std::abs(value(g, 0)) <= flat) found.push_back(f.breaks()[i]);
    roots(g, flat, s);
    for (const double at : s) found.push_back(f.breaks()[i] + at * g.length);
    if (std::abs(value(g, 1)) <= flat) found.push_back(f.breaks()[i + 1]);
  }
  const double apart = 1e-13 * f.length();
  found.erase(
      std::unique(found.begin(), found.end(), [&](double a, double b) { return b - a <= apart; }),
      found.end());
  return found;
}

template std::vector<double> crossings(const Curve<OverTime>&, int, double);
template std::vector<double> crossings(const Curve<OverMaster>&, int, double);

}  // namespace jounce
