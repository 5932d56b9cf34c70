// SPDX-License-Identifier: Apache-2.0
// One round: SLSQP runs on the present rows, with the signs of the velocity fixed. The exact
// extrema of the result that exceed the level of a row then become rows, and the signs are
// determined again. The search has converged after eight rounds without a gain and without a change
// of sign, or after one such round that also adds no row. The gain is measured by the exact value
// of the shape and not by the rows.

#include "optimize/src/shapes/fixed_knots.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>

#include "jounce/profiles/detail/random.hpp"

#include "optimize/src/shapes/optimized_from.hpp"
#include "optimize/src/tolerances.hpp"

namespace jounce::optimize_detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Clock = std::chrono::steady_clock;

/// Share of the length of a shape: a shorter piece is not divided.
constexpr double least_division = 1e-7;
constexpr double excess_rounding = 1e-11;  ///< relative excess that is none
constexpr double broken_row = 1e-10;  ///< excess, relative to the scale of a row, that adds the row

constexpr int most_rounds = 30;
constexpr int most_idle = 8;  ///< rounds without a gain
constexpr int evaluations_a_round = 200;

}  // namespace

/// The convex part of the problem.
ShapeProblem convex_part(ShapeProblem p) {
  std::erase_if(p.minimize, [](const WeightedFigure& m) { return !has_rows(m.figure); });
  std::erase_if(p.ceilings, [](const Ceiling& c) { return !has_rows(c.figure); });
  return p;
}

FixedKnots::FixedKnots(const ShapeProblem& problem, const std::vector<SearchedFigure>& parts,
                       std::vector<double> knots, const std::vector<Segment>& near)
    : problem_(problem),
      parts_(parts),
      model_(convex_part(problem), std::move(knots), near),
      reduced_(model_.space, model_.equalities, model_.space.coordinates(near)) {
  hold_signs(near);
  list_rows();
}

FoundShape FixedKnots::only_shape() const {
  FoundShape only = standing(VectorXd(0));
  only.settled = true;
  return only;
}

FoundShape FixedKnots::run(const VectorXd& start, SearchBudget& budget,
                           const KeepGoing& keep_going) {
  FoundShape best = standing(start);
  VectorXd y = start;
  for (int round = 0, idle = 0; round < most_rounds && !budget.spent(); ++round) {
    const DescentProgram rows = program();
    const int left = budget.most_evaluations - budget.evaluations;
    const auto go_on = [&] {
      if (keep_going && !keep_going(round_progress(budget.rounds, budget.evaluations, best.value)))
        budget.cancelled = true;
      return !budget.cancelled && !(budget.until && Clock::now() >= *budget.until);
    };
    Descended found = descend(rows, y, std::min(evaluations_a_round, left), go_on);
    budget.evaluations += found.evaluations;
    ++budget.rounds;
    finite_ = found.finite;
    if (!finite_) break;
    FoundShape now = standing(found.y);
    const int added = exchange(now.shape, found.t);
    const bool gains = gain(now, best);
    if (now.better_than(best)) {
      best = std::move(now);
      y = found.y;
    }
    const bool turned = hold_signs(best.shape);
    idle = gains || turned ? 0 : idle + 1;
    if (!go_on()) break;
    best.settled = idle >= (added == 0 ? 1 : most_idle);
    if (best.settled) break;
  }
  return best;
}

VectorXd FixedKnots::beside(int start) const {
  VectorXd y = VectorXd::Zero(reduced_.size());
  std::uint64_t state = problem_.options.seed * 1000003U + static_cast<std::uint64_t>(start);
  const double width = start == 0 ? 0 : 0.5 / std::sqrt(static_cast<double>(y.size()));
  for (double& each : y) each = width * (2 * profiles_detail::uniform(state) - 1);
  return y;
}

std::vector<double> FixedKnots::finer(const std::vector<Segment>& shape) const {
  std::vector<double> lost(model_.space.pieces(), 0);
  for (const SearchedFigure& part : parts_)
    if (!part.at_most && part.figure.over == Pointwise::Over::peak)
      add_lost(part.figure, shape, lost);
  const double least = 0.05 * *std::max_element(lost.begin(), lost.end());
  std::vector<double> knots;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    const double x = model_.space.knots()[i];
    knots.push_back(x);
    const bool divides = model_.space.length(i) > least_division * (problem_.end - problem_.begin);
    if (lost[i] > 0 && lost[i] >= least && divides) knots.push_back(x + model_.space.length(i) / 2);
  }
  knots.push_back(model_.space.knots().back());
  return knots;
}

bool FixedKnots::gain(const FoundShape& now, const FoundShape& best, double share) const {
  if (best.violation > 0 || now.violation > 0) return now.violation < 0.9 * best.violation;
  return now.value < best.value - share * problem_.options.tolerance * std::abs(best.value);
}

void FixedKnots::add_lost(const Pointwise& figure, const std::vector<Segment>& shape,
                          std::vector<double>& lost) const {
  constexpr int samples = 8;
  const double peak = value_of(figure, shape, problem_.begin);
  for (const Wave& wave : figure.waves(shape, problem_.begin)) {
    double sum = 0;
    double highest = 0;
    for (int k = 0; k < samples; ++k) {
      const double g = std::abs(wave.at((k + 0.5) / samples));
      sum += (peak - g) / samples;
      highest = std::max(highest, g);
    }
    if (highest > 0.5 * peak && peak > 0) lost[wave.piece] += sum / peak * (wave.to - wave.from);
  }
}

FoundShape FixedKnots::standing(const VectorXd& y) const {
  FoundShape now{.shape = model_.space.segments(reduced_.z(y))};
  for (const Term& term : model_.terms)
    now.value += term.weight * term.rows.value(now.shape) / term.unit;
  for (const SearchedFigure& part : parts_) {
    const double value = value_of(part.figure, now.shape, problem_.begin);
    if (part.at_most)
      now.violation = std::max(now.violation, beyond(value, *part.at_most, part.unit));
    else
      now.value += part.weight * value / part.unit;
  }
  for (const RoundCeiling& c : model_.round)
    now.violation =
        std::max(now.violation, beyond(c.rows.value(now.shape), c.at_most, scale_of(c)));
  for (const ShapeConstraint& constraint : model_.constraints) {
    for (const Form& form : constraint.beyond(now.shape, rounding_tolerance))
      if (model_.freedom(form) > 0)
        now.violation = std::max(now.violation, reduced_.row(form).at(y) / constraint.scale);
    for (const Form& form : constraint.start)
      now.violation =
          std::max(now.violation, beyond(reduced_.row(form).at(y) / constraint.scale, 0, 1));
  }
  return now;
}

double FixedKnots::scale_of(const RoundCeiling& c) {
  return c.at_most > 0 ? c.at_most : c.rows.natural;
}

double FixedKnots::beyond(double value, double limit, double scale) {
  const double excess = (value - limit) / scale;
  return excess > excess_rounding ? excess : 0;
}

int FixedKnots::exchange(const std::vector<Segment>& shape, const VectorXd& t) {
  int added = 0;
  const std::size_t before = rows_.size();
  for (const ShapeConstraint& constraint : model_.constraints)
    for (const Form& form : constraint.beyond(shape, broken_row))
      add_constraint(form, constraint.scale);
  std::size_t k = 0;
  for (const Term& term : model_.terms) {
    if (term.rows.by_squares()) continue;
    const double level = t[static_cast<Index>(k)] * (1 + precision());
    for (const Form& form : term.rows.cuts(shape, level * term.unit))
      rows_.push_back({.linear = reduced_.row(form), .factor = 1 / term.unit, .t = k});
    ++k;
  }
  added += static_cast<int>(rows_.size() - before);
  for (const SearchedFigure& part : parts_) {
    if (part.figure.over != Pointwise::Over::peak) continue;
    const double level =
        part.at_most ? *part.at_most / part.unit : t[static_cast<Index>(k)] * (1 + precision());
    added += add_peaks(part, k, shape, level);
    if (!part.at_most) ++k;
  }
  return added;
}

}  // namespace jounce::optimize_detail
