// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "jounce/cam/design/design.hpp"

#include "optimize/src/knots/free_quantities.hpp"

/// A cam as a function of its knots, with exact gradients.
///
/// Between two knots at the masters m0 and m1 = m0 + L, the laws are linear in q = (p0, v0, a0, p1,
/// v1, a1). With e = (0, 1, 2, 0, 1, 2), z = (m - m0) / L and normalized shapes B_i (LawPiece of
/// jounce/cam/laws/law.hpp):
///
///     (1)  f           = sum_i q_i L^e_i B_i(z)
///     (2)  f^(k)       = sum_i q_i L^(e_i - k) B_i^(k)(z)
///     (3)  df^(k)/dq_i = L^(e_i - k) B_i^(k)(z)
///     (4)  df^(k)/dL   = sum_i (e_i - k) q_i L^(e_i - k - 1) B_i^(k)(z),
///          df^(k)/dm1  = df^(k)/dL = -df^(k)/dm0            at fixed z
///     (5)  I  = integral of f''^2 = sum_ij q_i q_j L^(e_i + e_j - 3) G_ij,
///          G_ij = integral of B_i'' B_j'' over z
///     (6)  dI/dq_i = 2 sum_j q_j L^(e_i + e_j - 3) G_ij,
///          dI/dL   = sum_ij (e_i + e_j - 3) q_i q_j L^(e_i + e_j - 4) G_ij
namespace jounce::optimize_detail {

/// A gradient with respect to the values of the knot before (0 to 3) and of the knot after (4 to
/// 7).
using KnotGradient = std::array<double, 8>;

/// One segment of the finished curve: the six shapes of (1) over its share of a segment of the
/// spec.
struct Piece {
  /// Index of the segment of the spec, which is between the knots `segment` and `segment + 1`.
  std::size_t segment = 0;
  std::array<Segment, 6> shape{};
};

/// Returns the pieces, in the order of design(spec).cam.segments().
std::vector<Piece> pieces(const CamSpec& spec);

/// A derivative of the curve at a fixed z, (2) with k = `order`, plus `lower` times the next lower
/// derivative.
struct Sample {
  std::size_t piece = 0;           ///< index of the piece
  std::size_t segment = 0;         ///< index of the segment of the spec
  std::size_t order = 0;           ///< order of the derivative, k
  double s = 0;                    ///< place within the piece, 0 to 1
  double lower = 0;                ///< factor of the next lower derivative
  std::array<double, 6> weight{};  ///< B_i^(k)(z)
  /// The same for the next lower derivative; unused if `lower` is 0.
  std::array<double, 6> weight_below{};
};

/// Returns the sample at a place of a piece.
Sample sample(std::span<const Piece> pieces, std::size_t piece, std::size_t order, double s,
              double lower = 0);

/// Returns (2), and writes (3) and (4) to `gradient`.
double value(const Sample& sample, std::span<const Knot> knots, KnotGradient& gradient);

/// G of (5), for one segment of the spec.
using Gram = std::array<std::array<double, 6>, 6>;
/// Returns G of each segment.
std::vector<Gram> grams(std::span<const Piece> pieces);

/// Returns (5), and writes (6) to `gradient`.
double square_acceleration(const Gram& gram, const Knot& from, const Knot& to,
                           KnotGradient& gradient);

}  // namespace jounce::optimize_detail
