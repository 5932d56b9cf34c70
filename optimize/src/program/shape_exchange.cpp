// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/shape_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimize/src/program/equalities.hpp"
#include "optimize/src/program/shape_norms.hpp"
#include "optimize/src/program/shape_program.hpp"
#include "optimize/src/search/findings.hpp"
#include "optimize/src/shapes/shape_reach.hpp"

// Let t_p be an unknown for every figure p that is a peak, with planes g <= figure (FigureRows).
// Let w be the constraints, and let |F_r z| be the figures that are norms:
//
//   (1)  minimize  sum weight_p t_p + sum weight_r |F_r z|
//        subject to  g(z) <= t_p,   w(z) <= 0,   |F_c z| <= most_c,   the equalities.
//
// A norm alone without constraints is one linear system, peaks are a linear program, and both
// together a quadratic program (norms: shape_norms.hpp). Limited norms are second-order cones. For
// planes and constraints see shape_rows.hpp.

namespace jounce::optimize_detail {
namespace {

constexpr double coarsest_rows_met = 1e-7;  ///< residual of the least precise program
constexpr double least_missed = 1e-8;       ///< share of the sum that is worth a finer program

constexpr int max_rounds = 80;  ///< rounds of one exchange
constexpr int max_adjustments = 40;
constexpr double worthwhile = 1e-9;
constexpr double coarse = 1e-6;  ///< residual that is enough for a program that is solved again
constexpr double fine = 1e-11;
constexpr double joined = 1e-15;  ///< residual of an equality that is only rounding

class ShapeExchange {
 public:
  ShapeExchange(const ShapeModel& model, const Coordinates& start, double precision,
                const GoOn& go_on)
      : model_(model),
        norms_(model, model.space.segments(start)),
        go_on_(go_on),
        met_(std::clamp(precision / 20, fine, coarsest_rows_met)),
        rows_(model) {
    found_.z = start;
  }

  ShapeSolution run(double slack) {
    if (auto broken = broken_where_fixed(model_, found_.z))
      infeasible(std::move(*broken));
    else if (minimize() && slack > 0 && !norms_.any())
      smooth(slack);
    if (worst_equality(model_, found_.z) > joined) found_.z = as_fixed(model_, found_.z);
    return std::move(found_);
  }

 private:
  using End = ShapeSolution::End;

  void infeasible(std::string why) {
    found_.bound.reset();
    found_.end = End::infeasible;
    found_.why = std::move(why);
  }

  [[nodiscard]] bool stopped() {
    if (!go_on_ || go_on_(found_.rounds, last_sum_)) return false;
    found_.end = End::stopped;
    return true;
  }

  /// Rounds of one task until no new row is exceeded. False: no solution, or stopped.
  bool settle_rows(const ShapeTask& task, bool keep_bound) {
    std::vector<double> level(model_.terms.size(), 1);
    const bool linear = keep_bound && task.squares.empty();
    precision_ = linear ? coarse : fine;
    for (int round = 0; round < max_rounds; ++round) {
      if (stopped()) return false;
      const ShapeProgram p = program_of(model_, rows_, task);
      const ConvexSolution s = solve_once(p, level, task);
      if (found_.end == End::stopped || !solved(s, task)) return false;
      take(s.x);
      for (std::size_t k = 0; k < level.size(); ++k)
        level[k] = p.column[k] ? s.x[*p.column[k]] : task.level[k].value_or(HUGE_VAL);
      violation_ = p.slack ? s.x[*p.slack] * task.slack_unit : 0;
      const int added = look(p, s, task, level, keep_bound);
      if (added == 0 && precision_ == fine) return true;
      precision_ = added == 0 || !linear ? fine : finer(p, s);
    }
    found_.why = "the peaks still moved after " + std::to_string(max_rounds) + " rounds";
    return false;
  }

  ConvexSolution solve_once(const ShapeProgram& p, const std::vector<double>& level,
                            const ShapeTask& task) {
    std::vector<double> start = model_.with_auxiliary(found_.z);
    start.resize(p.convex.slope.size(), 1);
    for (std::size_t k = 0; k < p.column.size(); ++k)
      if (p.column[k]) start[*p.column[k]] = level[k];
    ConvexSolution solution = solve(
        p.convex, start, {.thorough = !task.squares_alone, .precision = precision_, .go_on = [&] {
                            return !stopped();
                          }});
    found_.iterations += solution.iterations;
    ++found_.rounds;
    return solution;
  }

  bool solved(const ConvexSolution& s, const ShapeTask& task) {
    last_residual_ = s.residual;
    return s.residual <= (task.squares_alone ? worthwhile : std::max(hopeless, precision_));
  }

  /// Makes the fixed values at the ends exact to the last bit: rest stays rest.
  void take(const std::vector<double>& x) {
    found_.z.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(model_.space.size()));
    for (const Form& f : model_.equalities)
      if (f.terms.size() == 1) found_.z[f.terms[0].index] = -f.constant / f.terms[0].factor;
  }

  /// Computes the bounds of the solution. Returns the number of new rows that it exceeds.
  int look(const ShapeProgram& p, const ConvexSolution& s, const ShapeTask& task,
           std::vector<double> level, bool keep_bound) {
    const auto shape = model_.space.segments(found_.z);
    last_sum_ = weighted_sum(model_, shape);
    const double bound = bound_of(model_, rows_, task, p, s, last_sum_);
    if (keep_bound) keep(bound + norms_.to_bound(shape, last_sum_));
    alone_bound_ = keep_bound ? 0 : bound;
    for (double& each : level) each = task.terms ? each + met_ : HUGE_VAL;
    return rows_.exchange(shape, level, std::max(violation_, 0.0));
  }

  void keep(double bound) {
    if (std::isfinite(bound)) found_.bound = std::max(found_.bound.value_or(bound), bound);
  }

  /// The tolerance of a solution: loose while the places are still far from their final ones.
  [[nodiscard]] double finer(const ShapeProgram& p, const ConvexSolution& s) const {
    double promised = 0;
    for (std::size_t k = 0; k < p.column.size(); ++k)
      if (p.column[k]) promised += model_.terms[k].weight * s.x[*p.column[k]];
    const double missed = 1e-3 * (last_sum_ - promised);
    return missed > least_missed ? std::min(missed, coarse) : fine;
  }

  bool minimize() {
    for (int k = 0; k < max_adjustments; ++k) {
      ShapeTask task = plain(model_);
      task.squares = norms_.squares();
      if (!settle_rows(task, true)) return unsettled();
      found_.end = End::solved;
      if (norms_.settle(model_.space.segments(found_.z))) return true;
    }
    found_.end = End::stalled;
    found_.why = "the weights of the rms figures did not converge";
    return false;
  }

  /// Sets the reason and returns false.
  bool unsettled() {
    if (found_.end == End::stopped || out_of_reach() || round_out_of_reach() ||
        found_.end == End::stopped)
      return false;
    found_.end = End::stalled;
    if (found_.why.empty())
      found_.why = "rounding stopped the solver at a residual of " + brief(last_residual_);
    return false;
  }

  /// True if the constraints cannot all be kept, by the least common violation and its proof.
  bool out_of_reach() {
    found_.bound.reset();
    if (contradictory(model_, found_.z)) {
      infeasible("the values that are fixed at the ends contradict those that are kept exactly");
      return true;
    }
    ShapeTask task = plain(model_);
    task.terms = false;
    task.elastic = true;
    const std::vector<double> now = model_.with_auxiliary(found_.z);
    for (const ShapeRow& row : rows_.all())
      if (!row.term) task.slack_unit = std::max(task.slack_unit, row.form.at(now));
    task.round = false;
    const double residual = std::exchange(last_residual_, 0);
    bool settled = settle_rows(task, false);
    if (!settled &&
        found_.end != End::stopped) {  // the constraints may leave coordinates undetermined
      task.squares = hint(model_.space);
      settled = settle_rows(task, false);
    }
    last_residual_ = residual;
    if (!settled || alone_bound_ <= 2 * margin) return false;
    infeasible("no spline over these knots keeps " +
               worst_constraints(model_, found_.z, violation_) +
               ": one of them is exceeded by at least " + brief(100 * alone_bound_, 3) +
               " %: raise the limits, free more (shape = N with a greater N, or the values of the "
               "knots), or lengthen the segments");
    return true;
  }

  /// True if a limited norm cannot be kept: its least value is above the limit.
  bool round_out_of_reach() {
    const double residual = last_residual_;
    for (const RoundCeiling& ceiling : model_.round) {
      ShapeTask task = plain(model_);
      task.terms = false;
      task.round = false;
      const FigureRows& rows = ceiling.rows;
      const double scale = std::max(ceiling.held(), rows.value(model_.space.segments(found_.z)));
      for (const Form& f : rows.squares) task.squares.push_back(scaled(f, 1 / scale));
      const bool settled = settle_rows(task, false);
      if (found_.end == End::stopped) return false;
      const double least = std::sqrt(std::max(alone_bound_, 0.0)) * scale;
      if (!settled || least <= ceiling.held() * (1 + 10 * margin)) continue;
      infeasible("no spline over these knots keeps limit/" + rows.name + ": at least " +
                 brief(least) + " is needed, " + brief(ceiling.at_most) + " allowed");
      return true;
    }
    last_residual_ = residual;
    return false;
  }

  /// Finds, of all shapes whose figures are within `slack`, the one with the least rms of the derivative above
  /// that of the peaks.
  void smooth(double slack) {
    const ShapeSolution best = found_;
    const auto shape = model_.space.segments(found_.z);
    ShapeTask task;
    task.squares_alone = true;
    int order = 1;
    for (const Term& t : model_.terms) {
      task.level.emplace_back(t.rows.value(shape) / t.unit * (1 + slack));
      order = std::max(order, t.order + 1);
    }
    const LinearQuantity above = derivative_of_shape(std::min({order, model_.space.degree(), 5}));
    const FigureRows rows = rows_of(RmsOf{above}, model_.space);
    const double size = rows.value(shape);
    if (!(size > 0)) return;
    for (const Form& f : rows.squares) task.squares.push_back(scaled(f, 1 / size));
    const bool smoother = settle_rows(task, false);
    if (found_.end == End::stopped) return keep_best(best);
    const auto now = model_.space.segments(found_.z);
    const bool kept = weighted_sum(model_, now) <= weighted_sum(model_, shape) * (1 + 2 * slack);
    if (!smoother || !kept) keep_best(best);
  }

  void keep_best(const ShapeSolution& best) {
    found_.z = best.z;
    found_.end = best.end;
    found_.why = best.why;
  }

  const ShapeModel& model_;
  ShapeNorms norms_;
  const GoOn& go_on_;
  double met_;  ///< excess of a plane that counts as rounding, in the unit of its term
  ShapeRows rows_;
  ShapeSolution found_;
  double last_sum_ = HUGE_VAL;
  double last_residual_ = 0;
  double precision_ = fine;  ///< precision of the next program
  double violation_ = 0;
  double alone_bound_ = 0;  ///< bound of the last program that was not the problem itself
};

}  // namespace

ShapeSolution minimized(const ShapeModel& model, const Coordinates& start, double precision,
                        double slack, const GoOn& go_on) {
  return ShapeExchange(model, start, precision, go_on).run(slack);
}

}  // namespace jounce::optimize_detail
