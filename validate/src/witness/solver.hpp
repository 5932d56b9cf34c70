// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "jounce/validate/integration.hpp"

#include "validate/src/witness/owned.hpp"

namespace jounce::validate_detail {

/// A differential equation y' = rhs(t, y), as functions of arrays. None of them may allocate.
struct Ode {
  /// Writes f(t, y) to dy.
  std::function<void(double t, const double* y, double* dy)> rhs;
  /// Writes df/dy column by column, to jacobian[column * size + row], which is zeros before.
  std::function<void(double t, const double* y, double* jacobian)> jacobian;
  /// Writes the values of the event functions to g. A step ends where one of them changes its sign.
  std::function<void(double t, const double* y, double* g)> event;
  int events = 0;  ///< number of event functions
  /// Writes df/dp, one parameter after another, to dfdp[j * size + row], which is zeros before.
  std::function<void(double t, const double* y, double* dfdp)> by_parameter = {};
  /// One entry for each parameter, > 0: the change of the parameter that changes the state by its
  /// own size. Empty: no sensitivities are integrated.
  std::vector<double> parameters = {};
};

enum class Method { adams, bdf };

/// Options of OdeSolver.
struct SolverOptions {
  Method method = Method::bdf;   ///< family of methods
  double relative = 1e-8;        ///< relative tolerance
  std::vector<double> absolute;  ///< absolute tolerance of each state, > 0
  double closest = 0;            ///< a stop time that is at most this far away counts as reached
  long max_steps = 0;            ///< greatest number of steps
};

/// End of a step: within the interval, at the stop time, at an event, or failed.
enum class Step { inside, stop, event, failed };

/// CVODES with a dense Newton solver, one step at a time. The following rules, which CVODES leaves
/// to its caller, were found by measurement with version 6.4.1:
///
/// - every step has a stop time, and none stays pending: step() sets it again each time, never within
///   rounding of the present time (which CVODES rejects with -22);
/// - messages are written to Integration::reason, not to stderr;
/// - exceptions of the functions of the Ode are carried across the C code and rethrown;
/// - a right-hand side that is not finite ends the integration as `not_finite`.
///
/// If the Ode has parameters, the sensitivities s_j = dy/dp_j are integrated with the state, to the
/// same tolerance (forward, staggered corrector, with error control):
///
///     s_j' = (df/dy) s_j + df/dp_j,    s_j(t0) = 0
///
/// At a jump of the state, a caller that changes state() must change sensitivity() too, before restart().
class OdeSolver {
 public:
  OdeSolver(Ode ode, SolverOptions options, double t0, std::span<const double> y0);
  OdeSolver(const OdeSolver&) = delete;
  OdeSolver& operator=(const OdeSolver&) = delete;

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::span<double> state() { return {N_VGetArrayPointer(y_.get()), size_}; }
  [[nodiscard]] std::span<const double> state() const {
    return {N_VGetArrayPointer(y_.get()), size_};
  }

  /// dy/dp_j at the present time.
  [[nodiscard]] std::span<double> sensitivity(std::size_t j) {
    return {N_VGetArrayPointer(sensitivities_.at[j]), size_};
  }

  /// Sets other tolerances. Call it before a restart.
  void tolerate(double relative, std::span<const double> absolute);
  /// Restarts at t from state(), which may have been changed. Call it after every jump and event.
  void restart(double t);

  /// Sets the greatest length of a step, which applies from the step after the next one.
  void limit_step(double longest);
  /// Length of the next step of the solver; 0 after a restart, when the solver searches for one.
  [[nodiscard]] double next_step() const;

  /// Makes one step, not beyond `stop`.
  Step step(double stop);
  /// Direction in which the event function has crossed zero: -1 or 1; 0: it has not.
  [[nodiscard]] int crossing(std::size_t event) const { return crossings_[event]; }
  [[nodiscard]] std::span<const int> crossings() const { return crossings_; }

  /// Start of the last step.
  [[nodiscard]] double before() const { return before_; }
  /// Writes the state at t, between before() and time(), to `state`, which has the size of state().
  void interpolate(double t, std::span<double> state) const;
  /// Writes the sensitivities at t, one parameter after another.
  void interpolate_sensitivities(double t, std::span<double> sensitivities) const;

  /// Statistics so far.
  [[nodiscard]] const Integration& integration() const { return integration_; }

 private:
  /// The vectors of all parameters, in the form of CVODES.
  struct Vectors {
    std::vector<N_Vector> at;
    explicit Vectors(std::size_t count, N_Vector like);
    Vectors(const Vectors&) = delete;
    Vectors& operator=(const Vectors&) = delete;
    ~Vectors();
  };

  static int rhs(double t, N_Vector y, N_Vector dy, void* self);
  static int jacobian(double t, N_Vector y, N_Vector fy, SUNMatrix j, void* self, N_Vector,
                      N_Vector, N_Vector);
  static int event(double t, N_Vector y, double* g, void* self);
  static int weights(N_Vector y, N_Vector weight, void* self);
  static int sensitivity_rhs(int count, double t, N_Vector y, N_Vector dy, N_Vector* s,
                             N_Vector* ds, void* self, N_Vector, N_Vector);
  static void message(int code, const char* module, const char* function, char* text, void* self);

  void set_up_sensitivities();
  template <class Call>
  int guarded(Call call) noexcept;
  Step fail(Ended ended, std::string reason);

  Ode ode_;
  SolverOptions options_;
  std::size_t size_;
  sundials::Context context_;
  Owned<N_Vector> y_;
  Owned<N_Vector> between_;
  Owned<SUNMatrix> matrix_;
  Owned<SUNLinearSolver> linear_;
  Owned<void*> cvode_;
  Vectors sensitivities_;
  Vectors sensitivities_between_;
  std::vector<double> dfdy_;
  std::vector<double> dfdp_;
  std::vector<int> crossings_;
  double time_ = 0;
  double before_ = 0;
  bool fresh_ = true;
  bool finite_ = true;
  std::string message_;
  std::exception_ptr thrown_;
  Integration integration_;
};

}  // namespace jounce::validate_detail
