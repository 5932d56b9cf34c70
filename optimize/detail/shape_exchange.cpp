#include "jounce/optimize/detail/shape_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/optimize/detail/certificate.hpp"
#include "jounce/optimize/detail/findings.hpp"
#include "jounce/optimize/detail/shape_norms.hpp"

// With t_p for every figure that is a peak, planes g <= figure (FigureRows), walls w and figures that
// are norms |F_r z|:
//
//   (1)  minimise  sum weight_p t_p + sum weight_r |F_r z|
//        subject to  g(z) <= t_p,   w(z) <= 0,   |F_c z| <= most_c,   the equalities.
//
// Which program that is: a norm alone, without walls, one linear system; peaks, a linear program; both, a
// quadratic one (norms: shape_norms.hpp).
//
// Walls are kept 1e-9 off, where there is freedom: so what rounding leaves does not break them.

namespace jounce::optimizer {
namespace {

constexpr int max_rounds = 40;  ///< of one exchange
constexpr int max_adjustments = 40;
constexpr double hopeless = 1e-7;  ///< residual of a program that has no solution
constexpr double worthwhile = 1e-9;
constexpr double range = 1e3;  ///< of a certificate, in sizes of the solution
constexpr double no_freedom = 1e-11;
constexpr double coarse = 1e-6;  ///< residual of a program that is solved again anyway
constexpr double fine = 1e-11;

/// g(z) <= t of its term, or w(z) <= 0.
struct Row {
  Form form;
  std::optional<std::size_t> term = {};
  double off = 0;  ///< by which a wall is kept off
};

/// What stands instead of t and mu in one kind of program.
struct Task {
  std::vector<std::optional<double>> level;  ///< of terms: given, or a t of its own
  bool terms = true;                         ///< with their rows
  bool elastic = false;                      ///< walls may be broken by a common v, to be minimised
  std::vector<Form> squares = {};
  bool squares_alone = false;  ///< only to be smoother: not worth much trouble
};

class ShapeExchange {
 public:
  ShapeExchange(const ShapeModel& model, const Coordinates& start, double precision,
                const GoOn& go_on)
      : model_(model),
        norms_(model, model.space.segments(start)),
        go_on_(go_on),
        met_(std::clamp(precision / 20, 1e-11, 1e-7)) {
    found_.z = start;
    for (std::size_t p = 0; p < model.terms.size(); ++p)
      for (const Form& f : model.terms[p].rows.start)
        rows_.push_back({scaled(f, 1 / model.terms[p].unit), p});
    for (const Wall& wall : model.walls)
      for (const Form& f : wall.start)
        if (auto row = wall_row(f, wall)) rows_.push_back(std::move(*row));
  }

  ShapeSolution run(double licence) {
    if (!walls_where_fixed()) return std::move(found_);
    if (!minimise()) return std::move(found_);
    if (licence > 0 && !norms_.any()) smooth(licence);
    return std::move(found_);
  }

 private:
  using End = ShapeSolution::End;

  // ---- rows -----------------------------------------------------------------------------------

  /// Whether it is new.
  bool add(Row row) {
    const auto same = [&](const Row& other) {
      if (other.term != row.term || other.form.terms.size() != row.form.terms.size()) return false;
      double apart = 0;
      double size = 0;
      for (std::size_t i = 0; i < row.form.terms.size(); ++i) {
        if (other.form.terms[i].index != row.form.terms[i].index) return false;
        apart = std::max(apart, std::abs(other.form.terms[i].factor - row.form.terms[i].factor));
        size = std::max(size, std::abs(row.form.terms[i].factor));
      }
      return apart <= 1e-7 * size &&
             std::abs(other.form.constant - row.form.constant) <= 1e-7 * size;
    };
    if (std::any_of(rows_.rbegin(), rows_.rend(), same)) return false;
    rows_.push_back(std::move(row));
    return true;
  }

  /// Nothing where nothing free changes it.
  [[nodiscard]] std::optional<Row> wall_row(const Form& form, const Wall& wall) const {
    const double free = model_.freedom(form);
    if (free <= no_freedom) return {};
    Row row{scaled(form, 1 / wall.scale), {}, wall.off * std::min(1.0, free)};
    row.form.constant += row.off;
    return row;
  }

  /// The planes and walls that a shape exceeds; how many are new.
  int exchange(const std::vector<Segment>& shape, const std::vector<double>& level, double slack) {
    int added = 0;
    for (std::size_t p = 0; p < model_.terms.size(); ++p) {
      const Term& term = model_.terms[p];
      if (term.rows.by_squares()) continue;
      for (const Form& f : term.rows.cuts(shape, term.unit * (level[p] + met_)))
        added += add({scaled(f, 1 / term.unit), p});
    }
    for (const Wall& wall : model_.walls)
      for (const Form& f : wall.beyond(shape, slack))
        if (auto row = wall_row(f, wall)) added += add(std::move(*row));
    return added;
  }

  // ---- programs -------------------------------------------------------------------------------

  struct Program {
    ConvexProgram convex;
    std::vector<std::optional<std::size_t>> column;  ///< of each term's t
    std::optional<std::size_t> slack;
  };

  [[nodiscard]] Program program(const Task& task) const {
    Program p;
    std::size_t unknowns = model_.unknowns();
    for (std::size_t k = 0; k < model_.terms.size(); ++k)
      p.column.push_back(task.level[k] || !task.terms || model_.terms[k].rows.by_squares()
                             ? std::nullopt
                             : std::optional(unknowns++));
    if (task.elastic) p.slack = unknowns++;
    p.convex.slope.assign(unknowns, 0);
    for (std::size_t k = 0; k < p.column.size(); ++k)
      if (p.column[k]) p.convex.slope[*p.column[k]] = model_.terms[k].weight;
    p.convex.squares = task.squares;
    p.convex.equalities = model_.equalities;
    p.convex.equalities.insert(p.convex.equalities.end(), model_.own.begin(), model_.own.end());
    for (const Row& row : rows_) {
      if (row.term && !task.terms) continue;
      Form form = row.form;
      if (!row.term && p.slack) form.terms.push_back({*p.slack, -1});
      if (row.term && p.column[*row.term]) form.terms.push_back({*p.column[*row.term], -1});
      if (row.term && task.level[*row.term]) form.constant -= *task.level[*row.term];
      p.convex.constraints.push_back(std::move(form));
    }
    if (p.slack) {
      p.convex.slope[*p.slack] = 1;
      p.convex.constraints.push_back({-1, {{*p.slack, -1}}});
    }
    return p;
  }

  /// Of the task as it stands: with (1), what is left of it; elastic, of v without hint().
  [[nodiscard]] double lower(Program p, const ConvexSolution& s, const Task& task) const {
    if (task.elastic) p.convex.squares.clear();
    return weak_bound(p.convex, s, range_of(p, s, last_sum_)) - held_off(s, task);
  }

  /// What a bound owes to walls that really stand a little farther out.
  [[nodiscard]] double held_off(const ConvexSolution& s, const Task& task) const {
    double sum = 0;
    std::size_t k = 0;  // rows as program() takes them
    for (const Row& row : rows_)
      if (!row.term || task.terms) sum += row.off * std::max(s.multipliers[k++], 0.0);
    return sum;
  }

  ConvexSolution solve_once(const Program& p, const std::vector<double>& level, const Task& task) {
    std::vector<double> start = model_.with_own(found_.z);
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

  /// By how much a better solution can differ; `sum`: of the figures of this one.
  [[nodiscard]] std::vector<double> range_of(const Program& p, const ConvexSolution& s,
                                             double sum) const {
    std::vector<double> largest(static_cast<std::size_t>(model_.space.degree()) + 1, 1);
    for (std::size_t j = 0; j < model_.space.size(); ++j)
      largest[j % largest.size()] = std::max(largest[j % largest.size()], std::abs(s.x[j]));
    std::vector<double> all(s.x.size());
    for (std::size_t j = 0; j < model_.space.size(); ++j)
      all[j] = range * largest[j % largest.size()];
    for (std::size_t k = 0; k < model_.own.size(); ++k)
      all[model_.space.size() + k] = model_.range_of_own(k, all);
    for (std::size_t k = 0; k < p.column.size(); ++k)
      if (p.column[k]) all[*p.column[k]] = sum / model_.terms[k].weight;
    if (p.slack) all[*p.slack] = 1 + std::abs(s.x[*p.slack]);
    return all;
  }

  [[nodiscard]] double bound_of(const Program& p, const ConvexSolution& s,
                                const std::vector<Segment>& shape) const {
    const double sum = weighted_sum(model_, shape);
    return weak_bound(p.convex, s, range_of(p, s, sum)) + norms_.to_bound(shape, sum) -
           held_off(s, plain());
  }

  [[nodiscard]] bool stopped() {
    if (!go_on_ || go_on_(found_.rounds, last_sum_)) return false;
    found_.end = End::stopped;
    return true;
  }

  /// Rounds of one task until nothing new is exceeded. False: no solution, or stopped.
  bool settle_rows(const Task& task, bool keep_bound) {
    std::vector<double> level(model_.terms.size(), 1);
    const bool linear = keep_bound && task.squares.empty();
    precision_ = linear ? coarse : fine;
    for (int round = 0; round < max_rounds; ++round) {
      if (stopped()) return false;
      const Program p = program(task);
      const ConvexSolution s = solve_once(p, level, task);
      if (found_.end == End::stopped) return false;
      last_residual_ = s.residual;
      const double enough = task.squares_alone ? worthwhile : std::max(hopeless, precision_);
      if (!(s.residual <= enough)) return false;
      take(s.x);
      for (std::size_t k = 0; k < level.size(); ++k)
        level[k] = p.column[k] ? s.x[*p.column[k]] : task.level[k].value_or(HUGE_VAL);
      slack_ = p.slack ? s.x[*p.slack] : 0;
      const auto shape = model_.space.segments(found_.z);
      last_sum_ = weighted_sum(model_, shape);
      if (keep_bound) keep(bound_of(p, s, shape));
      alone_bound_ = keep_bound ? 0 : lower(p, s, task);
      if (!task.terms) level.assign(level.size(), HUGE_VAL);
      const int added = exchange(shape, level, std::max(slack_, 0.0));
      if (added == 0 && precision_ == fine) return true;
      precision_ = added == 0 || !linear ? fine : finer(p, s);
    }
    found_.why = "peaks kept moving for " + std::to_string(max_rounds) + " rounds";
    return false;
  }

  /// As long as places are still far from where they belong, so may the solution be.
  [[nodiscard]] double finer(const Program& p, const ConvexSolution& s) const {
    double promised = 0;
    for (std::size_t k = 0; k < p.column.size(); ++k)
      if (p.column[k]) promised += model_.terms[k].weight * s.x[*p.column[k]];
    const double missed = 1e-3 * (last_sum_ - promised);
    return missed > 1e-8 ? std::min(missed, coarse) : fine;
  }

  /// What is fixed at the ends to the bit: rest stays rest.
  void take(const std::vector<double>& x) {
    found_.z.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(model_.space.size()));
    for (const Form& f : model_.equalities)
      if (f.terms.size() == 1) found_.z[f.terms[0].index] = -f.constant / f.terms[0].factor;
  }

  void keep(double bound) {
    if (std::isfinite(bound)) found_.bound = std::max(found_.bound.value_or(bound), bound);
  }

  [[nodiscard]] Task plain() const {
    Task task;
    task.level.resize(model_.terms.size());
    return task;
  }

  bool minimise() {
    for (int k = 0; k < max_adjustments; ++k) {
      Task task = plain();
      task.squares = norms_.squares();
      if (!settle_rows(task, true)) {
        if (found_.end != End::stopped && !out_of_reach() && found_.end != End::stopped) {
          found_.end = End::stalled;
          if (found_.why.empty())
            found_.why = "rounding stopped the solver at a residual of " + brief(last_residual_);
        }
        return false;
      }
      found_.end = End::solved;
      const bool unlimited = norms_.limited().empty();
      if (norms_.settle(model_.space.segments(found_.z))) return true;
      if (unlimited && !round_in_reach()) return false;
    }
    found_.end = End::stalled;
    found_.why = "the weights of the rms figures did not settle";
    return false;
  }

  /// Whether the walls cannot all be kept: the least common violation, with its proof.
  bool out_of_reach() {
    found_.bound.reset();
    Task task = plain();
    task.terms = false;
    task.elastic = true;
    if (contradictory()) {
      found_.end = End::infeasible;
      found_.why = "what is fixed at the ends and kept exactly contradicts itself";
      return true;
    }
    const double residual = std::exchange(last_residual_, 0);
    bool settled = settle_rows(task, false);
    if (!settled && found_.end != End::stopped) {  // the walls may leave coordinates open
      task.squares = hint();
      settled = settle_rows(task, false);
    }
    last_residual_ = residual;
    if (!settled) return false;
    if (alone_bound_ <= 2 * margin) return false;
    found_.end = End::infeasible;
    found_.why = "no spline over these knots keeps " + worst_walls() + ": at least " +
                 brief(100 * alone_bound_) + " % of a limit is exceeded";
    return true;
  }

  /// Squares next to nothing, which leave no coordinate open where the walls do.
  [[nodiscard]] std::vector<Form> hint() const {
    LinearQuantity top = derivative_of_shape(std::min(model_.space.degree(), 5));
    std::vector<Form> squares = model_.space.squares(top);
    const auto knots = model_.space.knots();
    const double size = model_.space.natural(top) * std::sqrt(knots.back() - knots.front());
    for (Form& f : squares) f = scaled(std::move(f), 1e-5 / size);
    return squares;
  }

  /// Whether each limited norm can be kept: its least value is below.
  bool round_in_reach() {
    for (const std::size_t k : norms_.limited()) {
      Task task = plain();
      task.terms = false;
      const FigureRows& rows = model_.round[k].rows;
      const double scale = std::max(norms_.most(k), rows.value(model_.space.segments(found_.z)));
      for (const Form& f : rows.squares) task.squares.push_back(scaled(f, 1 / scale));
      if (!settle_rows(task, false)) return found_.end != End::stopped;
      const double least = std::sqrt(std::max(alone_bound_, 0.0)) * scale;
      if (least <= norms_.most(k) * (1 + 10 * margin)) continue;
      found_.bound.reset();
      found_.end = End::infeasible;
      found_.why = "no spline over these knots keeps limit/" + rows.name + ": at least " +
                   brief(least) + " is needed, " + brief(model_.round[k].at_most) + " allowed";
      return false;
    }
    return true;
  }

  /// Whether no shape at all has what is fixed and kept exactly.
  [[nodiscard]] bool contradictory() const { return apart(as_fixed()); }

  /// A shape near the one so far that has what is fixed and kept exactly.
  [[nodiscard]] Coordinates as_fixed() const {
    ConvexProgram p{std::vector<double>(model_.space.size(), 0), {}, {}, {}};
    Coordinates z = found_.z;
    for (int round = 0; round < 3;
         ++round) {  // least squares, so that equalities may be said twice
      p.squares = model_.equalities;
      for (std::size_t k = 0; k < z.size(); ++k) p.squares.push_back({-1e-5 * z[k], {{k, 1e-5}}});
      z = solve(p, z).x;
    }
    return z;
  }

  [[nodiscard]] bool apart(const Coordinates& z) const {
    const auto off = [&](const Form& f) { return !(std::abs(f.at(z)) <= hopeless); };
    return std::any_of(model_.equalities.begin(), model_.equalities.end(), off);
  }

  /// The walls that stand in each other's way: those broken the most where the violation is least.
  [[nodiscard]] std::string worst_walls() const {
    const auto shape = model_.space.segments(found_.z);
    std::string names;
    for (const Wall& wall : model_.walls) {
      if (wall.beyond(shape, 0.999 * slack_).empty()) continue;
      if (names.find(wall.rule) != std::string::npos) continue;
      names += (names.empty() ? "" : " and ") + wall.rule;
    }
    return names.empty() ? "the limits" : names;
  }

  /// Walls that no free coordinate changes: kept or not, once and for all.
  bool walls_where_fixed() {
    std::optional<Coordinates> fixed;  // not `start`: that need not keep what is fixed
    for (const Wall& wall : model_.walls)
      for (const Form& f : wall.start) {
        if (model_.freedom(f) > no_freedom) continue;
        if (!fixed) fixed = as_fixed();
        if (apart(*fixed)) return true;  // minimise() will say so
        const double excess = f.at(*fixed) / wall.scale;
        if (excess <= margin) continue;
        found_.end = End::infeasible;
        found_.why = "what is fixed breaks " + wall.rule + " by " + brief(100 * excess) + " %";
        return false;
      }
    return true;
  }

  /// Of all shapes whose figures are within `licence`, the one with the least rms of the derivative
  /// above the peaks'.
  void smooth(double licence) {
    const ShapeSolution best = found_;
    const auto shape = model_.space.segments(found_.z);
    Task task;
    task.squares_alone = true;
    int order = 1;
    for (const Term& t : model_.terms) {
      task.level.push_back(t.rows.value(shape) / t.unit * (1 + licence));
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
    const bool kept = weighted_sum(model_, now) <= weighted_sum(model_, shape) * (1 + 2 * licence);
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
  double met_;
  std::vector<Row> rows_;
  ShapeSolution found_;
  double last_sum_ = HUGE_VAL;
  double last_residual_ = 0;
  double precision_ = fine;  ///< of the next program
  double slack_ = 0;
  double alone_bound_ = 0;  ///< of the last program that was not the problem itself
};

}  // namespace

ShapeSolution minimised(const ShapeModel& model, const Coordinates& start, double precision,
                        double licence, const GoOn& go_on) {
  return ShapeExchange(model, start, precision, go_on).run(licence);
}

}  // namespace jounce::optimizer
