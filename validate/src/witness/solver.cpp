// SPDX-License-Identifier: Apache-2.0
#include "validate/src/witness/solver.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/integration_watch.hpp"

namespace jounce {
namespace {

/// The function of the IntegrationWatch of this thread; null: there is none.
thread_local const std::function<void()>* watching = nullptr;

}  // namespace

IntegrationWatch::IntegrationWatch(std::function<void()> each_step)
    : each_step_(std::move(each_step)) {
  watching = &each_step_;
}

IntegrationWatch::~IntegrationWatch() {
  watching = nullptr;
}

}  // namespace jounce

namespace jounce::validate_detail {
namespace {

void set_up(int flag) {
  if (flag == CV_MEM_FAIL) throw std::bad_alloc();
  if (flag < 0)
    throw std::runtime_error("the solver CVODES failed with its error number " +
                             std::to_string(flag));
}

template <class Handle>
Handle made(Handle handle) {
  if (handle == nullptr) throw std::bad_alloc();
  return handle;
}

// CVODES' own vector operations search for special factors before they begin. For a few numbers that costs more
// than the operation, and a step makes about sixty of them.

void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
  const double* u = NV_DATA_S(x);
  const double* v = NV_DATA_S(y);
  double* w = NV_DATA_S(z);
  for (sunindextype i = 0; i < NV_LENGTH_S(x); ++i) w[i] = a * u[i] + b * v[i];
}

void scale(double a, N_Vector x, N_Vector z) {
  const double* u = NV_DATA_S(x);
  double* w = NV_DATA_S(z);
  for (sunindextype i = 0; i < NV_LENGTH_S(x); ++i) w[i] = a * u[i];
}

double weighted_rms(N_Vector x, N_Vector weights) {
  const double* u = NV_DATA_S(x);
  const double* w = NV_DATA_S(weights);
  double sum = 0;
  for (sunindextype i = 0; i < NV_LENGTH_S(x); ++i) sum += u[i] * w[i] * (u[i] * w[i]);
  return std::sqrt(sum / static_cast<double>(NV_LENGTH_S(x)));
}

void constant(double c, N_Vector z) {
  std::fill_n(NV_DATA_S(z), NV_LENGTH_S(z), c);
}

constexpr int most_at_once = 16;  // the history of BDF has 6 vectors, that of Adams 13

/// z = sum of c_k x_k, of which z may be one.
int linear_combination(int count, double* c, N_Vector* x, N_Vector z) {
  if (count > most_at_once) return N_VLinearCombination_Serial(count, c, x, z);
  std::array<const double*, most_at_once> in;
  for (int k = 0; k < count; ++k) in[static_cast<std::size_t>(k)] = NV_DATA_S(x[k]);
  double* w = NV_DATA_S(z);
  for (sunindextype i = 0; i < NV_LENGTH_S(z); ++i) {
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += c[k] * in[static_cast<std::size_t>(k)][i];
    w[i] = sum;
  }
  return 0;
}

/// z_k = a_k x + y_k, where z_k may be y_k.
int scale_add(int count, double* a, N_Vector x, N_Vector* y, N_Vector* z) {
  const double* u = NV_DATA_S(x);
  for (int k = 0; k < count; ++k) {
    const double factor = a[k];
    const double* v = NV_DATA_S(y[k]);
    double* w = NV_DATA_S(z[k]);
    for (sunindextype i = 0; i < NV_LENGTH_S(x); ++i) w[i] = factor * u[i] + v[i];
  }
  return 0;
}

/// A vector whose clones, as all of CVODES', are quick on few numbers.
N_Vector short_vector(std::size_t size, SUNContext context) {
  N_Vector v = N_VNew_Serial(static_cast<sunindextype>(size), context);
  if (v == nullptr) return v;
  static_cast<void>(N_VEnableFusedOps_Serial(v, SUNTRUE));
  v->ops->nvlinearsum = linear_sum;
  v->ops->nvscale = scale;
  v->ops->nvwrmsnorm = weighted_rms;
  v->ops->nvconst = constant;
  v->ops->nvlinearcombination = linear_combination;
  v->ops->nvscaleaddmulti = scale_add;
  return v;
}

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

OdeSolver::OdeSolver(Ode ode, SolverOptions options, double t0, std::span<const double> y0)
    : ode_(std::move(ode)),
      options_(std::move(options)),
      size_(y0.size()),
      y_(made(short_vector(size_, context_))),
      between_(made(N_VClone(y_.get()))),
      matrix_(made(SUNDenseMatrix(static_cast<sunindextype>(size_),
                                  static_cast<sunindextype>(size_), context_))),
      linear_(made(SUNLinSol_Dense(y_.get(), matrix_.get(), context_))),
      cvode_(made(CVodeCreate(options_.method == Method::bdf ? CV_BDF : CV_ADAMS, context_))),
      sensitivities_(ode_.parameters.size(), y_.get()),
      sensitivities_between_(ode_.parameters.size(), y_.get()),
      crossings_(static_cast<std::size_t>(ode_.events)),
      time_(t0),
      before_(t0) {
  std::copy(y0.begin(), y0.end(), state().begin());
  void* cvode = cvode_.get();
  set_up(CVodeSetErrHandlerFn(cvode, &OdeSolver::message, this));
  set_up(CVodeInit(cvode, &OdeSolver::rhs, t0, y_.get()));
  set_up(CVodeSetUserData(cvode, this));
  set_up(CVodeSetMaxErrTestFails(cvode, 20));  // enough to pass a small step of rhs
  set_up(CVodeWFtolerances(cvode, &OdeSolver::weights));
  set_up(CVodeSetLinearSolver(cvode, linear_.get(), matrix_.get()));
  set_up(CVodeSetJacFn(cvode, &OdeSolver::jacobian));
  if (!ode_.parameters.empty()) set_up_sensitivities();
  if (ode_.events > 0) {
    set_up(CVodeRootInit(cvode, ode_.events, &OdeSolver::event));
    set_up(CVodeSetNoInactiveRootWarn(cvode));
  }
}

void OdeSolver::tolerate(double relative, std::span<const double> absolute) {
  assert(absolute.size() == size_);
  options_.relative = relative;
  std::copy(absolute.begin(), absolute.end(), options_.absolute.begin());
}

/// One pass instead of the five of CVodeSVtolerances.
int OdeSolver::weights(N_Vector y, N_Vector weight, void* self) {
  const auto& s = *static_cast<OdeSolver*>(self);
  const double* values = N_VGetArrayPointer(y);
  double* w = N_VGetArrayPointer(weight);
  for (std::size_t i = 0; i < s.size_; ++i)
    w[i] = 1 / (s.options_.relative * std::abs(values[i]) + s.options_.absolute[i]);
  return 0;
}

void OdeSolver::restart(double t) {
  set_up(CVodeReInit(cvode_.get(), t, y_.get()));
  if (!ode_.parameters.empty())
    set_up(CVodeSensReInit(cvode_.get(), CV_STAGGERED, sensitivities_.at.data()));
  time_ = before_ = t;
  fresh_ = true;
  ++integration_.restarts;
}

void OdeSolver::limit_step(double longest) {
  set_up(CVodeSetMaxStep(cvode_.get(), longest));
}

double OdeSolver::next_step() const {
  double h = 0;
  if (!fresh_) set_up(CVodeGetCurrentStep(cvode_.get(), &h));
  return h;
}

Step OdeSolver::step(double stop) {
  if (watching != nullptr) (*watching)();
  before_ = time_;
  if (stop - time_ <= options_.closest) return Step::stop;
  if (integration_.steps >= options_.max_steps) {
    return fail(Ended::too_many_steps,
                "more than " + std::to_string(options_.max_steps) + " steps");
  }
  set_up(CVodeSetStopTime(cvode_.get(), stop));
  fresh_ = false;
  ++integration_.steps;
  const int flag = CVode(cvode_.get(), stop, y_.get(), &time_, CV_ONE_STEP);
  if (thrown_) std::rethrow_exception(thrown_);
  if (!finite_) return fail(Ended::not_finite, "the right-hand side is not finite");
  if (flag < 0) return fail(Ended::failed, message_);
  if (!all_finite(state())) return fail(Ended::not_finite, "the state is not finite");
  if (!ode_.parameters.empty()) {
    double at = 0;
    set_up(CVodeGetSens(cvode_.get(), &at, sensitivities_.at.data()));
  }
  if (flag == CV_ROOT_RETURN) {
    set_up(CVodeGetRootInfo(cvode_.get(), crossings_.data()));
    return Step::event;
  }
  return flag == CV_TSTOP_RETURN ? Step::stop : Step::inside;
}

Step OdeSolver::fail(Ended ended, std::string reason) {
  integration_.ended = ended;
  integration_.reason = std::move(reason);
  return Step::failed;
}

void OdeSolver::interpolate(double t, std::span<double> state) const {
  assert(state.size() == size_);
  set_up(CVodeGetDky(cvode_.get(), t, 0, between_.get()));
  const double* y = N_VGetArrayPointer(between_.get());
  std::copy(y, y + size_, state.begin());
}

OdeSolver::Vectors::Vectors(std::size_t count, N_Vector like) {
  at.reserve(count);
  for (std::size_t j = 0; j < count; ++j) {
    at.push_back(made(N_VClone(like)));
    N_VConst(0, at.back());
  }
}

OdeSolver::Vectors::~Vectors() {
  for (N_Vector v : at) N_VDestroy(v);
}

void OdeSolver::set_up_sensitivities() {
  void* cvode = cvode_.get();
  const std::size_t count = ode_.parameters.size();
  dfdy_.resize(size_ * size_);
  dfdp_.resize(size_ * count);
  set_up(CVodeSensInit(cvode, static_cast<int>(count), CV_STAGGERED, &OdeSolver::sensitivity_rhs,
                       sensitivities_.at.data()));
  set_up(CVodeSetSensParams(cvode, nullptr, ode_.parameters.data(), nullptr));
  set_up(CVodeSensEEtolerances(cvode));  // those of the state, over the size of the parameter
  set_up(CVodeSetSensErrCon(cvode, SUNTRUE));
}

void OdeSolver::interpolate_sensitivities(double t, std::span<double> sensitivities) const {
  assert(sensitivities.size() == size_ * ode_.parameters.size());
  if (sensitivities.empty()) return;
  // CVODES takes an array that it may write to; the vectors belong to this class.
  auto& between = const_cast<std::vector<N_Vector>&>(sensitivities_between_.at);
  set_up(CVodeGetSensDky(cvode_.get(), t, 0, between.data()));
  for (std::size_t j = 0; j < between.size(); ++j)
    std::copy_n(N_VGetArrayPointer(between[j]), size_, sensitivities.data() + j * size_);
}

/// No exception may pass through C: it is kept, and the solver is stopped.
template <class Call>
int OdeSolver::guarded(Call call) noexcept {
  try {
    finite_ = call();
  } catch (...) {
    thrown_ = std::current_exception();
  }
  return finite_ && !thrown_ ? 0 : -1;
}

int OdeSolver::rhs(double t, N_Vector y, N_Vector dy, void* self) {
  auto& s = *static_cast<OdeSolver*>(self);
  return s.guarded([&] {
    s.ode_.rhs(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
    return all_finite({N_VGetArrayPointer(dy), s.size_});
  });
}

int OdeSolver::jacobian(double t, N_Vector y, N_Vector, SUNMatrix j, void* self, N_Vector, N_Vector,
                        N_Vector) {
  auto& s = *static_cast<OdeSolver*>(self);
  return s.guarded([&] {
    std::fill_n(SUNDenseMatrix_Data(j), s.size_ * s.size_, 0.0);
    s.ode_.jacobian(t, N_VGetArrayPointer(y), SUNDenseMatrix_Data(j));
    return true;
  });
}

int OdeSolver::sensitivity_rhs(int count, double t, N_Vector y, N_Vector, N_Vector* s, N_Vector* ds,
                               void* self, N_Vector, N_Vector) {
  auto& solver = *static_cast<OdeSolver*>(self);
  const std::size_t n = solver.size_;
  return solver.guarded([&] {
    std::fill(solver.dfdy_.begin(), solver.dfdy_.end(), 0.0);
    std::fill(solver.dfdp_.begin(), solver.dfdp_.end(), 0.0);
    solver.ode_.jacobian(t, N_VGetArrayPointer(y), solver.dfdy_.data());
    solver.ode_.by_parameter(t, N_VGetArrayPointer(y), solver.dfdp_.data());
    for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) {
      const double* in = N_VGetArrayPointer(s[j]);
      double* out = N_VGetArrayPointer(ds[j]);
      std::copy_n(solver.dfdp_.data() + j * n, n, out);
      for (std::size_t column = 0; column < n; ++column)
        for (std::size_t row = 0; row < n; ++row)
          out[row] += solver.dfdy_[column * n + row] * in[column];
    }
    return all_finite(solver.dfdp_);
  });
}

int OdeSolver::event(double t, N_Vector y, double* g, void* self) {
  auto& s = *static_cast<OdeSolver*>(self);
  return s.guarded([&] {
    s.ode_.event(t, N_VGetArrayPointer(y), g);
    return true;
  });
}

void OdeSolver::message(int, const char*, const char*, char* text, void* self) {
  static_cast<OdeSolver*>(self)->message_ = text;
}

}  // namespace jounce::validate_detail
