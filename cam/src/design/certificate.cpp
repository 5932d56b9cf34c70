// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/certificate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "jounce/cam/design/characteristics.hpp"
#include "jounce/cam/detail/quadrature.hpp"

// f leads from 0 to 1 over z in [0, 1]; f', ..., f^(n-1) are zero at both ends and continuous.
// Integrating by parts n - 1 times, for every polynomial p of degree n - 1 with the leading
// coefficient (-1)^(n-1) / (n - 1)!,
//
//   (1)  1 = integral of f' = integral of p f^(n)
//
// so that 1 <= max|f^(n)| integral |p| and 1 <= (integral of f^(n)^2) (integral of p^2). The least
// integral |p| is that of the Chebyshev polynomial of the second kind, the least integral p^2 that
// of the Legendre polynomial, both shifted to [0, 1]:
//
//   (2)  max|f^(n)|          >= 2^(2n-2) (n-1)!
//   (3)  integral f^(n)^2    >= (2n-2)! (2n-1)! / (n-1)!^2
//
// |f' f''| <= P implies f'^2 <= 2 P z and f'^2 <= 2 P (1 - z). With 1 = integral of f', this gives
//
//   (4)  P >= 9/4
//
// From rest, with |f''| <= A and |f'''| <= J, the fastest way to the velocity V with zero
// acceleration is the ramp of constant jerks J, 0, -J. Its duration is
//
//   (5)  R = V/A + A/J,   or 2 sqrt(V/J) if A^2 > V J (no constant acceleration)
//
// No motion is ahead of this ramp at any time: while its acceleration rises or is constant, no
// motion can have more; while it falls, a' >= -J and f' <= V imply f'' <= sqrt(2 J (V - f')), which
// the ramp attains. The ramp is point-symmetric: of the distance V R it loses V R / 2. With a ramp
// at each end, and V = max f' between them,
//
//   (6)  1 <= V - V R,   that is   1/V + R <= 1
//
// For a free V, the motion of least A for a given J has no plateau in V: V = 2, R = 1/2 in (5),
//
//   (7)  2/A + A/J = 1/2,   A = (J/4) (1 - sqrt(1 - 32/J))
//
// The identities are the integrals of f'' and, by parts, of (1/2 - z) f'':
//
//   (8)  integral f'' = f'(1) - f'(0)
//   (9)  integral (1/2 - z) f'' = f(1) - f(0) - (f'(0) + f'(1)) / 2

namespace jounce {
namespace {

constexpr double end_rounding =
    1e-7;  // ends that are zero to 1e-9 of the peak change a bound by that

constexpr const char* impossible =
    "no motion can be below this bound: the data contradict each other";

/// The integrals over z of a rise in its normalized form.
struct Integrals {
  std::array<double, 5> square{};  ///< integral of f^(n)^2, by n from 1
  double gain = 0;                 ///< integral of f''
  double moment = 0;               ///< integral of (1/2 - z) f''
};

Integrals integrals_of(const Rise& rise) {
  Integrals all;
  const double b = rise.length();
  std::array<double, 5> factor{};  // from derivatives by master to those by z
  for (std::size_t n = 0; n < factor.size(); ++n)
    factor[n] = std::pow(b, static_cast<double>(n)) / rise.stroke;
  double start = 0;
  for (const Segment& f : rise.cam.segments()) {
    const Segment slope = derivative(f);
    const double share = f.length / b;
    cam_detail::quadrature(f, [&](double s, double weight) {
      const Jet jet = evaluate(slope, s);  // f' to f''''
      for (std::size_t n = 1; n < factor.size(); ++n) {
        const double d = jet[n - 1] * factor[n];
        all.square[n] += weight * share * d * d;
      }
      const double a = weight * share * jet[1] * factor[2];
      all.gain += a;
      all.moment += (0.5 - (start + s * share)) * a;
    });
    start += share;
  }
  return all;
}

/// Collects the findings for one rise.
class Certificate {
 public:
  explicit Certificate(const Rise& rise) : rise_(rise) {
    const Range& travel = rise.ranges[0];
    const double far = std::max(std::abs(travel.min.value), std::abs(travel.max.value));
    const double away = std::max(std::abs(rise.cam.start()), std::abs(rise.cam.end()));
    blur_ = 1e-14 * (far / std::abs(rise.stroke) + away / rise.length());
  }

  /// `value` cannot be below `bound`.
  void at_least(Rule rule, std::string quantity, Coefficient c, double bound) {
    add(std::move(rule), std::move(quantity), c, bound, c.value / bound - 1,
        c.value < bound * (1 - end_rounding - blur_));
  }
  /// `value` cannot be above `bound`.
  void at_most(Rule rule, std::string quantity, double value, double bound) {
    add(std::move(rule), std::move(quantity), {value, rise_.cam.start()}, bound, 1 - value / bound,
        value > bound * (1 + end_rounding + blur_));
  }
  /// `value` is `expected`, to 1e-9 of `scale` plus rounding.
  void equal(Rule rule, std::string quantity, double value, double expected, double scale) {
    const double room = (1e-9 + blur_) * scale - std::abs(value - expected);
    add(std::move(rule), std::move(quantity), {value, rise_.cam.start()}, expected,
        room / ((1e-9 + blur_) * scale), room < 0);
  }

  [[nodiscard]] Report report() && { return std::move(report_); }

 private:
  void add(Rule rule, std::string quantity, Coefficient c, double limit, double margin,
           bool broken) {
    Finding f;
    f.rule = std::move(rule);
    f.quantity = std::move(quantity);
    f.where = c.where;
    f.value = c.value;
    f.limit = limit;
    f.margin = margin;
    f.broken = broken;
    f.segment = rise_.first;
    f.severity = Severity::note;
    if (broken) f.advice = impossible;
    report_.findings.push_back(std::move(f));
  }

  double blur_ = 0;  // relative rounding, far from 0 in slave or master
  const Rise& rise_;
  Report report_;
};

constexpr std::array names{"", "velocity", "acceleration", "jerk", "jounce"};

void add_peaks(Certificate& all, const Rise& rise, const Characteristics& c) {
  constexpr std::array bounds{0.0, 1.0, 4.0, 32.0, 384.0};  // (2)
  const std::array quantities{"", "Cv", "Ca", "Cj", "max |f''''|"};
  const Extremum& a = rise.ranges[2].peak();
  const Extremum& jounce = rise.ranges[4].peak();
  const double b = rise.length();
  const std::array peaks{
      Coefficient{}, c.cv, Coefficient{c.peak_acceleration(), a.where},
      Coefficient{c.cj_inside, c.cj.where},
      Coefficient{std::abs(jounce.value / rise.stroke) * b * b * b * b, jounce.where}};
  for (std::size_t n = 1; n <= static_cast<std::size_t>(std::min(4, rise.smooth + 1)); ++n)
    all.at_least(Rule(RuleFamily::bound, names[n]), quantities[n], peaks[n], bounds[n]);
}

void add_squares(Certificate& all, const Rise& rise, const Integrals& integrals) {
  constexpr std::array bounds{0.0, 1.0, 12.0, 720.0, 100800.0};  // (3)
  const std::array quantities{"", "mean f'^2", "mean f''^2", "mean f'''^2", "mean f''''^2"};
  for (std::size_t n = 1; n <= static_cast<std::size_t>(std::min(4, rise.smooth + 1)); ++n)
    all.at_least(std::string("bound/square_") + names[n], quantities[n],
                 {integrals.square[n], rise.cam.start()}, bounds[n]);
}

/// The duration of the shortest ramp from rest to velocity v, by (5); without a jerk limit v / a.
double ramp(double v, double a, double j, bool jerk_counts) {
  if (!jerk_counts) return v / a;
  return a * a > v * j ? 2 * std::sqrt(v / j) : v / a + a / j;
}

void add_trade_offs(Certificate& all, const Rise& rise, const Characteristics& c) {
  if (rise.smooth < 1) return;
  const bool forwards = rise.stroke > 0;
  const double v = std::abs((forwards ? rise.ranges[1].max : rise.ranges[1].min).value) *
                   rise.length() / std::abs(rise.stroke);
  const double a = c.peak_acceleration();
  const double j = c.cj_inside;
  const bool jerk_counts = rise.smooth >= 2;
  all.at_least("bound/power", "Cm", c.cm, 2.25);  // (4)
  all.at_most("bound/duration", jerk_counts ? "1/Cv + Cv/Ca + Ca/Cj" : "1/Cv + Cv/Ca",
              1 / v + ramp(v, a, j, jerk_counts), 1);  // (6)
  if (jerk_counts)
    all.at_least("bound/acceleration_for_jerk", "Ca", {a, rise.ranges[2].peak().where},
                 j / 4 * (1 - std::sqrt(std::max(0.0, 1 - 32 / j))));  // (7)
}

void add_identities(Certificate& all, const Rise& rise, const Characteristics& c,
                    const Integrals& integrals) {
  if (rise.smooth < 1) return;  // the acceleration of a velocity step is not a function
  const double factor = rise.length() / rise.stroke;
  const double v0 = evaluate(rise.cam.segments().front(), 0)[1] * factor;
  const double v1 = evaluate(rise.cam.segments().back(), 1)[1] * factor;
  const double scale = std::max(1.0, c.peak_acceleration());
  all.equal("identity/acceleration", "mean f''", integrals.gain, v1 - v0, scale);  // (8)
  all.equal("identity/moment", "mean (1/2 - z) f''", integrals.moment, 1 - (v0 + v1) / 2,
            scale);  // (9)
}

}  // namespace

Report certificates(const Rise& rise) {
  const Characteristics c = characteristics(rise);
  const Integrals integrals = integrals_of(rise);
  Certificate all(rise);
  add_peaks(all, rise, c);
  add_squares(all, rise, integrals);
  add_trade_offs(all, rise, c);
  add_identities(all, rise, c, integrals);
  return std::move(all).report();
}

Report certificates(const Cam& cam) {
  Report all;
  for (const Rise& rise : rises(cam)) {
    Report one = certificates(rise);
    std::move(one.findings.begin(), one.findings.end(), std::back_inserter(all.findings));
  }
  sort(all);
  return all;
}

}  // namespace jounce
