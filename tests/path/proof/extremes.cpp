// SPDX-License-Identifier: Apache-2.0
#include "path/proof/extremes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace jounce::path_proof {
namespace {

constexpr int most = Segment::max_degree + 1;
constexpr int most_halvings = 60;

/// Bernstein coefficients of a polynomial on [0, 1].
struct Net {
  std::array<double, most> b{};
  int degree = 0;

  [[nodiscard]] double enclosure() const {
    double m = 0;
    for (int i = 0; i <= degree; ++i) m = std::max(m, std::abs(b[static_cast<std::size_t>(i)]));
    return m;
  }
  /// Greatest value at an end.
  [[nodiscard]] double ends() const {
    return std::max(std::abs(b[0]), std::abs(b[static_cast<std::size_t>(degree)]));
  }
  /// Both halves (de Casteljau): the first one is *this, the second one is returned.
  Net halve() {
    Net second = *this;
    for (int k = 1; k <= degree; ++k) {
      for (int i = 0; i <= degree - k; ++i) {
        const auto at = static_cast<std::size_t>(i);
        second.b[at] = (second.b[at] + second.b[at + 1]) / 2;
      }
      b[static_cast<std::size_t>(k)] = second.b[0];
    }
    return second;
  }
};

Net net_of(const Segment& f, int order) {
  Net net;
  net.degree = std::max(0, f.degree - order);
  std::array<double, most> c{};
  for (int i = order; i <= f.degree; ++i) {
    double x = f.c[static_cast<std::size_t>(i)];
    for (int k = 0; k < order; ++k) x *= (i - k) / f.length;
    c[static_cast<std::size_t>(i - order)] = x;
  }
  // b_j = sum over i <= j of C(j, i) / C(n, i) c_i
  for (int j = 0; j <= net.degree; ++j) {
    double share = 1;
    for (int i = 0; i <= j; ++i) {
      net.b[static_cast<std::size_t>(j)] += share * c[static_cast<std::size_t>(i)];
      if (i < j) share *= static_cast<double>(j - i) / (net.degree - i);
    }
  }
  return net;
}

void narrow_down(Net net, double limit, int depth, Bounded& result) {
  result.largest = std::max(result.largest, net.ends());
  if (net.enclosure() <= limit) return;
  if (net.ends() > limit || depth == most_halvings) {
    result.holds = false;
    return;
  }
  const Net second = net.halve();
  narrow_down(net, limit, depth + 1, result);
  if (result.holds) narrow_down(second, limit, depth + 1, result);
}

/// A sine and a constant: its extremes are at the ends and where the phase is a quarter turn.
Bounded of_a_sine(const Segment& f, int order, double limit) {
  const SineTerm& s = f.sine[0];
  double amplitude = s.amplitude;
  for (int k = 0; k < order; ++k) amplitude *= s.angle / f.length;
  const double phase = s.phase + order * std::numbers::pi / 2;
  const double constant = order == 1 ? f.c[1] / f.length : 0;
  const auto at = [&](double x) { return std::abs(constant + amplitude * std::sin(x)); };
  double largest = std::max(at(phase), at(phase + s.angle));
  const double low = std::min(phase, phase + s.angle);
  const double high = std::max(phase, phase + s.angle);
  const double pi = std::numbers::pi;
  for (double x = pi * std::ceil(low / pi - 0.5) + pi / 2; x <= high; x += pi)
    largest = std::max(largest, at(x));
  return {largest, largest <= limit};
}

}  // namespace

Bounded bounded(const Segment& f, int order, double limit) {
  if (f.sines == 1 && f.degree <= 1) return of_a_sine(f, order, limit);
  Bounded result;
  if (f.sines > 0) {
    result.holds = false;
    return result;
  }
  narrow_down(net_of(f, order), limit, 0, result);
  return result;
}

}  // namespace jounce::path_proof
