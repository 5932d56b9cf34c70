#include "jounce/profiles/roots.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Bernstein = std::array<double, Segment::max_degree + 1>;

/// A piece [a, b] of the segment with the Bernstein coefficients of f over it: f lies within their
/// hull, and f' within the hull of their differences.
struct Piece {
  double a = 0;
  double b = 1;
  Bernstein beta{};
};

Bernstein to_bernstein(const Segment& f) {
  // beta_i = sum over k <= i of C(i, k) / C(n, k) c_k: by differences of the scaled coefficients.
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

/// The widest angle over which a sine is its Taylor polynomial of degree 11 to within rounding:
/// the remainder is at most angle^12 / 12! = 1.3e-16.
constexpr double widest_angle = 0.25;

/// f with each sine, which spans at most widest_angle, replaced by that polynomial. Only so do a
/// sine and a polynomial that nearly cancel (the error of a table) leave a tight enclosure.
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

/// Isolates the roots of f piece by piece.
class Isolation {
 public:
  Isolation(const Segment& f, double flat, std::vector<double>& out)
      : f_(f), flat_(flat), out_(out) {
    noise_ = 1e-15 * magnitude(f);
    double widest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
      widest = std::max(widest, std::abs(f.sine[i].angle));
      remainder_ += 2e-16 * std::abs(f.sine[i].amplitude);
    }
    n_ = static_cast<std::size_t>(f.sines == 0 ? f.degree : Segment::max_degree);
    const double pieces = std::max(1.0, std::ceil(widest / widest_angle));
    for (int i = 0; i < static_cast<int>(pieces); ++i) {
      const double a = i / pieces;
      const double b = (i + 1) / pieces;
      run({a, b, to_bernstein(f.sines == 0 ? f : as_polynomial(part(f, a, b)))});
    }
  }

 private:
  void run(const Piece& piece) {
    const auto [lo, hi] = std::minmax_element(piece.beta.begin(), piece.beta.begin() + count());
    if (*lo > remainder_ || *hi < -remainder_) return;
    if ((*lo >= -flat_ && *hi <= flat_) || piece.b - piece.a < 1e-13) {
      out_.push_back((piece.a + piece.b) / 2);
      return;
    }
    if (is_monotone(piece)) {
      bracket(piece.a, piece.b);
      return;
    }
    if (*lo >= -noise_ && *hi <= noise_) {  // a multiple root: rounding hides all that is in here
      out_.push_back((piece.a + piece.b) / 2);
      return;
    }
    const auto [left, right] = halves(piece);
    run(left);
    run(right);
  }

  [[nodiscard]] std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(n_) + 1; }

  [[nodiscard]] bool is_monotone(const Piece& piece) const {
    bool rises = true;
    bool falls = true;
    for (std::size_t i = 0; i < n_; ++i) {
      const double difference = piece.beta[i + 1] - piece.beta[i];
      rises = rises && difference > remainder_;
      falls = falls && difference < -remainder_;
    }
    return rises || falls;
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
    const double fa = value(f_, a);
    const double fb = value(f_, b);
    if (fa == 0 || fb == 0) {
      out_.push_back(fa == 0 ? a : b);
      return;
    }
    if ((fa > 0) == (fb > 0)) {
      // The Bernstein form saw a change of sign at an end of the piece, where rounding gives f the
      // other sign: the root is that end.
      const double nearest = std::min(std::abs(fa), std::abs(fb));
      if (nearest <= 2e-15 * magnitude(f_)) out_.push_back(nearest == std::abs(fa) ? a : b);
      return;
    }
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
  double flat_;
  std::vector<double>& out_;
  std::size_t n_ = 0;     // degree of the Bernstein form
  double remainder_ = 0;  // what the polynomials may differ from f
  double noise_ = 0;      // what rounding may make of f = 0
};

}  // namespace

void roots(const Segment& f, double flat, std::vector<double>& out) {
  out.clear();
  const Isolation isolation(f, flat, out);
  std::erase_if(out, [](double s) { return s <= 0 || s >= 1; });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end(), [](double a, double b) { return b - a < 1e-13; }),
            out.end());
}

namespace {

/// Every s in [0, 1] where g vanishes, each stretch within `flat` of zero once.
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
  if (!is_new(1) && out.back() > 0) out.pop_back();  // an end that touches: the end itself is meant
  if (is_new(1)) out.push_back(1);
}

}  // namespace

template <class Over>
std::vector<double> crossings(const Curve<Over>& f, int order, double level) {
  assert(order >= 0 && order <= 3);
  require_finite("level", level);
  std::vector<double> found;
  std::vector<double> s;
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    Segment g = f.segments()[i];
    for (int k = 0; k < order; ++k) g = derivative(g);
    const double flat = 4e-16 * (magnitude(g) + std::abs(level));
    g.c[0] -= level;
    zeros(g, flat, s);
    for (const double at : s)
      found.push_back(at == 1 ? f.breaks()[i + 1] : f.breaks()[i] + at * g.length);
  }
  const double apart = 1e-13 * f.length();
  const auto same = [&](double a, double b) { return b - a <= apart; };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

template std::vector<double> crossings(const Curve<OverTime>&, int, double);
template std::vector<double> crossings(const Curve<OverMaster>&, int, double);

}  // namespace jounce
