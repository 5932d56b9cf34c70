// SPDX-License-Identifier: Apache-2.0
#include "study/src/tune/against.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "study/src/tune/driven_cam.hpp"

// Let z be the shape and y(z) the response of a drive at its instants. For a linear drive, y_l is
// affine in z, and the problem is convex (ResponseOf). For a drive with nonlinear parts
//
//   (1)  y(z) ~ y_l(z) + d,    d = y(z_k) - y_l(z_k)
//
// where y_l is the same drive without its nonlinear parts and z_k the shape of the present round.
// (1) is exact at z_k, with the slopes of y_l. The weight G sin(a(r)) of an arm changes with the
// reference r. Its slope along z_k, with the load taken to be at r, is added to the torque of y_l:
//
//   (3)  T_l(z) <- T_l(z) + G cos(a(r_k)) a' r(z)
//
// This is nearly exact: the load lags by far less than the angle over which the weight of the arm
// changes. After a solution, the drive itself is run along the result. If it is better, z_k moves
// there. If not, d is changed only partly:
//
//   (2)  d <- (d_old + d_new) / 2
//
// For a linear drive, the peaks between the instants are included. If a peak of the response on a
// grid 64 times as fine exceeds the value in the program, it becomes an instant, and the program is
// solved again, until there is no such peak.
//
// Every figure is finally determined by integration. If the integrated figure F exceeds its ceiling
// C, the ceiling is lowered to C C / F, and the problem is solved again.

namespace jounce {
namespace {

using study_detail::DrivenCam;
using Lists = DrivenCam::Lists;
using Status = OptimizeStatus;
using Clock = std::chrono::steady_clock;

constexpr double worth_a_round = 1e-3;  ///< relative gain
constexpr double rounding = 1e-9;       ///< relative to a ceiling
constexpr double new_peak =
    1e-6;  ///< relative: a peak that exceeds a figure by more becomes an instant
constexpr double floor_of_peaks = 1e-9;  ///< relative to the given figure: less is rounding
constexpr int max_exchanges = 12;        ///< exchanges of instants per solution

/// The difference between a drive and its linear twin, at a cam.
struct Correction {
  Lists lists = {};                 ///< d of (1)
  std::vector<double> slopes = {};  ///< slopes of (3)
};

/// The problem with every figure of the drive as a function of the shape.
class Prepared {
 public:
  Prepared(const CamShapeProblem& problem, const DrivenCam& cam) : problem_(problem), cam_(cam) {
    for (auto& stage : problem_.minimize)
      for (WeightedFigure& m : stage) wanted_.push_back(&m.figure);
    for (Ceiling& c : problem_.ceilings) wanted_.push_back(&c.figure);
  }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  /// Sets d of (1) and the limits of the ceilings.
  CamShapeProblem& with(const Correction& correction, const std::vector<double>& at_most) {
    for (ShapeFigure* figure : wanted_)
      if (const auto drive = drive_figure(*figure)) fill(*figure, *drive, correction);
    for (std::size_t i = 0; i < at_most.size(); ++i) problem_.ceilings[i].at_most = at_most[i];
    return problem_;
  }

 private:
  void fill(ShapeFigure& figure, DriveFigure drive, const Correction& correction) const {
    const auto found = correction.lists.find(drive);
    const auto of = [respond = cam_.response(drive, correction.slopes),
                     d = found == correction.lists.end() ? std::vector<double>{}
                                                         : found->second](const Trajectory& shape) {
      std::vector<double> y = respond(shape);
      for (std::size_t i = 0; i < d.size(); ++i) y[i] += d[i];
      return y;
    };
    if (auto* peak = std::get_if<ResponseOf>(&figure)) peak->of = of;
    if (auto* rms = std::get_if<RmsResponseOf>(&figure)) rms->of = of;
  }

  CamShapeProblem problem_;
  const DrivenCam& cam_;
  std::vector<ShapeFigure*> wanted_;
};

/// None where the drive could not be integrated.
std::optional<Correction> correction_at(const DrivenCam& driven, const CamSpec& cam) {
  std::vector<double> slopes = driven.weight_slopes(cam);
  Lists own = driven.measured(cam);
  Lists twin = driven.linear(cam, slopes);
  for (auto& [figure, y] : own) {
    if (y.size() != twin[figure].size()) return std::nullopt;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] -= twin[figure][i];
  }
  if (own.empty()) return std::nullopt;
  return Correction{std::move(own), std::move(slopes)};
}

void halve(std::vector<double>& y, const std::vector<double>& other) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = (y[i] + other[i]) / 2;
}

Correction halfway(const Correction& a, Correction b) {  // (2)
  for (auto& [figure, y] : b.lists)
    if (const auto other = a.lists.find(figure); other != a.lists.end()) halve(y, other->second);
  if (a.slopes.size() == b.slopes.size()) halve(b.slopes, a.slopes);
  return b;
}

/// The score of a cam with its drive.
struct Standing {
  double score = 1;     ///< weighted sum; 1 for the given cam
  bool excess = false;  ///< a ceiling is exceeded

  [[nodiscard]] bool better_than(const Standing& other) const {
    return excess != other.excess ? !excess : score < other.score;
  }
};

class Search {
 public:
  Search(const CamShapeProblem& problem, const Against& against, const KeepGoing& keep_going)
      : problem_(problem),
        against_(against),
        keep_going_(keep_going),
        driven_(problem, against),
        prepared_(problem, driven_) {
    for (const Ceiling& c : problem.ceilings) at_most_.push_back(c.at_most);
    out_.driven_given = driven_.run(problem.cam);
    best_.excess = breaks_ceiling(out_.driven_given);
    exact_ = driven_.is_linear() && out_.driven_given.saturation.empty();
  }

  AgainstOutcome run() {
    if (!out_.driven_given.integration.ok()) return failed();
    if (!exact_) correction_ = correction_at(driven_, problem_.cam).value_or(Correction{});
    for (solutions_ = 1;; ++solutions_) {
      const bool more = round();
      if (!more || solutions_ == against_.max_rounds) break;
    }
    return concluded();
  }

 private:
  AgainstOutcome failed() {
    out_.status = Status::infeasible;
    out_.reason = "the drive model could not be integrated with the given cam: " +
                  out_.driven_given.integration.reason;
    out_.best = problem_.cam;
    return out_;
  }

  /// One solution and its run. Returns true if another round may be better.
  bool round() {
    CamShapeOutcome found = solved();
    if (!found.usable()) {
      if (!have_) shapes() = std::move(found);
      return false;
    }
    DriveResult run = driven_.run(found.best);
    if (!run.integration.ok()) return false;
    const bool stopped = found.status == Status::cancelled;
    const double before = best_.score;
    const CamSpec cam = found.best;
    const bool excess = lower_ceilings(run);
    if (!run.saturation.empty()) {
      exact_ = false;
      driven_.forget_peaks();
    }
    const bool better = take(std::move(found), std::move(run), excess);
    if (stopped) return false;
    if (exact_) return excess;
    return correct(cam, better) &&
           (excess || !better || before - best_.score > worth_a_round * before);
  }

  /// The shapes of one convex problem, including the peaks of a linear drive.
  CamShapeOutcome solved() {
    for (int k = 0;; ++k) {
      CamShapeProblem& problem = prepared_.with(correction_, at_most_);
      if (problem_.options.budget.seconds)
        problem.options.budget.seconds = std::max(*problem_.options.budget.seconds - gone(), 1e-3);
      CamShapeOutcome found = optimize_cam_shapes(problem, keep_going_);
      const bool done = !exact_ || !found.usable() || found.status == Status::cancelled ||
                        k == max_exchanges || out_of_time();
      if (done || add_peaks(found) == 0) return found;
    }
  }

  [[nodiscard]] double gone() const {  // s
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }
  [[nodiscard]] bool out_of_time() const {
    return problem_.options.budget.seconds && gone() >= *problem_.options.budget.seconds;
  }

  /// Adds the peaks of the drive's figures that exceed the values at the instants. Returns their number.
  std::size_t add_peaks(const CamShapeOutcome& found) {
    std::size_t added = 0;
    auto figure = found.runs.front().shape.figures.begin();
    const auto look = [&](const ShapeFigure& of, double level) {
      if (const auto drive = drive_figure(of))
        added += driven_.add_peaks(*drive, found.best,
                                   level * (1 + new_peak) + floor_of_peaks * figure->given);
      ++figure;
    };
    for (const auto& stage : problem_.minimize)
      for (const WeightedFigure& m : stage) look(m.figure, figure->reached);
    for (std::size_t i = 0; i < at_most_.size(); ++i)
      look(problem_.ceilings[i].figure, at_most_[i]);
    return added;
  }

  bool correct(const CamSpec& cam, bool better) {
    const auto now = correction_at(driven_, cam);
    if (!now || (!better && ++worse_ > 3)) return false;
    correction_ = better ? *now : halfway(correction_, *now);
    return true;
  }

  /// Lowers the ceilings that the drive exceeds. Returns true if there is one.
  bool lower_ceilings(const DriveResult& run) {
    bool excess = false;
    for (std::size_t i = 0; i < at_most_.size(); ++i) {
      const Ceiling& ceiling = problem_.ceilings[i];
      const auto drive = drive_figure(ceiling.figure);
      if (!drive) continue;
      const double value = study_detail::value_of(*drive, run);
      if (value <= ceiling.at_most * (1 + rounding)) continue;
      at_most_[i] *= ceiling.at_most / value;
      excess = true;
    }
    return excess;
  }

  [[nodiscard]] bool breaks_ceiling(const DriveResult& run) const {
    return std::any_of(
        problem_.ceilings.begin(), problem_.ceilings.end(), [&](const Ceiling& ceiling) {
          const auto drive = drive_figure(ceiling.figure);
          return drive && study_detail::value_of(*drive, run) > ceiling.at_most * (1 + rounding);
        });
  }

  /// Compares a result with the best so far, at first the given cam, and returns true if it is
  /// better. A cam that satisfies the ceilings is better than one that does not. Otherwise the
  /// first weighted sum decides. The first result is kept in any case, for the outcome.
  bool take(CamShapeOutcome found, DriveResult run, bool excess) {
    const Standing now{weighted(found, run), excess};
    const bool better = now.better_than(best_);
    if (have_ && !better && !now.better_than(kept_)) return false;
    have_ = true;
    kept_ = now;
    if (better) best_ = now;
    promised_ = weighted(found, std::nullopt);
    shapes() = std::move(found);
    out_.driven_best = std::move(run);
    return better;
  }

  /// The weighted sum relative to the given cam. With a run, the figures of the drive are those of the
  /// integration.
  [[nodiscard]] double weighted(const CamShapeOutcome& found,
                                const std::optional<DriveResult>& run) const {
    double sum = 0;
    double all = 0;
    for (std::size_t i = 0; i < problem_.minimize.front().size(); ++i) {
      const WeightedFigure& m = problem_.minimize.front()[i];
      const FigureResult& figure = found.runs.front().shape.figures[i];
      double given = figure.given;
      double reached = figure.reached;
      if (const auto drive = run ? drive_figure(m.figure) : std::nullopt) {
        given = study_detail::value_of(*drive, out_.driven_given);
        reached = study_detail::value_of(*drive, *run);
      }
      sum += m.weight * (given > 0 ? reached / given : 1 + reached);
      all += m.weight;
    }
    return sum / all;
  }

  AgainstOutcome concluded() {
    out_.rounds = solutions_;
    if (!have_) return out_;
    add_figures();
    // No improvement is required if the given cam breaks a ceiling, or if the best cam within the limits is no
    // better.
    const bool improved = kept_.score < 1 || breaks_ceiling(out_.driven_given) ||
                          (promised_ >= 1 && out_.status == Status::optimal);
    out_.real = !kept_.excess && improved;
    if (!exact_) without_bounds();
    if (kept_.excess)
      out_.reason = "by integration, a limit of the drive is exceeded";
    else if (!improved)
      out_.reason = "by integration, the given cam is at least as good for the drive";
    if (!out_.real) out_.status = Status::stalled;
    out_.feasible = out_.feasible && out_.real;
    return out_;
  }

  void add_figures() {
    const auto add = [&](const ShapeFigure& figure) {
      if (const auto drive = drive_figure(figure))
        out_.driven_figures.push_back({name(*drive),
                                       study_detail::value_of(*drive, out_.driven_given),
                                       study_detail::value_of(*drive, out_.driven_best)});
    };
    for (const auto& stage : problem_.minimize)
      for (const WeightedFigure& m : stage) add(m.figure);
    for (const Ceiling& c : problem_.ceilings) add(c.figure);
  }

  void without_bounds() {
    out_.bound.reset();
    for (FigureResult& figure : out_.figures) figure.bound.reset();
    for (CamRunOutcome& run : out_.runs) {
      run.shape.bound.reset();
      for (FigureResult& figure : run.shape.figures) figure.bound.reset();
    }
    if (out_.status == Status::optimal) out_.status = Status::converged;
    out_.reason = "the drive is not linear: better in its own runs, but not proven best (" +
                  std::to_string(solutions_) + " rounds tried)";
  }

  CamShapeOutcome& shapes() { return out_; }

  const CamShapeProblem& problem_;
  const Against& against_;
  const KeepGoing& keep_going_;
  DrivenCam driven_;
  Prepared prepared_;
  AgainstOutcome out_;
  Correction correction_;
  int solutions_ = 0;
  std::vector<double> at_most_;
  bool exact_ = true;  ///< the linear drive is exact
  Clock::time_point begin_ = Clock::now();
  bool have_ = false;
  Standing best_;  ///< score of the best cam, at first the given one
  Standing kept_;  ///< score of the cam in `out_`
  double promised_ = 1;
  int worse_ = 0;
};

void require_valid(const CamShapeProblem& problem, const Against& against) {
  require_valid(against.drive);
  require_positive("velocity", against.velocity);
  require_not_negative("settle", against.settle);
  bool asked = false;
  const auto look = [&](const ShapeFigure& figure) {
    const auto drive = drive_figure(figure);
    asked = asked || drive;
    if (against.periodic && drive == DriveFigure::residual)
      throw InputError("minimize", '"' + name(*drive) + '"',
                       "needs a standstill after the cam, which a periodic cam does not have");
  };
  for (const auto& stage : problem.minimize)
    for (const WeightedFigure& m : stage) look(m.figure);
  for (const Ceiling& c : problem.ceilings) look(c.figure);
  if (!asked)
    throw InputError("minimize", "",
                     "must name a figure of the drive, such as \"drive rms torque\"");
  if (problem.shapes.empty())
    throw InputError("shapes", "none", "must name a segment with a free shape");
}

}  // namespace

AgainstOutcome optimize_against(const CamShapeProblem& problem, const Against& against,
                                const KeepGoing& keep_going) {
  require_valid(problem, against);
  return Search(problem, against, keep_going).run();
}

}  // namespace jounce
