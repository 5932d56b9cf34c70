// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/vibration_band.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/error.hpp"

// vibration.cpp, (3): with the pole s = w (-D + i sqrt(1 - D^2)) and the time t left to the end,
//
//   (1)  R = |I(s)| / sqrt(1 - D^2),   I(s) = integral of f' e^(s t)
//
// The boundary. I is analytic in s, so log |I| is subharmonic. 1 / sqrt(1 - D^2) = |s| / Im s. log
// |s| is harmonic except at 0, and -log Im s is subharmonic, because its Laplacian is 1 / (Im s)^2.
// So log R is subharmonic for D < 1, and its maximum over a region is on the boundary of the
// region: at one of the two end frequencies or one of the two end dampings.
//
// Along the boundary. Between a and b on a path s(q), the function I(s(q)) differs from the
// straight line between its values at both ends by at most (b - a)^2 / 8 times its greatest second
// derivative with respect to q. The magnitude of the straight line is greatest at one of its ends.
// With M_k = integral of |f'| t^k, which bounds the k-th derivative of I because |e^(s t)| <= 1,
//
//   (2)  |I| <= max(|I_a|, |I_b|) + (b - a)^2 / 8 C
//   (3)  damping fixed, q = w: |s'| = 1, s'' = 0, so C = M_2
//   (4)  w fixed, q = asin D: |s'| = |s''| = w, so C = M_2 w^2 + M_1 w
//
// Pieces of the boundary are halved until (2) excludes that a piece exceeds the worst value found.

namespace jounce {
namespace {

using profiles_detail::two_pi;

/// The moments M_0, M_1, M_2. A step of the position counts at its instant.
struct Moments {
  double travel = 0;
  double first = 0;
  double second = 0;

  explicit Moments(const Trajectory& motion) {
    double before = value(motion.segments().front(), 0);
    for (std::size_t i = 0; i < motion.segments().size(); ++i) {
      const Segment& f = motion.segments()[i];
      const double a = motion.end() - motion.breaks()[i + 1];
      const double b = a + f.length;
      add(std::abs(value(f, 0) - before), b, b);
      add(std::abs(segment_range(motion, i, 1).peak().value) * f.length, a, b);
      before = value(f, 1);
    }
  }

 private:
  /// Adds a distance that is evenly distributed over the times from a to b before the end.
  void add(double way, double a, double b) {
    travel += way;
    first += way * (a + b) / 2;
    second += way * (a * a + a * b + b * b) / 3;
  }
};

double cofactor(double damping) {
  return std::sqrt((1 - damping) * (1 + damping));
}

/// One side of the band, from q = a to q = b.
struct Border {
  bool over_frequency = true;  ///< q = w; otherwise q = asin D
  double fixed = 0;            ///< D, or w
  double a = 0;
  double b = 0;

  [[nodiscard]] Mode mode(double q) const {
    if (over_frequency) return {q / two_pi, fixed};
    return {fixed / two_pi, std::sin(q)};
  }
  /// C of (3), (4).
  [[nodiscard]] double curvature(const Moments& m) const {
    return over_frequency ? m.second : fixed * (m.second * fixed + m.first);
  }
};

struct Piece {
  double a, b;        ///< values of q
  double at_a, at_b;  ///< values of |I|
};

class VibrationSearch {
 public:
  VibrationSearch(const Trajectory& motion, double tolerance)
      : motion_(motion), moments_(motion), tolerance_(tolerance * moments_.travel) {}

  void along(const Border& side) {
    const double c = side.curvature(moments_);
    std::vector<Piece> open{{side.a, side.b, integral(side, side.a), integral(side, side.b)}};
    while (!open.empty()) {
      const Piece p = open.back();
      open.pop_back();
      const double most = std::max(p.at_a, p.at_b) + (p.b - p.a) * (p.b - p.a) / 8 * c;  // (2)
      const double middle = (p.a + p.b) / 2;
      const double highest = most / cofactor(side.mode(p.b).damping);
      if (highest <= worst_.residual + tolerance_ || middle <= p.a || middle >= p.b) continue;
      const double at_middle = integral(side, middle);
      open.push_back({p.a, middle, p.at_a, at_middle});
      open.push_back({middle, p.b, at_middle, p.at_b});
    }
  }

  [[nodiscard]] const WorstMode& worst() const { return worst_; }

 private:
  /// |I|, by (1).
  double integral(const Border& side, double q) {
    const Mode mode = side.mode(q);
    const double residual = residual_vibration(motion_, mode);
    if (residual > worst_.residual || worst_.mode.frequency == 0) worst_ = {residual, mode};
    return residual * cofactor(mode.damping);
  }

  const Trajectory& motion_;
  Moments moments_;
  double tolerance_;
  WorstMode worst_;
};

void require_band(const ModeBand& band) {
  require_positive("low", band.low);
  require_finite("high", band.high);
  if (band.high < band.low)
    throw InputError("high", band.high, "must not be less than low = " + number(band.low));
  require_not_negative("damping_low", band.damping_low);
  require_finite("damping_high", band.damping_high);
  if (band.damping_high < band.damping_low || band.damping_high >= 1)
    throw InputError(
        "damping_high", band.damping_high,
        "must be less than 1 and not less than damping_low = " + number(band.damping_low));
}

}  // namespace

WorstMode worst_residual(const Trajectory& motion, const ModeBand& band, double tolerance) {
  require_band(band);
  if (!(tolerance >= 1e-12) || tolerance > 1)
    throw InputError("tolerance", tolerance, "must be between 1e-12 and 1");
  const double low = two_pi * band.low;
  const double high = two_pi * band.high;
  const double least = std::asin(band.damping_low);
  const double most = std::asin(band.damping_high);
  VibrationSearch search(motion, tolerance);
  search.along({true, band.damping_low, low, high});
  if (most > least) search.along({true, band.damping_high, low, high});
  search.along({false, low, least, most});
  if (high > low) search.along({false, high, least, most});
  return search.worst();
}

}  // namespace jounce
