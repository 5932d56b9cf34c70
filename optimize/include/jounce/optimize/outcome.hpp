// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"

/// The types that all optimizers share. Each optimizer is one function:
///
///     Outcome<T> outcome = optimize(problem, keep_going);
///
/// A problem contains `options`. keep_going receives the progress, and can stop the optimizer.
///
/// | function | problem | T |
/// |---|---|---|
/// | optimize() | CamProblem: free knots | CamSpec |
/// | optimize_shape() | ShapeProblem: a free function | std::vector<Segment> |
/// | optimize_cam_shapes() | CamShapeProblem: free segments of a cam | CamSpec |
/// | spline_times() | SplineTimesSpec: times of a spline | SplineTimes |
/// | search() | any function of numbers | std::vector<double> |
namespace jounce {

/// Greatest effort of an optimizer. If the optimizer uses it up, it ends with the status `stalled`
/// and the best result so far.
struct Budget {
  /// Greatest number of evaluations, >= 1; nullopt: the default of the optimizer.
  std::optional<int> evaluations = {};
  /// Time limit, s, > 0. With a time limit, the result depends on the speed of the computer.
  std::optional<double> seconds = {};
};

/// Options of an optimizer. The same problem, options and number of evaluations give the same
/// outcome.
struct OptimizeOptions {
  double tolerance = 1e-6;  ///< relative tolerance of the objective, 1e-9 to 1
  std::uint64_t seed = 1;   ///< seed of the random starts
  /// Number of starts, >= 1; nullopt: the default of the optimizer.
  std::optional<int> starts = {};
  Budget budget = {};  ///< limits of the effort
};

/// Throws InputError with the key `tolerance`, `starts`, `max_evaluations` or `seconds` for a value
/// out of its range. `greatest_tolerance` is the greatest valid tolerance.
void require_valid(const OptimizeOptions& options, double greatest_tolerance = 1);

/// Progress of an optimizer.
struct OptimizeProgress {
  double done = 0;        ///< estimated share of the work, 0 to 1
  std::size_t run = 0;    ///< index of the present run of free segments (CamShapeProblem)
  std::size_t runs = 1;   ///< number of runs
  std::size_t stage = 0;  ///< index of the present entry of `minimize`
  int round = 0;          ///< number of rounds of an exchange method so far
  int evaluations = 0;    ///< number of evaluations so far
  /// Value of the objective so far; nullopt: no feasible point yet.
  std::optional<double> reached = {};
};

/// Receives the progress between evaluations. To stop the optimizer, return false: the outcome is
/// then `cancelled`, with the best result so far.
using KeepGoing = std::function<bool(const OptimizeProgress&)>;

/// Status at the end of an optimization, from the best to the worst.
enum class OptimizeStatus {
  optimal,  ///< each objective is within the tolerance of its proven bound
  /// No further step or start improves the result. If a bound is known, its gap limits the possible
  /// improvement.
  converged,
  stalled,     ///< the budget was used, or the solver gave up: a better result may exist
  cancelled,   ///< stopped by keep_going
  infeasible,  ///< no result was found that satisfies all constraints; `best` violates them least
};

/// Returns the name of a status: "optimal", ...
const char* name(OptimizeStatus status);

/// A figure that is minimized or limited: its values before and after the optimization.
struct FigureResult {
  std::string name = {};  ///< name with its kind: "peak geo_jerk"
  double given = 0;       ///< value of the given curve
  double reached = 0;     ///< value of the result
  /// Proven lower bound: no result that satisfies the constraints has a lower value, even if this
  /// figure alone is minimized. nullopt: no bound is known.
  std::optional<double> bound = {};

  /// Returns the greatest possible further decrease, as a share of `reached`; 0 if `reached` is at
  /// the bound. nullopt: no bound is known.
  [[nodiscard]] std::optional<double> gap() const;
};

/// Result of an optimizer. For T, see the table above.
template <class T>
struct Outcome {
  /// Status at the end of the optimization.
  OptimizeStatus status = OptimizeStatus::infeasible;
  std::string reason = {};  ///< the reason for the status, one sentence
  /// The best result that satisfies all constraints. If no result does, the result that violates
  /// them least.
  T best = {};
  bool feasible = false;  ///< true if `best` meets all constraints
  double value = 0;  ///< objective of `best`: a figure, or the weighted sum that was minimized last
  /// Proven lower bound of the objective: no result that satisfies the constraints has a lower
  /// objective (optimize_shape(): no spline over its knots). nullopt: no bound is known.
  std::optional<double> bound = {};
  /// Figures of `minimize`, followed by figures that are limited.
  std::vector<FigureResult> figures = {};
  Report limits = {};  ///< constraints of `best`, checked independently of the solver
  /// Obstacles to further improvement: limits that are reached ("limit/..."), free quantities at
  /// their bounds ("bound/..."), places where a peak is reached ("objective/...").
  std::vector<Finding> active = {};
  int evaluations = 0;  ///< number of evaluations
  int starts = 0;       ///< number of starts that were tried
  int agreeing = 0;     ///< number of starts that ended at `best`
  int rounds = 0;       ///< number of rounds of an exchange method

  /// True if `best` meets all constraints.
  [[nodiscard]] bool usable() const { return feasible; }
};

}  // namespace jounce
