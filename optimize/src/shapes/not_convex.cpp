// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/shapes/not_convex.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "optimize/src/program/shape_model.hpp"
#include "optimize/src/shapes/fixed_knots.hpp"
#include "optimize/src/shapes/shape_report.hpp"
#include "optimize/src/tolerances.hpp"

namespace jounce::optimize_detail {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int most_refinements = 14;

std::vector<SearchedFigure> parts_of(const ShapeProblem& p, const std::vector<Segment>& given,
                                     const SplineSpace& space) {
  std::vector<SearchedFigure> parts;
  const auto add = [&](const ShapeFigure& figure, double weight, std::optional<double> at_most) {
    auto found = pointwise(figure, p.begin);
    if (!found) return;
    const double value = std::abs(value_of(*found, given, p.begin));
    const double natural = figure_rows(figure, space).natural;
    const double unit =
        at_most && *at_most > 0 ? *at_most : (value > natural_zero * natural ? value : natural);
    parts.push_back({std::move(*found), unit, weight, at_most});
  };
  for (const WeightedFigure& m : p.minimize) add(m.figure, m.weight, {});
  for (const Ceiling& c : p.ceilings) add(c.figure, 0, c.at_most);
  return parts;
}

/// True if there is one figure to minimize and it is at its bound.
bool at_bound(const ShapeProblem& problem, const std::vector<Segment>& shape) {
  if (problem.minimize.size() != 1) return false;
  const ShapeFigure& figure = problem.minimize.front().figure;
  const auto bound = known_bound(problem, figure);
  const auto found = pointwise(figure, problem.begin);
  return bound && found &&
         value_of(*found, shape, problem.begin) <= *bound * (1 + problem.options.tolerance);
}

NotConvexResult result_of(FoundShape best, const SearchBudget& budget, bool finite) {
  using End = NotConvexResult::End;
  NotConvexResult result{
      .shape = std::move(best.shape), .rounds = budget.rounds, .evaluations = budget.evaluations};
  if (budget.cancelled) {
    result.end = End::cancelled;
  } else if (!finite) {
    result.end = End::stalled;
    result.why = "a figure was not finite for a shape that the search tried";
  } else if (best.violation > 0) {
    result.end = budget.spent() ? End::stalled : End::infeasible;
    result.why = "no start met the limits; as the problem is not convex, that is no proof";
  } else if (best.settled) {
    result.end = End::converged;
  } else {
    result.why = budget.spent() ? "evaluations or time ran out" : "rounds ran out";
  }
  return result;
}

}  // namespace

bool needs_search(const ShapeProblem& problem) {
  const auto outside = [](const auto& each) { return !has_rows(each.figure); };
  return std::any_of(problem.minimize.begin(), problem.minimize.end(), outside) ||
         std::any_of(problem.ceilings.begin(), problem.ceilings.end(), outside);
}

NotConvexResult search_shape(const ShapeProblem& problem, const std::vector<Segment>& given,
                             const KeepGoing& keep_going) {
  SearchBudget budget{.most_evaluations = problem.options.budget.evaluations.value_or(2000)};
  if (problem.options.budget.seconds)  // at most a year: more would overflow the clock
    budget.until =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                           std::min(*problem.options.budget.seconds, 3e7)));
  const ShapeModel first(convex_part(problem), first_knots(problem), given);
  const std::vector<SearchedFigure> parts = parts_of(problem, given, first.space);
  auto search = std::make_unique<FixedKnots>(problem, parts, first_knots(problem), given);
  if (search->contradicts())
    return {NotConvexResult::End::infeasible,
            "the values at the ends and the parts that are kept in step contradict each other",
            given, 0, 0};
  FoundShape best;
  bool finite = true;
  if (search->has_no_freedom()) {
    best = search->only_shape();
    return result_of(std::move(best), budget, true);
  }
  const int starts = problem.options.starts.value_or(3);
  for (int start = 0; start < starts && !budget.spent(); ++start) {
    FoundShape now = search->run(search->beside(start), budget, keep_going);
    finite = finite && search->finite();
    if (!now.shape.empty() && now.better_than(best)) best = std::move(now);
  }
  for (int k = 0; problem.refine && k < most_refinements && !best.shape.empty(); ++k) {
    std::vector<double> knots = search->finer(best.shape);
    if (budget.spent() || knots.size() == search->pieces() + 1) break;
    if (at_bound(problem, best.shape)) break;
    // Starts from the given shape: at the vertex of active rows of the best one SLSQP does not move, even with
    // finer knots.
    search = std::make_unique<FixedKnots>(problem, parts, std::move(knots), given);
    FoundShape now = search->run(search->beside(0), budget, keep_going);
    const bool worth_it = search->gain(now, best, 0.2);
    if (now.better_than(best)) best = std::move(now);
    if (!worth_it) break;
  }
  if (best.shape.empty()) best.shape = given;
  return result_of(std::move(best), budget, finite);
}

}  // namespace jounce::optimize_detail
