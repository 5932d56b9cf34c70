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

/// Figures that are not convex: power, torque with friction and gravity, energy. At each place,
/// such a figure is a function of a few linear quantities.
namespace jounce::optimize_detail {

/// The function g(x, q_0(x), q_1(x), ...) on an interval of a shape on which it is smooth:
///
///     (1)  g = polynomial + gravity sin(angle)
struct Wave {
  std::size_t piece = 0;    ///< index of the piece of the shape
  double from = 0;          ///< start of the interval, x
  double to = 0;            ///< end of the interval, x
  double sign = 1;          ///< sign of the velocity in the interval
  Segment polynomial = {};  ///< first term
  double gravity = 0;       ///< amplitude of the sine
  Segment angle = {};       ///< angle of the sine, rad

  /// Returns the value at s, where s from 0 to 1 runs over the interval.
  [[nodiscard]] double at(double s) const;
};

/// A figure in the form that the search needs.
struct Pointwise {
  enum class Over { peak, rms, integral };  ///< max |g|; root of the mean of g^2; integral of g

  Over over = Over::peak;               ///< kind of the figure
  std::vector<LinearQuantity> of = {};  ///< the quantities q
  /// Index of the quantity whose sign g depends on; nullopt: none.
  std::optional<std::size_t> signed_by = {};
  /// Returns g at x for given values q and the sign; writes its derivatives with respect to q to
  /// `slope`.
  std::function<double(double x, double sign, std::span<const double> q, std::span<double> slope)>
      g = {};
  /// Returns the waves of a whole shape; they contain g, or g^2 for the rms.
  std::function<std::vector<Wave>(const std::vector<Segment>& shape, double begin)> waves = {};
};

/// Returns the figure as a Pointwise; nullopt for a convex figure. `begin`: x at the start of the
/// shapes.
std::optional<Pointwise> pointwise(const ShapeFigure& figure, double begin);

/// Returns the least and the greatest value of a wave: exact for a polynomial, otherwise within
/// `tolerance` (from a bound of its second derivative).
Range range_of(const Wave& wave, double tolerance);

/// Returns the value of the figure for a shape. A peak is computed by range_of() to 1e-8 of its
/// value. The others are computed by quadrature between the places where g is not smooth, to about
/// 1e-10; energy to about 1e-6, since its integrand has a kink at each change of sign of the
/// torque.
double value_of(const Pointwise& figure, const std::vector<Segment>& shape, double begin);

/// Returns the places at which a peak figure reaches the level, with its sign, one for each run of
/// pieces. Empty for other figures.
std::vector<Extremum> places_of(const Pointwise& figure, const std::vector<Segment>& shape,
                                double begin, double level);

/// Throws InputError, with a key that begins with `key`, for a load out of range, and if a product
/// exceeds the capacity of a Segment. Does nothing for a convex figure.
void require_pointwise(const std::string& key, const ShapeFigure& figure,
                       const ShapeProblem& problem);

/// Returns the product of two polynomial segments; nullopt if it exceeds the capacity of a Segment.
std::optional<Segment> product(const Segment& f, const Segment& g);

}  // namespace jounce::optimize_detail
