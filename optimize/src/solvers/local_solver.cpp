// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/local_solver.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>

#include <nlopt.hpp>

// NLopt is a C library: an exception must not pass through it. The first exception stops the run; after it the
// callbacks only return zeros.

namespace jounce::optimize_detail {
namespace {

class NloptRun {
 public:
  NloptRun(const LocalProblem& problem, std::size_t n)
      : problem_(problem),
        solver_(problem.method == LocalProblem::Method::slsqp ? nlopt::LD_SLSQP : nlopt::LN_COBYLA,
                static_cast<unsigned>(n)) {
    if (!problem.lower.empty()) solver_.set_lower_bounds(problem.lower);
    if (!problem.upper.empty()) solver_.set_upper_bounds(problem.upper);
    solver_.set_min_objective(&NloptRun::objective, this);
    if (problem.rows > 0)
      solver_.add_inequality_mconstraint(&NloptRun::constraints, this,
                                         std::vector<double>(problem.rows, problem.row_tolerance));
    if (problem.initial_step > 0) solver_.set_initial_step(problem.initial_step);
    if (problem.x_relative > 0) solver_.set_xtol_rel(problem.x_relative);
    if (problem.x_absolute > 0) solver_.set_xtol_abs(problem.x_absolute);
    if (problem.objective_relative > 0) solver_.set_ftol_rel(problem.objective_relative);
    if (problem.max_evaluations > 0) solver_.set_maxeval(problem.max_evaluations);
  }

  std::vector<double> from(std::vector<double> x) {
    double least = 0;
    try {
      solver_.optimize(x, least);
    } catch (const std::runtime_error&) {     // rounding, "nlopt failure", force_stop()
    } catch (const std::invalid_argument&) {  // a first step for which the bounds leave no space
    }
    if (exception_) std::rethrow_exception(exception_);
    return x;
  }

 private:
  template <class Function>
  void guarded(const Function& function) {
    if (stopped_) return;
    try {
      function();
    } catch (const StopSolver&) {
      stop();
    } catch (...) {
      exception_ = std::current_exception();
      stop();
    }
  }

  void stop() {
    stopped_ = true;
    solver_.force_stop();
  }

  static double objective(unsigned n, const double* x, double* gradient, void* data) {
    NloptRun& run = *static_cast<NloptRun*>(data);
    double value = 0;
    run.guarded([&] {
      value =
          run.problem_.objective({x, n}, gradient ? std::span(gradient, n) : std::span<double>());
    });
    return value;
  }

  static void constraints(unsigned rows, double* result, unsigned n, const double* x,
                          double* gradient, void* data) {
    NloptRun& run = *static_cast<NloptRun*>(data);
    std::fill(result, result + rows, 0.0);
    const std::size_t slopes = std::size_t{rows} * n;
    run.guarded([&] {
      run.problem_.constraints({x, n}, {result, rows},
                               gradient ? std::span(gradient, slopes) : std::span<double>());
    });
  }

  const LocalProblem& problem_;
  nlopt::opt solver_;
  bool stopped_ = false;
  std::exception_ptr exception_;
};

}  // namespace

std::vector<double> run_local_solver(const LocalProblem& problem, std::vector<double> x) {
  NloptRun run(problem, x.size());
  return run.from(std::move(x));
}

}  // namespace jounce::optimize_detail
