#include "jounce/profiles/segment.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace jounce {
namespace {

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

Jet evaluate(const Segment& f, double s) {
  double p = f.c[static_cast<std::size_t>(f.degree)];
  double d1 = 0;
  double d2 = 0;
  double d3 = 0;
  for (int k = f.degree - 1; k >= 0; --k) {  // Horner, for the value and the derivatives / k!
    d3 = d3 * s + d2;
    d2 = d2 * s + d1;
    d1 = d1 * s + p;
    p = p * s + f.c[static_cast<std::size_t>(k)];
  }
  d2 *= 2;
  d3 *= 6;
  for (int i = 0; i < f.sines; ++i) {
    const auto& [amplitude, w, phase] = f.sine[static_cast<std::size_t>(i)];
    const double sn = amplitude * std::sin(w * s + phase);
    const double cs = amplitude * w * std::cos(w * s + phase);
    p += sn;
    d1 += cs;
    d2 -= w * w * sn;
    d3 -= w * w * cs;
  }
  const double r = 1 / f.length;
  return {p, d1 * r, d2 * r * r, d3 * r * r * r};
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
    if (t.angle == 0) {  // a constant in disguise
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
  assert(0 <= s0 && s0 < s1 && s1 <= 1);
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
    const double rounding = 4e-15 * std::max(1.0, std::abs(other));
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

Segment line(double length, double p0, double p1) {
  Segment f;
  f.length = length;
  f.degree = 1;
  f.c[0] = p0;
  f.c[1] = p1 - p0;
  trim(f);
  return f;
}

Segment cubic(double length, double p0, double v0, double p1, double v1) {
  const double h = p1 - p0;
  const double m0 = v0 * length;
  const double m1 = v1 * length;
  Segment f;
  f.length = length;
  f.degree = 3;
  f.c[0] = p0;
  f.c[1] = m0;
  f.c[2] = 3 * h - 2 * m0 - m1;
  f.c[3] = -2 * h + m0 + m1;
  trim(f);
  return f;
}

// The general 5th degree (VDI 2143), written in the end values of the segment.
Segment quintic(double length, double p0, double v0, double a0, double p1, double v1, double a1) {
  const double h = p1 - p0;
  const double m0 = v0 * length;
  const double m1 = v1 * length;
  const double k0 = a0 * length * length;
  const double k1 = a1 * length * length;
  Segment f;
  f.length = length;
  f.degree = 5;
  f.c[0] = p0;
  f.c[1] = m0;
  f.c[2] = k0 / 2;
  f.c[3] = 10 * h - 6 * m0 - 4 * m1 - (3 * k0 - k1) / 2;
  f.c[4] = -15 * h + 8 * m0 + 7 * m1 + (3 * k0 - 2 * k1) / 2;
  f.c[5] = 6 * h - 3 * (m0 + m1) - (k0 - k1) / 2;
  trim(f);
  return f;
}

}  // namespace jounce
