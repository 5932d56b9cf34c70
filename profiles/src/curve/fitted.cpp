// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/fitted.hpp"

#include <cmath>

#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

// p is the polynomial of degree 11 with the Taylor coefficients of h of order 0 to 5 at s = 0 and
// at s = 1. Let T be the first six terms of h at 0, and u = s - 1. Then
//
//   (1)  p = T + s^6 q,   T(1 + u) + (1 + u)^6 q = h(1 + u) + O(u^6)
//   (2)  q = (h - T)(1 + u)^-6 up to u^5,   (1 + u)^-6 = sum over n of (-1)^n C(n + 5, 5) u^n
//
// The error e = h - p vanishes six times at each end. With M >= |h^(12)| / 12!, Hermite's remainder
// gives
//
//   (3)  |e| <= M s^6 (1 - s)^6 <= M / 4^6
//
// By Rolle's theorem, e^(k) vanishes 6 - k times at each end and k times between them, and its
// derivative of order 12 - k is h^(12). With |s - s_i| <= 1 for the places s_i between the ends,
//
//   (4)  |e^(k)| <= M 12! / (12 - k)! / 4^(6 - k)
//
// M is a majorant: it is computed from the magnitudes of the coefficients of polynomials and sines,
// so nothing cancels. Its rounding error is relative to it, and the factor `slack` covers this
// error.

namespace jounce {
namespace profiles_detail {

template <std::size_t n>
Series<n> taylor(const Segment& f, double s) {
  auto c = f.c;
  for (int i = 0; i < f.degree && i < static_cast<int>(n); ++i)
    for (int k = f.degree - 1; k >= i; --k)
      c[static_cast<std::size_t>(k)] += s * c[static_cast<std::size_t>(k) + 1];
  Series<n> series{};
  std::copy_n(c.begin(), series.size(), series.begin());
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    const auto& [amplitude, angle, phase] = f.sine[i];
    const double sn = std::sin(angle * s + phase);
    const double cs = std::cos(angle * s + phase);
    const std::array cycle{sn, cs, -sn, -cs};
    double factor = amplitude;
    for (std::size_t k = 0; k < series.size(); ++k) {
      series[k] += factor * cycle[k % 4];
      factor *= angle / static_cast<double>(k + 1);
    }
  }
  return series;
}

template Series<6> taylor(const Segment& f, double s);
template Series<12> taylor(const Segment& f, double s);

Majorant majorant(const Segment& f, double reach) {
  Segment positive = f;
  for (double& c : positive.c) c = std::abs(c);
  for (int i = 0; i < f.degree; ++i)  // the Taylor shift by reach
    for (int k = f.degree - 1; k >= i; --k)
      positive.c[static_cast<std::size_t>(k)] +=
          reach * positive.c[static_cast<std::size_t>(k) + 1];
  Majorant bounds{};
  std::copy(positive.c.begin(), positive.c.end(), bounds.begin());
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    double factor = std::abs(f.sine[i].amplitude);
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      bounds[k] += factor;
      factor *= std::abs(f.sine[i].angle) / static_cast<double>(k + 1);
    }
  }
  return bounds;
}

Segment hermite(double length, const EndSeries& at0, const EndSeries& at1) {
  constexpr std::size_t n = 6;
  EndSeries at_one = at0;  // T about 1
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t k = n - 1; k-- > i;) at_one[k] += at_one[k + 1];
  constexpr EndSeries inverse{1, -6, 21, -56, 126, -252};
  EndSeries q{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; i + j < n; ++j) q[i + j] += (at1[i] - at_one[i]) * inverse[j];  // (2)
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t k = n - 1; k-- > i;) q[k] -= q[k + 1];  // u = s - 1
  Segment f;
  f.length = length;
  f.degree = Segment::max_degree;
  for (std::size_t k = 0; k < n; ++k) {
    f.c[k] = at0[k];
    f.c[n + k] = q[k];
  }
  return f;
}

Jet hermite_error(double length, double twelfth) {
  constexpr double slack = 1 + 1e-12;
  const double m = slack * twelfth;
  const double r = 1 / length;
  return {m / 4096, 12 * m / 1024 * r, 132 * m / 256 * r * r, 1320 * m / 64 * r * r * r};  // (4)
}

void require_tolerance(double tolerance, double magnitude) {
  constexpr double finest_fit = 1e-14;  // a smaller error cannot be computed
  require_positive("tolerance", tolerance);
  if (tolerance < finest_fit * magnitude)
    throw InputError("tolerance", tolerance,
                     "must be at least " + six_digits_up(finest_fit * magnitude) +
                         ", the rounding error of the curve");
}

void require_fitting(std::size_t pieces) {
  if (pieces > 1'000'000)
    throw InputError("tolerance", "too small", "needs more than 1e6 pieces: increase it");
}

}  // namespace profiles_detail

namespace {

/// A segment that is replaced by one without sines.
struct Whole {
  Segment f;

  [[nodiscard]] double length() const { return f.length; }
  [[nodiscard]] profiles_detail::EndSeries end(double s) const {
    return profiles_detail::taylor(f, s);
  }
  [[nodiscard]] double twelfth() const { return profiles_detail::majorant(f, 1).back(); }
  [[nodiscard]] std::pair<Whole, Whole> halves() const {
    return {{part(f, 0, 0.5)}, {part(f, 0.5, 1)}};
  }
};

}  // namespace

template <class Over>
Fitted<Over> polynomial_within(const Curve<Over>& f, double tolerance) {
  double scale = 0;
  for (const Segment& piece : f.segments()) scale = std::max(scale, magnitude(piece));
  profiles_detail::require_tolerance(tolerance, scale);
  std::vector<Segment> segments;
  Jet error{};
  for (const Segment& piece : f.segments()) {
    if (piece.sines > 0) {
      profiles_detail::fit(Whole{piece}, tolerance, segments, error);
    } else {
      segments.push_back(piece);
    }
  }
  return {Curve<Over>(std::move(segments), f.start(), f.outside()), error};
}

template Fitted<OverTime> polynomial_within(const Trajectory&, double);
template Fitted<OverMaster> polynomial_within(const Cam&, double);

}  // namespace jounce
