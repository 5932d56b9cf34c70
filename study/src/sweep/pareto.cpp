// SPDX-License-Identifier: Apache-2.0
#include "study/src/sweep/pareto.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace jounce {
namespace {

using Objectives = std::vector<double>;

bool dominates(const Objectives& a, const Objectives& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] > b[i]) return false;
  return a != b;
}

/// The front of points with two objectives, from their lexicographic order, in which a point is
/// dominated only by points before it. Their first objective is not larger, and the least second
/// one so far decides (H. T. Kung, F. Luccio and F. P. Preparata, "On finding the maxima of a set
/// of vectors", J. ACM 22, 1975).
std::vector<std::size_t> front_of_two(std::span<const Objectives> points,
                                      const std::vector<std::size_t>& order) {
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    const bool equal = !front.empty() && points[front.back()] == points[i];
    if (!equal && !front.empty() && points[i].back() >= least) continue;
    least = points[i].back();
    front.push_back(i);
  }
  return front;
}

std::vector<std::size_t> front_of_many(std::span<const Objectives> points,
                                       const std::vector<std::size_t>& order) {
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (std::none_of(front.begin(), front.end(),
                     [&](std::size_t k) { return dominates(points[k], points[i]); }))
      front.push_back(i);
  return front;
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const std::vector<double>> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    assert(!points[i].empty() && points[i].size() == points[0].size());
    if (std::none_of(points[i].begin(), points[i].end(), [](double v) { return std::isnan(v); }))
      order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  const bool few = !points.empty() && points[0].size() <= 2;
  std::vector<std::size_t> front = few ? front_of_two(points, order) : front_of_many(points, order);
  std::sort(front.begin(), front.end());
  return front;
}

}  // namespace jounce
