// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

/// Gauss-Legendre quadrature: all rules that Jounce uses.
namespace jounce::cam_detail {

/// A node in [0, 1] and its weight.
struct QuadratureNode {
  double s = 0;
  double weight = 0;
};

/// The rule with six nodes: exact for polynomials up to degree 11.
inline constexpr std::array gauss_6{QuadratureNode{0.033765242898423975, 0.085662246189585178},
                                    QuadratureNode{0.16939530676686776, 0.18038078652406930},
                                    QuadratureNode{0.38069040695840156, 0.23395696728634552},
                                    QuadratureNode{0.61930959304159844, 0.23395696728634552},
                                    QuadratureNode{0.83060469323313224, 0.18038078652406930},
                                    QuadratureNode{0.96623475710157603, 0.085662246189585178}};

/// The rule with any number of nodes, by Newton's method on the Legendre polynomial: exact up to
/// degree 2 points - 1.
inline std::vector<QuadratureNode> gauss(int points) {
  std::vector<QuadratureNode> rule;
  for (int i = 0; i < points; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));
    double slope = 1;
    for (int round = 0; round < 20; ++round) {
      double p = 1, before = 0;
      for (int k = 1; k <= points; ++k)
        before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
      slope = points * (x * p - before) / (x * x - 1);
      const double step = p / slope;
      x -= step;
      constexpr double last_node_step = 1e-16;
      if (std::abs(step) < last_node_step) break;
    }
    rule.push_back({(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return rule;
}

/// Returns the integral of f over [0, 1] by five nodes on each of 16 panels. Exact for polynomials
/// up to degree 9. The error is below 1e-13 for the square of a sine over one turn.
template <class F>
double integral(const F& f) {
  constexpr std::array<double, 3> node{0, 0.53846931010568309104, 0.90617984593866399280};
  constexpr std::array<double, 3> weight{0.56888888888888888889, 0.47862867049936646804,
                                         0.23692688505618908751};
  constexpr int panels = 16;
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double middle = (i + 0.5) / panels;
    sum += weight[0] * f(middle);
    for (std::size_t k = 1; k < node.size(); ++k) {
      const double h = node[k] / (2 * panels);
      sum += weight[k] * (f(middle - h) + f(middle + h));
    }
  }
  return sum / (2 * panels);
}

/// Calls visit(s, weight) for nodes s in [0, 1]. The sum of weight * g(s) is the integral of g over
/// [0, 1], if g is a product of two derivatives of f. It uses ten Gauss-Legendre nodes, exact for
/// polynomials up to degree 19. (The square of a first derivative has degree 20 at most: error
/// 1e-13.) A segment with sines is divided into panels of at most 2 rad. There the remainder,
/// (10!)^4 / (21 (20!)^3) times the 20th derivative, is below 1e-16 of the terms: rounding.
template <class Visit>
void quadrature(const Segment& f, const Visit& visit) {
  constexpr std::array<double, 5> node{0.14887433898163122, 0.43339539412924719,
                                       0.67940956829902441, 0.86506336668898451,
                                       0.97390652851717172};
  constexpr std::array<double, 5> weight{0.29552422471475287, 0.26926671930999636,
                                         0.21908636251598204, 0.14945134915058059,
                                         0.06667134430868814};
  double widest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i)
    widest = std::max(widest, std::abs(f.sine[i].angle));
  const double panels = std::max(1.0, std::ceil(widest / 2));
  for (double p = 0; p < panels; ++p)
    for (std::size_t k = 0; k < node.size(); ++k)
      for (const double x : {-node[k], node[k]})
        visit((p + 0.5 + x / 2) / panels, weight[k] / (2 * panels));
}

}  // namespace jounce::cam_detail
