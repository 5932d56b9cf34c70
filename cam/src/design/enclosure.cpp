// SPDX-License-Identifier: Apache-2.0
#include "cam/src/design/enclosure.hpp"

#include <algorithm>
#include <cmath>

// Enclosures of a segment over |t| <= h around its midpoint m, s = m + t:
//
//   (1)  f^(k)/k! (m + t) = q_k + sum over j > k of C(j, k) q_j t^(j-k)  polynomial, q shifted to m
//   (2)  a w^k/k! sin(w (m + t) + p + k pi/2)                            a sine: its exact range
//
// and of any function g whose g' and g'' are enclosed over the same interval, of half-width r in x:
//
//   (3)  g <= g(m) + r max |g'|                                             mean value form

namespace jounce::cam_detail {
namespace {

using Shifted = std::array<double, Segment::max_degree + 1>;

Shifted shifted_to(const Segment& f, double m) {
  Shifted q = f.c;
  const auto n = static_cast<std::size_t>(f.degree);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = n; k-- > i;) q[k] += m * q[k + 1];
  return q;
}

/// Equation (1), with respect to s.
Interval polynomial(const Shifted& q, std::size_t degree, std::size_t k, double h) {
  double radius = 0;
  double factor = 1;  // C(j, k) h^(j-k)
  for (std::size_t j = k + 1; j <= degree; ++j) {
    factor *= h * static_cast<double>(j) / static_cast<double>(j - k);
    radius += factor * std::abs(q[j]);
  }
  return {q[k] - radius, q[k] + radius};
}

/// Equation (2), with respect to s, without the factorial.
Interval sine(const SineTerm& term, std::size_t k, double m, double h) {
  const double middle = term.angle * m + term.phase + static_cast<double>(k) * std::numbers::pi / 2;
  const double half = std::abs(term.angle) * h;
  return Interval(term.amplitude * std::pow(term.angle, static_cast<double>(k))) *
         sin(Interval{middle - half, middle + half});
}

/// Branch and bound for one maximum.
class Maximum {
 public:
  Maximum(const Cam& f, double angle, const Observed& observed, double scale)
      : f_(f), angle_(angle), observed_(observed), scale_(scale) {
    best_.extremum.value = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < f.segments().size(); ++i) {
      look({i, 0, 1}, 0);
      look({i, 0, 1}, 1);
      run({i, 0, 1});
    }
    best_.excess = std::max(0.0, bound_ - best_.extremum.value);
  }

  [[nodiscard]] const Certified& best() const { return best_; }

 private:
  [[nodiscard]] double rounding() const {
    return 1e-13 * std::max(scale_, std::abs(best_.extremum.value));
  }
  [[nodiscard]] double half_width(const SegmentPart& over) const {
    return (over.s1 - over.s0) / 2 * f_.segments()[over.segment].length * angle_;
  }

  Taylor<2> look(const SegmentPart& over, double s) {
    const Taylor<2> g = observed_(over.at(s));
    const double value = g.c[0].middle();
    if (!(value <= best_.extremum.value + rounding() / 4))
      best_.extremum = {value, position(f_, over.segment, s), s == 1 ? Side::left : Side::right};
    return g;
  }

  void run(const SegmentPart& over) {
    const Taylor<2> g = observed_(over);
    const Interval at_middle = observed_(over.at(over.middle())).c[0];
    const double upper =
        std::min(g.c[0].hi, at_middle.hi + half_width(over) * g.c[1].magnitude());  // (3)
    if (upper <= best_.extremum.value + rounding() || over.s1 - over.s0 < 1e-12) {
      bound_ = std::max(bound_, upper);
      return;
    }
    if (!g.c[1].has_zero()) return ends(over);
    if (!g.c[2].has_zero()) return bend(over);
    run(over.left());
    run(over.right());
  }

  void ends(const SegmentPart& over) {
    look(over, over.s0);
    look(over, over.s1);
  }

  /// g' is monotone over the interval, so it is 0 at one point at most, which Newton's method
  /// inside a bracket finds.
  void bend(const SegmentPart& over) {
    const double first = look(over, over.s0).c[1].middle();
    const double last = look(over, over.s1).c[1].middle();
    if (!(first > 0 && last < 0)) return;  // a minimum, or none
    double a = over.s0;
    double b = over.s1;
    double s = a + (b - a) * first / (first - last);
    const double width = f_.segments()[over.segment].length * angle_;
    for (int i = 0; i < 100 && b - a > 2e-16; ++i) {
      const Taylor<2> g = observed_(over.at(s));
      const double slope = g.c[1].middle();
      (slope > 0 ? a : b) = s;
      const double newton = s - slope / (2 * g.c[2].middle() * width);
      const double next = newton > a && newton < b ? newton : (a + b) / 2;
      if (next == s) break;
      s = next;
    }
    look(over, s);
  }

  const Cam& f_;
  double angle_;
  const Observed& observed_;
  double scale_;
  double bound_ = -std::numeric_limits<double>::infinity();
  Certified best_;
};

}  // namespace

double position(const Cam& f, std::size_t segment, double s) {
  if (s == 1) return f.breaks()[segment + 1];
  return f.breaks()[segment] + s * f.segments()[segment].length;
}

Taylor<4> enclosure(const Cam& f, const SegmentPart& over, double angle) {
  const Segment& g = f.segments()[over.segment];
  const double m = over.middle();
  const double h = (over.s1 - over.s0) / 2;
  const Shifted q = shifted_to(g, m);
  Taylor<4> t;
  double factor = 1;  // 1 / (length * angle)^k
  double factorial = 1;
  for (std::size_t k = 0; k < t.c.size(); ++k) {
    Interval sines;
    for (std::size_t i = 0; i < static_cast<std::size_t>(g.sines); ++i)
      sines = sines + sine(g.sine[i], k, m, h);
    t.c[k] = Interval(factor) * (polynomial(q, static_cast<std::size_t>(g.degree), k, h) +
                                 Interval(1 / factorial) * sines);
    factor /= g.length * angle;
    factorial *= static_cast<double>(k + 1);
  }
  return t;
}

Certified maximum(const Cam& f, double angle, const Observed& observed, double scale) {
  return Maximum(f, angle, observed, scale).best();
}

}  // namespace jounce::cam_detail
