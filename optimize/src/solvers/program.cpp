// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/program.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::optimize_detail {
namespace {

double rms(const Space& space, std::span<const Knot> knots, std::span<double> gradient) {
  KnotGradient by_knots{};
  double total = 0;
  for (std::size_t i = 0; i < space.grams.size(); ++i) {
    total += square_acceleration(space.grams[i], knots[i], knots[i + 1], by_knots);
    if (space.moves[i]) add_gradient(space, i, by_knots, gradient);
  }
  const double value = std::sqrt(std::max(0.0, total) / space.length());
  for (double& g : gradient) g = value > 0 ? g / (2 * value * space.length()) : 0;
  return value;
}

}  // namespace

double evaluate(const Space& space, const Row& row, std::span<const Knot> knots,
                std::span<double> gradient) {
  KnotGradient by_knots{};
  double f = 0;
  if (const auto* at = std::get_if<Sample>(&row.f)) {
    f = value(*at, knots, by_knots);
    add_gradient(space, at->segment, by_knots, gradient);
  } else if (const auto* spacing = std::get_if<Spacing>(&row.f)) {
    f = knots[spacing->segment + 1][0] - knots[spacing->segment][0];
    by_knots[0] = -1;
    by_knots[4] = 1;
    add_gradient(space, spacing->segment, by_knots, gradient);
  } else {
    f = rms(space, knots, gradient);
  }
  for (double& g : gradient) g *= row.factor;
  return row.factor * f - row.offset;
}

double evaluate(const Program& program, const Row& row, std::span<const Knot> knots,
                std::span<double> gradient) {
  const double value = evaluate(program.space, row, knots, gradient);
  for (std::size_t i = 0; program.hold_masters && i < gradient.size(); ++i)
    if (program.space.variables[i].quantity == Quantity::master) gradient[i] = 0;
  return value;
}

std::vector<Knot> separated_knots(const Space& space, std::span<const double> z) {
  auto knots = knots_at(space, z);
  for (std::size_t i = 1; i < knots.size(); ++i)
    knots[i][0] = std::max(knots[i][0], knots[i - 1][0] + space.least_length[i - 1] / 2);
  return knots;
}

}  // namespace jounce::optimize_detail
