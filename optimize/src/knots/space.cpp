// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/space.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/detail/random.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double closest =
    1e-3;  ///< least segment, as a share of the interval between fixed masters

/// The size of a significant change of the quantity at this knot.
double natural_scale(const Space& space, std::size_t knot, Quantity quantity) {
  double length = space.length();
  if (knot > 0) length = std::min(length, space.knots[knot][0] - space.knots[knot - 1][0]);
  if (knot + 1 < space.knots.size())
    length = std::min(length, space.knots[knot + 1][0] - space.knots[knot][0]);
  switch (quantity) {
    case Quantity::master:
      return length;
    case Quantity::slave:
      return space.stroke;
    case Quantity::geo_velocity:
      return space.stroke / length;
    case Quantity::geo_acceleration:
      break;
  }
  return space.stroke / (length * length);
}

double stroke_of(const Space& space) {
  const auto [lo, hi] =
      std::minmax_element(space.knots.begin(), space.knots.end(),
                          [](const Knot& a, const Knot& b) { return a[1] < b[1]; });
  double stroke = (*hi)[1] - (*lo)[1];
  if (stroke > 0) return stroke;
  const double length =
      space.length();  // no knot differs: derivatives or bounds determine the scale
  for (const Knot& k : space.knots)
    stroke = std::max({stroke, std::abs(k[2]) * length, std::abs(k[3]) * length * length});
  for (const Variable& v : space.variables)
    if (v.quantity == Quantity::slave) stroke = std::max(stroke, v.upper - v.lower);
  return stroke > 0 ? stroke : 1;
}

std::vector<double> least_lengths(const Space& space, const std::vector<Freedom>& free) {
  std::vector<double> least(space.knots.size() - 1);
  std::size_t from = 0;
  for (std::size_t i = 1; i < space.knots.size(); ++i) {
    if (free[i][0]) continue;
    const double interval = space.knots[i][0] - space.knots[from][0];
    for (std::size_t k = from; k < i; ++k)
      least[k] = std::min(closest * interval, (space.knots[k + 1][0] - space.knots[k][0]) / 2);
    from = i;
  }
  return least;
}

double& member_of(CamKnot& knot, Quantity quantity) {
  switch (quantity) {
    case Quantity::master:
      return knot.master;
    case Quantity::slave:
      return knot.slave;
    case Quantity::geo_velocity:
      return knot.geo_velocity ? *knot.geo_velocity : knot.geo_velocity.emplace();
    case Quantity::geo_acceleration:
      break;
  }
  return knot.geo_acceleration ? *knot.geo_acceleration : knot.geo_acceleration.emplace();
}

double change(const Variable& v, double z) {
  return std::clamp(v.given + v.scale * z, v.lower, v.upper) - v.given;
}

/// Masters in ascending order and within their bounds, from left to right, each leaving the least lengths of
/// the segments after it. choose(i, least, greatest) returns a free one.
template <class Choose>
std::vector<double> ordered_masters(const Space& space, const Choose& choose) {
  std::vector<double> lower;
  for (const Knot& k : space.knots) lower.push_back(k[0]);
  std::vector<double> upper = lower;
  for (const Variable& v : space.variables)
    if (v.quantity == Quantity::master) {
      lower[v.knot] = v.lower;
      upper[v.knot] = v.upper;
    }
  for (std::size_t i = upper.size() - 1; i > 0; --i)
    upper[i - 1] = std::min(upper[i - 1], upper[i] - space.least_length[i - 1]);
  std::vector<double> master = lower;
  for (std::size_t i = 1; i < master.size(); ++i) {
    if (lower[i] == upper[i]) continue;
    const double least = std::max(lower[i], master[i - 1] + space.least_length[i - 1]);
    master[i] = choose(i, least, std::max(least, upper[i]));
  }
  return master;
}

}  // namespace

Space::Space(const CamProblem& problem)
    : given(problem.cam),
      knots(knots_of(problem.cam)),
      pieces(optimize_detail::pieces(problem.cam)),
      grams(optimize_detail::grams(pieces)) {
  const auto free = freedom(problem);
  const std::size_t last = knots.size() - 1;
  for (const FreeKnot& knot : problem.free)
    for (const Quantity q : quantities)
      if (const auto& bound = bound_of(knot, q); bound && bound->lower < bound->upper)
        variables.push_back({knot.knot, q, given.periodic && (knot.knot == 0 || knot.knot == last),
                             knots[knot.knot][index(q)], bound->lower, bound->upper, 1});
  stroke = stroke_of(*this);
  for (Variable& v : variables)
    v.scale = std::min(v.upper - v.lower, natural_scale(*this, v.knot, v.quantity));
  for (std::size_t i = 0; i < last; ++i) moves.push_back(any(free[i]) || any(free[i + 1]));
  least_length = least_lengths(*this, free);
}

bool Space::convex() const {
  return std::none_of(variables.begin(), variables.end(),
                      [](const Variable& v) { return v.quantity == Quantity::master; });
}

Point clamped(const Space& space, Point z) {
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Variable& v = space.variables[i];
    z[i] = std::clamp(z[i], (v.lower - v.given) / v.scale, (v.upper - v.given) / v.scale);
  }
  const auto knots = knots_at(space, z);
  const auto master = ordered_masters(space, [&](std::size_t i, double least, double greatest) {
    return std::clamp(knots[i][0], least, greatest);
  });
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Variable& v = space.variables[i];
    if (v.quantity == Quantity::master && master[v.knot] != knots[v.knot][0])
      z[i] = (master[v.knot] - v.given) / v.scale;
  }
  return z;
}

std::vector<Knot> knots_at(const Space& space, std::span<const double> z) {
  assert(z.size() == space.variables.size());
  auto knots = space.knots;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Variable& v = space.variables[i];
    knots[v.knot][index(v.quantity)] += change(v, z[i]);
    if (v.seam) knots[knots.size() - 1 - v.knot][index(v.quantity)] += change(v, z[i]);
  }
  return knots;
}

CamSpec spec_at(const Space& space, std::span<const double> z) {
  CamSpec spec = space.given;
  const auto knots = knots_at(space, z);
  const auto set = [&](std::size_t knot, Quantity quantity) {
    CamKnot& target = knot == 0 ? spec.start : spec.segments[knot - 1].end;
    member_of(target, quantity) = knots[knot][index(quantity)];
  };
  for (const Variable& v : space.variables) {
    set(v.knot, v.quantity);
    if (v.seam) set(knots.size() - 1 - v.knot, v.quantity);
  }
  return spec;
}

void add_gradient(const Space& space, std::size_t segment, const KnotGradient& by_knots,
                  std::span<double> by_z) {
  const auto share = [&](std::size_t knot, Quantity quantity) {
    const std::size_t side = knot - segment;  // wraps for a knot before: then not 0 or 1
    return side <= 1 ? by_knots[4 * side + index(quantity)] : 0.0;
  };
  for (std::size_t i = 0; i < by_z.size(); ++i) {
    const Variable& v = space.variables[i];
    double sum = share(v.knot, v.quantity);
    if (v.seam) sum += share(space.knots.size() - 1 - v.knot, v.quantity);
    by_z[i] += v.scale * sum;
  }
}

Point start_point(const Space& space, std::uint64_t seed, std::size_t number) {
  Point z(space.variables.size(), 0.0);
  if (number == 0) return z;
  std::uint64_t state = seed + 0x632be59bd9b4e019U * number;
  const auto master = ordered_masters(space, [&](std::size_t, double least, double greatest) {
    return least + profiles_detail::uniform(state) * (greatest - least);
  });
  const Cam cam = design(space.given).cam;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Variable& v = space.variables[i];
    if (v.seam) continue;
    const double value = v.quantity == Quantity::master
                             ? master[v.knot]
                             : cam.jet(master[v.knot])[index(v.quantity) - 1];
    z[i] = (std::clamp(value, v.lower, v.upper) - v.given) / v.scale;
  }
  return z;
}

}  // namespace jounce::optimize_detail
