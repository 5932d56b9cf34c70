// SPDX-License-Identifier: Apache-2.0
// The value of a pointwise figure for a whole shape: extrema, integrals, and places where it equals
// a level.
//
// The peak of a quantity with a sine term: between a and b, its distance from the straight line
// between its end values is at most
//
//   (2)  (b - a)^2 / 8 (max |P''| + |G| (max |angle'|^2 + max |angle''|))
//
// An interval is halved until (2) is within the tolerance. A half is dropped as soon as the higher
// of its end values plus (2) is below the best known value.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "jounce/cam/detail/quadrature.hpp"
#include "jounce/optimize/detail/pointwise.hpp"
#include "jounce/profiles/curve/roots.hpp"

#include "optimize/src/program/spline_space.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double level_precision = 1e-9;  ///< share of the level
constexpr double peak_precision = 1e-8;   ///< share of the peak so far

/// Halves until (2) permits at most the tolerance above the best value.
struct Climb {
  const Wave& wave;
  double sign;
  double tolerance;
  double bend;  ///< the factor of (b - a)^2 in (2), s in [0, 1]
  Extremum best{};

  void run(double a, double at_a, double b, double at_b, int depth) {
    const double highest = std::max(at_a, at_b) + bend * (b - a) * (b - a);
    if (highest <= sign * best.value + tolerance || depth == 0) return;
    const double middle = (a + b) / 2;
    const double at_middle = consider(middle);
    run(a, at_a, middle, at_middle, depth - 1);
    run(middle, at_middle, b, at_b, depth - 1);
  }
  double consider(double s) {
    const double value = sign * wave.at(s);
    if (value > sign * best.value)
      best = {sign * value, wave.from + s * (wave.to - wave.from), Side::right};
    return value;
  }
};

double peak_of_derivative(const Segment& f, int order) {
  return std::abs(segment_range(f, 0, f.length, order).peak().value);
}

}  // namespace

double Wave::at(double s) const {
  const double p = value(polynomial, s);
  return gravity == 0 ? p : p + gravity * std::sin(value(angle, s));
}

Range range_of(const Wave& wave, double tolerance) {
  if (wave.gravity == 0) return segment_range(wave.polynomial, wave.from, wave.to, 0);
  const double length = wave.angle.length;
  const double turning = peak_of_derivative(wave.angle, 1);
  const double bend =
      length * length / 8 *
      (peak_of_derivative(wave.polynomial, 2) +
       std::abs(wave.gravity) * (turning * turning + peak_of_derivative(wave.angle, 2)));
  Range range;
  for (const double sign : {1.0, -1.0}) {
    Climb climb{wave, sign, tolerance, bend, {wave.at(0), wave.from, Side::right}};
    const double first = sign * wave.at(0);
    climb.run(0, first, 1, climb.consider(1), 40);
    (sign > 0 ? range.max : range.min) = climb.best;
  }
  return range;
}

namespace {

/// The integral of g, or of its square, over the shape, by quadrature between the ends of the waves.
double integrated(const Pointwise& figure, const std::vector<Segment>& shape, double begin) {
  std::vector<double> starts{begin};
  for (const Segment& f : shape) starts.push_back(starts.back() + f.length);
  std::vector<double> q(figure.of.size());
  std::vector<double> slope(q.size());
  double total = 0;
  for (const Wave& wave : figure.waves(shape, begin)) {
    const Segment& f = shape[wave.piece];
    std::vector<Segment> parts;
    for (const LinearQuantity& each : figure.of) parts.push_back(quantity_of(each, f));
    const auto g = [&](double r) {
      const double x = wave.from + r * (wave.to - wave.from);
      const double s = std::clamp((x - starts[wave.piece]) / f.length, 0.0, 1.0);
      for (std::size_t k = 0; k < q.size(); ++k) q[k] = value(parts[k], s);
      const double at = figure.g(x, wave.sign, q, slope);
      return figure.over == Pointwise::Over::rms ? at * at : at;
    };
    total += (wave.to - wave.from) * jounce::cam_detail::integral(g);
  }
  return total;
}

}  // namespace

std::vector<Extremum> places_of(const Pointwise& figure, const std::vector<Segment>& shape,
                                double begin, double level) {
  std::vector<Extremum> places;
  if (figure.over != Pointwise::Over::peak) return places;
  std::array<std::size_t, 2> last{shape.size() + 1, shape.size() + 1};
  for (const Wave& wave : figure.waves(shape, begin)) {
    const Range range = range_of(wave, level_precision * level);
    for (const double sign : {1.0, -1.0}) {
      const Extremum& e = sign > 0 ? range.max : range.min;
      if (sign * e.value < level) continue;
      std::size_t& before = last[sign > 0 ? 0 : 1];
      if (before != wave.piece && before + 1 != wave.piece) places.push_back(e);
      before = wave.piece;
    }
  }
  return places;
}

double value_of(const Pointwise& figure, const std::vector<Segment>& shape, double begin) {
  if (figure.over != Pointwise::Over::peak) {
    double length = 0;
    for (const Segment& f : shape) length += f.length;
    const double total = integrated(figure, shape, begin);
    return figure.over == Pointwise::Over::rms ? std::sqrt(total / length) : total;
  }
  double peak = 0;
  const std::vector<Wave> waves = figure.waves(shape, begin);
  for (const Wave& wave : waves) {
    const double ends = std::max(std::abs(wave.at(0)), std::abs(wave.at(1)));
    if (!std::isfinite(ends)) return std::nan("");  // std::max would lose it
    peak = std::max(peak, ends);
  }
  for (const Wave& wave : waves)
    peak = std::max(peak, std::abs(range_of(wave, peak_precision * peak).peak().value));
  return peak;
}

}  // namespace jounce::optimize_detail
