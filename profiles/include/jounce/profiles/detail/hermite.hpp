// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"
#include "jounce/profiles/error.hpp"

// The two-point Hermite polynomial of degree 11, and bounds of its distance from a function.

namespace jounce::profiles_detail {

/// Taylor coefficients f^(k) / k! with respect to s, k = 0 .. n - 1.
template <std::size_t n>
using Series = std::array<double, n>;

/// The six coefficients that each end of a piece gives, and bounds up to the twelfth coefficient,
/// which bounds the error.
using EndSeries = Series<6>;
using Majorant = Series<13>;

/// Returns the first n coefficients of f at s, for any s; n is 6 or 12.
template <std::size_t n = 6>
Series<n> taylor(const Segment& f, double s);

/// Upper bounds of the magnitude of every coefficient of f over |s| <= reach.
Majorant majorant(const Segment& f, double reach);

/// Returns the series of F(r0 + d(s)). F: its coefficients at r0; d: a series whose first
/// coefficient is 0. If both are majorants (upper bounds of the coefficients), so is the result.
template <std::size_t n>
Series<n> substituted(const Series<n>& F, const Series<n>& d) {
  Series<n> g{};
  for (std::size_t k = n; k-- > 0;) {  // Horner: g = g d + F_k
    Series<n> product{};
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 1; i + j < n; ++j) product[i + j] += g[i] * d[j];
    g = product;
    g[0] += F[k];
  }
  return g;
}

/// Returns the segment of degree 11 with these coefficients at its start and end.
Segment hermite(double length, const EndSeries& at0, const EndSeries& at1);

/// Bounds of the distance between a function and its `hermite`, and of their derivatives with
/// respect to u. `twelfth` bounds the magnitude of the function's twelfth coefficient with respect
/// to s.
Jet hermite_error(double length, double twelfth);

/// require_tolerance() throws InputError("tolerance", ...) unless the tolerance is positive and
/// exceeds the rounding of `magnitude`. require_fitting() throws it if a fit has more than a
/// million pieces.
void require_tolerance(double tolerance, double magnitude);
void require_fitting(std::size_t pieces);

/// Appends the fit of a piece to `out` and widens `error`. The piece is halved until its error is
/// at most `tolerance`. A Piece has length(), end(0) and end(1) as EndSeries, twelfth(), and
/// halves().
template <class Piece>
void fit(const Piece& piece, double tolerance, std::vector<Segment>& out, Jet& error) {
  const Jet here = hermite_error(piece.length(), piece.twelfth());
  if (!(here[0] <= tolerance)) {
    const auto [left, right] = piece.halves();
    fit(left, tolerance, out, error);
    fit(right, tolerance, out, error);
    return;
  }
  require_fitting(out.size());
  out.push_back(hermite(piece.length(), piece.end(0), piece.end(1)));
  for (std::size_t k = 0; k < error.size(); ++k) error[k] = std::max(error[k], here[k]);
}

}  // namespace jounce::profiles_detail
