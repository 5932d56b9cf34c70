// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/optimize/shape.hpp"
#include "jounce/profiles/curve/extrema.hpp"

/// Figures that are made of a function of a few linear quantities at one place, which is not convex:
/// power, torque with friction and gravity, energy.
namespace jounce::optimizer {

/// g(x, q_0(x), q_1(x), ...) on a interval of a shape where it is smooth:
///
///     (1)  g = polynomial + gravity sin(angle)
struct Wave {
  std::size_t piece = 0;  ///< piece of the shape
  double from = 0;        ///< x
  double to = 0;
  double sign = 1;  ///< sign of the velocity here
  Segment polynomial = {};
  double gravity = 0;
  Segment angle = {};

  /// The value at s in [0, 1] of the interval.
  [[nodiscard]] double at(double s) const;
};

/// A figure as a search sees it.
struct Pointwise {
  enum class Over { peak, rms, integral };  ///< max |g|; root of the mean of g^2; integral of g

  Over over = Over::peak;
  std::vector<LinearQuantity> of = {};        ///< q
  std::optional<std::size_t> signed_by = {};  ///< the quantity whose sign g depends on, if it does
  /// g at x for given q and sign; its derivatives by q into `slope`.
  std::function<double(double x, double sign, std::span<const double> q, std::span<double> slope)>
      g = {};
  /// For a whole shape; the integrand is g^2 or g.
  std::function<std::vector<Wave>(const std::vector<Segment>& shape, double begin)> waves = {};
};

/// Nothing for figures that are convex. `begin`: of the shapes.
std::optional<Pointwise> pointwise(const ShapeFigure& figure, double begin);

/// The least and the greatest g of a wave: exact for a polynomial, otherwise within `tolerance` (by
/// a bound of its second derivative).
Range range_of(const Wave& wave, double tolerance);

/// The figure of a shape: a peak by range_of(), with a tolerance of 1e-8 of its value; the others
/// by quadrature between the places where T is not smooth, to about 1e-10; energy, whose integrand
/// has a kink at each change of sign of T, to about 1e-6.
double value_of(const Pointwise& figure, const std::vector<Segment>& shape, double begin);

/// Places where a peaked figure reaches the level, with its sign: each run of pieces once. Empty for the
/// others.
std::vector<Extremum> places_of(const Pointwise& figure, const std::vector<Segment>& shape,
                                double begin, double level);

/// Throws InputError, its key beginning with `key`, for a load out of range, or if a product would
/// exceed the capacity of a Segment. Does nothing for the convex figures.
void require_pointwise(const std::string& key, const ShapeFigure& figure,
                       const ShapeProblem& problem);

/// f g; nothing if it would exceed the capacity of a Segment. Neither has sines.
std::optional<Segment> product(const Segment& f, const Segment& g);

}  // namespace jounce::optimizer
