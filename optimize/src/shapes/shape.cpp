// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/shape.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "optimize/src/program/shape_exchange.hpp"
#include "optimize/src/search/findings.hpp"
#include "optimize/src/shapes/not_convex.hpp"
#include "optimize/src/shapes/optimized_from.hpp"
#include "optimize/src/shapes/shape_report.hpp"

// If the figure is the peak of the highest derivative, the optimum is +-peak on every piece, except
// on a piece within which it should switch: there it is the mean. A piece with the mean b, between
// neighbors with the values a and c, is divided so that the mean is preserved, at the share
//
//   (1)  s = (b - c) / (a - c)
//
// of its length. With a knot there, the next optimum is closer to a switch. If the mean b is beyond
// both neighbors, or the piece is at an end, the piece contains a shorter interval at a limit l of
// that derivative (its peak, or an edge of a corridor), and outside it the value a of a neighbor:
//
//   (2)  share of the interval = (b - a) / (l - a)
//
// The interval is next to the neighbor whose value is like b, otherwise in the middle.

namespace jounce {
namespace {

using optimize_detail::brief;
using optimize_detail::Coordinates;
using optimize_detail::ShapeModel;
using optimize_detail::ShapeSolution;
using Clock = std::chrono::steady_clock;
using End = ShapeSolution::End;

constexpr double different_sums = 1e-6;   ///< share of the largest sum
constexpr double least_sum_scale = 1e-6;  ///< a smaller sum does not scale the objective

constexpr int max_refinements = 12;
constexpr int max_lowerings = 3;  ///< attempts with lower limits, if rounding exceeds them
constexpr std::size_t most_new_knots = 24;
constexpr double shortest_piece = 1e-7;  ///< share of the length of the shape

/// A place for a knot.
struct KnotPlace {
  double weight = 0;  ///< step times distance to the next knot
  double x = 0;
};

/// The range of the highest derivative on a piece.
struct TopRange {
  double lower = -HUGE_VAL;
  double upper = HUGE_VAL;
};

/// Finds the places of new knots by (1) and (2).
class Switches {
 public:
  Switches(const ShapeProblem& problem, const ShapeModel& model, const Coordinates& z)
      : problem_(problem), space_(model.space) {
    for (std::size_t i = 0; i < space_.pieces(); ++i) {
      top_.push_back(z[space_.index(i, space_.degree())] * space_.unit(i, space_.degree()));
      largest_ = std::max(largest_, std::abs(top_.back()));
    }
  }

  /// The places with the largest steps first.
  std::vector<double> places() {
    for (std::size_t i = 0; i < top_.size(); ++i) look(i);
    std::sort(found_.begin(), found_.end(), [](auto& a, auto& b) { return a.weight > b.weight; });
    std::vector<double> x;
    for (std::size_t i = 0; i < std::min(found_.size(), most_new_knots); ++i)
      x.push_back(found_[i].x);
    return x;
  }

 private:
  [[nodiscard]] bool differ(double a, double b) const {
    return std::abs(a - b) >= different_sums * largest_;
  }

  void look(std::size_t i) {
    const double b = top_[i];
    const double a = i > 0 ? top_[i - 1] : b;
    const double c = i + 1 < top_.size() ? top_[i + 1] : b;
    if ((b - a) * (c - b) > 0) return add(i, (b - c) / (a - c), c - a);
    const bool before = differ(a, b);
    const bool after = differ(c, b);
    if (!before && !after) return;
    const double beside = before && after ? (a + c) / 2 : before ? a : c;
    const TopRange range = range_of(i);
    const double limit = b > beside ? range.upper : range.lower;
    if (!std::isfinite(limit) || !differ(limit, b)) return;
    const double share = (b - beside) / (limit - beside);  // (2)
    if (before && after) {
      add(i, (1 - share) / 2, limit - beside);
      add(i, (1 + share) / 2, limit - beside);
    } else {
      add(i, before ? 1 - share : share, limit - beside);
    }
  }

  void add(std::size_t i, double s, double step) {
    const double h = space_.length(i);
    const double least = std::min(s, 1 - s);
    const double shortest = shortest_piece * (space_.knots().back() - space_.knots().front());
    if (least * h < shortest || !differ(step, 0)) return;
    found_.push_back({std::abs(step) * least * h, space_.knots()[i] + s * h});
  }

  [[nodiscard]] bool is_top(const LinearQuantity& q) const {
    const auto order = static_cast<std::size_t>(space_.degree());
    return order < q.by.size() && q.by[order] != 0 &&
           std::count_if(q.by.begin(), q.by.end(), [](double by) { return by != 0; }) == 1;
  }

  /// The range by corridors, and by the peak that is minimized.
  [[nodiscard]] TopRange range_of(std::size_t i) const {
    TopRange range;
    const double x = space_.knots()[i] + space_.length(i) / 2;
    for (const WeightedFigure& m : problem_.minimize)
      if (const auto* peak = std::get_if<PeakOf>(&m.figure); peak && is_top(peak->quantity))
        range = {-largest_, largest_};
    for (const Corridor& corridor : problem_.corridors) {
      if (!is_top(corridor.quantity) || x < corridor.from || x > corridor.to) continue;
      const LinearQuantity& q = corridor.quantity;
      const double by = q.by[static_cast<std::size_t>(space_.degree())];
      const auto at = [&](const Edge& edge) {
        return (optimize_detail::edge_at(corridor, edge, x) - q.constant) / by;
      };
      const auto& upper = by > 0 ? corridor.upper : corridor.lower;
      const auto& lower = by > 0 ? corridor.lower : corridor.upper;
      if (upper) range.upper = std::min(range.upper, at(*upper));
      if (lower) range.lower = std::max(range.lower, at(*lower));
    }
    return range;
  }

  const ShapeProblem& problem_;
  const optimize_detail::SplineSpace& space_;
  std::vector<double> top_;  ///< the highest derivative of each piece
  double largest_ = 0;
  std::vector<KnotPlace> found_;
};

/// The peak of a response, also for its rms, which is not above it: planes can hold a value close to zero, a
/// multiplier cannot.
ShapeFigure peak_of(const ShapeFigure& figure) {
  if (const auto* rms = std::get_if<RmsResponseOf>(&figure)) return ResponseOf{rms->name, rms->of};
  return figure;
}

class ShapeSearch {
 public:
  /// `start`: the first shape; none: the given one.
  ShapeSearch(const ShapeProblem& problem, std::vector<Segment> start, const KeepGoing& keep_going)
      : problem_(problem),
        keep_going_(keep_going),
        begin_(Clock::now()),
        given_(optimize_detail::given_shape(problem)),
        start_(std::move(start)) {
    if (start_.empty()) return;
    const ShapeModel model(problem_, optimize_detail::first_knots(problem_), given_);
    const double sum = optimize_detail::weighted_sum(model, start_);
    if (std::isfinite(sum) && sum > least_sum_scale) scale_ = sum;
  }

  ShapeOutcome run() {
    optimize();
    if (nothing_left()) take_smoothest();
    out_.feasible = out_.limits.ok() && !out_.best.empty();
    return std::move(out_);
  }

 private:
  void optimize() {
    std::vector<double> knots = optimize_detail::first_knots(problem_);
    std::vector<Segment> from = start_.empty() ? given_ : start_;
    for (int k = 0;; ++k) {
      const ShapeModel model(problem_, knots, given_, true, scale_);
      ShapeSolution found = improve(model, knots, from);
      const double before = k > 0 ? out_.value : HUGE_VAL;
      const bool better = take(model, found);
      if (!problem_.refine || k == max_refinements || !better || found.end != End::solved) break;
      if (near_bound() || before - out_.value < problem_.options.tolerance / 100 * out_.value)
        break;
      const std::vector<double> more = Switches(problem_, model, found.z).places();
      if (more.empty()) break;
      knots.insert(knots.end(), more.begin(), more.end());
      std::sort(knots.begin(), knots.end());
      from = out_.best;
    }
  }

  /// True if only responses are minimized and their values are only rounding, which may have stopped the
  /// solver.
  [[nodiscard]] bool nothing_left() const {
    using Status = OptimizeStatus;
    const bool answers = std::all_of(problem_.minimize.begin(), problem_.minimize.end(),
                                     [](const WeightedFigure& m) {
                                       return std::holds_alternative<ResponseOf>(m.figure) ||
                                              std::holds_alternative<RmsResponseOf>(m.figure);
                                     });
    if (!answers || out_of_time_ || out_.status == Status::cancelled) return false;
    return out_.value <= nothing_ || out_.status == Status::stalled;
  }

  /// Many shapes have a figure of zero, and most of them oscillate. Takes the one with the least rms jerk.
  void take_smoothest() {
    ShapeProblem calm = problem_;
    calm.minimize = {{RmsOf{derivative_of_shape(std::min(3, problem_.degree))}}};
    for (std::size_t k = 0; k < problem_.minimize.size(); ++k)
      calm.ceilings.push_back({peak_of(problem_.minimize[k].figure), nothing_of_[k]});
    if (problem_.options.budget.seconds)
      calm.options.budget.seconds = std::max(*problem_.options.budget.seconds - elapsed(), 1e-3);
    const ShapeOutcome found = ShapeSearch(calm, {}, keep_going_).run();
    out_.rounds += found.rounds;
    out_.evaluations += found.evaluations;
    if (found.status == OptimizeStatus::cancelled)
      return answer(found.status, "stopped by the caller");
    if (!found.usable()) return;
    const ShapeModel model(problem_, optimize_detail::first_knots(problem_), given_);
    out_.best = found.best;
    out_.value = optimize_detail::weighted_sum(model, out_.best);
    out_.limits = optimize_detail::checked(problem_, model, out_.best);
    out_.bound = 0;
    fill_figures(model);
    out_.active = optimize_detail::active(problem_, model, out_.best);
    answer(
        OptimizeStatus::optimal,
        "the figure is zero to rounding; of all such shapes, this one has the least rms geo_jerk");
  }

  /// Solves the program. The pieces of a solution join exactly, which may exceed a limit by the rounding of the
  /// solver. Then it is solved again with a lower limit. The bound remains that of the problem.
  ShapeSolution improve(const ShapeModel& model, const std::vector<double>& knots,
                        const std::vector<Segment>& from) {
    ShapeSolution found = improve(model, model.space.coordinates(from));
    ShapeProblem held = problem_;
    for (int k = 0; k < max_lowerings && found.end == End::solved; ++k) {
      if (!optimize_detail::lower_exceeded(problem_, model, model.space.segments(found.z), held))
        break;
      const ShapeModel lower(held, knots, given_, true, scale_);
      ShapeSolution again = improve(lower, found.z);
      if (again.end != End::solved) break;
      again.bound = found.bound;
      again.rounds += found.rounds;
      again.iterations += found.iterations;
      found = std::move(again);
    }
    return found;
  }

  ShapeSolution improve(const ShapeModel& model, const Coordinates& from) {
    const auto go_on = [&](int round, double value) {
      out_of_time_ =
          problem_.options.budget.seconds && elapsed() > *problem_.options.budget.seconds;
      return !out_of_time_ &&
             (!keep_going_ || keep_going_(optimize_detail::round_progress(
                                  out_.rounds + round, out_.evaluations, value * scale_)));
    };
    const double tolerance = problem_.options.tolerance;
    return optimize_detail::minimized(model, from, tolerance, problem_.refine ? 0 : tolerance / 2,
                                      go_on);
  }

  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }

  /// True if every figure has a known bound and is at it.
  [[nodiscard]] bool near_bound() const {
    bool any = false;
    for (std::size_t k = 0; k < problem_.minimize.size(); ++k) {
      const FigureResult& r = out_.figures[k];
      if (!r.bound || r.reached > *r.bound * (1 + problem_.options.tolerance)) return false;
      any = true;
    }
    return any;
  }

  /// Takes the outcome of these knots, unless the one before was better. Returns true if it is taken.
  bool take(const ShapeModel& model, const ShapeSolution& found) {
    std::vector<Segment> shape = model.space.segments(found.z);
    optimize_detail::make_exact(problem_, shape);
    out_.rounds += found.rounds;
    out_.evaluations += found.iterations;
    const double value = optimize_detail::weighted_sum(model, shape) * model.scale;
    Report limits = optimize_detail::checked(problem_, model, shape);
    const bool first = out_.best.empty();
    if (!first && (found.end != End::solved || !limits.ok() || value > out_.value)) {
      if (found.end == End::stopped) set_status(found);
      return false;
    }
    out_.best = std::move(shape);
    out_.value = value;
    out_.limits = std::move(limits);
    out_.bound = found.bound;
    if (found.bound)  // a figure is never below 0
      out_.bound = std::max(*found.bound * model.scale, 0.0);
    nothing_ = 0;
    nothing_of_.clear();
    for (const auto& term : model.terms) {
      nothing_of_.push_back(term.rows.nothing * term.rows.natural);
      nothing_ += term.weight * nothing_of_.back() / term.unit * model.scale;
    }
    if (out_.value <= nothing_ && out_.bound) out_.bound = 0;
    fill_figures(model);
    out_.active = optimize_detail::active(problem_, model, out_.best);
    set_status(found);
    return true;
  }

  void fill_figures(const ShapeModel& model) {
    out_.figures = optimize_detail::figure_results(problem_, model.space, given_, out_.best);
  }

  void answer(OptimizeStatus status, std::string reason) {
    out_.status = status;
    out_.reason = std::move(reason);
  }

  void set_status(const ShapeSolution& found) {
    using Status = OptimizeStatus;
    if (found.end == End::infeasible) return answer(Status::infeasible, found.why);
    if (found.end == End::stopped)
      return out_of_time_ ? answer(Status::stalled, "the time limit of " +
                                                        brief(*problem_.options.budget.seconds) +
                                                        " s is reached")
                          : answer(Status::cancelled, "stopped by the caller");
    if (!out_.limits.ok())
      return answer(Status::stalled,
                    "the shape found exceeds a limit: " +
                        optimize_detail::broken_sentence(out_.limits.findings.front()));
    if (found.end == End::stalled) return answer(Status::stalled, found.why);
    if (!std::isfinite(out_.value)) return answer(Status::stalled, "a figure is not finite");
    const double gap = out_.bound ? (out_.value - *out_.bound) / out_.value : 1;
    if (out_.value <= nothing_ || gap <= problem_.options.tolerance)
      return answer(Status::optimal,
                    "no spline over these knots is better by more than the relative tolerance " +
                        brief(problem_.options.tolerance));
    answer(Status::converged, out_.bound
                                  ? "at most " + brief(100 * gap) +
                                        " % could still be saved by a spline over these knots"
                                  : "the search finds no better shape; no lower bound is known");
  }

  const ShapeProblem& problem_;
  const KeepGoing& keep_going_;
  Clock::time_point begin_;
  std::vector<Segment> given_;
  std::vector<Segment> start_;
  double scale_ = 1;  ///< scale of the model
  ShapeOutcome out_;
  bool out_of_time_ = false;
  double nothing_ = 0;              ///< weighted sum that is only rounding
  std::vector<double> nothing_of_;  ///< the same of each figure
};

}  // namespace

ShapeOutcome optimize_shape(const ShapeProblem& problem, const KeepGoing& keep_going) {
  return optimize_detail::optimized_from(problem, {}, keep_going);
}

ShapeOutcome optimize_detail::optimized_from(const ShapeProblem& problem,
                                             std::vector<Segment> start,
                                             const KeepGoing& keep_going) {
  require_valid(problem);
  if (needs_search(problem)) return searched(problem, keep_going);
  return ShapeSearch(problem, std::move(start), keep_going).run();
}

}  // namespace jounce
