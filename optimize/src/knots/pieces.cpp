// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/pieces.hpp"

#include <cassert>
#include <cmath>

#include "jounce/cam/detail/quadrature.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr std::array<int, 6> power{0, 1, 2, 0, 1, 2};  // e of (1)

double at_knots(std::span<const Knot> knots, std::size_t segment, std::size_t i) {
  return knots[segment + i / 3][1 + i % 3];
}

/// L^-4 ... L^4, so that exponents index.
struct Powers {
  explicit Powers(double length) {
    up[4] = 1;
    for (std::size_t i = 5; i < up.size(); ++i) up[i] = up[i - 1] * length;
    for (std::size_t i = 4; i > 0; --i) up[i - 1] = up[i] / length;
  }
  double operator()(int exponent) const { return up[static_cast<std::size_t>(exponent + 4)]; }
  std::array<double, 9> up{};
};

std::array<Segment, 6> shapes(const LawPiece& f) {
  return {scaled(f.rise, -1, 1), f.enter, f.bend_in, f.rise, f.leave, f.bend_out};
}

}  // namespace

std::vector<Piece> pieces(const CamSpec& spec) {
  std::vector<Piece> all;
  const auto laws = jounce::shapes(spec);
  for (std::size_t i = 0; i < laws.size(); ++i)
    for (const LawPiece& f : laws[i]) all.push_back({i, shapes(f)});
  return all;
}

Sample sample(std::span<const Piece> pieces, std::size_t piece, std::size_t order, double s,
              double lower) {
  assert(order <= 3 && 0 <= s && s <= 1 && (lower == 0 || order > 0));
  Sample at{piece, pieces[piece].segment, order, s, lower, {}, {}};
  for (std::size_t i = 0; i < 6; ++i) {
    const Jet jet = evaluate(pieces[piece].shape[i], s);
    at.weight[i] = jet[order];
    if (lower != 0) at.weight_below[i] = jet[order - 1];
  }
  return at;
}

double value(const Sample& sample, std::span<const Knot> knots, KnotGradient& gradient) {
  const Powers length(knots[sample.segment + 1][0] - knots[sample.segment][0]);
  gradient = {};
  double f = 0;
  double by_length = 0;
  const auto add = [&](std::size_t order, double factor, const std::array<double, 6>& weight) {
    for (std::size_t i = 0; i < 6; ++i) {
      const int e = power[i] - static_cast<int>(order);
      const double q = at_knots(knots, sample.segment, i);
      const double by_q = factor * length(e) * weight[i];  // (3)
      gradient[4 * (i / 3) + 1 + i % 3] += by_q;
      f += q * by_q;                                            // (2)
      by_length += factor * e * q * length(e - 1) * weight[i];  // (4)
    }
  };
  add(sample.order, 1, sample.weight);
  if (sample.lower != 0) add(sample.order - 1, sample.lower, sample.weight_below);
  gradient[0] = -by_length;
  gradient[4] = by_length;
  return f;
}

std::vector<Gram> grams(std::span<const Piece> pieces) {
  std::vector<Gram> all(pieces.back().segment + 1);
  for (const Piece& piece : pieces)
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        all[piece.segment][i][j] +=
            piece.shape[0].length * jounce::cam_detail::integral([&](double s) {
              return evaluate(piece.shape[i], s)[2] * evaluate(piece.shape[j], s)[2];
            });
  return all;
}

double square_acceleration(const Gram& gram, const Knot& from, const Knot& to,
                           KnotGradient& gradient) {
  const std::array<Knot, 2> knots{from, to};
  const Powers length(to[0] - from[0]);
  double total = 0;
  double by_length = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    double half = 0;
    for (std::size_t j = 0; j < 6; ++j) {
      const int e = power[i] + power[j] - 3;
      const double q = at_knots(knots, 0, j) * gram[i][j];
      half += q * length(e);
      by_length += e * at_knots(knots, 0, i) * q * length(e - 1);  // (6)
    }
    gradient[4 * (i / 3) + 1 + i % 3] = 2 * half;  // (6)
    total += at_knots(knots, 0, i) * half;         // (5)
  }
  gradient[0] = -by_length;
  gradient[4] = by_length;
  return total;
}

}  // namespace jounce::optimize_detail
