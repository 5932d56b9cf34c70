// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/segment.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/detail/evaluate.hpp"

#include "profiles/src/curve/coefficients.hpp"

namespace jounce {
namespace {

/// Difference of two angles, relative and in rad, that is rounding.
constexpr double same_angle = 4e-15;
constexpr double half_pi = 1.57079632679489661923;

using Coefficients = std::array<double, Segment::max_degree + 1>;

void trim(Segment& f) {
  while (f.degree > 0 && f.c[static_cast<std::size_t>(f.degree)] == 0) --f.degree;
}

/// p(s) -> p(s + h), in place: repeated synthetic division.
void taylor_shift(Coefficients& c, int degree, double h) {
  for (int i = 0; i < degree; ++i)
    for (int k = degree - 1; k >= i; --k)
      c[static_cast<std::size_t>(k)] += h * c[static_cast<std::size_t>(k) + 1];
}

/// a1 sin(wt + p1) + a2 sin(wt + p2) as one sine of the same frequency: phasor addition.
SineTerm merged(const SineTerm& a, const SineTerm& b) {
  const double x = a.amplitude * std::cos(a.phase) + b.amplitude * std::cos(b.phase);
  const double y = a.amplitude * std::sin(a.phase) + b.amplitude * std::sin(b.phase);
  return {std::hypot(x, y), a.angle, std::atan2(y, x)};
}

}  // namespace

Jet profiles_detail::evaluate_with_sines(const Segment& f, double s) {
  auto [p, d1, d2, d3] = polynomial(f, s);
  for (int i = 0; i < f.sines; ++i) {
    const auto& [amplitude, w, phase] = f.sine[static_cast<std::size_t>(i)];
    const double sn = amplitude * std::sin(w * s + phase);
    const double cs = amplitude * w * std::cos(w * s + phase);
    p += sn;
    d1 += cs;
    d2 -= w * w * sn;
    d3 -= w * w * cs;
  }
  return over_length({p, d1, d2, d3}, f.length);
}

Jet evaluate(const Segment& f, double s) {
  return profiles_detail::evaluate(f, s);
}

double value(const Segment& f, double s) {
  double p = f.c[static_cast<std::size_t>(f.degree)];
  for (int k = f.degree - 1; k >= 0; --k) p = p * s + f.c[static_cast<std::size_t>(k)];
  for (int i = 0; i < f.sines; ++i) {
    const auto& term = f.sine[static_cast<std::size_t>(i)];
    p += term.amplitude * std::sin(term.angle * s + term.phase);
  }
  return p;
}

Segment derivative(const Segment& f) {
  Segment g;
  g.length = f.length;
  g.degree = std::max(0, f.degree - 1);
  for (std::size_t k = 0; k < static_cast<std::size_t>(f.degree); ++k)
    g.c[k] = static_cast<double>(k + 1) * f.c[k + 1] / f.length;
  g.sines = f.sines;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const auto& t = f.sine[i];
    g.sine[i] = {t.amplitude * t.angle / f.length, t.angle, t.phase + half_pi};
  }
  return g;
}

std::optional<Segment> integral(const Segment& f, double start_value) {
  if (f.degree == Segment::max_degree) return std::nullopt;
  Segment g;
  g.length = f.length;
  g.degree = f.degree + 1;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(g.degree); ++k)
    g.c[k] = f.c[k - 1] * f.length / static_cast<double>(k);
  double constant = start_value;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const auto& t = f.sine[i];
    if (t.angle == 0) {  // a constant
      g.c[1] += t.amplitude * std::sin(t.phase) * f.length;
      continue;
    }
    const SineTerm term{t.amplitude * f.length / t.angle, t.angle, t.phase - half_pi};
    constant -= term.amplitude * std::sin(term.phase);
    g.sine[static_cast<std::size_t>(g.sines++)] = term;
  }
  g.c[0] = constant;
  trim(g);
  return g;
}

Segment reversed(const Segment& f) {
  Segment g = f;
  taylor_shift(g.c, g.degree, 1);  // f(1 + t), then t = -s
  for (std::size_t k = 1; k <= static_cast<std::size_t>(g.degree); k += 2) g.c[k] = -g.c[k];
  for (std::size_t i = 0; i < static_cast<std::size_t>(g.sines); ++i) {
    auto& t = g.sine[i];
    t.phase += t.angle;
    t.angle = -t.angle;
  }
  return g;
}

Segment part(const Segment& f, double s0, double s1) {
  assert(s0 < s1);
  Segment g = f;
  const double width = s1 - s0;
  g.length = f.length * width;
  taylor_shift(g.c, g.degree, s0);
  double power = 1;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(g.degree); ++k, power *= width)
    g.c[k] *= power;
  for (std::size_t i = 0; i < static_cast<std::size_t>(g.sines); ++i) {
    auto& t = g.sine[i];
    t.phase += t.angle * s0;
    t.angle *= width;
  }
  return g;
}

Segment scaled(const Segment& f, double factor, double offset) {
  Segment g = f;
  for (double& c : g.c) c *= factor;
  for (auto& t : g.sine) t.amplitude *= factor;
  g.c[0] += offset;
  return g;
}

std::optional<Segment> sum(const Segment& f, const Segment& g) {
  assert(f.length == g.length);
  Segment h = f;
  h.degree = std::max(f.degree, g.degree);
  for (std::size_t k = 0; k < h.c.size(); ++k) h.c[k] = f.c[k] + g.c[k];
  for (std::size_t i = 0; i < static_cast<std::size_t>(g.sines); ++i) {
    const auto begin = h.sine.begin();
    const auto end = begin + h.sines;
    // Parts of one sine, cut at different places, have one angle to rounding.
    const double other = g.sine[i].angle;
    const double rounding = same_angle * std::max(1.0, std::abs(other));
    const auto same = std::find_if(
        begin, end, [&](const SineTerm& t) { return std::abs(t.angle - other) <= rounding; });
    if (same != end) {
      *same = merged(*same, g.sine[i]);
    } else if (h.sines < Segment::max_sines) {
      h.sine[static_cast<std::size_t>(h.sines++)] = g.sine[i];
    } else {
      return std::nullopt;
    }
  }
  trim(h);
  return h;
}

double magnitude(const Segment& f) {
  double m = 0;
  for (const double c : f.c) m += std::abs(c);
  for (int i = 0; i < f.sines; ++i) m += std::abs(f.sine[static_cast<std::size_t>(i)].amplitude);
  return m;
}

namespace {

template <std::size_t n>
Segment with_coefficients(double length, const std::array<double, n>& c) {
  Segment f;
  f.length = length;
  f.degree = static_cast<int>(n) - 1;
  std::copy(c.begin(), c.end(), f.c.begin());
  trim(f);
  return f;
}

}  // namespace

Segment line(double length, double p0, double p1) {
  return with_coefficients(length, profiles_detail::line_coefficients(p0, p1));
}

Segment cubic(double length, double p0, double v0, double p1, double v1) {
  return with_coefficients(length, profiles_detail::cubic_coefficients(length, p0, v0, p1, v1));
}

Segment quintic(double length, double p0, double v0, double a0, double p1, double v1, double a1) {
  return with_coefficients(length,
                           profiles_detail::quintic_coefficients(length, p0, v0, a0, p1, v1, a1));
}

}  // namespace jounce
