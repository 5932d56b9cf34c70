// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimize/src/program/spline_space.hpp"

namespace jounce::optimize_detail {

/// A convex figure as rows of a program. A new kind of figure needs one more overload of rows_of().
///
/// A figure is given either by planes or by squares. Planes are linear forms that are at most
/// figure(z) for every z, and the highest of them is the figure. There are too many to list; cuts()
/// returns the planes that matter (an exchange method). Squares are linear forms such that the sum
/// of their squares is figure(z)^2.
struct FigureRows {
  std::string name;  ///< name for the user
  /// Returns the exact value for a finished shape that begins at the first knot. It does not use
  /// the rows of the program.
  std::function<double(const std::vector<Segment>& shape)> value;
  /// The first planes.
  std::vector<Form> start = {};
  /// Returns the planes that touch the figure of `shape` where it exceeds `level`, for example one
  /// for each peak; empty: the figure does not exceed the level.
  std::function<std::vector<Form>(const std::vector<Segment>& shape, double level)> cuts = {};
  std::vector<Form> squares = {};  ///< linear forms; the sum of their squares is figure^2
  /// Returns the places where the figure of a shape is attained, with the sign, for the report; one
  /// for each run of pieces.
  std::function<std::vector<Extremum>(const std::vector<Segment>& shape, double level)> places = {};
  /// Usual size of the figure.
  double natural = 1;
  double nothing = 1e-12;  ///< values up to this share of `natural` are rounding
  double accuracy = 0;     ///< accuracy of the forms, as a share of `natural`; 0: rounding
  /// The equations (form == 0) that define the auxiliary variables by the coordinates. The other
  /// forms of the figure use these variables.
  std::vector<Form> definitions = {};
  double auxiliary_share = 0;  ///< an auxiliary variable is at most this multiple of the figure

  /// True if the figure is given by squares.
  [[nodiscard]] bool by_squares() const { return !squares.empty(); }
};

/// Requests auxiliary variables for a response or a residual, as many as it has independent parts.
struct Auxiliary {
  std::size_t first = 0;              ///< index of the first one among the unknowns
  const std::vector<Segment>& given;  ///< the given shape
  /// Target of the figure, which determines the unit of the unknowns; nullopt: the figure of
  /// `given`.
  std::optional<double> at_most = {};
};

/// Returns the rows of a figure. `space` must outlive the result. `auxiliary`: the response or
/// residual is written in auxiliary variables; null: in coordinates.
FigureRows rows_of(const PeakOf& figure, const SplineSpace& space);
FigureRows rows_of(const RmsOf& figure, const SplineSpace& space);
FigureRows rows_of(const ResponseOf& figure, const SplineSpace& space,
                   const Auxiliary* auxiliary = nullptr);
FigureRows rows_of(const RmsResponseOf& figure, const SplineSpace& space,
                   const Auxiliary* auxiliary = nullptr);
FigureRows rows_of(const ResidualOf& figure, const SplineSpace& space,
                   const Auxiliary* auxiliary = nullptr);

/// True if there is a rows_of() for the figure.
bool has_rows(const ShapeFigure& figure);
/// Returns the rows of any figure. `space` must outlive the result. `auxiliary`: see rows_of().
FigureRows figure_rows(const ShapeFigure& figure, const SplineSpace& space,
                       const Auxiliary* auxiliary = nullptr);

/// Returns the places, in [0, 1], of new planes for an extremum of g that exceeds a level: the
/// extremum itself and, if g bends, the points halfway to where g crosses the level. An optimum
/// usually touches between two planes. In the next round, planes are four times as close.
std::vector<double> places_around(const Segment& g, double s, double excess);

/// Returns max |q| over a shape that begins at x, signed, with its place.
Extremum peak_of(const LinearQuantity& q, const std::vector<Segment>& shape, double x);

}  // namespace jounce::optimize_detail
