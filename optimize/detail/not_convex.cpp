#include "jounce/optimize/detail/not_convex.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "jounce/optimize/detail/descent.hpp"
#include "jounce/optimize/detail/drawn.hpp"
#include "jounce/optimize/detail/shape_model.hpp"
#include "jounce/optimize/detail/shape_report.hpp"

// One round: SLSQP on the rows there are, the signs of the velocity held; then the exact extrema of the
// shape it found, where they exceed a row's level, become rows, and the signs are taken anew. Converged are
// eight rounds that gain nothing and turn no sign, or one that adds no row either. What counts is always the
// exact value of the shape, never what the rows promise.

namespace jounce::optimizer {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Clock = std::chrono::steady_clock;

constexpr int most_rounds = 30;
constexpr int most_refinements = 14;
constexpr int starts = 3;
constexpr int most_idle = 8;  ///< rounds that gain nothing
constexpr int evaluations_a_round = 200;
constexpr double margin = 1e-9;  ///< that limits are kept by: SLSQP leaves as much rounding
constexpr std::array signs{1.0, -1.0};

/// A figure that is not convex, and what it is counted in.
struct Part {
  Pointwise figure;
  double unit = 1;
  double weight = 1;                   ///< of the objective
  std::optional<double> at_most = {};  ///< a ceiling instead
};

/// What the budget leaves, over all starts and refinements.
struct Budget {
  int evaluations = 0;
  int rounds = 0;
  int most_evaluations = 0;
  std::optional<Clock::time_point> until = {};
  bool cancelled = false;

  [[nodiscard]] bool spent() const {
    return cancelled || evaluations >= most_evaluations || (until && Clock::now() >= *until);
  }
};

/// The shape a round ended with.
struct Standing {
  std::vector<Segment> shape = {};
  double value = 0;
  double violation = 0;  ///< 0: every limit is met
  bool settled = false;

  [[nodiscard]] bool better_than(const Standing& other) const {
    if (other.shape.empty()) return true;
    if (violation > 0 || other.violation > 0) return violation < other.violation;
    return value < other.value || (std::isnan(other.value) && !std::isnan(value));
  }
};

/// The problem's convex part.
ShapeProblem convex_part(ShapeProblem p) {
  std::erase_if(p.minimize, [](const WeightedFigure& m) { return !has_rows(m.figure); });
  std::erase_if(p.ceilings, [](const Ceiling& c) { return !has_rows(c.figure); });
  return p;
}

std::vector<Part> parts_of(const ShapeProblem& p, const std::vector<Segment>& given,
                           const SplineSpace& space) {
  std::vector<Part> parts;
  const auto add = [&](const ShapeFigure& figure, double weight, std::optional<double> at_most) {
    auto found = pointwise(figure, p.begin);
    if (!found) return;
    const double value = std::abs(value_of(*found, given, p.begin));
    const double natural = figure_rows(figure, space).natural;
    const double unit =
        at_most && *at_most > 0 ? *at_most : (value > 1e-9 * natural ? value : natural);
    parts.push_back({std::move(*found), unit, weight, at_most});
  };
  for (const WeightedFigure& m : p.minimize) add(m.figure, m.weight, {});
  for (const Ceiling& c : p.ceilings) add(c.figure, 0, c.at_most);
  return parts;
}

/// Gauss's nodes and weights over a piece: the mean that a search sees; the result is judged by value_of().
struct Place {
  double s, weight;
};
constexpr std::array quadrature{Place{0.033765242898423975, 0.085662246189585178},
                                Place{0.16939530676686776, 0.18038078652406930},
                                Place{0.38069040695840156, 0.23395696728634552},
                                Place{0.61930959304159844, 0.23395696728634552},
                                Place{0.83060469323313224, 0.18038078652406930},
                                Place{0.96623475710157603, 0.085662246189585178}};

/// The search over fixed knots.
class Search {
 public:
  Search(const ShapeProblem& problem, const std::vector<Part>& parts, std::vector<double> knots,
         const std::vector<Segment>& near)
      : problem_(problem),
        parts_(parts),
        model_(convex_part(problem), std::move(knots), near),
        reduced_(model_.space, model_.equalities, model_.space.coordinates(near)) {
    hold_signs(near);
    list_rows();
  }

  [[nodiscard]] bool contradicts() const { return reduced_.contradiction() > 1e-7; }
  [[nodiscard]] bool finite() const { return finite_; }
  [[nodiscard]] bool has_no_freedom() const { return reduced_.size() == 0; }
  /// That of the ends, where they leave nothing free.
  [[nodiscard]] Standing only_shape() const {
    Standing only = standing(VectorXd(0));
    only.settled = true;
    return only;
  }

  /// Each round starts from the best shape so far: where SLSQP gets lost, its next start is no worse.
  Standing run(const VectorXd& start, Budget& budget, const ShapeKeepGoing& keep_going) {
    Standing best = standing(start);
    VectorXd y = start;
    for (int round = 0, idle = 0; round < most_rounds && !budget.spent(); ++round) {
      const DescentProgram rows = program();
      const int left = budget.most_evaluations - budget.evaluations;
      const auto go_on = [&] {
        if (keep_going && !keep_going(budget.rounds, best.value)) budget.cancelled = true;
        return !budget.cancelled && !(budget.until && Clock::now() >= *budget.until);
      };
      Descended found = descend(rows, y, std::min(evaluations_a_round, left), go_on);
      budget.evaluations += found.evaluations;
      ++budget.rounds;
      finite_ = found.finite;
      if (!finite_) break;
      Standing now = standing(found.y);
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

  /// y of a shape beside the nearest one, in direction number `start`; 0: that itself.
  [[nodiscard]] VectorXd beside(int start) const {
    VectorXd y = VectorXd::Zero(reduced_.size());
    std::uint64_t state = problem_.seed * 1000003U + static_cast<std::uint64_t>(start);
    const double width = start == 0 ? 0 : 0.5 / std::sqrt(static_cast<double>(y.size()));
    for (double& each : y) each = width * (2 * drawn(state) - 1);
    return y;
  }

  /// Knots with the pieces halved on which a peaked figure falls most short of a peak that it meets there.
  [[nodiscard]] std::vector<double> finer(const std::vector<Segment>& shape) const {
    std::vector<double> lost(model_.space.pieces(), 0);
    for (const Part& part : parts_)
      if (!part.at_most && part.figure.over == Pointwise::Over::peak)
        add_lost(part.figure, shape, lost);
    const double least = 0.05 * *std::max_element(lost.begin(), lost.end());
    std::vector<double> knots;
    for (std::size_t i = 0; i < lost.size(); ++i) {
      const double x = model_.space.knots()[i];
      knots.push_back(x);
      const bool divides = model_.space.length(i) > 1e-7 * (problem_.end - problem_.begin);
      if (lost[i] > 0 && lost[i] >= least && divides)
        knots.push_back(x + model_.space.length(i) / 2);
    }
    knots.push_back(model_.space.knots().back());
    return knots;
  }
  /// Whether a shape is better by more than a share of the tolerance.
  [[nodiscard]] bool gain(const Standing& now, const Standing& best, double share = 0.01) const {
    if (best.violation > 0 || now.violation > 0) return now.violation < 0.9 * best.violation;
    return now.value < best.value - share * problem_.tolerance * std::abs(best.value);
  }
  [[nodiscard]] std::size_t pieces() const { return model_.space.pieces(); }

 private:
  /// The integral of peak - |g| over each piece on which the peak is met, about.
  void add_lost(const Pointwise& figure, const std::vector<Segment>& shape,
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

  [[nodiscard]] std::size_t piece_of(double x) const { return model_.space.piece_at(x); }

  // ---- rows ------------------------------------------------------------------------------------

  [[nodiscard]] PlaceRow place_row(const Pointwise& figure, std::size_t piece, double s,
                                   double sign) const {
    PlaceRow row{&figure, model_.space.knots()[piece] + s * model_.space.length(piece), sign};
    for (const LinearQuantity& q : figure.of)
      row.q.push_back(reduced_.row(model_.space.at(q, piece, s)));
    return row;
  }

  /// Of a wall; a limit that nothing can change is no row.
  void add_wall(const Form& form, double scale) {
    DescentRow row{.linear = reduced_.row(form), .factor = 1 / scale};
    const double slope = row.linear.slope.lpNorm<Eigen::Infinity>() / scale;
    if (slope < 1e-9) return;
    row.offset = -margin * std::min(1.0, slope);
    rows_.push_back(std::move(row));
  }

  void add_peak(const Part& part, std::size_t t, std::size_t piece, double s, double sign,
                double direction) {
    DescentRow row{.place = place_row(part.figure, piece, s, sign),
                   .factor = direction / part.unit};
    if (part.at_most)
      row.offset = *part.at_most / part.unit - margin;
    else
      row.t = t;
    rows_.push_back(std::move(row));
  }

  void list_rows() {
    for (const Wall& wall : model_.walls)
      for (const Form& form : wall.start) add_wall(form, wall.scale);
    std::size_t t = 0;
    for (const Term& term : model_.terms) {
      if (term.rows.by_squares()) continue;
      for (const Form& form : term.rows.start)
        rows_.push_back({.linear = reduced_.row(form), .factor = 1 / term.unit, .t = t});
      ++t;
    }
    for (const Part& part : parts_) {
      if (part.figure.over != Pointwise::Over::peak) continue;
      for (std::size_t i = 0; i < model_.space.pieces(); ++i)
        for (const double s : {0.0, 0.25, 0.5, 0.75})
          for (const double direction : signs)
            add_peak(part, t, i, s, sign_at(part, i, s), direction);
      if (!part.at_most) ++t;
    }
  }

  /// Those of the objective's epigraphs, in the order of list_rows().
  [[nodiscard]] std::vector<double> weights() const {
    std::vector<double> all;
    for (const Term& term : model_.terms)
      if (!term.rows.by_squares()) all.push_back(term.weight);
    for (const Part& part : parts_)
      if (!part.at_most && part.figure.over == Pointwise::Over::peak) all.push_back(part.weight);
    return all;
  }

  [[nodiscard]] Mean mean_of(const Part& part) const {
    Mean mean{.root = part.figure.over == Pointwise::Over::rms};
    const double length = problem_.end - problem_.begin;
    for (std::size_t i = 0; i < model_.space.pieces(); ++i)
      for (const auto& [s, weight] : quadrature) {
        mean.places.push_back(place_row(part.figure, i, s, sign_at(part, i, s)));
        mean.weight.push_back(weight * model_.space.length(i) / (mean.root ? length : 1));
      }
    mean.factor = (part.at_most ? 1 : part.weight) / part.unit;
    if (part.at_most) mean.offset = *part.at_most / part.unit - margin;
    return mean;
  }

  [[nodiscard]] Mean mean_of(const FigureRows& rows, double factor, double offset) const {
    Mean mean{.factor = factor, .offset = offset};
    for (const Form& form : rows.squares) mean.forms.push_back(reduced_.row(form));
    return mean;
  }

  [[nodiscard]] DescentProgram program() const {
    DescentProgram p{.unknowns = reduced_.size(), .weight = weights(), .rows = rows_};
    for (const Term& term : model_.terms)
      if (term.rows.by_squares()) p.means.push_back(mean_of(term.rows, term.weight / term.unit, 0));
    for (const RoundCeiling& c : model_.round)
      p.ceilings.push_back(mean_of(c.rows, 1 / scale_of(c), c.at_most / scale_of(c) - margin));
    for (const Part& part : parts_)
      if (part.figure.over != Pointwise::Over::peak)
        (part.at_most ? p.ceilings : p.means).push_back(mean_of(part));
    return p;
  }

  // ---- signs -----------------------------------------------------------------------------------

  [[nodiscard]] double sign_at(const Part& part, std::size_t piece, double s) const {
    if (!part.figure.signed_by) return 1;
    return value(derivative(held_[piece]), s) < 0 ? -1 : 1;
  }

  /// Takes the signs of a shape; whether one of a row has turned.
  bool hold_signs(const std::vector<Segment>& shape) {
    held_ = shape;
    if (shape.size() != model_.space.pieces())
      held_ = model_.space.segments(model_.space.coordinates(shape));
    bool turned = false;
    for (DescentRow& row : rows_) {
      if (!row.place || !row.place->figure->signed_by) continue;
      const std::size_t i = piece_of(row.place->x);
      const double s = (row.place->x - model_.space.knots()[i]) / model_.space.length(i);
      const double v = value(derivative(held_[i]), std::clamp(s, 0.0, 1.0));
      if (std::abs(v) <= 1e-9 * model_.space.natural(derivative_of_shape(1)) ||
          v * row.place->sign > 0)
        continue;
      row.place->sign = -row.place->sign;
      turned = true;
    }
    return turned;
  }

  // ---- what a shape is worth -------------------------------------------------------------------

  [[nodiscard]] Standing standing(const VectorXd& y) const {
    Standing now{.shape = model_.space.segments(reduced_.z(y))};
    for (const Term& term : model_.terms)
      now.value += term.weight * term.rows.value(now.shape) / term.unit;
    for (const Part& part : parts_) {
      const double value = value_of(part.figure, now.shape, problem_.begin);
      if (part.at_most)
        now.violation = std::max(now.violation, beyond(value, *part.at_most, part.unit));
      else
        now.value += part.weight * value / part.unit;
    }
    for (const RoundCeiling& c : model_.round)
      now.violation =
          std::max(now.violation, beyond(c.rows.value(now.shape), c.at_most, scale_of(c)));
    for (const Wall& wall : model_.walls) {
      for (const Form& form : wall.beyond(now.shape, 1e-12))
        if (model_.freedom(form) > 0)
          now.violation = std::max(now.violation, reduced_.row(form).at(y) / wall.scale);
      for (const Form& form : wall.start)
        now.violation =
            std::max(now.violation, beyond(reduced_.row(form).at(y) / wall.scale, 0, 1));
    }
    return now;
  }

  static double scale_of(const RoundCeiling& c) {
    return c.at_most > 0 ? c.at_most : c.rows.natural;
  }

  static double beyond(double value, double limit, double scale) {
    const double excess = (value - limit) / scale;
    return excess > 1e-11 ? excess : 0;
  }

  /// Adds what the shape breaks; how many rows.
  int exchange(const std::vector<Segment>& shape, const VectorXd& t) {
    int added = 0;
    const std::size_t before = rows_.size();
    for (const Wall& wall : model_.walls)
      for (const Form& form : wall.beyond(shape, 1e-10)) add_wall(form, wall.scale);
    std::size_t k = 0;
    for (const Term& term : model_.terms) {
      if (term.rows.by_squares()) continue;
      const double level = t[static_cast<Index>(k)] * (1 + precision());
      for (const Form& form : term.rows.cuts(shape, level * term.unit))
        rows_.push_back({.linear = reduced_.row(form), .factor = 1 / term.unit, .t = k});
      ++k;
    }
    added += static_cast<int>(rows_.size() - before);
    for (const Part& part : parts_) {
      if (part.figure.over != Pointwise::Over::peak) continue;
      const double level =
          part.at_most ? *part.at_most / part.unit : t[static_cast<Index>(k)] * (1 + precision());
      added += add_peaks(part, k, shape, level);
      if (!part.at_most) ++k;
    }
    return added;
  }

  [[nodiscard]] double precision() const { return std::min(1e-7, 0.1 * problem_.tolerance); }

  int add_peaks(const Part& part, std::size_t t, const std::vector<Segment>& shape, double level) {
    int added = 0;
    for (const Wave& wave : part.figure.waves(shape, problem_.begin)) {
      const Range range = range_of(wave, 1e-9 * level * part.unit);
      for (const double direction : signs) {
        const Extremum& e = direction > 0 ? range.max : range.min;
        if (direction * e.value <= level * part.unit) continue;
        const double from = model_.space.knots()[wave.piece];
        const double s = std::clamp((e.where - from) / model_.space.length(wave.piece), 0.0, 1.0);
        drop_near(part, wave.piece, e.where, direction);
        add_peak(part, t, wave.piece, s, part.figure.signed_by ? wave.sign : 1, direction);
        ++added;
      }
    }
    return added;
  }

  /// Two rows at almost one place are almost one row, and SLSQP loses its digits over them.
  void drop_near(const Part& part, std::size_t piece, double x, double direction) {
    const double near = 1e-4 * model_.space.length(piece);
    std::erase_if(rows_, [&](const DescentRow& row) {
      return row.place && row.place->figure == &part.figure && row.factor * direction > 0 &&
             std::abs(row.place->x - x) < near;
    });
  }

  const ShapeProblem& problem_;
  const std::vector<Part>& parts_;
  ShapeModel model_;
  ReducedSpace reduced_;
  std::vector<Segment> held_;  ///< whose signs count
  std::vector<DescentRow> rows_;
  bool finite_ = true;
};

/// Whether there is one figure to minimise, with a bound, and it is there.
bool at_bound(const ShapeProblem& problem, const std::vector<Segment>& shape) {
  if (problem.minimize.size() != 1) return false;
  const ShapeFigure& figure = problem.minimize.front().figure;
  const auto bound = known_bound(problem, figure);
  const auto found = pointwise(figure, problem.begin);
  return bound && found &&
         value_of(*found, shape, problem.begin) <= *bound * (1 + problem.tolerance);
}

NotConvexResult result_of(Standing best, const Budget& budget, bool finite) {
  using End = NotConvexResult::End;
  NotConvexResult result{
      .shape = std::move(best.shape), .rounds = budget.rounds, .evaluations = budget.evaluations};
  if (budget.cancelled) {
    result.end = End::cancelled;
  } else if (!finite) {
    result.end = End::stalled;
    result.why = "a figure is not finite for shapes on the way";
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
                             const ShapeKeepGoing& keep_going) {
  Budget budget{.most_evaluations = problem.max_evaluations};
  if (problem.seconds)  // for ever is a year: more would not fit the clock
    budget.until =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double>(std::min(*problem.seconds, 3e7)));
  const ShapeModel first(convex_part(problem), first_knots(problem), given);
  const std::vector<Part> parts = parts_of(problem, given, first.space);
  auto search = std::make_unique<Search>(problem, parts, first_knots(problem), given);
  if (search->contradicts())
    return {NotConvexResult::End::infeasible,
            "the ends and what is kept in step contradict each other", given, 0, 0};
  Standing best;
  bool finite = true;
  if (search->has_no_freedom()) {
    best = search->only_shape();
    return result_of(std::move(best), budget, true);
  }
  for (int start = 0; start < starts && !budget.spent(); ++start) {
    Standing now = search->run(search->beside(start), budget, keep_going);
    finite = finite && search->finite();
    if (!now.shape.empty() && now.better_than(best)) best = std::move(now);
  }
  for (int k = 0; problem.refine && k < most_refinements && !best.shape.empty(); ++k) {
    std::vector<double> knots = search->finer(best.shape);
    if (budget.spent() || knots.size() == search->pieces() + 1) break;
    if (at_bound(problem, best.shape)) break;
    // Not from the best: at its vertex of active rows SLSQP does not move, however much finer the knots.
    search = std::make_unique<Search>(problem, parts, std::move(knots), given);
    Standing now = search->run(search->beside(0), budget, keep_going);
    const bool worth_it = search->gain(now, best, 0.2);
    if (now.better_than(best)) best = std::move(now);
    if (!worth_it) break;
  }
  if (best.shape.empty()) best.shape = given;
  return result_of(std::move(best), budget, finite);
}

}  // namespace jounce::optimizer
