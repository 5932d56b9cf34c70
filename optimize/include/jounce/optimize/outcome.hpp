// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"

/// The types that all optimizers share. Each optimizer is one function
///
///     Outcome<T> outcome = optimize(problem, keep_going);
///
/// of a problem with `options` and a function that receives the progress and may stop the run:
///
/// | function | problem | T |
/// |---|---|---|
/// | optimize() | CamProblem: free knots | CamSpec |
/// | optimize_shape() | ShapeProblem: a free function | std::vector<Segment> |
/// | optimize_cam_shapes() | CamShapeProblem: free segments of a cam | CamSpec |
/// | optimize_against() | the same, through a drive | CamSpec |
/// | spline_times() | SplineTimesSpec: times of a spline | SplineTimes |
/// | search() | any function of numbers | std::vector<double> |
namespace jounce {

/// Effort after which a run ends. It is then `stalled`, with its best result so far.
struct Budget {
  std::optional<int> evaluations = {};  ///< >= 1; none: the optimizer's own number
  std::optional<double> seconds =
      {};  ///< > 0, may be infinite; the result then depends on the machine
};

/// Options of an optimizer. The same problem, options and evaluations give the same outcome.
struct OptimizeOptions {
  double tolerance = 1e-6;         ///< relative, of the objective; in [1e-9, 1]
  std::uint64_t seed = 1;          ///< seed of random starts
  std::optional<int> starts = {};  ///< >= 1; none: the optimizer's own number
  Budget budget = {};
};

/// Throws InputError with the key `tolerance`, `starts`, `max_evaluations` or `seconds` for a value out of
/// its range.
void require_valid(const OptimizeOptions& options, double greatest_tolerance = 1);

/// State of a run.
struct OptimizeProgress {
  double done = 0;      ///< estimated share of the work, in [0, 1]
  std::size_t run = 0;  ///< index of the run of free segments of a cam
  std::size_t runs = 1;
  std::size_t stage = 0;  ///< index into `minimize` of the problem
  int round = 0;          ///< rounds of an exchange method so far
  int evaluations = 0;    ///< evaluations so far
  std::optional<double> reached =
      {};  ///< value of the objective so far; none: no feasible point yet
};

/// Receives the progress between evaluations. Return false to stop: the outcome is then `cancelled`, with the
/// best so far.
using KeepGoing = std::function<bool(const OptimizeProgress&)>;

/// The end of a run, from the best to the worst.
enum class OptimizeStatus {
  optimal,     ///< every objective is within tolerance of its proven bound
  converged,   ///< no step and no start improves any more; the gaps bound the remaining gain
  stalled,     ///< the budget ran out, or the solver gave up: the best may still be improved
  cancelled,   ///< stopped by the caller
  infeasible,  ///< nothing that meets every constraint was found; `best` violates them least
};

const char* name(OptimizeStatus status);

/// A figure that is minimized or limited.
struct FigureResult {
  std::string name;    ///< "peak geo_jerk"
  double given = 0;    ///< value of the given curve
  double reached = 0;  ///< value of the best one
  /// Proven: nothing within the constraints has less, if this figure alone is minimized; none: no bound is
  /// known.
  std::optional<double> bound = {};

  /// The greatest share of `reached` that can still be saved: 0 at the bound; none: no bound is known.
  [[nodiscard]] std::optional<double> gap() const;
};

/// Result of an optimizer.
template <class T>
struct Outcome {
  OptimizeStatus status = OptimizeStatus::infeasible;
  std::string reason = {};  ///< one sentence
  T best = {};  ///< the best that meets every constraint, or the one that violates them least
  bool feasible = false;  ///< `best` meets every constraint
  double value = 0;  ///< objective of `best`: a figure, or the weighted sum that was minimized last
  /// Proven: nothing within the constraints has a lower objective (optimize_shape(): no spline over its knots).
  std::optional<double> bound = {};
  std::vector<FigureResult> figures = {};  ///< those of `minimize`, then those that are limited
  Report limits = {};  ///< constraints of `best`, judged independently of the solver
  /// The reasons that stop further improvement: limits reached ("limit/..."), free quantities at a bound ("bound/..."),
  /// places where a peak is attained ("objective/...").
  std::vector<Finding> active = {};
  int evaluations = 0;
  int starts = 0;    ///< starts of a multi-start that were tried
  int agreeing = 0;  ///< starts that ended at `best`
  int rounds = 0;    ///< rounds of an exchange method

  /// True if `best` can be used.
  [[nodiscard]] bool usable() const { return feasible; }
};

}  // namespace jounce
