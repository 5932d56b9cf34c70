// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimize/src/program/spline_space.hpp"

namespace jounce::optimizer {

/// A convex figure as rows of a program. A new kind of figure needs one more overload of rows_of().
///
/// A figure is given either by planes or by squares. Planes are linear forms that are at most
/// figure(z) for every z, and the highest of them is the figure. There are too many to list; cuts()
/// returns those that matter (an exchange method). Squares are linear forms such that the sum of
/// their squares is figure(z)^2.
struct FigureRows {
  std::string name;
  /// The exact value for a finished shape that begins at the first knot; it does not use the rows of the
  /// program.
  std::function<double(const std::vector<Segment>& shape)> value;
  /// The first planes.
  std::vector<Form> start = {};
  /// The planes that touch the figure of `shape` where it exceeds `level`, for example one for each peak. None:
  /// it does not exceed the level.
  std::function<std::vector<Form>(const std::vector<Segment>& shape, double level)> cuts = {};
  std::vector<Form> squares = {};
  /// The places where the figure of a shape is attained, with the sign, for the report: each run of pieces
  /// once.
  std::function<std::vector<Extremum>(const std::vector<Segment>& shape, double level)> places = {};
  /// A value of ordinary size.
  double natural = 1;
  double nothing = 1e-12;  ///< values up to this share of `natural` are rounding
  double accuracy = 0;     ///< accuracy of the forms, as a share of `natural`; 0: rounding
  /// The auxiliary variables in which the forms are written. The equations `== 0` define them by
  /// the coordinates.
  std::vector<Form> definitions = {};
  double auxiliary_share = 0;  ///< no auxiliary variable exceeds this multiple of the figure

  [[nodiscard]] bool by_squares() const { return !squares.empty(); }
};

/// Gives a response or a residual auxiliary variables, numbered from `first`: as many as it has independent
/// parts.
struct Auxiliary {
  std::size_t first = 0;
  const std::vector<Segment>& given;
  std::optional<double> at_most = {};  ///< unit of the unknowns; left out: the figure of `given`
};

FigureRows rows_of(const PeakOf& figure, const SplineSpace& space);
FigureRows rows_of(const RmsOf& figure, const SplineSpace& space);
FigureRows rows_of(const ResponseOf& figure, const SplineSpace& space,
                   const Auxiliary* auxiliary = nullptr);
FigureRows rows_of(const RmsResponseOf& figure, const SplineSpace& space,
                   const Auxiliary* auxiliary = nullptr);
FigureRows rows_of(const ResidualOf& figure, const SplineSpace& space,
                   const Auxiliary* auxiliary = nullptr);

/// True if there is a rows_of() for it.
bool has_rows(const ShapeFigure& figure);
/// Rows of any figure. `space` must outlive the result. `auxiliary`: a response or a residual gets unknowns of its
/// own.
FigureRows figure_rows(const ShapeFigure& figure, const SplineSpace& space,
                       const Auxiliary* auxiliary = nullptr);

/// Returns the places, in [0, 1], of new planes for an extremum of g that exceeds a level: the
/// extremum itself and, if g bends, the points halfway to where g crosses the level. An optimum
/// usually touches between two planes. In the next round, planes are four times as close.
std::vector<double> places_around(const Segment& g, double s, double excess);

/// max |y| of q over a shape that begins at x, with its place.
Extremum peak_of(const LinearQuantity& q, const std::vector<Segment>& shape, double x);

}  // namespace jounce::optimizer
