// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/characteristics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "jounce/cam/detail/quadrature.hpp"

// Let z = (x - x0) / b and f = (y - y0) / h. The n-th derivative with respect to z is b^n / h times
// that with respect to the master:
//
//   (1)  f^(n) = y^(n) b^n / h
//
// Cm is the peak of g = y' y'', with g' = y''^2 + y' y''' and g'' = 3 y'' y''' + y' y''''. On a
// piece of half-width r around m,
//
//   (2)  |g| <= |g(m)| + |g'(m)| r + K r^2 / 2,   K = 3 max|y''| max|y'''| + max|y'| max|y''''|
//
// with the exact peaks of the rise. The search discards a piece whose bound (2) is not above the
// best value so far, and halves all others. Near a peak the bound shrinks with r^2, so few pieces
// remain at each size. A Newton step towards g' = 0 finds the peak itself early.

namespace jounce {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Searches max |y' y''| over the segments of a rise.
class PowerSearch {
 public:
  explicit PowerSearch(const Rise& rise) {
    best_.where = rise.cam.start();
    const auto pieces = rise.cam.segments();
    std::vector<Segment> slopes;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      slopes.push_back(derivative(pieces[i]));
      noise_ = std::max(noise_, 4e-16 * magnitude(slopes[i]) * magnitude(derivative(slopes[i])));
      for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0})
        take(evaluate(slopes[i], s), rise.cam.breaks()[i] + s * pieces[i].length);
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Ranges own = extrema(Curve<OverMaster>({slopes[i]}));  // ranges of y' to y''''
      const auto peak = [&](std::size_t k) { return std::abs(own[k].peak().value); };
      curvature_ = 3 * peak(1) * peak(2) + peak(0) * peak(3);
      search(slopes[i], rise.cam.breaks()[i], 0, 1);
    }
  }

  [[nodiscard]] Coefficient best() const { return best_; }

 private:
  static constexpr double enough = 1e-10;

  void take(const Jet& v, double where) {
    if (const double g = std::abs(v[0] * v[1]); g > best_.value) best_ = {g, where};
  }

  void search(const Segment& slope, double start, double a, double b) {
    const double m = (a + b) / 2;
    const double r = (b - a) / 2 * slope.length;
    const Jet v = evaluate(slope, m);
    const double g = v[0] * v[1];
    take(v, start + m * slope.length);
    const double dg = v[1] * v[1] + v[0] * v[2];
    const double ddg = 3 * v[1] * v[2] + v[0] * v[3];
    if (const double step = -dg / ddg; std::abs(step) < r) {
      const double u = m * slope.length + step;
      take(evaluate(slope, u / slope.length), start + u);
    }
    const double bound = std::abs(g) + std::abs(dg) * r + curvature_ * r * r / 2;  // (2)
    if (bound <= best_.value * (1 + enough) + noise_ || !(m > a && m < b)) return;
    search(slope, start, a, m);
    search(slope, start, m, b);
  }

  Coefficient best_;
  double curvature_ = 0;
  double noise_ = 0;  ///< rounding of y' y''
};

double mean_square_acceleration(const Cam& cam) {
  double sum = 0;
  for (const Segment& f : cam.segments())
    cam_detail::quadrature(f, [&](double s, double weight) {
      const double a = evaluate(f, s)[2];
      sum += weight * f.length * a * a;
    });
  return sum / cam.length();
}

}  // namespace

Characteristics characteristics(const Rise& rise) {
  const double h = rise.stroke;
  const double b = rise.length();
  const double velocity = b / std::abs(h);  // (1)
  const double acceleration = velocity * b;
  const double jerk = acceleration * b;
  const auto coefficient = [](const Extremum& e, double factor) {
    return Coefficient{std::max(0.0, e.value * factor), e.where};
  };
  const auto peak = [](const Range& range, double factor) {
    return Coefficient{std::abs(range.peak().value) * factor, range.peak().where};
  };
  const Range& a = rise.ranges[2];
  Characteristics c;
  c.stroke = h;
  c.length = b;
  c.cv = peak(rise.ranges[1], velocity);
  c.ca = h > 0 ? coefficient(a.max, acceleration) : coefficient(a.min, -acceleration);
  c.ca_star = h > 0 ? coefficient(a.min, -acceleration) : coefficient(a.max, acceleration);
  c.cj = peak(rise.ranges[3], jerk);
  c.cj_inside = c.cj.value;
  if (rise.continuous < 2) c.cj.value = infinite;
  c.cm = PowerSearch(rise).best();
  c.cm.value *= velocity * acceleration;
  c.rms = std::sqrt(mean_square_acceleration(rise.cam)) * acceleration;
  if (rise.continuous < 1) c.ca.value = c.ca_star.value = c.cm.value = c.rms = infinite;
  return c;
}

Characteristics characteristics(const Cam& law) {
  return characteristics(as_rise(law));
}

}  // namespace jounce
