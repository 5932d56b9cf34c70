// The gradient of G = integral of g dt + phi(y(T)) by the adjoint of y' = f(t, y, p):
//
//     (1)  lambda' = -(df/dy)^T lambda - (dg/dy)^T,        lambda(T) = dphi/dy
//     (2)  dG/dp   = lambda(t0)^T dy0/dp + integral of lambda^T df/dp + dg/dp
//
// (Cao, Li, Petzold, Serban, SIAM J. Sci. Comput. 24, 2003.) The state is needed backwards: CVODES
// walks forward first, keeps a checkpoint every `checkpoint_steps` steps, and repeats each part once
// more when the walk back comes to it. (2) is integrated as a quadrature under error control: where
// every parameter acts over a short time only, (1) alone would choose steps that miss it.

#include "jounce/validate/detail/adjoint.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "jounce/validate/detail/owned.hpp"

namespace jounce::detail {
namespace {

struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Backward {
 public:
  Backward(const Adjoint& adjoint, const AdjointOptions& options, const Stretch& stretch,
           std::span<const double> start, std::span<double> lambda, std::span<double> gradient)
      : adjoint_(adjoint),
        options_(options),
        stretch_(stretch),
        size_(start.size()),
        y_(vector(size_)),
        tolerance_(vector(size_)),
        lambda_(vector(size_)),
        gradient_(vector(adjoint.parameters)),
        forward_matrix_(matrix()),
        backward_matrix_(matrix()),
        forward_linear_(SUNLinSol_Dense(y_.get(), forward_matrix_.get(), context_)),
        backward_linear_(SUNLinSol_Dense(y_.get(), backward_matrix_.get(), context_)),
        cvode_(CVodeCreate(CV_BDF, context_)),
        dfdy_(size_ * size_),
        dgdy_(size_) {
    std::copy(start.begin(), start.end(), N_VGetArrayPointer(y_.get()));
    std::copy(lambda.begin(), lambda.end(), N_VGetArrayPointer(lambda_.get()));
    N_VConst(0, gradient_.get());
    outcome_ = run();
    if (thrown_) std::rethrow_exception(thrown_);
    if (!outcome_.ok()) return;
    std::copy_n(N_VGetArrayPointer(lambda_.get()), size_, lambda.begin());
    for (std::size_t j = 0; j < gradient.size(); ++j)
      gradient[j] += N_VGetArrayPointer(gradient_.get())[j];
  }

  [[nodiscard]] const Integration& outcome() const { return outcome_; }

 private:
  Owned<N_Vector> vector(std::size_t n) {
    return Owned<N_Vector>(N_VNew_Serial(static_cast<sunindextype>(n), context_));
  }
  Owned<SUNMatrix> matrix() {
    const auto n = static_cast<sunindextype>(size_);
    return Owned<SUNMatrix>(SUNDenseMatrix(n, n, context_));
  }

  /// A refusal of CVODES ends the run with its own message.
  void call(int flag) const {
    if (flag < 0) throw Refused(message_.empty() ? "flag " + std::to_string(flag) : message_);
  }

  Integration run() {
    Integration outcome;
    try {
      set_up_forward();
      walk_forward();
      set_up_backward();
      walk_backward();
      long steps = 0;
      call(CVodeGetNumSteps(CVodeGetAdjCVodeBmem(cvode_.get(), which_), &steps));
      outcome.steps = steps;
      outcome.reached = stretch_.begin;
    } catch (const Refused& refused) {
      outcome.ended = finite_ ? Ended::failed : Ended::not_finite;
      outcome.reason = finite_ ? refused.what() : "the right-hand side is not finite";
      outcome.reached = stretch_.end;
    }
    return outcome;
  }

  void set_up_forward() {
    void* cvode = cvode_.get();
    std::copy(options_.solver.absolute.begin(), options_.solver.absolute.end(),
              N_VGetArrayPointer(tolerance_.get()));
    call(CVodeSetErrHandlerFn(cvode, &Backward::message, this));
    call(CVodeInit(cvode, &Backward::rhs, stretch_.begin, y_.get()));
    call(CVodeSetUserData(cvode, this));
    call(CVodeSVtolerances(cvode, options_.solver.relative, tolerance_.get()));
    call(CVodeSetLinearSolver(cvode, forward_linear_.get(), forward_matrix_.get()));
    call(CVodeSetJacFn(cvode, &Backward::jacobian));
    call(CVodeSetMaxErrTestFails(cvode, 20));
    call(CVodeSetMaxNumSteps(cvode, options_.solver.max_steps));
    if (stretch_.longest_step > 0) call(CVodeSetMaxStep(cvode, stretch_.longest_step));
    // CV_POLYNOMIAL interpolates with the order of the step; cubic Hermite would be the weakest link
    call(CVodeAdjInit(cvode, options_.checkpoint_steps, CV_POLYNOMIAL));
  }

  void walk_forward() {
    double reached = 0;
    int checkpoints = 0;
    call(CVodeSetStopTime(cvode_.get(), stretch_.end));
    call(CVodeF(cvode_.get(), stretch_.end, y_.get(), &reached, CV_NORMAL, &checkpoints));
    require_arrival(reached, stretch_.end);
  }

  void set_up_backward() {
    void* cvode = cvode_.get();
    call(CVodeCreateB(cvode, CV_BDF, &which_));
    call(CVodeInitB(cvode, which_, &Backward::lambda_rhs, stretch_.end, lambda_.get()));
    call(CVodeSetUserDataB(cvode, which_, this));
    call(CVodeSStolerancesB(cvode, which_, options_.relative, options_.absolute_lambda));
    call(CVodeSetLinearSolverB(cvode, which_, backward_linear_.get(), backward_matrix_.get()));
    call(CVodeSetJacFnB(cvode, which_, &Backward::lambda_jacobian));
    call(CVodeSetMaxNumStepsB(cvode, which_, options_.solver.max_steps));
    if (stretch_.longest_step > 0) call(CVodeSetMaxStepB(cvode, which_, stretch_.longest_step));
    call(CVodeQuadInitB(cvode, which_, &Backward::gradient_rhs, gradient_.get()));
    call(CVodeQuadSStolerancesB(cvode, which_, options_.relative, options_.absolute_gradient));
    call(CVodeSetQuadErrConB(cvode, which_, SUNTRUE));
  }

  void walk_backward() {
    call(CVodeB(cvode_.get(), stretch_.begin, CV_NORMAL));
    double reached = 0;
    call(CVodeGetB(cvode_.get(), which_, &reached, lambda_.get()));
    require_arrival(reached, stretch_.begin);
    call(CVodeGetQuadB(cvode_.get(), which_, &reached, gradient_.get()));
  }

  void require_arrival(double reached, double wanted) const {
    if (!(std::abs(reached - wanted) <= 1e-9 * (stretch_.end - stretch_.begin)))
      throw Refused("the solver stopped short of the end");
  }

  template <class Call>
  int guarded(Call function, std::span<const double> out) noexcept {
    try {
      function();
      finite_ = std::all_of(out.begin(), out.end(), [](double v) { return std::isfinite(v); });
    } catch (...) {
      thrown_ = std::current_exception();
    }
    return finite_ && !thrown_ ? 0 : -1;
  }

  static Backward& of(void* self) { return *static_cast<Backward*>(self); }

  static int rhs(double t, N_Vector y, N_Vector dy, void* self) {
    Backward& b = of(self);
    double* out = N_VGetArrayPointer(dy);
    return b.guarded([&] { b.adjoint_.ode.rhs(t, N_VGetArrayPointer(y), out); }, {out, b.size_});
  }

  static int jacobian(double t, N_Vector y, N_Vector, SUNMatrix j, void* self, N_Vector, N_Vector,
                      N_Vector) {
    Backward& b = of(self);
    double* out = SUNDenseMatrix_Data(j);
    std::fill_n(out, b.size_ * b.size_, 0.0);
    return b.guarded([&] { b.adjoint_.ode.jacobian(t, N_VGetArrayPointer(y), out); },
                     {out, b.size_ * b.size_});
  }

  void linearise(double t, N_Vector y) {
    std::fill(dfdy_.begin(), dfdy_.end(), 0.0);
    adjoint_.ode.jacobian(t, N_VGetArrayPointer(y), dfdy_.data());
  }

  static int lambda_rhs(double t, N_Vector y, N_Vector lambda, N_Vector rate, void* self) {
    Backward& b = of(self);
    const std::size_t n = b.size_;
    const double* in = N_VGetArrayPointer(lambda);
    double* out = N_VGetArrayPointer(rate);
    return b.guarded(
        [&] {
          b.linearise(t, y);
          std::fill(b.dgdy_.begin(), b.dgdy_.end(), 0.0);
          if (b.adjoint_.objective) b.adjoint_.objective(t, N_VGetArrayPointer(y), b.dgdy_.data());
          for (std::size_t column = 0; column < n; ++column) {
            out[column] = -b.dgdy_[column];
            for (std::size_t row = 0; row < n; ++row)
              out[column] -= b.dfdy_[column * n + row] * in[row];  // (1)
          }
        },
        {out, n});
  }

  static int lambda_jacobian(double t, N_Vector y, N_Vector, N_Vector, SUNMatrix j, void* self,
                             N_Vector, N_Vector, N_Vector) {
    Backward& b = of(self);
    const std::size_t n = b.size_;
    double* out = SUNDenseMatrix_Data(j);
    return b.guarded(
        [&] {
          b.linearise(t, y);
          for (std::size_t column = 0; column < n; ++column)
            for (std::size_t row = 0; row < n; ++row)
              out[column * n + row] = -b.dfdy_[row * n + column];
        },
        {out, n * n});
  }

  static int gradient_rhs(double t, N_Vector y, N_Vector lambda, N_Vector rate, void* self) {
    Backward& b = of(self);
    double* out = N_VGetArrayPointer(rate);
    const std::size_t n = b.adjoint_.parameters;
    std::fill_n(out, n, 0.0);
    return b.guarded(
        [&] {
          b.adjoint_.by_parameter(t, N_VGetArrayPointer(y), N_VGetArrayPointer(lambda), out);
          for (std::size_t j = 0; j < n; ++j) out[j] = -out[j];  // time runs backwards
        },
        {out, n});
  }

  static void message(int, const char*, const char*, char* text, void* self) {
    of(self).message_ = text;
  }

  const Adjoint& adjoint_;
  const AdjointOptions& options_;
  const Stretch& stretch_;
  std::size_t size_;
  sundials::Context context_;
  Owned<N_Vector> y_, tolerance_, lambda_, gradient_;
  Owned<SUNMatrix> forward_matrix_, backward_matrix_;
  Owned<SUNLinearSolver> forward_linear_, backward_linear_;
  Owned<void*> cvode_;
  std::vector<double> dfdy_, dgdy_;
  int which_ = 0;
  bool finite_ = true;
  std::string message_;
  std::exception_ptr thrown_;
  Integration outcome_;
};

}  // namespace

Integration backward(const Adjoint& adjoint, const AdjointOptions& options, const Stretch& stretch,
                     std::span<const double> start, std::span<double> lambda,
                     std::span<double> gradient) {
  assert(lambda.size() == start.size() && gradient.size() == adjoint.parameters);
  return Backward(adjoint, options, stretch, start, lambda, gradient).outcome();
}

}  // namespace jounce::detail
