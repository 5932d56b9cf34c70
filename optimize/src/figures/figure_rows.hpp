// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimize/src/program/spline_space.hpp"

namespace jounce::optimizer {

/// A convex figure as a program sees it. A new kind of figure is one more overload of rows_of().
///
/// Either by planes: forms with form(z) <= figure(z) for every z, of which the highest is the figure.
/// There are more than can be listed; cuts() finds those that matter (an exchange method).
/// Or by squares: figure(z)^2 = sum of squares(z)^2.
struct FigureRows {
  std::string name;
  /// Exact, of a finished shape from the first knot on; not from the program's rows.
  std::function<double(const std::vector<Segment>& shape)> value;
  /// Planes to begin with.
  std::vector<Form> start = {};
  /// The planes that touch the figure of `shape` where it exceeds `level`: one for each peak, say.
  /// None: it does not.
  std::function<std::vector<Form>(const std::vector<Segment>& shape, double level)> cuts = {};
  std::vector<Form> squares = {};
  /// Where the figure of a shape is taken, with the sign, to tell the user: each run of pieces once.
  std::function<std::vector<Extremum>(const std::vector<Segment>& shape, double level)> places = {};
  /// A value that is neither large nor small.
  double natural = 1;
  double nothing = 1e-12;  ///< share of it that is no more than rounding
  double accuracy = 0;  ///< share of it to which the forms are true, where that is not all digits
  /// Unknowns of its own that its forms are in (Lift): each == 0 says what one is by the coordinates.
  std::vector<Form> own = {};
  double own_share = 0;  ///< none of these is larger than so much times the figure

  [[nodiscard]] bool by_squares() const { return !squares.empty(); }
};

/// Gives a response or a residual unknowns of its own, numbered from `first`: as many as it has independent parts.
struct Lift {
  std::size_t first = 0;
  const std::vector<Segment>& given;
  std::optional<double> at_most =
      {};  ///< what they are counted in; left out: the figure of `given`
};

FigureRows rows_of(const PeakOf& figure, const SplineSpace& space);
FigureRows rows_of(const RmsOf& figure, const SplineSpace& space);
FigureRows rows_of(const ResponseOf& figure, const SplineSpace& space, const Lift* lift = nullptr);
FigureRows rows_of(const RmsResponseOf& figure, const SplineSpace& space,
                   const Lift* lift = nullptr);
FigureRows rows_of(const ResidualOf& figure, const SplineSpace& space, const Lift* lift = nullptr);

/// True if there is a rows_of() for it.
bool has_rows(const ShapeFigure& figure);
/// That of whichever figure it is. `space` must outlive what is returned.
/// Lifted, if asked to and a response or a residual.
FigureRows figure_rows(const ShapeFigure& figure, const SplineSpace& space,
                       const Lift* lift = nullptr);

/// Where to put planes for an extremum of g, in [0, 1], that exceeds a level: there and, if g bends,
/// halfway to where g crosses the level. Optima touch between two planes as a rule; so the next round
/// has them four times as close.
std::vector<double> places_around(const Segment& g, double s, double excess);

/// max |y| of q over a shape that begins at x, with its place.
Extremum peak_of(const LinearQuantity& q, const std::vector<Segment>& shape, double x);

}  // namespace jounce::optimizer
